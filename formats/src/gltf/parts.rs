//! The vertices and indices of each group.

use std::cmp::Reverse;
use std::io;

use crate::groups::Table;
use crate::mesh::Mesh;

/// How coordinates become single precision: position = (coordinate − origin) / scale.
pub(super) struct Frame {
    pub origin: [f64; 2],
    pub scale: f64,
}

impl Frame {
    /// The frame of the middle of the points.
    pub fn of(points: &[[f64; 2]]) -> Self {
        let mut least = [f64::INFINITY; 2];
        let mut most = [f64::NEG_INFINITY; 2];
        for point in points {
            for axis in 0..2 {
                least[axis] = least[axis].min(point[axis]);
                most[axis] = most[axis].max(point[axis]);
            }
        }
        if points.is_empty() {
            return Self { origin: [0.0; 2], scale: 1.0 };
        }
        let origin = [0, 1].map(|axis| least[axis] / 2.0 + most[axis] / 2.0);
        let reach = (most[0] - origin[0]).max(most[1] - origin[1]);
        Self { origin, scale: scale(reach) }
    }

    pub fn position(&self, point: [f64; 2]) -> [f32; 3] {
        let axis = |axis: usize| ((point[axis] - self.origin[axis]) / self.scale) as f32;
        [axis(0), axis(1), 0.0]
    }
}

/// 1 where single precision can hold the mesh with its details; else a power of two near its size.
fn scale(reach: f64) -> f64 {
    if reach == 0.0 || (1e-20..1e20).contains(&reach) {
        return 1.0;
    }
    // The power of two whose exponent is that of the reach; at least the smallest normal number.
    f64::from_bits(reach.max(f64::MIN_POSITIVE).to_bits() & 0x7ff0_0000_0000_0000)
}

/// What is drawn of one group.
pub(super) struct Part {
    /// The group, as an index into the table's entries.
    pub group: usize,
    /// The mesh's points that the part uses, by index.
    pub vertices: Vec<u32>,
    /// Indices into `vertices`: two for each line, three for each triangle.
    pub indices: Vec<u32>,
    /// The colour of all vertices, or of each.
    pub color: Color,
    /// The smallest and the largest position, axis by axis.
    pub least: [f32; 3],
    pub most: [f32; 3],
}

/// The colours of a part.
pub(super) enum Color {
    One([u8; 4]),
    Each(Vec<[u8; 4]>),
}

impl Part {
    /// Bytes of positions, of colours and of indices; all of them multiples of four.
    pub fn sizes(&self) -> [u64; 3] {
        let (vertices, indices) = (self.vertices.len() as u64, self.indices.len() as u64);
        [12 * vertices, 4 * vertices, 4 * indices]
    }

    pub fn bytes(&self) -> u64 {
        self.sizes().iter().sum()
    }

    /// Lets no two triangles share a vertex, so that each corner has a colour of its own.
    fn give_corners_to_triangles(&mut self, colors: Vec<[u8; 4]>) {
        self.vertices = self.indices.iter().map(|&index| self.vertices[index as usize]).collect();
        self.indices = (0..self.vertices.len() as u32).collect();
        self.color = Color::Each(colors);
    }

    /// Writes positions, colours and indices.
    pub fn write(
        &self,
        mesh: &Mesh,
        frame: &Frame,
        take: &mut dyn FnMut(&[u8]) -> io::Result<()>,
    ) -> io::Result<()> {
        let mut buffer = Vec::new();
        let mut hand_on = |buffer: &mut Vec<u8>| {
            take(buffer)?;
            buffer.clear();
            io::Result::Ok(())
        };
        for block in self.vertices.chunks(BLOCK) {
            let positions =
                block.iter().map(|&vertex| frame.position(mesh.points[vertex as usize]));
            buffer.extend(positions.flatten().flat_map(f32::to_le_bytes));
            hand_on(&mut buffer)?;
        }
        let color = |vertex: usize| match &self.color {
            Color::One(color) => *color,
            Color::Each(colors) => colors[vertex],
        };
        for block in (0..self.vertices.len()).step_by(BLOCK) {
            let block = block..(block + BLOCK).min(self.vertices.len());
            buffer.extend(block.flat_map(color));
            hand_on(&mut buffer)?;
        }
        for block in self.indices.chunks(BLOCK) {
            buffer.extend(block.iter().flat_map(|index| index.to_le_bytes()));
            hand_on(&mut buffer)?;
        }
        Ok(())
    }
}

/// Numbers that are gathered before they are handed on.
const BLOCK: usize = 1 << 14;

