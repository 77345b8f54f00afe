//! Options that several commands share, and how their values are read.

use clap::Args;
use meshwright::certify::Promise;
use meshwright::formats::{Enclosed, Mesh, Pslg};
use meshwright::{Excuse, MinAngle, MinAngleError, Parameters, Region};

use super::failure::Failure;
use super::voice::Voice;
use super::wording::count;
use super::words::{EXCUSES, HOLES, Holes, PROFILES, Profile, REGIONS, one_of};

/// What the mesh is held to: the same options, with the same defaults, for `mesh` and `check`.
#[derive(Debug, Args)]
pub struct PromiseOptions {
    /// What the other options start from: our rules, or the paper's (shells, midpoints,
    /// circumcenters, the whole convex hull).
    #[arg(long, default_value = "default", value_parser = one_of(PROFILES))]
    profile: Profile,
    /// The smallest angle where the outline allows it: promised up to 26.452 [default: 26.45], from
    /// there to 34 a target that is reached but for a few angles, which are listed.
    #[arg(long, value_name = "DEG", value_parser = number, allow_negative_numbers = true)]
    min_angle: Option<f64>,
    /// Take a --min-angle above 34: it may cost any number of points, up to --max-points.
    #[arg(long)]
    no_guarantee: bool,
    /// What is meshed: what the segments enclose less the holes (domain, global: triangulated
    /// alone, or with what is around it), or the whole convex hull [default: domain].
    #[arg(long, value_parser = one_of(REGIONS))]
    region: Option<Region>,
    /// When a smaller angle is excused: by its measure, or between midpoints only [default:
    /// measured].
    #[arg(long, value_parser = one_of(EXCUSES))]
    excuse: Option<Excuse>,
}

impl PromiseOptions {
    /// The parameters that these options stand for.
    pub fn parameters(&self) -> Result<Parameters, Failure> {
        let base = self.profile.parameters();
        let (min_angle, soft_angle) = self.angles(&base).map_err(|error| {
            let failure = Failure::usage(format!("--min-angle: {error}"));
            if self.no_guarantee {
                return failure;
            }
            failure.with_help("--no-guarantee takes up to 60°, within --max-points")
        })?;
        Ok(Parameters {
            min_angle,
            soft_angle,
            region: self.region.unwrap_or(base.region),
            excuse: self.excuse.unwrap_or(base.excuse),
            ..base
        })
    }

    /// The promise that these options stand for.
    pub fn promise(&self) -> Result<Promise, Failure> {
        let Parameters { min_angle, region, excuse, .. } = self.parameters()?;
        Ok(Promise { min_angle, region, excuse, is_plain: None })
    }

    fn angles(&self, base: &Parameters) -> Result<(MinAngle, Option<MinAngle>), MinAngleError> {
        match self.min_angle {
            None => Ok((base.min_angle, base.soft_angle)),
            Some(degrees) if degrees <= MinAngle::LARGEST_DEGREES => {
                Ok((MinAngle::from_degrees(degrees)?, None))
            }
            Some(degrees) => {
                let soft = if self.no_guarantee {
                    MinAngle::without_guarantee_from_degrees(degrees)?
                } else {
                    MinAngle::soft_from_degrees(degrees)?
                };
                Ok((base.min_angle, Some(soft)))
            }
        }
    }
}

/// How an outline is read: the same options for every command that reads one.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Args)]
pub struct ReadOptions {
    /// What is a hole: what a seed of the file lies in, a loop within a loop (even-odd), or
    /// nothing [default: as the format has it: .poly seeds, .obj even-odd].
    #[arg(long, value_parser = one_of(HOLES))]
    pub holes: Option<Holes>,
    /// Take the outlines of faces too (.obj).
    #[arg(long)]
    pub faces: bool,
    /// Take a mesh as an outline: its points, boundary and interfaces stay. Beside a .ele file, a
    /// .area file bounds the area of each triangle.
    #[arg(long)]
    pub refine: bool,
}

impl ReadOptions {
    /// The outline with the holes that are asked for.
    pub fn apply(self, pslg: &mut Pslg, voice: &Voice) {
        match self.holes {
            None => return,
            Some(Holes::Seeds) if pslg.enclosed == Enclosed::EvenOdd => {
                pslg.enclosed = Enclosed::All;
            }
            Some(Holes::Seeds) => {}
            Some(Holes::EvenOdd) => pslg.enclosed = Enclosed::EvenOdd,
            Some(Holes::None) => pslg.enclosed = Enclosed::All,
        }
        if self.holes != Some(Holes::Seeds) && !pslg.holes.is_empty() {
            let seeds = count(pslg.holes.len(), "hole seed");
            voice.note(format!("{}: {seeds} not used, as --holes asks", pslg.source.file));
            pslg.holes.clear();
            pslg.source.hole_lines.clear();
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

    /// The mesh with its points' coordinates multiplied.
    pub fn apply_to_mesh(self, mesh: &mut Mesh) {
        let Some(factor) = self.scale else { return };
        mesh.points.iter_mut().flatten().for_each(|x| *x *= factor);
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
        for area in &mut pslg.local_areas {
            area.corners.iter_mut().for_each(scale);
            area.max_area *= factor * factor;
        }
    }
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
