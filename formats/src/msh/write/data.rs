//! `$NodeData` and `$ElementData`: named numbers of points and triangles, the same in both
//! versions.

use std::io::{self, Write};

use super::scribe::Scribe;
use crate::groups::{Note, Rules, writable};
use crate::mesh::{Data, Values};
use crate::nodes::Nodes;

/// Writes the data of nodes, then those of triangles, which come after `before` other elements.
pub(super) fn write(
    scribe: &mut Scribe<impl Write>,
    nodes: &Nodes,
    before: usize,
    notes: &mut Vec<Note>,
) -> io::Result<()> {
    let mesh = nodes.mesh;
    scribe.check(before + nodes.len().max(mesh.triangles.len()))?;
    for data in &mesh.point_data {
        let data = &nodes.with_middles(data);
        section(scribe, "NodeData", data, 0, nodes.len(), notes)?;
    }
    for data in &mesh.triangle_data {
        section(scribe, "ElementData", data, before, mesh.triangles.len(), notes)?;
    }
    Ok(())
}

fn section(
    scribe: &mut Scribe<impl Write>,
    section: &str,
    data: &Data,
    before: usize,
    count: usize,
    notes: &mut Vec<Note>,
) -> io::Result<()> {
    let Data { name, components, values } = data;
    let written = writable(name, Rules { quoted: true, ..Rules::default() });
    if *written != *name {
        notes.push(Note::NameChanged { name: name.clone(), written: written.to_string() });
    }
    if !values.are_real_numbers() {
        notes.push(Note::DataRounded { name: name.clone() });
    }
    // One text, the name; one real number, the time; then the step, the components, the count.
    scribe.text(&format!("${section}\n1\n\"{written}\"\n1\n0\n3\n0\n{components}\n{count}\n"))?;
    for item in 0..count {
        scribe.number(before + item + 1);
        for i in item * components..(item + 1) * components {
            match values {
                Values::Real(values) => scribe.real(values.get(i).copied().unwrap_or(f64::NAN)),
                Values::Integer(values) => scribe.whole(values.get(i).copied().unwrap_or(0)),
            }
        }
        scribe.end()?;
    }
    scribe.close(section)
}