/// The parts of all groups that have cells, regions first, else in the order of the table; triangles
/// in their own `colors`, where there are some.
pub(super) fn parts(
    mesh: &Mesh,
    table: &Table,
    frame: &Frame,
    colors: Option<&[[u8; 4]]>,
) -> Vec<Part> {
    let mut corners: Vec<Vec<u32>> = vec![Vec::new(); table.entries.len()];
    for (edge, &group) in mesh.edges.iter().zip(&table.edges) {
        corners[group as usize].extend(edge);
    }
    let mut own: Vec<Vec<[u8; 4]>> = vec![Vec::new(); table.entries.len()];
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        let group = table.region(mesh.triangle_tag(index));
        corners[group].extend(triangle);
        if let Some(colors) = colors {
            own[group].extend([linear(colors.get(index).copied().unwrap_or(NO_COLOR)); 3]);
        }
    }
    let mut local = vec![u32::MAX; mesh.points.len()];
    let used = corners.into_iter().enumerate().filter(|(_, corners)| !corners.is_empty());
    let mut used: Vec<(usize, Vec<u32>)> = used.collect();
    // What is drawn later covers what lies at the same place: lines come last.
    used.sort_by_key(|&(group, _)| Reverse(table.entries[group].dim));
    let parts = used.into_iter().map(|(group, corners)| {
        let dim = table.entries[group].dim;
        let colors = std::mem::take(&mut own[group]);
        let mut part = part(group, corners, dim, mesh, frame, &mut local);
        if !colors.is_empty() {
            part.give_corners_to_triangles(colors);
        }
        part
    });
    parts.collect()
}

/// One part; `local` is all `u32::MAX` before and after.
fn part(
    group: usize,
    mut corners: Vec<u32>,
    dim: u8,
    mesh: &Mesh,
    frame: &Frame,
    local: &mut [u32],
) -> Part {
    let mut vertices = Vec::new();
    let (mut least, mut most) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
    for corner in &mut corners {
        let place = &mut local[*corner as usize];
        if *place == u32::MAX {
            *place = vertices.len() as u32;
            vertices.push(*corner);
            let position = frame.position(mesh.points[*corner as usize]);
            for axis in 0..3 {
                least[axis] = least[axis].min(position[axis]);
                most[axis] = most[axis].max(position[axis]);
            }
        }
        *corner = *place;
    }
    for &vertex in &vertices {
        local[vertex as usize] = u32::MAX;
    }
    let color: &[[u8; 4]] = if dim == 1 { &LINES } else { &REGIONS };
    let color = Color::One(linear(color[group % color.len()]));
    Part { group, vertices, indices: corners, color, least, most }
}

/// The colour of what is given none.
const NO_COLOR: [u8; 4] = [217, 217, 217, 255];

/// Colours that tell neighbours apart, light for regions and dark for boundaries.
const REGIONS: [[u8; 4]; 8] = [
    [166, 206, 227, 255],
    [178, 223, 138, 255],
    [253, 191, 111, 255],
    [202, 178, 214, 255],
    [251, 154, 153, 255],
    [255, 237, 160, 255],
    [153, 216, 201, 255],
    [217, 217, 217, 255],
];
const LINES: [[u8; 4]; 6] = [
    [31, 60, 120, 255],
    [140, 30, 30, 255],
    [20, 100, 40, 255],
    [90, 40, 120, 255],
    [150, 80, 10, 255],
    [40, 40, 40, 255],
];

/// The colour that glTF holds for one as it is seen: its channels count light.
fn linear([red, green, blue, opacity]: [u8; 4]) -> [u8; 4] {
    let [red, green, blue] = [red, green, blue].map(|channel| LINEAR[usize::from(channel)]);
    [red, green, blue, opacity]
}

/// The light of each channel of sRGB (IEC 61966-2-1), from 0 to 255.
#[rustfmt::skip]
const LINEAR: [u8; 256] = [
    0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3,
    4, 4, 4, 4, 4, 5, 5, 5, 5, 6, 6, 6, 6, 7, 7, 7, 8, 8, 8, 8, 9, 9, 9, 10, 10, 10, 11, 11, 12, 12,
    12, 13, 13, 13, 14, 14, 15, 15, 16, 16, 17, 17, 17, 18, 18, 19, 19, 20, 20, 21, 22, 22, 23, 23,
    24, 24, 25, 25, 26, 27, 27, 28, 29, 29, 30, 30, 31, 32, 32, 33, 34, 35, 35, 36, 37, 37, 38, 39,
    40, 41, 41, 42, 43, 44, 45, 45, 46, 47, 48, 49, 50, 51, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60,
    61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 76, 77, 78, 79, 80, 81, 82, 84, 85, 86,
    87, 88, 90, 91, 92, 93, 95, 96, 97, 99, 100, 101, 103, 104, 105, 107, 108, 109, 111, 112, 114,
    115, 116, 118, 119, 121, 122, 124, 125, 127, 128, 130, 131, 133, 134, 136, 138, 139, 141, 142,
    144, 146, 147, 149, 151, 152, 154, 156, 157, 159, 161, 163, 164, 166, 168, 170, 171, 173, 175,
    177, 179, 181, 183, 184, 186, 188, 190, 192, 194, 196, 198, 200, 202, 204, 206, 208, 210, 212,
    214, 216, 218, 220, 222, 224, 226, 229, 231, 233, 235, 237, 239, 242, 244, 246, 248, 250, 253,
    255,
];

#[cfg(test)]
mod tests {
    use super::LINEAR;

    #[test]
    fn channels_count_light() {
        for (channel, light) in LINEAR.into_iter().enumerate() {
            let seen = channel as f64 / 255.0;
            let exact =
                if seen <= 0.04045 { seen / 12.92 } else { ((seen + 0.055) / 1.055).powf(2.4) };
            assert!((f64::from(light) - 255.0 * exact).abs() <= 0.5, "{channel}: {light}");
        }
    }
}
