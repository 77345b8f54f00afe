//! The cells of a grid, made of nodes that come one after the other.

use std::ops::Range;

use super::{Part, Tags, Wrong, wrong};
use crate::assembly::{Assembly, Shape};
use crate::wholes::Wholes;

/// What a grid tells of its cells, and the edges and triangles that they are.
#[derive(Default)]
pub(crate) struct Cells {
    /// VTK's kind of each cell.
    pub kinds: Wholes,
    /// Where the nodes of each cell end among all.
    pub ends: Wholes,
    /// The first thing that is wrong with them.
    pub(super) wrong: Option<Wrong>,
    /// The edges and triangles, without their tags.
    pub(super) assembly: Assembly,
    /// Which cell each of them is.
    pub(super) edges: Runs,
    pub(super) triangles: Runs,
    /// Points that are cells, and which.
    pub(super) points: Vec<(u32, usize)>,
    /// How many points and nodes the grid has.
    counts: [usize; 2],
    /// The cell that comes next, where its nodes start, and those that are there.
    cell: usize,
    start: usize,
    begun: Vec<u32>,
}

/// Numbers that grow, most often by one.
#[derive(Default)]
pub(crate) struct Runs(Vec<Range<usize>>);

impl Runs {
    fn push(&mut self, number: usize) {
        match self.0.last_mut() {
            Some(last) if last.end == number => last.end += 1,
            _ => self.0.push(number..number + 1),
        }
    }

    pub fn runs(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        self.0.iter().cloned()
    }

    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        self.runs().flatten()
    }
}

impl Cells {
    /// Begins the nodes of these cells: so many, of so many points.
    pub fn begin(&mut self, points: usize, nodes: usize) {
        self.counts = [points, nodes];
        let most = self.kinds.len().min(nodes / 3);
        self.assembly.mesh.triangles.reserve(most);
        self.assembly.mesh.triangle_tags.reserve(most);
    }

    /// Takes nodes.
    pub fn take(&mut self, mut nodes: &[i64]) {
        while self.wrong.is_none() && self.cell < self.ends.len().min(self.kinds.len()) {
            let Some(end) = self.end() else { return };
            let missing = end - self.start - self.begun.len();
            let (these, others) = nodes.split_at(missing.min(nodes.len()));
            if !self.begin_cell(these) || these.len() < missing {
                return;
            }
            nodes = others;
            self.finish_cell();
            self.start = end;
            self.cell += 1;
        }
    }

    /// Where the nodes of the next cell end.
    fn end(&mut self) -> Option<usize> {
        let end = self.ends.at(self.cell);
        let sound =
            usize::try_from(end).ok().filter(|end| (self.start..=self.counts[1]).contains(end));
        if sound.is_none() {
            self.wrong = Some(wrong(Part::Ends, self.cell, "the number of nodes so far", end));
        }
        sound
    }

    /// Takes some nodes of the next cell; false where one is no point.
    fn begin_cell(&mut self, nodes: &[i64]) -> bool {
        for &node in nodes {
            match u32::try_from(node) {
                Ok(point) if (point as usize) < self.counts[0] => self.begun.push(point),
                _ => {
                    let index = self.start + self.begun.len();
                    self.wrong = Some(wrong(Part::Nodes, index, "a point", node));
                    return false;
                }
            }
        }
        true
    }

    /// Takes the next cell, of which all nodes are there.
    fn finish_cell(&mut self) {
        let (cell, kind) = (self.cell, self.kinds.at(self.cell));
        match pieces(kind, self.begun.len()) {
            Some(Pieces::Points) => {
                self.points.extend(self.begun.iter().map(|&node| (node, cell)));
            }
            Some(Pieces::Chain) => {
                for pair in self.begun.windows(2) {
                    self.edges.push(cell);
                    self.assembly.push(Shape::Edge, pair, 0);
                }
            }
            Some(Pieces::One(shape)) => {
                self.assembly.push(shape, &self.begun, 0);
                match shape {
                    Shape::Edge => self.edges.push(cell),
                    _ => self.triangles.push(cell),
                }
            }
            None => {
                let found = format!("{kind} ({}) of {} nodes", kind_name(kind), self.begun.len());
                let expected = "3 (line), 5 (triangle) or 1 (vertex)";
                self.wrong = Some(wrong(Part::Kinds, cell, expected, found));
            }
        }
        self.begun.clear();
    }

