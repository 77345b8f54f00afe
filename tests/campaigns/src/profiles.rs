//! Ways of meshing, drawn at random among those that promise to end.

use meshwright::{Excuse, MinAngle, Parameters, Pslg, Region, Splitting, Steiner, Thinning};

use crate::figures::in_a_box;
use crate::random::Random;

/// On shells, and after Algorithm 1, an angle θ costs in proportion to 1/θ: these are drawn for
/// outlines without smaller angles (radians).
pub const SMALLEST_FOR_SHELLS: f64 = 1e-3;

/// The way that outline number `index` of a seed is meshed, `smallest` its smallest angle.
///
/// Half of the draws are one of the two profiles as they stand; the other half mixes everything.
///
/// ```
/// use meshwright_campaigns::profiles;
/// assert_eq!(profiles::draw(1, 0, None), profiles::draw(1, 0, None));
/// ```
#[must_use]
pub fn draw(seed: u64, index: u64, smallest: Option<f64>) -> Parameters {
    let random = &mut Random::stream(seed ^ 0x70_72_6f_66_69_6c_65, index);
    let shells = smallest.is_none_or(|theta| theta >= SMALLEST_FOR_SHELLS);
    match random.whole(0, 7) {
        0 | 1 => Parameters::default(),
        2 | 3 if shells => Parameters::paper(),
        _ => mixed(shells, random),
    }
}

fn mixed(shells: bool, random: &mut Random) -> Parameters {
    let splittings = [Splitting::Ladder, Splitting::Shells, Splitting::Augment];
    let soft = [None, None, Some(30.0), Some(33.0), Some(34.0)];
    let soft = random
        .pick(&soft)
        .map(|degrees| MinAngle::soft_from_degrees(degrees).expect("it is within the range"));
    let lower = MinAngle::from_degrees(random.range(5.0, MinAngle::LARGEST_DEGREES));
    let is_lower = soft.is_none() && random.chance(0.25);
    Parameters {
        splitting: *random.pick(if shells { &splittings } else { &splittings[..1] }),
        excuse: *random.pick(&[Excuse::Measured, Excuse::Midpoints]),
        steiner: *random.pick(&[Steiner::OffCenter, Steiner::Circumcenter, Steiner::LookAhead]),
        region: *random.pick(&[Region::Domain, Region::Hull, Region::Global]),
        incremental: random.chance(0.3),
        min_angle: if is_lower {
            lower.expect("it is within the range")
        } else {
            MinAngle::default()
        },
        soft_angle: soft,
        thinning: if random.chance(0.4) {
            Thinning::Tries(random.whole(1, 400) as u64)
        } else {
            Thinning::None
        },
        ..Parameters::default()
    }
}

/// The outline as these parameters want it: where the whole convex hull is meshed in a box, as in the
/// paper. The hull's own edges would run as near to other features as chance has it.
#[must_use]
pub fn prepared(outline: Pslg, parameters: &Parameters) -> Pslg {
    if parameters.region == Region::Hull { in_a_box(&outline) } else { outline }
}

/// The options of the command `meshwright mesh` that ask for these parameters.
#[must_use]
pub fn options(parameters: &Parameters) -> String {
    let Parameters {
        min_angle,
        soft_angle,
        splitting,
        excuse,
        steiner,
        region,
        incremental,
        thinning,
        ..
    } = parameters;
    let word = |value: &dyn std::fmt::Debug| match format!("{value:?}").as_str() {
        "OffCenter" => "off-center".to_owned(),
        "LookAhead" => "look-ahead".to_owned(),
        one_word => one_word.to_lowercase(),
    };
    let angle = soft_angle.unwrap_or(*min_angle).degrees();
    let angle = libm::round(angle * 1e9) / 1e9;
    let options = format!(
        "--splitting {} --excuse {} --steiner {} --region {} --min-angle {angle}",
        word(splitting),
        word(excuse),
        word(steiner),
        word(region)
    );
    let thin = match thinning {
        Thinning::None => String::new(),
        Thinning::Tries(tries) => format!(" --thin {tries}"),
        Thinning::Auto => " --thin auto".to_owned(),
    };
    options + if *incremental { " --incremental" } else { "" } + &thin
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_choice_is_drawn_and_shells_not_for_thin_angles() {
        let drawn = |smallest| (0..300).map(move |index| draw(1, index, smallest));
        let all: Vec<Parameters> = drawn(None).collect();
        for splitting in [Splitting::Ladder, Splitting::Shells, Splitting::Augment] {
            assert!(all.iter().any(|one| one.splitting == splitting), "{splitting:?}");
        }
        for region in [Region::Domain, Region::Hull, Region::Global] {
            assert!(all.iter().any(|one| one.region == region && one.incremental), "{region:?}");
        }
        assert!(all.contains(&Parameters::default()) && all.contains(&Parameters::paper()));
        assert!(all.iter().any(|one| one.soft_angle.is_some()));
        assert!(all.iter().any(|one| one.thinning != Thinning::None && one.incremental));
        assert!(drawn(Some(1e-6)).all(|one| one.splitting == Splitting::Ladder));
    }

    #[test]
    fn the_options_are_those_of_the_command() {
        let options = options(&Parameters { incremental: true, ..Parameters::paper() });
        let expected = "--splitting shells --excuse midpoints --steiner circumcenter --region hull --min-angle";
        assert!(options.starts_with(expected) && options.ends_with("--incremental"), "{options}");
    }
}
