//! Good meshes for faults to be planted in.

use meshwright::formats::{Group, Membership, Region, poly};
use meshwright::{Mesh, Parameters, Pslg};

pub type Point = [f64; 2];

/// A mesh, the outline it is a mesh of, and a name for messages.
#[derive(Clone)]
pub struct Subject {
    pub name: &'static str,
    pub pslg: Pslg,
    pub mesh: Mesh,
}

/// A sequence of random numbers that is the same everywhere (splitmix64).
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `n`.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }

    /// One of the items.
    pub fn pick<T: Copy>(&mut self, items: &[T]) -> T {
        items[self.below(items.len())]
    }

    /// From −1 to 1.
    pub fn signed(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// Twice the area of a triangle, positive if it is counter-clockwise.
pub fn area(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Positive if `d` is inside the circle through `a`, `b`, `c`.
pub fn in_circle(a: Point, b: Point, c: Point, d: Point) -> f64 {
    let [a, b, c] = [a, b, c].map(|p| [p[0] - d[0], p[1] - d[1]]);
    let cross = |p: Point, q: Point| p[0] * q[1] - p[1] * q[0];
    let square = |p: Point| p[0] * p[0] + p[1] * p[1];
    square(a) * cross(b, c) + square(b) * cross(c, a) + square(c) * cross(a, b)
}

/// Each of the meshes.
pub fn subjects(random: &mut Random) -> [Subject; 4] {
    [plate(random), wedge(), block(random), lake()]
}

/// Lake Superior, refined.
fn lake() -> Subject {
    let text = include_bytes!("../../examples/lake_superior.poly");
    let alone = |_: &str| Err(std::io::ErrorKind::NotFound.into());
    let (pslg, _) = poly::read(text, "lake_superior.poly", alone).unwrap();
    let mesh = meshwright::mesh(&pslg, &Parameters::default()).unwrap().mesh;
    Subject { name: "lake", pslg, mesh }
}

/// A plate of 12 × 7 squares with a square hole, an interface at x = 6 and a slit on the left.
fn plate(random: &mut Random) -> Subject {
    let outline = [[0.0, 0.0], [6.0, 0.0], [12.0, 0.0], [12.0, 7.0], [6.0, 7.0], [0.0, 7.0]];
    let hole = [[4.0, 2.0], [5.0, 2.0], [5.0, 3.0], [4.0, 3.0]];
    let slit = [[1.0, 5.0], [4.0, 5.0]];
    let pslg = Pslg {
        points: [&outline[..], &hole[..], &slit[..]].concat(),
        segments: [
            [0, 1],
            [1, 2],
            [2, 3],
            [3, 4],
            [4, 5],
            [5, 0],
            [1, 4],
            [6, 7],
            [7, 8],
            [8, 9],
            [9, 6],
            [10, 11],
        ]
        .to_vec(),
        segment_tags: vec![1, 1, 2, 3, 3, 2, 7, 1, 2, 3, 2, -5],
        holes: vec![[4.5, 2.5]],
        regions: vec![region([1.0, 1.0], 10), region([7.0, 1.0], 20)],
        groups: vec![
            Group { dim: 1, tag: 7, name: "membrane".to_owned() },
            Group { dim: 1, tag: 9, name: "wet".to_owned() },
            Group { dim: 0, tag: 9, name: "gauges".to_owned() },
        ],
        memberships: vec![
            member(0, 2, 9),
            member(0, 10, 9),
            member(0, 10, 8),
            member(1, 6, 9),
            member(1, 1, 9),
            member(1, 1, 4),
        ],
        ..Pslg::default()
    };
    let grid = Grid { columns: 12, rows: 7, corner: [0.0, 0.0], step: 1.0, hole: Some([4, 2]) };
    let mut mesh = grid.mesh(&pslg, random);
    mesh.triangle_tags = mesh
        .triangles
        .iter()
        .map(|t| if t.iter().all(|v| mesh.points[*v as usize][0] >= 6.0) { 20 } else { 10 })
        .collect();
    Subject { name: "plate", pslg, mesh }
}

/// Two segments at about 20°, closed by a third.
fn wedge() -> Subject {
    // Slopes and distances with few bits: every point lies exactly on its segment.
    let (up, down) = (13.0 / 64.0, -9.0 / 64.0);
    let radii: Vec<f64> =
        std::iter::successors(Some(8.0), |r: &f64| Some((r * 1.36 * 8.0).round() / 8.0))
            .take(14)
            .collect();
    let end = *radii.last().unwrap();
    let pslg = Pslg {
        points: vec![[0.0, 0.0], [end, end * up], [end, end * down]],
        segments: vec![[0, 1], [2, 0], [1, 2]],
        segment_tags: vec![1, 2, 3],
        ..Pslg::default()
    };
    let mut mesh = Mesh { points: pslg.points.clone(), ..Mesh::default() };
    let mut rungs = vec![[0, 0]];
    for &r in &radii[..radii.len() - 1] {
        let v = mesh.points.len() as u32;
        mesh.points.extend([[r, r * up], [r, r * down]]);
        rungs.push([v, v + 1]);
    }
    rungs.push([1, 2]);
    for pair in rungs.windows(2) {
        let ([a, b], [c, d]) = (pair[0], pair[1]);
        let at = |v: u32| mesh.points[v as usize];
        if a == b {
            mesh.triangles.push([a, d, c]);
        } else if in_circle(at(b), at(d), at(c), at(a)) > 0.0 {
            mesh.triangles.extend([[a, b, d], [a, d, c]]);
        } else {
            mesh.triangles.extend([[b, d, c], [b, c, a]]);
        }
        mesh.edges.extend([[a, c], [d, b]]);
        mesh.edge_tags.extend([1, 2]);
        mesh.edge_segments.extend([0, 1]);
    }
    mesh.edges.push([1, 2]);
    mesh.edge_tags.push(3);
    mesh.edge_segments.push(2);
    mesh.triangle_tags = vec![0; mesh.triangles.len()];
    Subject { name: "wedge", pslg, mesh }
}

/// A block of 9 × 9 squares far from the origin, in metres.
fn block(random: &mut Random) -> Subject {
    let (x, y) = (431_200.5, 5_402_310.25);
    let (right, top) = (x + 9.0 * 0.75, y + 9.0 * 0.75);
    let pslg = Pslg {
        points: vec![[x, y], [right, y], [right, top], [x, top], [x + 0.75, y + 1.5]],
        segments: vec![[1, 0], [1, 2], [2, 3], [0, 3]],
        segment_tags: vec![1, 1, 2, 2],
        regions: vec![region([x + 1.0, y + 1.0], 20)],
        ..Pslg::default()
    };
    let grid = Grid { columns: 9, rows: 9, corner: [x, y], step: 0.75, hole: None };
    let mut mesh = grid.mesh(&pslg, random);
    mesh.triangle_tags = vec![20; mesh.triangles.len()];
    Subject { name: "block", pslg, mesh }
}

/// A point or an edge in a group.
pub fn member(dim: u8, item: u32, tag: i32) -> Membership {
    Membership { dim, item, tag }
}

fn region(seed: Point, tag: i32) -> Region {
    Region { seed, tag, attribute: f64::from(tag), max_area: None }
}

/// A grid of squares, each cut into two triangles.
struct Grid {
    columns: usize,
    rows: usize,
    corner: Point,
    step: f64,
    /// The square that is left out.
    hole: Option<[usize; 2]>,
}

impl Grid {
    /// Points on no segment are moved by up to a tenth of a square; then each square is cut
    /// along the diagonal that is Delaunay.
    fn mesh(&self, pslg: &Pslg, random: &mut Random) -> Mesh {
        let mut mesh = Mesh { points: pslg.points.clone(), ..Mesh::default() };
        let mut number = Vec::new();
        for row in 0..=self.rows {
            for column in 0..=self.columns {
                let p = [
                    self.corner[0] + column as f64 * self.step,
                    self.corner[1] + row as f64 * self.step,
                ];
                let known = mesh.points.iter().position(|q| *q == p);
                number.push(known.unwrap_or_else(|| {
                    mesh.points.push(p);
                    mesh.points.len() - 1
                }) as u32);
            }
        }
        self.list_edges(pslg, &mut mesh);
        let mut fixed = vec![false; mesh.points.len()];
        fixed[..pslg.points.len()].fill(true);
        mesh.edges.iter().flatten().for_each(|&v| fixed[v as usize] = true);
        for p in (0..mesh.points.len()).filter(|&v| !fixed[v]) {
            mesh.points[p] = mesh.points[p].map(|x| x + 0.1 * self.step * random.signed());
        }
        let at = |column: usize, row: usize| number[row * (self.columns + 1) + column];
        for row in 0..self.rows {
            for column in (0..self.columns).filter(|&column| self.hole != Some([column, row])) {
                let [a, b, c, d] = [
                    at(column, row),
                    at(column + 1, row),
                    at(column + 1, row + 1),
                    at(column, row + 1),
                ];
                let [p, q, r, s] = [a, b, c, d].map(|v| mesh.points[v as usize]);
                let cut = if in_circle(p, q, r, s) > 0.0 {
                    [[a, b, d], [b, c, d]]
                } else {
                    [[a, b, c], [a, c, d]]
                };
                mesh.triangles.extend(cut);
            }
        }
        mesh
    }

    /// The pieces of the (level or upright) segments.
    fn list_edges(&self, pslg: &Pslg, mesh: &mut Mesh) {
        for (s, ends) in pslg.segments.iter().enumerate() {
            let [a, b] = ends.map(|v| pslg.points[v as usize]);
            let along = |p: &Point| (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]);
            let mut on: Vec<u32> = (0..mesh.points.len() as u32)
                .filter(|&v| {
                    let p = mesh.points[v as usize];
                    (0..2).all(|i| p[i] >= a[i].min(b[i]) && p[i] <= a[i].max(b[i]))
                })
                .collect();
            on.sort_by(|v, w| {
                along(&mesh.points[*v as usize]).total_cmp(&along(&mesh.points[*w as usize]))
            });
            for pair in on.windows(2) {
                mesh.edges.push([pair[0], pair[1]]);
                mesh.edge_tags.push(pslg.segment_tags[s]);
                mesh.edge_segments.push(s as u32);
            }
        }
        mesh.memberships.extend(pslg.memberships.iter().filter(|m| m.dim == 0));
        for (edge, &s) in (0..).zip(&mesh.edge_segments) {
            let of_segment = pslg.memberships.iter().filter(|m| (m.dim, m.item) == (1, s));
            mesh.memberships.extend(of_segment.map(|m| member(1, edge, m.tag)));
        }
    }
}
