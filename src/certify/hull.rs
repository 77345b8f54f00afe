//! The boundary of the convex hull, as far as doubles can tell.
//!
//! A point beside a hull edge that is nearer to it than 2φ belongs to the boundary: an edge that
//! passes it at rounding distance would ask for triangles as thin as that. (Two features that near
//! limit their surroundings anywhere else; see `precision`.)

use super::exact;

/// The directions in which edges of a convex boundary run: in each of them they follow one
/// another along one axis.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Run {
    East,
    North,
    West,
    South,
}

/// An edge, by the stretch that it covers along the axis of its run.
struct Stretch {
    run: Run,
    low: f64,
    high: f64,
    edge: usize,
}

/// The edges of a convex boundary, through every one of the `others` that is nearer to one of
/// them than `closest`, in the order along it.
pub(super) fn through_near_points(
    edges: &[[u32; 2]],
    points: &[[f64; 2]],
    others: impl Iterator<Item = u32>,
    closest: f64,
) -> Vec<[u32; 2]> {
    let at = |v: u32| points[v as usize];
    let mut stretches: Vec<Stretch> =
        edges.iter().enumerate().map(|(i, e)| stretch(i, e.map(at))).collect();
    stretches.sort_by(|a, b| a.run.cmp(&b.run).then(a.low.total_cmp(&b.low)));
    let mut beside: Vec<(usize, f64, u32)> = Vec::new();
    for v in others {
        let near = stretches.chunk_by(|a, b| a.run == b.run).filter_map(|run| {
            let along = at(v)[axis(run[0].run)];
            let place = run.partition_point(|stretch| stretch.low <= along).checked_sub(1)?;
            let stretch = run.get(place).filter(|stretch| along <= stretch.high)?;
            let [a, b] = edges[stretch.edge].map(at);
            let length = libm::hypot(b[0] - a[0], b[1] - a[1]);
            let height = exact::cross(a, b, at(v)).to_f64().abs() / length;
            let foot = (at(v)[0] - a[0]) * (b[0] - a[0]) + (at(v)[1] - a[1]) * (b[1] - a[1]);
            (height < closest && 0.0 < foot && foot < length * length).then_some((
                height,
                stretch.edge,
                foot,
            ))
        });
        if let Some((_, edge, foot)) = near.min_by(|a, b| a.0.total_cmp(&b.0)) {
            beside.push((edge, foot, v));
        }
    }
    beside.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut chain = Vec::with_capacity(edges.len() + beside.len());
    for (i, &[a, b]) in edges.iter().enumerate() {
        let own = beside.partition_point(|b| b.0 < i)..beside.partition_point(|b| b.0 <= i);
        let stops: Vec<u32> = std::iter::once(a)
            .chain(beside[own].iter().map(|b| b.2))
            .chain(std::iter::once(b))
            .collect();
        chain.extend(stops.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    chain
}

fn axis(run: Run) -> usize {
    usize::from(matches!(run, Run::North | Run::South))
}

fn stretch(edge: usize, [a, b]: [[f64; 2]; 2]) -> Stretch {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let run = match (dx.abs() >= dy.abs(), dx > 0.0, dy > 0.0) {
        (true, true, _) => Run::East,
        (true, false, _) => Run::West,
        (false, _, true) => Run::North,
        (false, _, false) => Run::South,
    };
    let (from, to) = (a[axis(run)], b[axis(run)]);
    Stretch { run, low: from.min(to), high: from.max(to), edge }
}
