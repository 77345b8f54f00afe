//! Named arrays of numbers, as VTK's files have them: made block by block while they are written.

use std::borrow::Cow;
use std::ops::Range;

use crate::groups::{Entry, Note, Rules, Table, writable};
use crate::mesh::{Data, Mesh, Values};
use crate::nodes::{Nodes, Order};
use crate::vtu::{
    LINE, LINE_3, MARKER, PHYSICAL, PROVENANCE, SEGMENT, TAG, TRIANGLE, TRIANGLE_6, VERSION,
};

/// An array of a file: its description, and its numbers.
pub(crate) struct Array<'a> {
    pub name: String,
    pub kind: Kind,
    pub components: usize,
    /// How many numbers it has.
    pub length: usize,
    /// How many items they are made for, one after the other: points, cells …
    items: usize,
    fill: Fill<'a>,
}

/// Types of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Float64,
    Int64,
    Int32,
    UInt8,
}

/// Appends the numbers of some items.
type Appends<'a, T> = Box<dyn Fn(Range<usize>, &mut Vec<T>) + 'a>;

enum Fill<'a> {
    Real(Appends<'a, f64>),
    Whole(Appends<'a, i64>),
}

/// Some numbers of an array.
pub(crate) enum Block<'a> {
    Real(&'a [f64]),
    Whole(&'a [i64]),
}

/// Items that are made at once.
const BLOCK: usize = 1 << 12;

impl<'a> Array<'a> {
    /// Whole numbers, one for each item.
    pub fn whole(name: &str, kind: Kind, items: usize, value: impl Fn(usize) -> i64 + 'a) -> Self {
        let fill = move |items: Range<usize>, out: &mut Vec<i64>| out.extend(items.map(&value));
        Self::wholes(name, kind, [items, items], fill)
    }

    /// Whole numbers, `length` of them for all items.
    pub fn wholes(
        name: &str,
        kind: Kind,
        [items, length]: [usize; 2],
        fill: impl Fn(Range<usize>, &mut Vec<i64>) + 'a,
    ) -> Self {
        let fill = Fill::Whole(Box::new(fill));
        Self { name: name.to_owned(), kind, components: 1, length, items, fill }
    }

    /// Real numbers, a tuple for each item.
    pub fn reals(
        name: &str,
        components: usize,
        items: usize,
        fill: impl Fn(Range<usize>, &mut Vec<f64>) + 'a,
    ) -> Self {
        let (name, length) = (name.to_owned(), components * items);
        let fill = Fill::Real(Box::new(fill));
        Self { name, kind: Kind::Float64, components, length, items, fill }
    }

    /// The array with so many numbers in a tuple.
    pub fn in_tuples(self, components: usize) -> Self {
        Self { components, ..self }
    }

    /// Hands on all numbers, in order.
    pub fn blocks<E>(&self, mut take: impl FnMut(Block) -> Result<(), E>) -> Result<(), E> {
        let ranges = (0..self.items).step_by(BLOCK).map(|i| i..(i + BLOCK).min(self.items));
        match &self.fill {
            Fill::Real(fill) => {
                let mut numbers = Vec::new();
                for range in ranges {
                    numbers.clear();
                    fill(range, &mut numbers);
                    take(Block::Real(&numbers))?;
                }
            }
            Fill::Whole(fill) => {
                let mut numbers = Vec::new();
                for range in ranges {
                    numbers.clear();
                    fill(range, &mut numbers);
                    take(Block::Whole(&numbers))?;
                }
            }
        }
        Ok(())
    }
}

/// One array for each name, `[number, dimension]` for each group of that name.
///
/// The first array is a single byte. In `.vtu` files it, and that no other array but the last has
/// a length that is no multiple of four, keeps all further offsets odd: meshio 5.3 gives each array
/// a new offset (a multiple of four) and then looks for the next one by its old offset; where an
/// old and a new one are the same number, it mixes up the two arrays.
pub(crate) fn of_groups(entries: &[Entry]) -> Vec<Array<'_>> {
    let mut names: Vec<&str> = Vec::new();
    let mut pairs: Vec<Vec<i64>> = Vec::new();
    for entry in entries {
        let place = names.iter().position(|&name| name == entry.name).unwrap_or_else(|| {
            names.push(&entry.name);
            pairs.push(Vec::new());
            names.len() - 1
        });
        pairs[place].extend([i64::from(entry.number), i64::from(entry.dim)]);
    }
    let array = |(name, pairs): (&str, Vec<i64>)| {
        Array::whole(name, Kind::Int64, pairs.len(), move |i| pairs[i])
    };
    let first = Array::whole(VERSION, Kind::UInt8, 1, |_| 0);
    std::iter::once(first).chain(names.into_iter().zip(pairs).map(array)).collect()
}

/// What is known of points: provenance, markers, data.
pub(crate) fn of_points<'a>(nodes: &'a Nodes, notes: &mut Vec<Note>) -> Vec<Array<'a>> {
    let (mesh, count) = (nodes.mesh, nodes.len());
    let mut arrays = Vec::new();
    if !mesh.provenance.is_empty() {
        let of_point = |i| mesh.provenance.get(i).map_or(0, |&kind| kind as i64);
        let value = move |i| if i < mesh.points.len() { of_point(i) } else { -1 };
        arrays.push(Array::whole(PROVENANCE, Kind::Int32, count, value));
    }
    if !mesh.point_markers.is_empty() {
        let of_point = |i| mesh.point_markers.get(i).map_or(0, |&marker| i64::from(marker));
        let value = move |i: usize| match i.checked_sub(mesh.points.len()) {
            None => of_point(i),
            Some(middle) => {
                let [a, b] = nodes.sides[middle].map(|end| of_point(end as usize));
                if a == b { a } else { 0 }
            }
        };
        arrays.push(Array::whole(MARKER, Kind::Int32, count, value));
    }
    for data in &mesh.point_data {
        let name = data_name(&data.name, &[PROVENANCE, MARKER], notes);
        arrays.push(of_data(nodes.with_middles(data), name, 0, count));
    }
    arrays
}