    /// The edges and triangles with their tags, and the points that have one.
    pub(super) fn tagged(&mut self, tags: &Tags) -> Assembly {
        let mut assembly = std::mem::take(&mut self.assembly);
        let mesh = &mut assembly.mesh;
        for (of_shape, cells) in
            [(&mut mesh.edge_tags, &self.edges), (&mut mesh.triangle_tags, &self.triangles)]
        {
            of_shape.iter_mut().zip(cells.iter()).for_each(|(tag, cell)| *tag = tags.of(cell));
        }
        for &(node, cell) in &self.points {
            assembly.push(Shape::Point, &[node], tags.of(cell));
        }
        assembly
    }
}

/// What a cell is to a mesh.
enum Pieces {
    /// A point for each node.
    Points,
    /// An edge from each node to the next.
    Chain,
    One(Shape),
}

fn pieces(kind: i64, nodes: usize) -> Option<Pieces> {
    Some(match (kind, nodes) {
        (1, 1) | (2, _) => Pieces::Points,
        (3, 2) => Pieces::One(Shape::Edge),
        (4, 2..) => Pieces::Chain,
        (21, 3) | (35, 4) | (68, 2..) => Pieces::One(Shape::Edge),
        (5 | 7, 3) | (22, 6) | (34, 7) | (69, 3..) => Pieces::One(Shape::Triangle),
        _ => return None,
    })
}

/// VTK's name of a kind of cells.
fn kind_name(kind: i64) -> &'static str {
    match kind {
        1 => "vertex",
        3 => "line",
        4 => "polyline",
        5 => "triangle",
        6 => "triangle strip",
        7 => "polygon",
        8 => "pixel",
        9 => "quadrilateral",
        10 => "tetrahedron",
        11 => "voxel",
        12 => "hexahedron",
        13 => "wedge",
        14 => "pyramid",
        21 => "quadratic edge",
        22 => "quadratic triangle",
        23 => "quadratic quadrilateral",
        24 => "quadratic tetrahedron",
        _ => "another kind",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of these kinds and ends, of four points, whose nodes come in blocks of a length.
    fn cells(kinds: &[i64], ends: &[i64], nodes: &[i64], length: usize) -> Cells {
        let mut cells = Cells::default();
        cells.kinds.extend(kinds);
        cells.ends.extend(ends);
        cells.begin(4, nodes.len());
        nodes.chunks(length).for_each(|block| cells.take(block));
        cells.take(&[]);
        cells
    }

    #[test]
    fn nodes_come_in_blocks_of_any_length() {
        for length in 1..9 {
            // No points, a line, a triangle, a chain of two lines, no points.
            let (kinds, ends) = ([2, 3, 5, 4, 2], [0, 2, 5, 8, 8]);
            let cells = cells(&kinds, &ends, &[0, 1, 1, 2, 3, 3, 0, 2], length);
            assert!(cells.wrong.is_none());
            let mesh = &cells.assembly.mesh;
            assert_eq!(mesh.edges, [[0, 1], [3, 0], [0, 2]]);
            assert_eq!(mesh.triangles, [[1, 2, 3]]);
            assert_eq!(cells.edges.iter().collect::<Vec<_>>(), [1, 3, 3]);
            assert_eq!(cells.triangles.iter().collect::<Vec<_>>(), [2]);
        }
    }

    #[test]
    fn the_first_number_that_means_nothing_is_the_one_to_name() {
        let wrong = |kinds: &[i64], ends: &[i64], nodes: &[i64]| {
            let wrong = cells(kinds, ends, nodes, 2).wrong.expect("something is wrong");
            (wrong.part, wrong.index, wrong.found)
        };
        let found = wrong(&[3, 5], &[2, 5], &[0, 1, 2, 4, -1]);
        assert_eq!(found, (Part::Nodes, 3, "4".to_owned()));
        assert_eq!(wrong(&[3, 3], &[2, 1], &[0, 1]), (Part::Ends, 1, "1".to_owned()));
        assert_eq!(wrong(&[3], &[3], &[0, 1]), (Part::Ends, 0, "3".to_owned()));
        let found = wrong(&[3, 9], &[2, 6], &[0, 1, 0, 1, 2, 3]);
        assert_eq!(found, (Part::Kinds, 1, "9 (quadrilateral) of 4 nodes".to_owned()));
    }
}
