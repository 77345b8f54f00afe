//! From an outline to a mesh: the whole way through.

use std::fmt;
use std::mem;
use std::ops::ControlFlow;

use crate::assemble::assemble;
use crate::carve::{carve, without_the_outside};
use crate::certify::{Certificate, Promise, certify, not_judged};
use crate::domain::{self, Domain};
use crate::predicates;
use crate::refine::counters::Counters;
use crate::refine::incremental::Introduction;
use crate::refine::segments::Segments;
use crate::refine::sizes::Sizes;
use crate::refine::sizing::Sizing;
use crate::refine::thin::{Thinned, thin};
use crate::refine::trace::{Event, Listener, Names};
use crate::refine::{End, Progress, Refinement, refine};
use crate::statistics::{Measured, Statistics};
use crate::triangulation::initial::{self, triangulate};
use crate::{Mesh, Parameters, Pslg, Region, Thinning};

/// What a run makes.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Outcome {
    /// The mesh.
    pub mesh: Mesh,
    /// What the judge, who shares no code with the refinement, found; nothing unless
    /// [`Parameters::judged`].
    pub certificate: Certificate,
    /// The smallest angle between two adjoining segments; `None` where none adjoin.
    pub smallest_input_angle: Option<InputAngle>,
    /// What was done to the outline, or is worth knowing about it.
    pub warnings: Vec<Warning>,
    /// Why the run ended: a mesh that was stopped early keeps no promise about its angles.
    pub end: End,
    /// Angles below the soft target that are not excused: attacking them was not safe.
    pub missed: Vec<Missed>,
    /// How many subsegments and triangles were left as they are at the precision floor.
    pub refused: usize,
    /// The points of the outline near which that was, zero-based. With [`Rule::Ruppert`] above
    /// what the outline's angles allow, this is where the rule goes on for ever.
    ///
    /// [`Rule::Ruppert`]: crate::Rule::Ruppert
    pub refused_at: Vec<u32>,
    /// What was done, counted.
    pub counters: Counters,
    /// With [`Parameters::incremental`]: points and segments in the order in which they were
    /// introduced, by the outline's indices.
    pub introduced: Vec<Introduction>,
    /// With [`Parameters::thinning`]: what it did; `None` too where the run ended early.
    pub thinned: Option<Thinned>,
    /// With [`Parameters::measured`], but for a domain that is scaled.
    measured: Option<Measured>,
}

impl Outcome {
    /// The mesh's counts and angles: counted now, and measured now unless [`Parameters::measured`].
    #[must_use]
    pub fn statistics(&self) -> Statistics {
        match self.measured {
            Some(measured) => Statistics::with(&self.mesh, measured),
            None => Statistics::of(&self.mesh),
        }
    }
}

/// An angle that misses the soft target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Missed {
    /// Its triangle, zero-based.
    pub triangle: u32,
    /// The angle.
    pub radians: f64,
}

/// An angle between two adjoining segments. Indices are those of the outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InputAngle {
    /// The common point.
    pub point: u32,
    /// The segments; `None` for an edge of the convex hull that the outline lacks.
    pub segments: [Option<u32>; 2],
    /// The angle.
    pub radians: f64,
}

impl InputAngle {
    fn smallest(domain: &Domain) -> Option<Self> {
        let input = |segment: u32| {
            Some(domain.input_segments[segment as usize]).filter(|&input| input != u32::MAX)
        };
        domain.smallest_angle().map(|angle| Self {
            point: domain.input_points[angle.apex as usize],
            segments: angle.segments.map(input),
            radians: angle.radians,
        })
    }
}

/// Why there is no mesh.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The outline is no PSLG, or encloses nothing.
    #[error(transparent)]
    Domain(#[from] domain::Error),
    /// The kernel cannot hold the outline.
    #[error(transparent)]
    Triangulation(#[from] initial::Error),
    /// A trace tells the refinement: a mesh that is thinned afterwards would be another one.
    #[error("a trace tells the refinement alone: no thinning may be asked for with it")]
    TraceOfThinning,
    /// The progress callback asked to stop.
    #[error("cancelled")]
    Cancelled,
}

/// Something that is worth knowing about a run, though it made a mesh.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Warning {
    /// About the outline.
    Domain(domain::Warning),
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Domain(warning) => warning.fmt(f),
        }
    }
}

/// Meshes an outline.
///
/// ```
/// use meshwright::{Parameters, Pslg};
/// let square = Pslg {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
///     segments: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
///     segment_tags: vec![7; 4],
///     ..Pslg::default()
/// };
/// let parameters = Parameters { max_area: Some(0.01), ..Parameters::default() };
/// let outcome = meshwright::mesh(&square, &parameters)?;
/// assert!(outcome.mesh.triangles.len() >= 100);
/// # Ok::<(), meshwright::Error>(())
/// ```
///
/// # Errors
/// See [`Error`].
pub fn mesh(pslg: &Pslg, parameters: &Parameters) -> Result<Outcome, Error> {
    mesh_with(pslg, parameters, &mut |_| ControlFlow::Continue(()))
}

