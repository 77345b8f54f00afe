//! Triangle's files: those of one mesh stand beside each other under one name.

use std::path::{Path, PathBuf};

use super::format::Format;
use super::output::STDOUT;
use super::voice::Voice;

/// Whether a file of this format is written beside an output, under the same name.
pub fn is_beside(output: &Path, format: Format, outputs: &[(&PathBuf, Format)]) -> bool {
    let stands = |&(other, found): &(&PathBuf, Format)| {
        found == format && other.with_extension("") == output.with_extension("")
    };
    output != Path::new(STDOUT) && outputs.iter().any(stands)
}

/// Says which outputs hold indices into a file that this run does not write.
pub fn tell_incomplete(outputs: &[(&PathBuf, Format)], voice: &Voice) {
    for &(output, format) in outputs {
        let (what, wanted): (_, &[Format]) = match format {
            Format::Ele | Format::Edge => ("points", &[Format::Node, Format::Poly]),
            Format::Neigh => ("triangles", &[Format::Ele]),
            _ => continue,
        };
        if output != Path::new(STDOUT) && !wanted.iter().any(|&f| is_beside(output, f, outputs)) {
            let beside = output.with_extension(wanted[0].extension());
            voice.note(format!(
                "{}: its {what} belong into {}, which is not written",
                output.display(),
                beside.display()
            ));
        }
    }
}
