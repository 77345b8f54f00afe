//! Assumption 2, Lemma 7, Corollary 3: an independent judge of finished meshes.
//!
//! [`certify`] judges any triangle mesh against any outline, [`certify_alone`] a mesh of which no
//! outline is known. Nothing here is shared with what makes meshes: the judge reads the outline
//! itself and has its own exact arithmetic. No mesh makes it fail: indices out of range,
//! coordinates that are no numbers, nothing at all are verdicts too.
//!
//! | | guarantee | judged in |
//! |-|-|-|
//! | G1 | the triangles are a complex and cover the domain | `complex`, `cover` |
//! | G2 | edges are locally Delaunay | `delaunay` |
//! | G3 | diametral discs of subsegments are empty | `delaunay` |
//! | G4 | segments, points, tags and groups of the outline are kept | `conformity`, `tags`, `memberships` |
//! | G5, G6 | Lemma 7 | `angles` |
//! | G7 | Corollary 3 | `angles` |
//! | G8 | Corollary 2 | `shortest` |
//! | G9 | points are of the kinds they are said to be | `provenance` |
//! | G10 | the stiffness matrix is an M-matrix | `delaunay` |

mod angles;
mod closest;
mod complex;
mod conformity;
mod cover;
mod delaunay;
mod edges;
mod exact;
mod fault;
mod frame;
mod hull;
mod memberships;
mod nearby;
mod nesting;
mod outline;
mod precision;
mod provenance;
mod roles;
mod screens;
mod sequences;
mod shortest;
mod tags;
mod verdict;
mod wording;

pub use fault::{Fault, FaultKind, Numbered};
pub use verdict::{
    Apex, Certificate, Corollary2, ExcusedAngle, Guarantee, Judgement, Kinds, Narrow, NarrowTo,
    Promise, Verdict,
};

use std::borrow::Cow;

use angles::{AngleJudgements, Angles, Laid};
use complex::Complex;
use conformity::Chains;
use frame::Frame;
use nearby::Nearby;
use outline::Outline;
use precision::Floor;

use crate::formats::{Mesh, Pslg};
use crate::parameters::Region;

/// Judges a mesh against the outline that it is a mesh of.
///
/// Every guarantee is judged (G8 and G9 only where the mesh says its points' kinds), and the mesh's
/// tags are compared with the outline's, and so are its memberships: of a mesh out of a file that
/// holds one group for each edge, judge against an outline without further ones. The work grows like
/// n log n. A mesh that is handed over, not lent, is judged in less memory: no copy stays beside it.
///
/// ```
/// use meshwright::certify::{Guarantee, Promise, Verdict, certify};
/// use meshwright::{Mesh, Pslg};
///
/// let pslg = Pslg {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
///     segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
///     segment_tags: vec![1, 1, 2, 2],
///     ..Pslg::default()
/// };
/// let mut mesh = Mesh {
///     points: pslg.points.clone(),
///     triangles: vec![[0, 1, 2], [0, 2, 3]],
///     triangle_tags: vec![0, 0],
///     edges: pslg.segments.clone(),
///     edge_tags: pslg.segment_tags.clone(),
///     ..Mesh::default()
/// };
/// let promise = Promise::default();
/// assert!(certify(&pslg, &mesh, &promise).holds());
///
/// mesh.triangles[1] = [0, 3, 2];
/// let certificate = certify(&pslg, &mesh, &promise);
/// assert_eq!(certificate.verdict(Guarantee::Complex), Verdict::Fails);
/// assert_eq!(certificate.judgement(Guarantee::Complex).first[0].triangle, Some(1));
/// ```
#[must_use]
pub fn certify<'m>(pslg: &Pslg, mesh: impl Into<Cow<'m, Mesh>>, promise: &Promise) -> Certificate {
    let mesh = mesh.into();
    let not_judged = missing_tags(&mesh);
    let (nearby, at_input) = Nearby::new(pslg, mesh);
    let mut certificate = judge(&nearby, at_input, promise);
    certificate.not_judged = not_judged;
    nearby.restore(pslg, &mut certificate);
    certificate
}

fn judge(nearby: &Nearby, at_input: Vec<u32>, promise: &Promise) -> Certificate {
    let Nearby { pslg, mesh, .. } = nearby;
    let mut frame = Frame::new(&pslg.points);
    if promise.region != Region::Global {
        frame = frame.with_output(&mesh.points);
    }
    let outline = Outline::new(pslg, promise.region, frame);
    let [mut g1, mut g2, mut g3, mut g4, mut g5, mut g6, mut g7, mut g8, mut g9, mut g10] =
        Guarantee::ALL.map(Judgement::new);

    let complex = Complex::new(mesh, frame, &mut g1);
    let chains = conformity::judge(&outline, &complex, at_input, &mut g4);
    cover::judge(&outline, &complex, &chains, &mut g1);
    tags::judge_regions(nearby, &outline, &complex, &chains, &mut g4);
    memberships::judge(&outline, &complex, &chains, &mut g4);

    let floor = Floor::new(&outline, &complex, &chains);
    delaunay::judge_edges(Some(&outline), &complex, &chains, &floor, &mut g2);
    delaunay::judge_discs(Some(&outline), &complex, &chains, &floor, &mut g3);
    if promise.region == Region::Global {
        delaunay::judge_discs_of_all(Some(&outline), &complex, &chains, &floor, &mut g3);
    }

    let theta_star = outline.smallest_angle();
    let laid = Laid { outline: &outline, theta_star };
    let judgements = AngleJudgements { g5: &mut g5, g6: &mut g6, g7: &mut g7 };
    let angles =
        angles::judge(&complex, &chains, Some(laid), &floor, promise.min_angle, judgements);

    let corollary_2 =
        shortest::judge(&outline, &complex, &chains, &floor, promise, theta_star, &mut g8);
    let kinds = provenance::judge(&complex, &chains, &mut g9);
    delaunay::conclude_matrix(&g2, &g3, &mut g10);

    let judgements = vec![g1, g2, g3, g4, g5, g6, g7, g8, g9, g10];
    let mut certificate = conclude(mesh, promise, judgements, complex.area_outside(), angles);
    certificate.theta_star = Some(theta_star);
    certificate.corollary_2 = corollary_2;
    certificate.kinds = kinds;
    certificate.limited_triangles = complex.triangles.iter().filter(|t| floor.covers(*t)).count();
    certificate.apexes = floor.apexes;
    certificate.narrows = floor.narrows;
    certificate
}

