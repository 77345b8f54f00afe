//! Writing `.inp`.

use std::collections::BTreeMap;
use std::io::{self, Write};

use crate::blocks::Blocks;
use crate::groups::{Names, Note, Rules, Table};
use crate::mesh::Mesh;
use crate::nodes::{Nodes, Order};
use crate::pslg::Tag;
use crate::rows::{Rows, one_based};

/// Writes a mesh, and says what became of its tags and names.
///
/// A region is a set of elements (ELSET), a boundary a set of nodes (NSET) and a surface of the same
/// name, a group of points a set of nodes. The sides of a surface between two regions are those of
/// the region with the smaller number. Names are single words there: other characters become
/// `_`. Markers, provenance and data are not written.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more nodes than 32 bits can number.
///
/// ```
/// use meshwright_formats::{Mesh, Order, inp};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![7],
///     edges: vec![[2, 0]],
///     edge_tags: vec![3],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// inp::write_with(&mesh, Order::First, &mut text)?;
/// let expected = "*NODE, NSET=NALL\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 0.5, 0\n\
///                 *ELEMENT, TYPE=CPS3, ELSET=EALL\n1, 1, 2, 3\n\
///                 *ELSET, ELSET=region_7\n1\n\
///                 *NSET, NSET=boundary_3\n1, 3\n\
///                 *SURFACE, NAME=boundary_3, TYPE=ELEMENT\n1, S3\n";
/// assert_eq!(text, expected.as_bytes());
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write_with(mesh: &Mesh, order: Order, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let rules =
        Rules { numberless: true, names: Names::Plain, memberships: true, ..Rules::default() };
    let (table, mut notes) = Table::new(mesh, rules);
    // Sets of elements and sets of nodes may share a name.
    notes.retain(|note| !matches!(note, Note::SharedName { .. }));
    notes.extend(Note::data_not_held(mesh));
    let nodes = Nodes::new(mesh, order)?;
    let mut lines = Lines { rows: Rows::new(out) };
    lines.nodes(&nodes)?;
    lines.elements(&nodes)?;
    lines.regions(mesh, &table)?;
    lines.boundaries(&nodes, &table)?;
    lines.rows.finish()?;
    Ok(notes)
}

/// Numbers on a line of a set, as many as Abaqus takes.
const PER_LINE: usize = 16;

struct Lines<'a, W> {
    rows: Rows<'a, W>,
}

impl<W: Write> Lines<'_, W> {
    fn nodes(&mut self, nodes: &Nodes) -> io::Result<()> {
        self.rows.text("*NODE, NSET=NALL\n")?;
        for (number, [x, y]) in (1_i64..).zip(nodes.points()) {
            self.rows.integer(number);
            self.rows.comma();
            self.rows.real(x);
            self.rows.comma();
            self.rows.real(y);
            self.rows.comma();
            self.rows.integer(0);
            self.rows.end()?;
        }
        Ok(())
    }

    fn elements(&mut self, nodes: &Nodes) -> io::Result<()> {
        let kind = match nodes.order {
            Order::First => "CPS3",
            Order::Second => "CPS6",
        };
        self.rows.text(&format!("*ELEMENT, TYPE={kind}, ELSET=EALL\n"))?;
        for triangle in 0..nodes.mesh.triangles.len() {
            let number = triangle as i64 + 1;
            self.line(std::iter::once(number).chain(nodes.triangle(triangle).map(one_based)))?;
        }
        Ok(())
    }

    fn regions(&mut self, mesh: &Mesh, table: &Table) -> io::Result<()> {
        let groups = (0..mesh.triangles.len()).map(|t| table.region(mesh.triangle_tag(t)));
        for (group, triangles) in Blocks::new(groups, table.entries.len()).in_use() {
            self.rows.text(&format!("*ELSET, ELSET={}\n", table.entries[group].name))?;
            self.set(triangles)?;
        }
        Ok(())
    }

    /// The sets of nodes of boundaries and of groups of points; surfaces of boundaries.
    fn boundaries(&mut self, nodes: &Nodes, table: &Table) -> io::Result<()> {
        let mesh = nodes.mesh;
        let mut edges: Vec<Vec<u32>> = vec![Vec::new(); table.entries.len()];
        let mut members: Vec<Vec<u32>> = vec![Vec::new(); table.entries.len()];
        (0..).zip(&table.edges).for_each(|(edge, &group)| edges[group as usize].push(edge));
        for (membership, &group) in mesh.memberships.iter().zip(&table.memberships) {
            let of = if membership.dim == 0 { &mut members } else { &mut edges };
            of[group as usize].push(membership.item);
        }
        let sides = sides(mesh);
        for (group, (edges, mut members)) in edges.into_iter().zip(members).enumerate() {
            let name = &table.entries[group].name;
            members.extend(edges.iter().flat_map(|&edge| nodes.edge(edge as usize)));
            if members.is_empty() {
                continue;
            }
            members.sort_unstable();
            members.dedup();
            self.rows.text(&format!("*NSET, NSET={name}\n"))?;
            self.set(&members)?;
            let mut sides = edges.iter().filter_map(|edge| sides.get(&key(mesh, *edge))).peekable();
            if sides.peek().is_none() {
                continue;
            }
            self.rows.text(&format!("*SURFACE, NAME={name}, TYPE=ELEMENT\n"))?;
            for &Side { triangle, number, .. } in sides {
                self.rows.text(&format!("{}, S{number}\n", triangle + 1))?;
            }
        }
        Ok(())
    }

    fn set(&mut self, items: &[u32]) -> io::Result<()> {
        let mut lines = items.chunks(PER_LINE);
        lines.try_for_each(|line| self.line(line.iter().copied().map(one_based)))
    }

    fn line(&mut self, numbers: impl Iterator<Item = i64>) -> io::Result<()> {
        for (place, number) in numbers.enumerate() {
            if place > 0 {
                self.rows.comma();
            }
            self.rows.integer(number);
        }
        self.rows.end()
    }
}

fn key(mesh: &Mesh, edge: u32) -> [u32; 2] {
    let [a, b] = mesh.edges[edge as usize];
    [a.min(b), a.max(b)]
}

/// A side of a triangle.
struct Side {
    triangle: usize,
    /// 1, 2 or 3.
    number: u8,
    /// Of two sides that are one edge, the lower one is taken.
    rank: (Tag, bool),
}

/// For each edge of the mesh its side in a surface.
///
/// Between two regions it is that of the region with the smaller number, within one region that to
/// the left of the edge: so what flows through a surface flows one way.
fn sides(mesh: &Mesh) -> BTreeMap<[u32; 2], Side> {
    let mut is_end = vec![false; mesh.points.len()];
    mesh.edges.iter().flatten().for_each(|&end| is_end[end as usize] = true);
    let edges = (0..mesh.edges.len() as u32).map(|edge| (key(mesh, edge), edge));
    let asked: BTreeMap<[u32; 2], u32> = edges.collect();
    let mut sides: BTreeMap<[u32; 2], Side> = BTreeMap::new();
    for (triangle, &[a, b, c]) in mesh.triangles.iter().enumerate() {
        for (number, [a, b]) in (1..).zip([[a, b], [b, c], [c, a]]) {
            let key = [a.min(b), a.max(b)];
            if !is_end[a as usize] || !is_end[b as usize] {
                continue;
            }
            let Some(&edge) = asked.get(&key) else { continue };
            let rank = (mesh.triangle_tag(triangle), mesh.edges[edge as usize] != [a, b]);
            if sides.get(&key).is_none_or(|side| rank < side.rank) {
                sides.insert(key, Side { triangle, number, rank });
            }
        }
    }
    sides
}
