//! The nodes of a mesh's cells, corners first: what writers number.
//!
//! Second-order cells have a node in the middle of each side, shared by the cells on both sides of
//! it. The order is the one of Gmsh, VTK, Abaqus, Medit and XDMF: corners, then the middles of the
//! sides 1–2, 2–3, 3–1.

use std::borrow::Cow;
use std::io;

use crate::mesh::{Data, Mesh, Values};

/// How many nodes cells have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Order {
    /// Corners alone: 2 for an edge, 3 for a triangle.
    #[default]
    First,
    /// A further node in the middle of each side: 3 for an edge, 6 for a triangle. Sides stay
    /// straight, also where the outline stands for a curve.
    Second,
}

/// The nodes of a mesh: its points, then the middles of sides.
pub(crate) struct Nodes<'a> {
    pub mesh: &'a Mesh,
    pub order: Order,
    /// The ends of the side that each further node is the middle of.
    pub sides: Vec<[u32; 2]>,
    /// The middles of each triangle's three sides, then that of each edge; empty for first order.
    middles: Vec<u32>,
}

impl<'a> Nodes<'a> {
    /// The nodes of a mesh.
    ///
    /// # Errors
    /// [`io::ErrorKind::FileTooLarge`] if there are more of them than 32 bits can number.
    pub fn new(mesh: &'a Mesh, order: Order) -> io::Result<Self> {
        let mut nodes = Self { mesh, order, sides: Vec::new(), middles: Vec::new() };
        if order == Order::Second {
            nodes.add_middles()?;
        }
        Ok(nodes)
    }

    fn add_middles(&mut self) -> io::Result<()> {
        let of_triangles =
            self.mesh.triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
        let sides = of_triangles.chain(self.mesh.edges.iter().copied());
        let mut places: Vec<([u32; 2], usize)> =
            sides.map(|[a, b]| [a.min(b), a.max(b)]).zip(0..).collect();
        places.sort_unstable();
        self.middles = vec![0; places.len()];
        for shared in places.chunk_by(|one, other| one.0 == other.0) {
            let node = self.mesh.points.len() + self.sides.len();
            let node = u32::try_from(node).map_err(|_| io::ErrorKind::FileTooLarge)?;
            self.sides.push(shared[0].0);
            for &(_, place) in shared {
                self.middles[place] = node;
            }
        }
        Ok(())
    }

    /// How many nodes there are.
    pub fn len(&self) -> usize {
        self.mesh.points.len() + self.sides.len()
    }

    /// The place of a node.
    pub fn point(&self, node: usize) -> [f64; 2] {
        let points = &self.mesh.points;
        match node.checked_sub(points.len()) {
            None => points[node],
            Some(middle) => {
                let [a, b] = self.sides[middle].map(|end| points[end as usize]);
                [0, 1].map(|axis| f64::midpoint(a[axis], b[axis]))
            }
        }
    }

    /// The places of all nodes.
    pub fn points(&self) -> impl Iterator<Item = [f64; 2]> {
        (0..self.len()).map(|node| self.point(node))
    }

    /// The nodes of an edge.
    pub fn edge(&self, edge: usize) -> impl Iterator<Item = u32> + Clone {
        let place = 3 * self.mesh.triangles.len() + edge;
        self.mesh.edges[edge].into_iter().chain(self.middles.get(place).copied())
    }

    /// The nodes of a triangle.
    pub fn triangle(&self, triangle: usize) -> impl Iterator<Item = u32> + Clone {
        let middles = self.middles.get(3 * triangle..3 * triangle + 3).unwrap_or_default();
        self.mesh.triangles[triangle].into_iter().chain(middles.iter().copied())
    }

    /// Data of points as data of all nodes: in the middle of a side the mean of its ends, or, for
    /// whole numbers, which have no mean, what both ends have in common, else 0.
    pub fn with_middles<'d>(&self, data: &'d Data) -> Cow<'d, Data> {
        if self.order == Order::First {
            return Cow::Borrowed(data);
        }
        let mut data = data.clone();
        let components = data.components;
        let at = |end: u32, i: usize| end as usize * components + i;
        let tuple = |&side: &[u32; 2]| (0..components).map(move |i| side.map(|end| at(end, i)));
        let places = self.sides.iter().flat_map(tuple);
        let length = self.mesh.points.len() * components;
        match &mut data.values {
            Values::Real(values) => {
                values.resize(length, f64::NAN);
                for [a, b] in places {
                    values.push(f64::midpoint(values[a], values[b]));
                }
            }
            Values::Integer(values) => {
                values.resize(length, 0);
                for [a, b] in places {
                    values.push(if values[a] == values[b] { values[a] } else { 0 });
                }
            }
        }
        Cow::Owned(data)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Mesh {
        Mesh {
            points: vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            edges: vec![[2, 1], [2, 0]],
            ..Mesh::default()
        }
    }

    #[test]
    fn cells_share_the_middles_of_their_sides() {
        let mesh = square();
        let nodes = Nodes::new(&mesh, Order::Second).unwrap();
        assert_eq!(nodes.len(), 9);
        let cell = |t| nodes.triangle(t).collect::<Vec<_>>();
        // Sides by their ends: 0–1 is 4, 0–2 is 5, 0–3 is 6, 1–2 is 7, 2–3 is 8.
        assert_eq!(cell(0), [0, 1, 2, 4, 7, 5]);
        assert_eq!(cell(1), [0, 2, 3, 5, 8, 6]);
        assert_eq!(nodes.edge(0).collect::<Vec<_>>(), [2, 1, 7]);
        assert_eq!(nodes.edge(1).collect::<Vec<_>>(), [2, 0, 5]);
        assert_eq!(nodes.point(5), [1.0, 1.0]);
    }

    #[test]
    fn first_order_cells_have_corners_alone() {
        let mesh = square();
        let nodes = Nodes::new(&mesh, Order::First).unwrap();
        assert_eq!(nodes.points().collect::<Vec<_>>(), mesh.points);
        assert_eq!(nodes.triangle(1).collect::<Vec<_>>(), [0, 2, 3]);
        assert_eq!(nodes.edge(0).collect::<Vec<_>>(), [2, 1]);
    }

    #[test]
    fn data_in_the_middle_are_means_or_what_ends_have_in_common() {
        let mesh = Mesh { points: vec![[0.0; 2]; 2], edges: vec![[0, 1]], ..Mesh::default() };
        let nodes = Nodes::new(&mesh, Order::Second).unwrap();
        let filled = |components, values| {
            let data = Data { name: "d".into(), components, values };
            nodes.with_middles(&data).into_owned().values
        };
        let real = filled(2, Values::Real(vec![1.0, 10.0, 2.0, 30.0]));
        assert_eq!(real, Values::Real(vec![1.0, 10.0, 2.0, 30.0, 1.5, 20.0]));
        let whole = filled(2, Values::Integer(vec![7, 1, 7, 3]));
        assert_eq!(whole, Values::Integer(vec![7, 1, 7, 3, 7, 0]));
    }

    #[test]
    fn the_middle_of_the_largest_numbers_is_finite() {
        let points = vec![[f64::MAX, -f64::MAX], [f64::MAX, f64::MAX]];
        let mesh = Mesh { points, edges: vec![[0, 1]], ..Mesh::default() };
        assert_eq!(Nodes::new(&mesh, Order::Second).unwrap().point(2), [f64::MAX, 0.0]);
    }
}
