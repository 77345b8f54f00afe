//! Points by the cells of a square grid: which lie near a place, also while points are added.

use std::collections::BTreeMap;

/// Points in square cells.
#[derive(Debug)]
pub struct Grid {
    size: f64,
    cells: BTreeMap<[i64; 2], Vec<u32>>,
}

impl Grid {
    /// An empty grid. No search will reach farther than `size`, which is no smaller than the
    /// distance between doubles at the points.
    pub fn new(size: f64) -> Self {
        Self { size, cells: BTreeMap::new() }
    }

    /// Adds a point.
    pub fn add(&mut self, point: u32, place: [f64; 2]) {
        self.cells.entry(self.cell(place)).or_default().push(point);
    }

    /// The points that may lie within the grid's size of a place.
    pub fn near(&self, place: [f64; 2]) -> impl Iterator<Item = u32> {
        let [column, row] = self.cell(place);
        (column - 1..=column + 1).flat_map(move |column| {
            let cells = self.cells.range([column, row - 1]..=[column, row + 1]);
            cells.flat_map(|(_, points)| points.iter().copied())
        })
    }

    /// The cell of a place: coordinates are at most 2^53 sizes from the origin.
    fn cell(&self, place: [f64; 2]) -> [i64; 2] {
        place.map(|c| (c / self.size).floor() as i64)
    }
}
