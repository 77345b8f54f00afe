//! The outlines of faces: the edges that belong to one face alone.

/// The edges of faces.
#[derive(Default)]
pub struct Faces {
    edges: Vec<Edge>,
}

/// An edge of a face.
#[derive(Clone, Copy)]
pub struct Edge {
    /// Its vertices.
    pub ends: [u32; 2],
    /// The group of its face.
    pub group: u32,
    /// The line of its face.
    pub line: u32,
}

impl Faces {
    /// Takes an edge of a face.
    pub fn edge(&mut self, ends: [u32; 2], group: u32, line: u32) {
        self.edges.push(Edge { ends, group, line });
    }

    /// The edges that belong to one face alone, in the order of the file. Vertices at one place
    /// count as one: exporters give every face its own.
    pub fn outline(self, vertices: &[[f64; 2]], heights: &[f64]) -> Vec<Edge> {
        if self.edges.is_empty() {
            return self.edges;
        }
        let same = first_at_place(vertices, heights);
        let key = |edge: &Edge| {
            let [a, b] = edge.ends.map(|end| same[end as usize]);
            [a.min(b), a.max(b)]
        };
        let mut sorted: Vec<[u32; 2]> = self.edges.iter().map(key).collect();
        sorted.sort_unstable();
        let mut edges = self.edges;
        edges.retain(|edge| {
            let first = sorted.partition_point(|other| *other < key(edge));
            sorted.get(first + 1) != Some(&sorted[first])
        });
        edges
    }
}

/// For each vertex the first one at the same place.
fn first_at_place(vertices: &[[f64; 2]], heights: &[f64]) -> Vec<u32> {
    // −0 is at the place of 0.
    let place = |vertex: u32| {
        let [x, y] = vertices[vertex as usize];
        [x, y, heights[vertex as usize]].map(|coordinate| (coordinate + 0.0).to_bits())
    };
    let mut sorted: Vec<u32> = (0..vertices.len() as u32).collect();
    sorted.sort_unstable_by_key(|&vertex| (place(vertex), vertex));
    let mut same = vec![0; vertices.len()];
    for group in sorted.chunk_by(|&v, &w| place(v) == place(w)) {
        group.iter().for_each(|&vertex| same[vertex as usize] = group[0]);
    }
    same
}
