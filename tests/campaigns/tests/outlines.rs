//! What the generators promise: clean outlines, the same everywhere.

mod support;

use meshwright::domain::{self, Domain};
use meshwright::{Pslg, Region};
use meshwright_campaigns::families::Family;
use meshwright_campaigns::hostile::{NEAREST, hostile};
use meshwright_campaigns::measure::{clearance, is_clean, smallest_angle};
use meshwright_campaigns::{Random, figures, poly};
use proptest::prelude::*;

proptest! {
    #![proptest_config(support::cases(200))]

    #[test]
    fn every_family_is_clean(size in 1_usize..30, exponent in -8.0..-0.3, seed: u64) {
        for family in Family::ALL {
            let theta = libm::exp10(exponent);
            let outline = family.outline(size, theta, seed);
            prop_assert!(is_clean(&outline), "{family:?}:\n{}", poly::text(&outline, ""));
            let domain = Domain::new(&outline, Region::Domain);
            prop_assert!(domain.is_ok(), "{domain:?}:\n{}", poly::text(&outline, ""));
            prop_assert!(!outline.segments.is_empty(), "{family:?}");
        }
    }

    #[test]
    fn hostile_outlines_are_clean_and_keep_their_distance(seed: u64, index in 0_u64..2000) {
        let outline = hostile(seed, index);
        prop_assert!(is_clean(&outline), "{}", poly::text(&outline, ""));
        let domain = Domain::new(&outline, Region::Domain);
        prop_assert!(domain.is_ok(), "{domain:?}:\n{}", poly::text(&outline, ""));
        prop_assert!(clearance(&outline) >= NEAREST, "{}", poly::text(&outline, ""));
    }

    #[test]
    fn the_plane_sweep_agrees_with_a_look_at_all_pairs(
        seed: u64,
        side in 2_usize..8,
        count in 1_usize..14,
        shear in prop::bool::ANY,
    ) {
        let outline = scribble(side, count, shear, &mut Random::new(seed));
        let accepted = match Domain::new(&outline, Region::Domain) {
            Ok(_) => Some(true),
            Err(domain::Error::Conflicts(_)) => Some(false),
            Err(_) => None, // too few points, all on one line
        };
        if let Some(accepted) = accepted {
            prop_assert_eq!(accepted, is_clean(&outline), "{}", poly::text(&outline, ""));
        }
    }
}

/// Segments between points of a small lattice, full of crossings, overlaps and T-junctions; no
/// point and no segment twice. A shear by an irrational factor makes near misses of some.
fn scribble(side: usize, count: usize, shear: bool, random: &mut Random) -> Pslg {
    let mut points: Vec<[f64; 2]> = (0..side * side)
        .filter(|_| random.chance(0.6))
        .map(|i| [(i % side) as f64, (i / side) as f64])
        .collect();
    let mut segments: Vec<[u32; 2]> = Vec::new();
    for _ in 0..if points.len() < 2 { 0 } else { count } {
        let [a, b] = [0; 2].map(|_| random.whole(0, points.len() - 1) as u32);
        if a != b && !segments.contains(&[a, b]) && !segments.contains(&[b, a]) {
            segments.push([a, b]);
        }
    }
    if shear {
        points = points.iter().map(|[x, y]| [x + 0.618_034 * y, y - 0.1 * x]).collect();
    }
    figures::outline(points, segments)
}

#[test]
fn the_wedge_has_its_angle() {
    for theta in [1e-2, 1e-5, 1e-8] {
        let measured = smallest_angle(&figures::wedge(theta)).unwrap();
        assert!((measured / theta - 1.0).abs() < 1e-6, "{measured} for {theta}");
    }
}

#[test]
fn the_closest_pair_of_20_spokes_is_the_papers() {
    for seed in 900..912 {
        let spokes = figures::spokes20(seed);
        assert_eq!((spokes.points.len(), spokes.segments.len()), (25, 24));
        let degrees = smallest_angle(&spokes).unwrap().to_degrees();
        assert!((0.85..=1.0).contains(&degrees), "seed {seed}: {degrees}°");
    }
}

#[test]
fn a_hostile_outline_is_the_same_on_every_platform() {
    // FNV-1a over the text of 50 outlines.
    let digest = (0..50).fold(0xcbf2_9ce4_8422_2325_u64, |digest, index| {
        poly::text(&hostile(1, index), "")
            .bytes()
            .fold(digest, |d, byte| (d ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
    });
    assert_eq!(
        format!("{digest:016x}"),
        "ddf93104aaf2e12b",
        "(seed, index) name other outlines now"
    );
}
