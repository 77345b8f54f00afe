//! Data of nodes and elements, in both versions.
//!
//! ```text
//! data := $NodeData or $ElementData  <count> "<text>"*  <count> <number>*  <count> <whole>*
//!         (<node or element> <value>*)*  the same word with End
//! ```
//!
//! The first text is the name; the first three whole numbers are the time step, how many values
//! belong to one node, and how many nodes there are. All but the values is text in binary files too.
//! Nodes and triangles without a value get NaN.

use super::source::Source;
use super::{Elements, Reader, count, end, end_of_line, item, quoted};
use crate::error::{Notice, SyntaxError};
use crate::mesh::{Data, Values};
use crate::node::MOST;
use crate::text::Scanner;

/// What data belong to.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Place {
    Nodes,
    Elements,
}

struct Head {
    name: String,
    components: usize,
    count: i64,
}

pub(super) fn read<'a>(
    reader: &mut Reader,
    source: &mut impl Source<'a>,
    place: Place,
    line: u32,
) -> Result<(), SyntaxError> {
    let Head { name, components, count } = Head::read(source.scanner())?;
    source.begin()?;
    let mesh = &reader.assembly.mesh;
    let tuples = if place == Place::Nodes { mesh.points.len() } else { mesh.triangles.len() };
    let mut values = vec![f64::NAN; components * tuples];
    let mut is_there = vec![false; tuples];
    let mut left_out = 0;
    for index in 0..count {
        source.row("value", index, count)?;
        let tuple = index_of(reader, source, place)?;
        if tuple.is_some_and(|tuple| std::mem::replace(&mut is_there[tuple], true)) {
            return Err(source.wrong("the number of one that has no value yet"));
        }
        left_out += usize::from(tuple.is_none());
        for component in 0..components {
            let value = source.any_real("a value")?;
            if let Some(tuple) = tuple {
                values[tuple * components + component] = value;
            }
        }
        source.end_row()?;
    }
    let file = source.scanner().file();
    let assembly = &mut reader.assembly;
    if left_out > 0 {
        assembly.warn(file, line, Notice::DataLeftOut { name: name.clone(), count: left_out });
    }
    let is_nodes = place == Place::Nodes;
    let mesh = &mut assembly.mesh;
    let all = if is_nodes { &mut mesh.point_data } else { &mut mesh.triangle_data };
    if all.iter().any(|data| data.name == name) {
        assembly.warn(file, line, Notice::RepeatedData { name });
    } else if count == 0 || is_there.contains(&true) {
        all.push(Data { name, components, values: Values::Real(values) });
    }
    end(source.scanner(), if is_nodes { "$EndNodeData" } else { "$EndElementData" })
}

/// Which tuple the number that is read stands for; `None` for an element that is no triangle.
fn index_of<'a>(
    reader: &Reader,
    source: &mut impl Source<'a>,
    place: Place,
) -> Result<Option<usize>, SyntaxError> {
    let what = match place {
        Place::Nodes => "the number of a node",
        Place::Elements => "the number of an element",
    };
    let number = source.int(what, i64::MIN, i64::MAX)?;
    if place == Place::Nodes {
        return reader.node(number, source).map(|node| Some(node as usize));
    }
    let triangle = reader.elements.as_ref().and_then(|elements| {
        let element = elements.numbers.index(number)?;
        elements.triangles.get(element as usize).copied()
    });
    let triangle = triangle.ok_or_else(|| source.wrong(what))?;
    Ok((triangle != Elements::OTHER).then_some(triangle as usize))
}

/// Most texts and numbers at the head of data, and most values that belong to one node.
const MOST_TEXTS: i64 = 1000;
const MOST_COMPONENTS: i64 = 9;

impl Head {
    fn read(scanner: &mut Scanner) -> Result<Self, SyntaxError> {
        let mut name = None;
        let texts = few(scanner, "the number of texts")?;
        for index in 0..texts {
            item(scanner, "text", index, texts)?;
            name.get_or_insert(quoted(scanner, "a text between double quotes")?);
        }
        let reals = few(scanner, "the number of real numbers")?;
        for index in 0..reals {
            item(scanner, "number", index, reals)?;
            scanner.real("a number")?;
            end_of_line(scanner)?;
        }
        scanner.next_line();
        let wholes = scanner.integer("the number of whole numbers (3 or more)", 3, MOST_TEXTS)?;
        end_of_line(scanner)?;
        let (mut components, mut count) = (1, 0);
        for index in 0..wholes {
            item(scanner, "number", index, wholes)?;
            match index {
                1 => {
                    let what = "how many values belong to one (1 to 9)";
                    components = scanner.integer(what, 1, MOST_COMPONENTS)? as usize;
                }
                2 => count = scanner.integer("how many have values", 0, MOST)?,
                _ => {
                    scanner.integer("a whole number", i64::MIN, i64::MAX)?;
                }
            }
            if index + 1 < wholes {
                end_of_line(scanner)?;
            }
        }
        Ok(Self { name: name.unwrap_or_else(|| "data".to_owned()), components, count })
    }
}

/// How many lines of the head follow.
fn few(scanner: &mut Scanner, what: &'static str) -> Result<i64, SyntaxError> {
    let place = scanner.next_place();
    let count = count(scanner, what)?;
    if count > MOST_TEXTS { Err(scanner.unexpected_at(place, what)) } else { Ok(count) }
}
