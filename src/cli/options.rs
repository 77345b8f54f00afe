//! Options that several commands share, and how their values are read.

use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use meshwright::certify::Promise;
use meshwright::formats::Pslg;
use meshwright::{Excuse, MinAngle, MinAngleError, Region};

use super::failure::Failure;

/// What the mesh is held to: the same options, with the same defaults, for `mesh` and `check`.
#[derive(Debug, Args)]
pub struct PromiseOptions {
    /// The smallest angle where the outline allows it: promised up to 26.452 [default: 26.45], from
    /// there to 34 a target that is reached but for a few angles, which are listed.
    #[arg(long, value_name = "DEG", value_parser = number, allow_negative_numbers = true)]
    min_angle: Option<f64>,
    /// Take a --min-angle above 34: it may cost any number of points, up to --max-points.
    #[arg(long)]
    no_guarantee: bool,
    /// What is meshed: what the segments enclose less the holes, or the whole convex hull.
    #[arg(long, default_value = "domain", value_parser = one_of([
        ("domain", Region::Domain), ("hull", Region::Hull),
    ]))]
    region: Region,
    /// When a smaller angle is excused: by its measure, or between midpoints only.
    #[arg(long, default_value = "measured", value_parser = one_of([
        ("measured", Excuse::Measured), ("midpoints", Excuse::Midpoints),
    ]))]
    excuse: Excuse,
}

impl PromiseOptions {
    /// The promise that these options stand for, and the soft target above it.
    pub fn promise(&self) -> Result<(Promise, Option<MinAngle>), Failure> {
        let (min_angle, soft) = self.angles().map_err(|error| {
            let failure = Failure::usage(format!("--min-angle: {error}"));
            if self.no_guarantee {
                return failure;
            }
            failure.with_help("--no-guarantee takes up to 60°, within --max-points")
        })?;
        Ok((Promise { min_angle, region: self.region, excuse: self.excuse, is_plain: None }, soft))
    }

    fn angles(&self) -> Result<(MinAngle, Option<MinAngle>), MinAngleError> {
        match self.min_angle {
            None => Ok((MinAngle::default(), None)),
            Some(degrees) if degrees <= MinAngle::LARGEST_DEGREES => {
                Ok((MinAngle::from_degrees(degrees)?, None))
            }
            Some(degrees) => {
                let soft = if self.no_guarantee {
                    MinAngle::without_guarantee_from_degrees(degrees)?
                } else {
                    MinAngle::soft_from_degrees(degrees)?
                };
                Ok((MinAngle::default(), Some(soft)))
            }
        }
    }
}

/// Multiplying an outline's lengths.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct Scale {
    /// Multiply the outline's coordinates by this (0.001: millimetres to metres).
    #[arg(long, value_name = "F", value_parser = positive, allow_negative_numbers = true)]
    scale: Option<f64>,
}

impl Scale {
    /// Multiplying by a factor.
    pub fn by(factor: f64) -> Self {
        Self { scale: Some(factor) }
    }

    /// The factor, where there is one.
    pub fn factor(self) -> Option<f64> {
        self.scale
    }

    /// The outline with every length multiplied.
    pub fn apply(self, pslg: &mut Pslg) {
        let Some(factor) = self.scale else { return };
        let scale = |place: &mut [f64; 2]| *place = place.map(|x| x * factor);
        pslg.points.iter_mut().for_each(scale);
        pslg.holes.iter_mut().for_each(scale);
        pslg.point_sizes.iter_mut().for_each(|size| *size *= factor);
        for region in &mut pslg.regions {
            scale(&mut region.seed);
            region.max_area = region.max_area.map(|area| area * factor * factor);
        }
    }
}

/// One of a few words, each with its value.
pub fn one_of<T: Clone + Send + Sync + 'static, const N: usize>(
    choices: [(&'static str, T); N],
) -> impl TypedValueParser<Value = T> {
    let words = PossibleValuesParser::new(choices.each_ref().map(|(word, _)| *word));
    words.map(move |word| {
        let chosen = choices.iter().find(|(choice, _)| *choice == word);
        chosen.expect("the parser lets only the choices through").1.clone()
    })
}

/// A finite number greater than zero.
pub fn positive(text: &str) -> Result<f64, String> {
    match number(text)? {
        value if value > 0.0 => Ok(value),
        _ => Err("it must be greater than 0".to_string()),
    }
}

/// A finite number.
pub fn number(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err("this is no finite number".to_string()),
    }
}

/// A zoom box, `xmin,ymin,xmax,ymax`.
pub fn zoom_box(text: &str) -> Result<[f64; 4], String> {
    let words: Vec<&str> = text.split(',').collect();
    let [xmin, ymin, xmax, ymax] = words[..] else {
        return Err("a box has four numbers: xmin,ymin,xmax,ymax".to_string());
    };
    let zoom = [number(xmin)?, number(ymin)?, number(xmax)?, number(ymax)?];
    if zoom[0] < zoom[2] && zoom[1] < zoom[3] {
        Ok(zoom)
    } else {
        Err("the box is empty: xmin < xmax and ymin < ymax are needed".to_string())
    }
}