/// Judges a mesh of which no outline is known: G1 (but not whether it covers what it should), G2,
/// G3, G7 and G10. The mesh's list of boundary and interface edges is taken for the subsegments.
#[must_use]
pub fn certify_alone<'m>(mesh: impl Into<Cow<'m, Mesh>>, promise: &Promise) -> Certificate {
    let nothing = Pslg::default();
    let (nearby, _) = Nearby::new(&nothing, mesh.into());
    let mut certificate = judge_alone(&nearby.mesh, promise);
    nearby.restore(&nothing, &mut certificate);
    certificate
}

fn judge_alone(mesh: &Mesh, promise: &Promise) -> Certificate {
    const REASON: &str = "it needs the outline";
    let frame = Frame::new(&mesh.points);
    let [mut g1, mut g2, mut g3, mut g4, mut g5, mut g6, mut g7, _, _, mut g10] =
        Guarantee::ALL.map(Judgement::new);

    let complex = Complex::new(mesh, frame, &mut g1);
    let chains = Chains::listed(&complex, &mut g4);
    cover::judge_gaps(&complex, &chains, &mut g1);

    let floor = Floor::none(&complex);
    delaunay::judge_edges(None, &complex, &chains, &floor, &mut g2);
    delaunay::judge_discs(None, &complex, &chains, &floor, &mut g3);
    if promise.region == Region::Global {
        delaunay::judge_discs_of_all(None, &complex, &chains, &floor, &mut g3);
    }

    let judgements = AngleJudgements { g5: &mut g5, g6: &mut g6, g7: &mut g7 };
    let angles = angles::judge(&complex, &chains, None, &floor, promise.min_angle, judgements);

    delaunay::conclude_matrix(&g2, &g3, &mut g10);
    let [g4, g5, g6, g8, g9] = [
        Guarantee::Conforming,
        Guarantee::SmallAngles,
        Guarantee::SmallestAngle,
        Guarantee::ShortestEdge,
        Guarantee::Provenance,
    ]
    .map(|guarantee| Judgement::not_judged(guarantee, REASON));
    let judgements = vec![g1, g2, g3, g4, g5, g6, g7, g8, g9, g10];
    let mut certificate = conclude(mesh, promise, judgements, complex.area_outside(), angles);
    certificate.not_judged = vec![
        "whether the mesh covers what it should (it needs the outline)",
        "whether the outline excuses the smallest angles (it needs the outline)",
    ];
    certificate
}

/// The certificate of a mesh that is not judged: it counts, and vouches for nothing.
#[must_use]
pub fn not_judged(mesh: &Mesh, promise: &Promise) -> Certificate {
    const REASON: &str = "it was not asked for";
    let judgements = Guarantee::ALL.map(|guarantee| Judgement::not_judged(guarantee, REASON));
    conclude(mesh, promise, judgements.into(), f64::NAN, Angles::default())
}

fn conclude(
    mesh: &Mesh,
    promise: &Promise,
    judgements: Vec<Judgement>,
    area: f64,
    angles: Angles,
) -> Certificate {
    Certificate {
        promise: *promise,
        judgements,
        points: mesh.points.len(),
        triangles: mesh.triangles.len(),
        area,
        smallest_angle: angles.smallest,
        largest_angle: angles.largest,
        theta_star: None,
        excused: angles.excused,
        kinds: None,
        corollary_2: None,
        apexes: Vec::new(),
        narrows: Vec::new(),
        limited_triangles: 0,
        not_judged: Vec::new(),
    }
}

/// What a mesh that carries no tags cannot be asked.
fn missing_tags(mesh: &Mesh) -> Vec<&'static str> {
    let mut missing = Vec::new();
    if mesh.edges.is_empty() {
        missing.push("boundary and interface edges (the mesh lists none)");
    } else if mesh.edge_tags.is_empty() {
        missing.push("tags of boundary and interface edges (the mesh has none)");
    }
    if mesh.triangle_tags.is_empty() && !mesh.triangles.is_empty() {
        missing.push("region tags (the mesh has none)");
    }
    missing
}

/// Sorts `items` by their first half, a number below `count`, keeping their order otherwise: those
/// of number v are `items[start[v]..start[v + 1]]`.
fn grouped<T: Copy + Default>(
    count: usize,
    items: impl Iterator<Item = (u32, T)> + Clone,
) -> (Vec<u32>, Vec<T>) {
    // One place further than they will stand, so that filling moves them to their places.
    let mut start = vec![0_u32; count + 2];
    for (v, _) in items.clone() {
        start[v as usize + 2] += 1;
    }
    for v in 2..start.len() {
        start[v] += start[v - 1];
    }
    let mut sorted = vec![T::default(); start[count + 1] as usize];
    for (v, item) in items {
        let place = &mut start[v as usize + 1];
        sorted[*place as usize] = item;
        *place += 1;
    }
    start.pop();
    (start, sorted)
}

#[cfg(test)]
mod tests;
