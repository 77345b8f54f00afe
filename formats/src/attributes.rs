//! Attributes: the columns of real numbers in Triangle's files. They have numbers, no names.

use crate::groups::Note;
use crate::mesh::{Data, Values};

/// The name that a reader gives to an attribute, counted from one.
pub(crate) fn name(attribute: usize) -> String {
    format!("attribute_{attribute}")
}

/// The data that attributes can hold, to be written after `before` others.
pub(crate) fn columns<'a>(
    data: &'a [Data],
    before: usize,
    notes: &mut Vec<Note>,
) -> Vec<&'a [f64]> {
    let mut columns = Vec::new();
    for Data { name, components, values } in data {
        let (1, Values::Real(values)) = (components, values) else {
            notes.push(Note::DataDropped { name: name.clone() });
            continue;
        };
        columns.push(values.as_slice());
        let attribute = before + columns.len();
        if *name != self::name(attribute) {
            notes.push(Note::Column { name: name.clone(), attribute });
        }
    }
    columns
}
