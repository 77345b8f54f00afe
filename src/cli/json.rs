//! What `--json` prints: one object of a stated version, described by `docs/schema/`.
//!
//! Numbers that JSON cannot hold (an area that overflows) are null. Indices count from zero;
//! *numbers* are those of the user's files. Angles are in degrees.

use meshwright::certify::{Certificate, Fault, Judgement, NarrowTo, Promise, Verdict};
use meshwright::domain::{self, Angle, ClosestPair, Domain, Feature, Repair};
use meshwright::formats::Pslg;
use meshwright::refine::End;
use meshwright::refine::counters::Counters;
use meshwright::refine::incremental::{self, Introduction};
use meshwright::refine::thin::Thinned;
use meshwright::statistics::{GroupCount, Statistics};
use meshwright::{MinAngle, Missed, Outcome, Parameters, Thinning};
use serde_json::{Map, Value, json};

use super::failure::Exit;
use super::format::Format;
use super::info::OutlineFacts;
use super::input::Input;
use super::options::{ReadOptions, Scale};
use super::output::Written;
use super::repair::Mended;
use super::words::{EXCUSES, HOLES, REGIONS, RULES, SPLITTINGS, STEINERS, word};

/// The version of these objects: it changes when a reader of them would have to change.
pub const VERSION: u32 = 1;

/// What the object of `mesh` is made from.
pub struct MeshReport<'a> {
    /// The outline's file.
    pub input: &'a Input,
    /// The outline.
    pub pslg: &'a Pslg,
    /// What was mended in it.
    pub mended: &'a Mended,
    /// The run.
    pub outcome: &'a Outcome,
    /// The mesh's counts and angles.
    pub statistics: &'a Statistics,
    /// What was asked.
    pub parameters: &'a Parameters,
    /// The files written, with their formats.
    pub written: &'a [(Written, Format)],
    /// What was warned of.
    pub warnings: Vec<String>,
    /// How the command ends.
    pub exit: Exit,
}

/// The report of `mesh`.
pub fn mesh_run(report: &MeshReport) -> Vec<u8> {
    let MeshReport { pslg, outcome, .. } = report;
    let mut object = header("mesh");
    object.extend(file(report.input));
    let corner = outcome.smallest_input_angle.map(|corner| {
        let number = |segment: Option<u32>| segment.map(|s| pslg.source.segment_number(s));
        json!({
            "degrees": corner.radians.to_degrees(),
            "point": pslg.source.point_number(corner.point),
            "segments": corner.segments.map(number),
        })
    });
    let outline = json!({
        "points": pslg.points.len(),
        "segments": pslg.segments.len(),
        "holes": pslg.holes.len(),
        "regions": pslg.regions.len(),
        "smallest_angle": corner,
    });
    let output = |(written, format): &(Written, Format)| {
        json!({
            "file": written.place.display().to_string(),
            "format": format.extension(),
            "bytes": written.size,
        })
    };
    for (name, value) in [
        ("outline", outline),
        ("repair", repair(report.mended)),
        ("parameters", parameters(report.parameters)),
        ("mesh", mesh(report.statistics)),
        ("certificate", certificate(&outcome.certificate)),
        ("stopped", json!(outcome.end == End::PointBudget)),
        ("refused", json!(outcome.refused)),
        ("counters", counters(&outcome.counters)),
        ("missed", outcome.missed.iter().map(missed).collect()),
        ("thinned", thinned(outcome.thinned)),
        ("introduced", outcome.introduced.iter().map(|it| introduction(it, pslg)).collect()),
        ("warnings", json!(report.warnings)),
        ("outputs", report.written.iter().map(output).collect()),
        ("exit", json!(report.exit as u8)),
    ] {
        object.insert(name.into(), value);
    }
    finished(object)
}

fn counters(counters: &Counters) -> Value {
    json!({
        "popped": counters.popped,
        "stale": counters.stale,
        "committed": counters.committed,
        "replaced": counters.replaced,
        "exact": counters.exact,
    })
}

/// What a mesh was made from, besides its outline.
pub struct MadeFrom<'a> {
    /// How the outline was read.
    pub read: ReadOptions,
    /// By how much its lengths were multiplied.
    pub scale: Scale,
    /// The tolerance by which the outline was mended, if it was.
    pub tolerance: Option<f64>,
    /// What was asked.
    pub parameters: &'a Parameters,
}