/// What is known of cells: groups, tags, input segments, data of triangles.
pub(crate) fn of_cells<'a>(
    mesh: &'a Mesh,
    table: &'a Table,
    notes: &mut Vec<Note>,
) -> Vec<Array<'a>> {
    let (edges, count) = (mesh.edges.len(), mesh.edges.len() + mesh.triangles.len());
    let groups = move |cells: Range<usize>| {
        let mut last = None; // neighbours in the file mostly share their region
        cells.map(move |cell| match table.edges.get(cell) {
            Some(&group) => &table.entries[group as usize],
            None => {
                let tag = mesh.triangle_tag(cell - edges);
                let group = match last {
                    Some((same, group)) if same == tag => group,
                    _ => table.region(tag),
                };
                last = Some((tag, group));
                &table.entries[group]
            }
        })
    };
    let array = |name, value: fn(&Entry) -> i64| {
        let fill = move |cells, out: &mut Vec<i64>| out.extend(groups(cells).map(value));
        Array::wholes(name, Kind::Int32, [count, count], fill)
    };
    let mut arrays = vec![
        array(PHYSICAL, |entry| i64::from(entry.number)),
        array(TAG, |entry| i64::from(entry.tag)),
    ];
    if !mesh.edge_segments.is_empty() {
        let value = move |i| match mesh.edge_segments.get(i) {
            Some(&segment) if i < edges && segment != u32::MAX => i64::from(segment),
            _ => -1,
        };
        arrays.push(Array::whole(SEGMENT, Kind::Int64, count, value));
    }
    arrays.extend(of_triangles(mesh, edges, &[PHYSICAL, TAG, SEGMENT], notes));
    arrays
}

/// Data of triangles, after `before` cells that have none; `meant` are names with a meaning.
pub(crate) fn of_triangles<'a>(
    mesh: &'a Mesh,
    before: usize,
    meant: &[&str],
    notes: &mut Vec<Note>,
) -> Vec<Array<'a>> {
    let array = |data: &'a Data| {
        let name = data_name(&data.name, meant, notes);
        of_data(Cow::Borrowed(data), name, before, mesh.triangles.len())
    };
    mesh.triangle_data.iter().map(array).collect()
}

