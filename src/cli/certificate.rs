//! The certificate file: a verdict with the parameters that it was judged by, which `mesh` writes
//! and `check` reads them from. `docs/schema/report-1.json` describes it.

use std::fs;
use std::path::Path;

use meshwright::MinAngle;
use meshwright::certify::Promise;
use serde_json::Value;

use super::failure::Failure;
use super::json::VERSION;
use super::options::{ReadOptions, Scale};
use super::repair::RepairOptions;
use super::words::{self, EXCUSES, HOLES, REGIONS};

/// What `check` takes from a certificate file.
pub struct Held {
    /// What the mesh was held to.
    pub promise: Promise,
    /// How the outline was read.
    pub read: ReadOptions,
    /// By how much the outline's lengths were multiplied.
    pub scale: Scale,
    /// How the outline was mended.
    pub repair: RepairOptions,
}

/// Reads what a mesh was held to.
pub fn read(path: &Path) -> Result<Held, Failure> {
    let bytes = fs::read(path).map_err(|error| Failure::io(path, &error))?;
    let object: Value = serde_json::from_slice(&bytes)
        .map_err(|error| Failure::input(format!("{}: this is no JSON: {error}", path.display())))?;
    held(&object).ok_or_else(|| {
        let message = format!("{}: this is no certificate of version {VERSION}", path.display());
        Failure::input(message).with_help("`meshwright mesh --certificate FILE.json` writes one")
    })
}

fn held(object: &Value) -> Option<Held> {
    if object["version"] != VERSION || object["command"] != "certificate" {
        return None;
    }
    let promise = &object["certificate"]["promise"];
    let promise = Promise {
        min_angle: min_angle(promise["min_angle"].as_f64()?)?,
        region: words::value(&REGIONS, promise["region"].as_str()?)?,
        excuse: words::value(&EXCUSES, promise["excuse"].as_str()?)?,
        is_plain: promise["plain"].as_bool(),
    };
    let scale = match &object["scale"] {
        Value::Null => Scale::default(),
        factor => Scale::by(factor.as_f64().filter(|&f| f > 0.0 && f.is_finite())?),
    };
    let repair = match &object["repair"] {
        Value::Null => RepairOptions::default(),
        repair => RepairOptions::within(repair["tolerance"].as_f64()?),
    };
    Some(Held { promise, read: read_options(&object["reading"])?, scale, repair })
}

fn read_options(reading: &Value) -> Option<ReadOptions> {
    let holes = match &reading["holes"] {
        Value::Null => None,
        word => Some(words::value(&HOLES, word.as_str()?)?),
    };
    let (faces, refine) = (reading["faces"].as_bool()?, reading["refine"].as_bool()?);
    Some(ReadOptions { holes, faces, refine })
}

/// κ̂ from the degrees that it was written as: rounding must neither lift it above the largest nor
/// make another angle of the default.
fn min_angle(degrees: f64) -> Option<MinAngle> {
    if degrees == MinAngle::default().degrees() {
        return Some(MinAngle::default());
    }
    let is_rounded = (degrees - MinAngle::LARGEST_DEGREES).abs() < 1e-12;
    let degrees = if is_rounded { MinAngle::LARGEST_DEGREES } else { degrees };
    MinAngle::from_degrees(degrees).ok()
}
