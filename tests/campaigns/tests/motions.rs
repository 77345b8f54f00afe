//! What a mesher must not mind: where the outline lies, how large it is, how it is numbered; and
//! what it must not forget: the same input makes the same bytes.

mod support;

use meshwright::formats::{gltf, msh, vtu};
use meshwright::{Mesh, Parameters, Pslg};
use meshwright_campaigns::families::Family;
use meshwright_campaigns::hostile::hostile;
use meshwright_campaigns::judge::judge;
use meshwright_campaigns::motion::{Motion, renumbered};
use meshwright_campaigns::{Random, figures};
use proptest::prelude::*;

fn outline() -> impl Strategy<Value = Pslg> {
    let family = prop::sample::select(Family::ALL.to_vec());
    (family, 1_usize..12, -3.0..-0.3, any::<u64>()).prop_map(|(family, size, exponent, seed)| {
        family.outline(size, libm::exp10(exponent), seed)
    })
}

fn mesh(outline: &Pslg) -> Mesh {
    judge(outline, &Parameters::default()).well().mesh
}

/// The mesh with every coordinate multiplied by a power of two.
fn times(mesh: &Mesh, factor: f64) -> Mesh {
    let mut scaled = mesh.clone();
    scaled.points.iter_mut().flatten().for_each(|c| *c *= factor);
    scaled
}

proptest! {
    #![proptest_config(support::cases(32))]

    #[test]
    fn doubling_the_coordinates_doubles_the_mesh_bit_for_bit(outline in outline()) {
        let doubled = mesh(&Motion::scale(2.0).apply(&outline));
        prop_assert_eq!(doubled, times(&mesh(&outline), 2.0));
    }

    #[test]
    fn turned_and_moved_outlines_keep_every_promise(
        outline in outline(), turn in 0.0..6.3, x in -100.0..100.0, y in -100.0..100.0,
    ) {
        let motion = Motion { turn, offset: [x, y], ..Motion::NONE };
        let moved = motion.apply(&outline);
        // Rounding may close a thin wedge or lift a point off a line: then it is another outline.
        prop_assume!(meshwright_campaigns::measure::is_clean(&moved));
        mesh(&moved);
    }

    #[test]
    fn mirrored_outlines_keep_every_promise(outline in outline()) {
        mesh(&Motion::mirror().apply(&outline));
    }

    #[test]
    fn renumbered_outlines_keep_every_promise(outline in outline(), seed: u64) {
        let renumbered = renumbered(&outline, &mut Random::new(seed));
        prop_assert!(!mesh(&renumbered).triangles.is_empty());
    }
}

#[test]
fn two_to_the_900_changes_no_bit() {
    for seed in 0..8 {
        let spokes = figures::spokes(8, &mut Random::new(seed));
        let plain = mesh(&spokes);
        for exponent in [-900, -101, 60, 101, 900] {
            let factor = libm::scalbn(1.0, exponent);
            let scaled = mesh(&Motion::scale(factor).apply(&spokes));
            assert_eq!(scaled, times(&plain, factor), "seed {seed}, 2^{exponent}");
        }
    }
}

/// Everything that a user gets, as bytes.
fn written(outline: &Pslg) -> Vec<u8> {
    let mesh = mesh(outline);
    let mut bytes = Vec::new();
    msh::write(&mesh, &mut bytes).expect("writing to memory");
    vtu::write(&mesh, &mut bytes).expect("writing to memory");
    gltf::write(&mesh, &mut bytes).expect("writing to memory");
    bytes
}

#[test]
fn the_same_outline_makes_the_same_bytes() {
    for index in 0..12 {
        let outline = hostile(4, index);
        let first = written(&outline);
        // On another thread too, whose hash seeds and stack are others.
        let second = std::thread::spawn(move || written(&hostile(4, index)));
        let second = second.join().expect("it ran once before");
        assert!(first == second, "number {index}");
        assert_eq!(first, written(&outline), "number {index}");
    }
}