/// The certificate file of `mesh`: the verdict, and what it was judged by.
pub fn certificate_file(input: &Input, from: &MadeFrom, certificate: &Certificate) -> Vec<u8> {
    let mut object = header("certificate");
    object.extend(file(input));
    for (name, value) in [
        ("reading", reading(from.read)),
        ("scale", json!(from.scale.factor())),
        ("repair", json!(from.tolerance.map(|tolerance| json!({ "tolerance": tolerance })))),
        ("parameters", parameters(from.parameters)),
        ("certificate", self::certificate(certificate)),
    ] {
        object.insert(name.into(), value);
    }
    finished(object)
}

/// A feature that came into the mesh, by its number: `segment` is null for a point, and for an edge
/// of the convex hull that the outline lacks.
pub fn introduced(introduction: &Introduction, pslg: &Pslg) -> Value {
    let (point, segment) = match introduction.feature {
        incremental::Feature::Point(point) => (Some(pslg.source.point_number(point)), None),
        incremental::Feature::Segment(u32::MAX) => (None, None),
        incremental::Feature::Segment(segment) => (None, Some(pslg.source.segment_number(segment))),
    };
    json!({ "point": point, "segment": segment })
}

fn introduction(introduction: &Introduction, pslg: &Pslg) -> Value {
    let mut object = introduced(introduction, pslg);
    object["early"] = introduction.called_by.is_some().into();
    object
}

/// What was mended, each with the numbers and lines of the outline's file; null where nothing was
/// to be.
fn repair(mended: &Mended) -> Value {
    let Some(report) = mended.report() else {
        return Value::Null;
    };
    let of_repair = |repair: &Repair| {
        let point = |&point: &u32| report.point_number(point);
        let segment = |&segment: &u32| report.segment_number(segment);
        let lines = report.lines(repair);
        json!({
            "kind": repair.kind().noun(),
            "points": repair.points().iter().map(point).collect::<Vec<_>>(),
            "segments": repair.segments().iter().map(segment).collect::<Vec<_>>(),
            "place": repair.points().first().map(|&point| report.place(point)),
            "distance": repair.distance(),
            "lines": lines.iter().map(|(file, line)| json!([file, line])).collect::<Vec<_>>(),
        })
    };
    json!({
        "tolerance": mended.tolerance(),
        "mended": report.repairs().iter().map(of_repair).collect::<Vec<_>>(),
    })
}

fn missed(missed: &Missed) -> Value {
    json!({ "triangle": missed.triangle, "angle": missed.radians.to_degrees() })
}

/// What thinning did; null where none was asked for.
fn thinned(thinned: Option<Thinned>) -> Value {
    json!(thinned.map(|Thinned { tries, kept, saved, stopped }| {
        json!({ "tries": tries, "kept": kept, "saved": saved, "stopped": stopped })
    }))
}

/// How an outline was read.
fn reading(options: ReadOptions) -> Value {
    json!({
        "holes": options.holes.map(|holes| word(&HOLES, &holes)),
        "faces": options.faces,
        "refine": options.refine,
    })
}

/// What was asked of a run.
pub fn parameters(parameters: &Parameters) -> Value {
    let mut object = promise(&Promise::from(parameters));
    let more = json!({
        "soft_angle": parameters.soft_angle.map(MinAngle::degrees),
        "max_area": parameters.max_area,
        "max_points": parameters.max_points,
        "splitting": word(&SPLITTINGS, &parameters.splitting),
        "steiner": word(&STEINERS, &parameters.steiner),
        "rule": word(&RULES, &parameters.rule),
        "incremental": parameters.incremental,
        "thin": match parameters.thinning {
            Thinning::None => json!(0),
            Thinning::Tries(tries) => json!(tries),
            Thinning::Auto => json!("auto"),
        },
    });
    if let (Value::Object(object), Value::Object(more)) = (&mut object, more) {
        object.extend(more);
    }
    object
}

/// The answer of `info` about an outline.
pub fn outline_info(
    input: &Input,
    mended: &Mended,
    facts: &OutlineFacts,
    mut warnings: Vec<String>,
) -> Vec<u8> {
    let mut object = header("info");
    object.extend(file(input));
    object.insert("repair".into(), repair(mended));
    object.insert("outline".into(), outline(mended.outline(), facts));
    let of_domain = facts.domain.iter().flat_map(|facts| &facts.warnings);
    warnings.extend(of_domain.map(ToString::to_string));
    object.insert("warnings".into(), json!(warnings));
    finished(object)
}

