//! The events of a run: each has its reason, and together they are the run.

use std::collections::BTreeSet;

use meshwright::formats::{Mesh, Provenance, poly};
use meshwright::refine::trace::{Cause, Damaged, Event, Fault, Made, Refusal, Replay};
use meshwright::{MinAngle, Outcome, Parameters, Pslg, Rule, Splitting, Steiner, mesh, trace};

fn read(name: &str, text: &[u8]) -> Pslg {
    poly::read(text, name, |node| std::fs::read(node)).expect("the outline is read").0
}

/// Two segments at 1e-9 rad in a box, slanted so that nothing is exact: splits are refused.
const NEEDLE: &[u8] = b"7 2\n1 0 0\n2 0.955336489125606 0.29552020666133955\n\
    3 0.7929292857289711 0.24528177232184115\n4 -1 -1\n5 2 -1\n6 2 2\n7 -1 2\n\
    6 0\n1 1 2\n2 1 3\n3 4 5\n4 5 6\n5 6 7\n6 7 4\n0\n";

/// A point twice, a point outside, a slit, a hole, and a region of its own size.
const ODDS: &[u8] = b"14 2\n1 9 9\n2 0 0\n3 4 0\n4 4 3\n5 4 3\n6 0 3\n7 1 1\n8 2 1.25\n\
    9 2.5 2\n10 3.5 2\n11 3 2.5\n12 1 2\n13 1.5 2\n14 0.5 0.25\n\
    9 0\n1 2 3\n2 3 4\n3 5 6\n4 6 2\n5 7 8\n6 9 10\n7 10 11\n8 11 9\n9 12 13\n\
    1\n1 3 2.2\n1\n1 0.5 2.5 4 0.05\n";

fn outlines() -> Vec<(&'static str, Pslg)> {
    let superior = include_bytes!("../examples/lake_superior.poly");
    let rooms = include_bytes!("fixtures/two_rooms.poly");
    let far: &[u8] = b"3 2\n1 0 0\n2 4e200 0\n3 4e200 1e200\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n";
    let mut outlines = [
        ("superior", &superior[..]),
        ("rooms", &rooms[..]),
        ("needle", NEEDLE),
        ("odds", ODDS),
        ("far", far),
    ]
    .map(|(name, text)| (name, read(name, text)))
    .to_vec();
    let mut sized = outlines[1].1.clone();
    sized.point_sizes = (0..sized.points.len()).map(|i| if i == 0 { 0.05 } else { 0.5 }).collect();
    outlines.push(("sized", sized));
    outlines
}

/// Ours, and each other rule; some of them would go on for long on some outline.
fn variants() -> [Parameters; 7] {
    let ours = Parameters { max_points: 3_000, ..Parameters::default() };
    [
        ours,
        Parameters { max_area: Some(0.01), ..ours },
        Parameters { splitting: Splitting::Shells, steiner: Steiner::Circumcenter, ..ours },
        Parameters { splitting: Splitting::Augment, rule: Rule::Terminator, ..ours },
        Parameters { rule: Rule::Ruppert, ..ours },
        Parameters { incremental: true, ..ours },
        Parameters { incremental: true, splitting: Splitting::Augment, ..ours },
    ]
}

fn recorded(pslg: &Pslg, parameters: &Parameters) -> (Vec<Event>, Outcome) {
    let mut events = Vec::new();
    let outcome = trace(pslg, parameters, &mut |event| events.push(event.clone()));
    (events, outcome.expect("the outline is meshed"))
}

/// Judges every run of every outline.
fn each_run(judge: impl Fn(&str, &Pslg, &[Event], &Outcome)) {
    for (name, pslg) in outlines() {
        for parameters in variants() {
            let (events, outcome) = recorded(&pslg, &parameters);
            judge(&format!("{name}, {parameters:?}"), &pslg, &events, &outcome);
        }
    }
}

fn made(event: &Event) -> Option<&Made> {
    match event {
        Event::Commit { made, .. } | Event::Split { made, .. } => Some(made),
        _ => None,
    }
}

/// The triangles with their smallest vertex first, sorted.
fn triangles(mesh: &Mesh) -> Vec<[u32; 3]> {
    let smallest_first = |&[a, b, c]: &[u32; 3]| {
        if a < b && a < c {
            [a, b, c]
        } else if b < c {
            [b, c, a]
        } else {
            [c, a, b]
        }
    };
    let mut triangles: Vec<_> = mesh.triangles.iter().map(smallest_first).collect();
    triangles.sort_unstable();
    triangles
}

