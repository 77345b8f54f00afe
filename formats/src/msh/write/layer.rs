//! One layer of prisms over the mesh.

use std::io::{self, Write};

use crate::groups::{FreshTags, Names, Note, Rules, Table};
use crate::mesh::Mesh;
use crate::pslg::Tag;
use crate::rows::{Rows, one_based};

/// The group of both ends of the layer.
const ENDS: &str = "frontAndBack";

/// Gmsh's numbers of the kinds of elements.
const TRIANGLE: i64 = 2;
const QUADRANGLE: i64 = 3;
const PRISM: i64 = 6;

pub(super) fn write(mesh: &Mesh, thickness: f64, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let rules = Rules { positive: true, names: Names::Plain, ..Rules::default() };
    let (table, mut notes) = Table::new(mesh, rules);
    notes.extend(Note::data_not_held(mesh));
    let mut layer = Layer { mesh, table: &table, rows: Rows::new(out), number: 0 };
    let ends = layer.names()?;
    layer.nodes(thickness)?;
    layer.elements(ends)?;
    layer.rows.finish()?;
    Ok(notes)
}

struct Layer<'m, 'a, W> {
    mesh: &'m Mesh,
    table: &'m Table,
    rows: Rows<'a, W>,
    /// The number of the last element.
    number: i64,
}

impl<W: Write> Layer<'_, '_, W> {
    /// Writes the names of groups; returns the number of the ends' group.
    fn names(&mut self) -> io::Result<Tag> {
        let entries = &self.table.entries;
        let numbers = entries.iter().filter(|entry| entry.dim == 1).map(|entry| entry.number);
        let ends = FreshTags::beside(numbers.collect()).take();
        let is_taken = |name: &str| entries.iter().any(|entry| entry.name == name);
        let others = (2..).map(|i| format!("{ENDS}_{i}"));
        let name = std::iter::once(ENDS.to_owned()).chain(others).find(|name| !is_taken(name));
        self.rows.text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n")?;
        self.rows.integers(&[entries.len() as i64 + 1])?;
        self.rows.text(&format!("2 {ends} \"{}\"\n", name.unwrap_or_default()))?;
        for entry in entries {
            let (dim, number, name) = (entry.dim + 1, entry.number, &entry.name);
            self.rows.text(&format!("{dim} {number} \"{name}\"\n"))?;
        }
        self.rows.text("$EndPhysicalNames\n")?;
        Ok(ends)
    }

    /// The nodes of the lower end, then those of the upper one in the same order.
    fn nodes(&mut self, thickness: f64) -> io::Result<()> {
        self.rows.text("$Nodes\n")?;
        self.rows.integers(&[2 * self.mesh.points.len() as i64])?;
        let mut number = 0_i64;
        for z in [0.0, thickness] {
            for &[x, y] in &self.mesh.points {
                number += 1;
                self.rows.integer(number);
                self.rows.real(x);
                self.rows.real(y);
                self.rows.real(z);
                self.rows.end()?;
            }
        }
        self.rows.text("$EndNodes\n")
    }

    fn elements(&mut self, ends: Tag) -> io::Result<()> {
        let mesh = self.mesh;
        let up = |node: i64| node + mesh.points.len() as i64;
        self.rows.text("$Elements\n")?;
        self.rows.integers(&[(mesh.edges.len() + 3 * mesh.triangles.len()) as i64])?;
        for (edge, ends) in mesh.edges.iter().enumerate() {
            let [a, b] = ends.map(one_based);
            let group = self.table.edges[edge] as usize;
            self.element(QUADRANGLE, group, &[a, b, up(b), up(a)])?;
        }
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(one_based);
            self.numbered(TRIANGLE, ends, &[a, c, b])?;
            self.numbered(TRIANGLE, ends, &[up(a), up(b), up(c)])?;
        }
        for (triangle, corners) in mesh.triangles.iter().enumerate() {
            let [a, b, c] = corners.map(one_based);
            let group = self.table.region(mesh.triangle_tag(triangle));
            self.element(PRISM, group, &[a, b, c, up(a), up(b), up(c)])?;
        }
        self.rows.text("$EndElements\n")
    }

    fn element(&mut self, kind: i64, group: usize, nodes: &[i64]) -> io::Result<()> {
        self.numbered(kind, self.table.entries[group].number, nodes)
    }

    fn numbered(&mut self, kind: i64, group: Tag, nodes: &[i64]) -> io::Result<()> {
        self.number += 1;
        [self.number, kind, 2, group.into(), group.into()]
            .iter()
            .chain(nodes)
            .for_each(|&number| self.rows.integer(number));
        self.rows.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_becomes_a_prism_between_its_two_ends() {
        let mesh = Mesh {
            points: vec![[0.0, 0.0], [2.0, 0.0], [0.0, 0.1]],
            triangles: vec![[0, 1, 2]],
            triangle_tags: vec![7],
            edges: vec![[0, 1]],
            edge_tags: vec![1],
            ..Mesh::default()
        };
        let mut text = Vec::new();
        write(&mesh, 0.5, &mut text).unwrap();
        let expected = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
            $PhysicalNames\n3\n2 2 \"frontAndBack\"\n2 1 \"boundary_1\"\n3 7 \"region_7\"\n\
            $EndPhysicalNames\n\
            $Nodes\n6\n1 0 0 0\n2 2 0 0\n3 0 0.1 0\n4 0 0 0.5\n5 2 0 0.5\n6 0 0.1 0.5\n$EndNodes\n\
            $Elements\n4\n1 3 2 1 1 1 2 5 4\n2 2 2 2 2 1 3 2\n3 2 2 2 2 4 5 6\n\
            4 6 2 7 7 1 2 3 4 5 6\n$EndElements\n";
        assert_eq!(String::from_utf8(text).unwrap(), expected);
    }
}