fn outline(pslg: &Pslg, facts: &OutlineFacts) -> Value {
    let clean = facts.domain.as_ref().ok();
    let error = facts.domain.as_ref().err();
    let places: Vec<[f64; 2]> = match error {
        Some(domain::Error::Conflicts(conflicts)) => {
            conflicts.first.iter().map(|conflict| conflict.place).collect()
        }
        _ => Vec::new(),
    };
    json!({
        "points": pslg.points.len(),
        "segments": pslg.segments.len(),
        "holes": pslg.holes.len(),
        "regions": pslg.regions.len(),
        "extent": facts.extent,
        "smallest_angle": clean.and_then(|facts| {
            facts.smallest.map(|smallest| angle(smallest, &facts.domain, pslg))
        }),
        "small_angles": clean.map(|facts| facts.small),
        "closest_pair": clean.and_then(|facts| {
            facts.closest.map(|closest| closest_pair(closest, &facts.domain, pslg))
        }),
        "lfs_min": clean.and_then(|facts| facts.lfs_min),
        "area": clean.map(|facts| facts.domain.area()),
        "groups": groups(&facts.groups),
        "ready": error.is_none(),
        "error": error.map(ToString::to_string),
        "places": places,
    })
}

fn angle(angle: Angle, domain: &Domain, pslg: &Pslg) -> Value {
    json!({
        "degrees": angle.radians.to_degrees(),
        "point": pslg.source.point_number(domain.input_points[angle.apex as usize]),
        "segments": angle.segments.map(|segment| segment_number(segment, domain, pslg)),
    })
}

fn closest_pair(closest: ClosestPair, domain: &Domain, pslg: &Pslg) -> Value {
    let point = |p: u32| pslg.source.point_number(domain.input_points[p as usize]);
    let (other, segment) = match closest.feature {
        Feature::Point(other) => (Some(point(other)), None),
        Feature::Segment(segment) => (None, segment_number(segment, domain, pslg)),
    };
    json!({
        "distance": closest.distance,
        "point": point(closest.point),
        "other_point": other,
        "segment": segment,
    })
}

/// The file's number of a segment; none for an edge of the convex hull that the outline lacks.
fn segment_number(segment: u32, domain: &Domain, pslg: &Pslg) -> Option<i64> {
    let input = domain.input_segments[segment as usize];
    (input != u32::MAX).then(|| pslg.source.segment_number(input))
}

/// The answer of `info` about a mesh.
pub fn mesh_info(input: &Input, statistics: &Statistics, warnings: Vec<String>) -> Vec<u8> {
    let mut object = header("info");
    object.extend(file(input));
    object.insert("mesh".into(), mesh(statistics));
    object.insert("warnings".into(), json!(warnings));
    finished(object)
}

/// A mesh's counts and angles.
fn mesh(statistics: &Statistics) -> Value {
    let kinds = statistics.kinds.map(|kinds| {
        json!({
            "input": kinds.input,
            "shell": kinds.shell,
            "midpoint": kinds.midpoint,
            "circumcenter": kinds.circumcenter,
        })
    });
    json!({
        "points": statistics.points,
        "points_by_kind": kinds,
        "triangles": statistics.triangles,
        "edges": statistics.edges,
        "area": statistics.area,
        "smallest_angle": statistics.smallest_angle.to_degrees(),
        "largest_angle": statistics.largest_angle.to_degrees(),
        "histogram": {
            "bin": 5,
            "smallest_angles_from_0": statistics.smallest_angles,
            "largest_angles_from_60": statistics.largest_angles,
        },
        "groups": groups(&statistics.groups),
    })
}

/// The verdict of `check`.
pub fn check(
    input: &Input,
    mended: Option<&Mended>,
    statistics: &Statistics,
    certificate: &Certificate,
    warnings: Vec<String>,
) -> Vec<u8> {
    let mut object = header("check");
    object.extend(file(input));
    object.insert("repair".into(), mended.map_or(Value::Null, repair));
    object.insert("mesh".into(), mesh(statistics));
    object.insert("certificate".into(), self::certificate(certificate));
    object.insert("warnings".into(), json!(warnings));
    finished(object)
}