/// [`mesh`], telling its progress now and then; the callback may stop it. Thinning that is stopped
/// leaves a whole mesh: [`Thinned::stopped`] tells so.
///
/// # Errors
/// See [`Error`].
pub fn mesh_with(
    pslg: &Pslg,
    parameters: &Parameters,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Outcome, Error> {
    run(pslg, parameters, progress, None)
}

/// [`mesh`], telling every step that the refinement takes, with its reason.
///
/// ```
/// use meshwright::refine::trace::{Event, Replay};
/// use meshwright::{Parameters, Pslg};
/// let needle = Pslg {
///     points: vec![[0.0, 0.0], [4.0, 0.0], [4.0, 1.0]],
///     segments: vec![[0, 1], [1, 2], [2, 0]],
///     segment_tags: vec![0; 3],
///     ..Pslg::default()
/// };
/// let mut replay = Replay::default();
/// let mut splits = 0;
/// let outcome = meshwright::trace(&needle, &Parameters::default(), &mut |event| {
///     splits += usize::from(matches!(event, Event::Split { .. }));
///     replay.apply(event).expect("it is one run's event");
/// })?;
/// assert!(splits > 0);
/// assert_eq!(replay.mesh().points, outcome.mesh.points);
/// # Ok::<(), meshwright::Error>(())
/// ```
///
/// # Errors
/// See [`Error`].
pub fn trace(
    pslg: &Pslg,
    parameters: &Parameters,
    hear: &mut dyn FnMut(&Event),
) -> Result<Outcome, Error> {
    if parameters.thinning != Thinning::None {
        return Err(Error::TraceOfThinning);
    }
    run(pslg, parameters, &mut |_| ControlFlow::Continue(()), Some(hear))
}

fn run(
    pslg: &Pslg,
    parameters: &Parameters,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    hear: Option<&mut dyn FnMut(&Event)>,
) -> Result<Outcome, Error> {
    let mut outcome = unjudged(pslg, parameters, progress, hear)?;
    if parameters.judged {
        outcome.certificate = certify(pslg, &outcome.mesh, &Promise::from(parameters));
    }
    Ok(outcome)
}

/// Everything but the judgement, which needs memory of its own.
fn unjudged(
    pslg: &Pslg,
    parameters: &Parameters,
    progress: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    hear: Option<&mut dyn FnMut(&Event)>,
) -> Result<Outcome, Error> {
    let (domain, warnings) = Domain::new(pslg, parameters.region)?;
    let exact_before = predicates::exact_answers();
    let smallest_input_angle = InputAngle::smallest(&domain);
    let (mut domain, initial) = triangulate(domain)?;
    if parameters.soft_angle.is_none() {
        domain.forget_points(); // the triangulation has them, and lfs is asked for that angle only
    }
    let domain = domain;
    let has_attributes = !pslg.point_attributes.is_empty();
    let kept = if has_attributes { initial.triangles.clone() } else { Vec::new() };
    let segments = Segments::of(&domain, &initial.points, domain.floor());
    let sizing = sizing(parameters, &domain);
    let sizes = Sizes::of(&domain, initial.points.len());
    let carved = carve(initial, &domain);

    let names = Names::new(&domain, pslg.points.len());
    let mut translate = hear.map(|hear| |event| hear(&names.translate(event)));
    let mut refinement = Refinement::new(carved, segments, sizing, sizes, &domain, parameters);
    if let Some(translate) = &mut translate {
        refinement.listener = Listener::new(translate);
    }
    let end = refine(&mut refinement, progress);
    let exact = predicates::exact_answers() - exact_before;
    if end == End::Cancelled {
        return Err(Error::Cancelled);
    }
    let thinned = if end == End::Finished { thin(&mut refinement, progress) } else { None };
    let input = |&v: &u32| domain.input_points[v as usize];
    let refused_at = refinement.stalled_at().iter().map(input).collect();
    if domain.region == Region::Global {
        refinement.mesh = without_the_outside(mem::take(&mut refinement.mesh));
    }
    let wanted = parameters.measured.then_some(&refinement.mesh);
    let measured = wanted.and_then(|mesh| Measured::of_refined(mesh, domain.scale_exponent));
    let missed = refinement.missed();
    let missed = missed.map(|(triangle, angle)| Missed { triangle, radians: angle.radians() });
    let missed = missed.collect();
    let introduced = refinement.introductions().iter().map(|&it| names.introduction(it)).collect();
    let counters = Counters { exact, ..refinement.counters };
    let refused = refinement.refused.subsegments.len() + refinement.refused.triangles.len();
    let mesh = assemble(refinement, kept, &domain, pslg);
    Ok(Outcome {
        missed,
        refused_at,
        counters,
        measured,
        thinned,
        introduced,
        certificate: not_judged(&mesh, &Promise::from(parameters)),
        mesh,
        smallest_input_angle,
        warnings: warnings.into_iter().map(Warning::Domain).collect(),
        end,
        refused,
    })
}

fn sizing(parameters: &Parameters, domain: &Domain) -> Sizing {
    let max_area = parameters.max_area.map(|a| libm::scalbn(a, -2 * domain.scale_exponent));
    let of_regions: Vec<_> = domain.regions.iter().map(|region| region.max_area).collect();
    Sizing::new(max_area, &of_regions, &domain.local_areas)
}