/// The name of a data array in the file, which the names that have a meaning are kept from.
fn data_name(name: &str, meant: &[&str], notes: &mut Vec<Note>) -> String {
    let mut written = writable(name, Rules::default()).into_owned();
    while meant.contains(&written.as_str()) {
        written.push('_');
    }
    if written != name {
        notes.push(Note::NameChanged { name: name.to_owned(), written: written.clone() });
    }
    written
}

/// `count` tuples of data, after `before` tuples that say nothing.
fn of_data(data: Cow<'_, Data>, name: String, before: usize, count: usize) -> Array<'_> {
    let components = data.components.max(1);
    let numbers = move |items: Range<usize>| {
        let end = |item: usize| item.saturating_sub(before) * components;
        let nothing = before.saturating_sub(items.start).min(items.len()) * components;
        (nothing, end(items.start)..end(items.end))
    };
    let items = before + count;
    match data.values {
        Values::Real(_) => Array::reals(&name, components, items, move |items, out| {
            let Values::Real(values) = &data.values else { return };
            let (nothing, places) = numbers(items);
            out.extend(std::iter::repeat_n(f64::NAN, nothing));
            out.extend(places.map(|i| values.get(i).copied().unwrap_or(f64::NAN)));
        }),
        Values::Integer(_) => {
            let fill = move |items, out: &mut Vec<i64>| {
                let Values::Integer(values) = &data.values else { return };
                let (nothing, places) = numbers(items);
                out.extend(std::iter::repeat_n(0, nothing));
                out.extend(places.map(|i| values.get(i).copied().unwrap_or(0)));
            };
            let counts = [items, items * components];
            Array::wholes(&name, Kind::Int64, counts, fill).in_tuples(components)
        }
    }
}

/// The nodes as VTK wants them: with a z coordinate, 0.
pub(crate) fn coordinates<'a>(nodes: &'a Nodes) -> Array<'a> {
    Array::reals("Points", 3, nodes.len(), |items, out| {
        let start = out.len();
        out.resize(start + 3 * items.len(), 0.0);
        for (place, node) in out[start..].chunks_exact_mut(3).zip(items) {
            place[..2].copy_from_slice(&nodes.point(node));
        }
    })
}

/// Edges, then triangles: their nodes, where those of each end, and VTK's kinds of cells.
pub(crate) fn cells<'a>(nodes: &'a Nodes) -> [Array<'a>; 3] {
    let (edges, triangles) = (nodes.mesh.edges.len(), nodes.mesh.triangles.len());
    let count = edges + triangles;
    let ([line, of_line], [triangle, of_triangle]) = match nodes.order {
        Order::First => ([LINE, 2], [TRIANGLE, 3]),
        Order::Second => ([LINE_3, 3], [TRIANGLE_6, 6]),
    };
    let (of_line, of_triangle) = (usize::from(of_line), usize::from(of_triangle));
    let length = of_line * edges + of_triangle * triangles;
    let connectivity = move |cells: Range<usize>, out: &mut Vec<i64>| {
        // The common case: a flat copy.
        if nodes.order == Order::First && cells.start >= edges {
            let corners = &nodes.mesh.triangles[cells.start - edges..cells.end - edges];
            out.extend(corners.as_flattened().iter().map(|&corner| i64::from(corner)));
            return;
        }
        for cell in cells {
            match cell.checked_sub(edges) {
                None => out.extend(nodes.edge(cell).map(i64::from)),
                Some(triangle) => out.extend(nodes.triangle(triangle).map(i64::from)),
            }
        }
    };
    let offset = move |cell: usize| {
        let end = cell + 1;
        (of_line * end.min(edges) + of_triangle * end.saturating_sub(edges)) as i64
    };
    let kind = move |cell| i64::from(if cell < edges { line } else { triangle });
    [
        Array::wholes("connectivity", Kind::Int64, [count, length], connectivity),
        Array::whole("offsets", Kind::Int64, count, offset),
        Array::whole("types", Kind::UInt8, count, kind),
    ]
}