fn certificate(certificate: &Certificate) -> Value {
    json!({
        "holds": certificate.is_judged() && certificate.holds(),
        "limited_by_precision": certificate.limited(),
        "promise": promise(&certificate.promise),
        "theta_star": certificate.theta_star.map(f64::to_degrees),
        "guarantees": certificate.judgements.iter().map(judgement).collect::<Vec<_>>(),
        "excused": certificate.excused.iter().map(|excused| json!({
            "triangle": excused.triangle,
            "degrees": excused.angle.to_degrees(),
            "edge": excused.edge,
            "segments": excused.segments.map(|segment| segment.number),
            "theta": excused.theta.to_degrees(),
        })).collect::<Vec<_>>(),
        "points_by_kind": certificate.kinds.map(|kinds| json!({
            "input": kinds.input,
            "shell": kinds.shell,
            "midpoint": kinds.midpoint,
            "circumcenter": kinds.circumcenter,
        })),
        "corollary_2": certificate.corollary_2.map(|found| json!({
            "lfs_min": found.lfs_min,
            "bound": found.bound,
            "shortest_edge": found.shortest,
            "pessimism": found.shortest / found.bound,
        })),
        "apexes": certificate.apexes.iter().map(|apex| json!({
            "point": apex.point.number,
            "segments": apex.segments.map(|segment| segment.number),
            "theta": apex.theta.to_degrees(),
            "reach": apex.reach,
            "place": apex.place,
        })).collect::<Vec<_>>(),
        "narrows": certificate.narrows.iter().map(|narrow| {
            let (other, segment) = match narrow.to {
                NarrowTo::Point(point) => (Some(point.number), None),
                NarrowTo::Segment(segment) => (None, Some(segment.number)),
            };
            json!({
                "point": narrow.point.number,
                "other_point": other,
                "segment": segment,
                "gap": narrow.gap,
                "place": narrow.place,
            })
        }).collect::<Vec<_>>(),
        "limited_triangles": certificate.limited_triangles,
        "not_judged": certificate.not_judged,
    })
}

fn promise(promise: &Promise) -> Value {
    json!({
        "min_angle": promise.min_angle.degrees(),
        "region": word(&REGIONS, &promise.region),
        "excuse": word(&EXCUSES, &promise.excuse),
        "plain": promise.is_plain,
    })
}

fn judgement(judgement: &Judgement) -> Value {
    let (verdict, reason) = match judgement.verdict() {
        Verdict::Holds => ("holds", None),
        Verdict::Fails => ("fails", None),
        Verdict::LimitedByPrecision => ("limited by precision", None),
        Verdict::NotJudged(reason) => ("not judged", Some(reason)),
    };
    json!({
        "code": judgement.guarantee.code(),
        "name": judgement.guarantee.name(),
        "verdict": verdict,
        "reason": reason,
        "faults": judgement.faults,
        "first": judgement.first.iter().map(fault).collect::<Vec<_>>(),
        "limited": judgement.limited,
    })
}

fn fault(fault: &Fault) -> Value {
    json!({
        "text": fault.to_string(),
        "place": fault.place,
        "triangle": fault.triangle,
        "edge": fault.edge,
        "point": fault.point,
        "segment": fault.segment.map(|segment| segment.number),
        "input_point": fault.input_point.map(|point| point.number),
        "degrees": fault.angle.map(f64::to_degrees),
    })
}

fn groups(groups: &[GroupCount]) -> Vec<Value> {
    let group = |group: &GroupCount| json!({ "dim": group.dim, "tag": group.tag, "name": group.name, "count": group.count });
    groups.iter().map(group).collect()
}

fn header(command: &str) -> Map<String, Value> {
    let mut object = Map::new();
    object.insert("version".into(), json!(VERSION));
    object.insert("meshwright".into(), json!(env!("CARGO_PKG_VERSION")));
    object.insert("command".into(), json!(command));
    object
}

fn file(input: &Input) -> [(String, Value); 2] {
    [("file".into(), json!(input.name)), ("format".into(), json!(input.format.extension()))]
}

fn finished(object: Map<String, Value>) -> Vec<u8> {
    let text = serde_json::to_string(&Value::Object(object));
    (text.expect("an object whose keys are strings becomes JSON") + "\n").into_bytes()
}