fn edges(mesh: &Mesh) -> BTreeSet<([u32; 2], u32)> {
    let sorted = |&[a, b]: &[u32; 2]| [a.min(b), a.max(b)];
    mesh.edges.iter().map(sorted).zip(mesh.edge_segments.iter().copied()).collect()
}

#[test]
fn listening_changes_nothing() {
    for (name, pslg) in outlines() {
        for parameters in variants() {
            let alone = mesh(&pslg, &parameters).expect("the outline is meshed");
            assert_eq!(alone.mesh, recorded(&pslg, &parameters).1.mesh, "{name} {parameters:?}");
        }
    }
}

#[test]
fn the_events_replayed_make_the_mesh() {
    each_run(|run, _, events, Outcome { mesh, .. }| {
        let mut replay = Replay::default();
        for event in events {
            replay.apply(event).unwrap_or_else(|error| panic!("{run}: {event:?}: {error}"));
        }
        let replayed = replay.mesh();
        assert_eq!(replayed.points, mesh.points, "{run}");
        assert_eq!(replayed.provenance, mesh.provenance, "{run}");
        assert_eq!(triangles(&replayed), triangles(mesh), "{run}");
        assert_eq!(edges(&replayed), edges(mesh), "{run}");
    });
}

#[test]
fn the_events_count_what_the_mesh_holds() {
    each_run(|run, _, events, outcome| {
        let count = |wanted: &dyn Fn(&Event) -> bool| events.iter().filter(|e| wanted(e)).count();
        let of_kind = |wanted| outcome.mesh.provenance.iter().filter(|&&k| k == wanted).count();
        for wanted in [Provenance::Shell, Provenance::Midpoint] {
            let split = |e: &Event| matches!(e, Event::Split { kind, .. } if *kind == wanted);
            assert_eq!(count(&split), of_kind(wanted), "{run}: {wanted:?}");
        }
        let commits = count(&|e| matches!(e, Event::Commit { .. }));
        assert_eq!(commits, of_kind(Provenance::Circumcenter), "{run}");
        let refused =
            count(&|e| matches!(e, Event::RefusedSplit { .. } | Event::RefusedPoint { .. }));
        assert_eq!(refused, outcome.refused, "{run}");
        assert_eq!(count(&|e| matches!(e, Event::Start(_))), 1, "{run}");
        assert!(matches!(events[0], Event::Start(_)), "{run}");
    });
}

#[test]
fn every_split_names_what_encroaches() {
    let encroached_by_rounding = |[a, b]: [[f64; 2]; 2], p: [f64; 2]| {
        // Scaled, so that no product overflows.
        let size = a.iter().chain(&b).chain(&p).fold(0.0_f64, |m, c| m.max(c.abs()));
        let [ax, ay, bx, by] =
            [a[0] - p[0], a[1] - p[1], b[0] - p[0], b[1] - p[1]].map(|c| c / size);
        ax * bx + ay * by < 1e-15
    };
    each_run(|run, _, events, _| {
        let mut replay = Replay::default();
        let mut rejected = None;
        for event in events {
            let place = |v: u32| replay.point(v).expect("a vertex that is there");
            match event {
                Event::Rejected { bad, point, encroached } => {
                    assert!(!encroached.is_empty(), "{run}");
                    for subsegment in encroached {
                        assert!(
                            encroached_by_rounding(subsegment.ends.map(place), *point),
                            "{run}"
                        );
                    }
                    rejected = Some((bad.vertices, encroached));
                }
                Event::Split { subsegment, cause, .. }
                | Event::RefusedSplit { subsegment, cause, .. } => match cause {
                    Cause::Encroached(v) => {
                        let ends = subsegment.ends.map(place);
                        assert!(encroached_by_rounding(ends, place(*v)), "{run}: {event:?}");
                    }
                    Cause::Rejected(vertices) => {
                        let (of, encroached) = rejected.expect("a rejection before");
                        assert_eq!(of, *vertices, "{run}");
                        assert!(encroached.contains(subsegment), "{run}: {event:?}");
                    }
                    Cause::Size => assert!(run.starts_with("sized"), "{run}: {event:?}"),
                    Cause::Augmented => assert!(run.contains("Augment"), "{run}: {event:?}"),
                },
                _ => {}
            }
            replay.apply(event).expect("it is one run's event");
        }
    });
}

