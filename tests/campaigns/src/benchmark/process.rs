//! What a run of a program took: processor time, time, memory; and what it printed.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

use wait4::Wait4;

/// A run that went well.
#[derive(Debug, Clone)]
pub struct Run {
    /// Processor time in seconds, that of the system included.
    pub cpu: f64,
    /// Time in seconds.
    pub wall: f64,
    /// The most memory held at once, in bytes.
    pub peak: u64,
    /// What it printed on standard output.
    pub output: String,
}

/// Runs a program, with what it prints kept in the folder `scratch`.
///
/// # Errors
/// It could not be run, or ended with an error: what it printed.
pub fn run(command: &mut Command, scratch: &Path) -> Result<Run, String> {
    let told = |error: std::io::Error| format!("{}: {error}", scratch.display());
    let [output, errors] = ["output.txt", "errors.txt"].map(|name| scratch.join(name));
    command
        .stdin(Stdio::null())
        .stdout(fs::File::create(&output).map_err(told)?)
        .stderr(fs::File::create(&errors).map_err(told)?);
    let start = Instant::now();
    let mut child = command.spawn().map_err(|error| format!("{command:?}: {error}"))?;
    let used = child.wait4().map_err(told)?;
    let wall = start.elapsed().as_secs_f64();
    let text = |path: &Path| fs::read(path).map(|text| String::from_utf8_lossy(&text).into_owned());
    if !used.status.success() {
        let said = text(&errors).map_err(told)?;
        return Err(format!("{command:?} ended with {}: {said}", used.status));
    }
    let time = used.rusage.utime + used.rusage.stime;
    Ok(Run {
        cpu: time.as_secs_f64(),
        wall,
        peak: used.rusage.maxrss,
        output: text(&output).map_err(told)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_measured_and_its_output_kept() {
        let scratch = std::env::temp_dir().join(format!("meshwright-run-{}", std::process::id()));
        fs::create_dir_all(&scratch).expect("a folder can be made");
        let found = run(Command::new("echo").arg("seven"), &scratch).expect("echo runs");
        assert_eq!(found.output, "seven\n");
        assert!(found.peak > 100_000 && found.wall > 0.0, "{found:?}");
        let failed = run(&mut Command::new("false"), &scratch);
        assert!(failed.is_err_and(|why| why.contains("false")));
        fs::remove_dir_all(&scratch).expect("the folder can be removed");
    }
}