#[test]
fn every_steiner_point_names_a_triangle_that_it_removes() {
    let kappa = Parameters::default().min_angle.radians();
    each_run(|run, _, events, _| {
        let mut replay = Replay::default();
        for event in events {
            let (Event::Commit { bad, .. }
            | Event::Rejected { bad, .. }
            | Event::RefusedPoint { bad, .. }) = event
            else {
                replay.apply(event).expect("it is one run's event");
                continue;
            };
            let there = |replay: &Replay| replay.has_triangle(bad.vertices);
            let before = there(&replay);
            replay.apply(event).expect("it is one run's event");
            match event {
                Event::Commit { .. } => assert!(before && !there(&replay), "{run}: {event:?}"),
                Event::Rejected { .. } => assert!(before, "{run}: {event:?}"),
                _ => {}
            }
            match bad.fault {
                Fault::Angle(angle) => assert!(angle < kappa * 1.000_001, "{run}: {angle}"),
                Fault::Area(area) => {
                    assert!(run.starts_with("sized") || area > 0.01, "{run}: {area}")
                }
            }
        }
    });
}

#[test]
fn what_is_refused_says_why() {
    // Ruppert's rule does not end at 14°: the apex is split down to the precision floor.
    let wedge = read("wedge", b"3 2\n1 0 0\n2 4 0\n3 4 1\n3 0\n1 1 2\n2 2 3\n3 3 1\n0\n");
    let (events, outcome) = recorded(&wedge, &variants()[4]);
    assert!(outcome.refused > 0);
    let split = |event: &Event| match event {
        Event::RefusedSplit { refusal, .. } => Some(*refusal),
        _ => None,
    };
    let point = |event: &Event| match event {
        Event::RefusedPoint { refusal, .. } => Some(*refusal),
        _ => None,
    };
    let splits: Vec<Refusal> = events.iter().filter_map(split).collect();
    let points: Vec<Refusal> = events.iter().filter_map(point).collect();
    assert!(!splits.is_empty() && splits.iter().all(|&why| why == Refusal::Floor), "{splits:?}");
    assert!(points.contains(&Refusal::AllSplitsRefused), "{points:?}");
}

#[test]
fn vertices_are_the_outlines_points_and_then_the_new_ones() {
    each_run(|run, pslg, events, _| {
        let Event::Start(start) = &events[0] else { panic!("{run}") };
        for &(index, place) in &start.points {
            assert_eq!(place, pslg.points[index as usize], "{run}");
        }
        let new = events.iter().filter_map(made).map(|made| made.vertex);
        let expected = pslg.points.len() as u32..;
        assert!(new.zip(expected).all(|(vertex, index)| vertex == index), "{run}");
        for event in events {
            if let Event::Split { subsegment, .. } = event {
                assert!((subsegment.segment as usize) < pslg.segments.len(), "{run}");
            }
        }
    });
}

#[test]
fn events_of_no_whole_run_are_damaged() {
    let rooms = read("rooms", include_bytes!("fixtures/two_rooms.poly"));
    let (events, _) = recorded(&rooms, &variants()[1]);
    let replay = |events: &mut dyn Iterator<Item = &Event>| {
        let mut replay = Replay::default();
        for event in events {
            replay.apply(event)?;
        }
        Ok(())
    };
    assert_eq!(replay(&mut events.iter()), Ok(()));
    assert_eq!(replay(&mut events.iter().skip(1)), Err(Damaged), "without its start");
    assert_eq!(replay(&mut events.iter().chain(&events[..1])), Err(Damaged), "started twice");
    let first = events.iter().position(|event| made(event).is_some()).expect("a point is made");
    let without = events[..first].iter().chain(&events[first + 1..]);
    assert_eq!(replay(&mut without.into_iter()), Err(Damaged), "without its first point");
    let twice = events[..=first].iter().chain(&events[first..]);
    assert_eq!(replay(&mut twice.into_iter()), Err(Damaged), "its first point twice");
}

#[test]
fn a_segment_to_come_is_called_by_a_point_that_encroaches_it_from_afar() {
    // A needle whose third segment is encroached when its turn has not come: the triangle on it
    // is out of reach for the points near its end.
    let needle: &[u8] = b"3 2\n0 -11.169529755461243 -90.26663930416545\n\
        1 -11.207759182314707 -90.22182926984135\n2 -11.198470502962026 -90.23271718253224\n\
        3 0\n0 0 1\n1 1 2\n2 2 0\n0\n";
    let target = MinAngle::soft_from_degrees(33.0).expect("it is no more than 34°");
    let parameters = Parameters {
        incremental: true,
        steiner: Steiner::LookAhead,
        soft_angle: Some(target),
        ..Parameters::default()
    };
    let outcome = mesh(&read("needle", needle), &parameters).expect("it is meshed");
    assert!(outcome.certificate.holds());
    assert_eq!(outcome.refused, 0);
}
