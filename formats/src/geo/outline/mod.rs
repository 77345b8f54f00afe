//! From the geometry to an outline: curves become segments, surfaces become regions.

mod chain;
mod contours;
mod curves;
mod faces;
mod groups;
mod linework;
mod overlaps;
mod path;
mod places;
mod plane;
mod seeds;
mod sizes;
mod surfaces;

use super::error::Problem;
use super::evaluate::Options;
use super::model::Model;
use super::sources::{Answer, Sources};
use super::syntax::Place;
use crate::error::{Notice, Warning};
use crate::pslg::{Enclosed, Membership, Pslg, Source};
use groups::Grouping;
use linework::Linework;

/// Makes the outline of everything that the surfaces cover.
///
/// The geometry ends here: of a large one, what has become part of the outline is let go.
pub(super) fn outline(
    model: Model,
    options: &Options,
    sources: &Sources,
    end: Place,
) -> Answer<(Pslg, Vec<Warning>)> {
    if model.surfaces.is_empty() {
        return Err(Problem::Nothing.at(end));
    }
    let (mut warnings, mut of_groups) = (Vec::new(), Vec::new());
    let grouping = Grouping::new(&model, sources, &mut of_groups);
    let linework = Linework::new(model, options, sources)?;
    if linework.plane.at != 0.0 || linework.plane.normal != 2 {
        let ([first, second], at) = (linework.plane.axes(), linework.plane.at);
        let normal = ['x', 'y', 'z'][linework.plane.normal];
        let notice = Notice::AxisPlane { normal, at, first, second };
        warnings.push(Warning { file: sources.name(0).to_owned(), line: 1, notice });
    }
    warnings.append(&mut of_groups);
    let regions = surfaces::regions(&linework, &grouping, sources, &mut warnings)?;
    let mut pslg = segments(linework, &grouping, sources);
    pslg.enclosed = Enclosed::Seeded;
    for (region, place) in regions {
        pslg.regions.push(region);
        pslg.source.region_lines.push(sources.line(place));
    }
    pslg.groups = grouping.names();
    Ok((pslg, warnings))
}

/// Points and segments: first the points of the script, then those on its curves.
fn segments(linework: Linework, grouping: &Grouping, sources: &Sources) -> Pslg {
    let Linework { points, curves, .. } = linework;
    let mut number = points.tags.last().map_or(0, |&tag| i64::from(tag));
    let source = Source {
        file: sources.name(0).to_owned(),
        first_number: 1,
        point_numbers: points.tags.iter().map(|&tag| i64::from(tag)).collect(),
        point_lines: points.lines,
        ..Source::default()
    };
    let mut pslg = Pslg { points: points.at, point_sizes: points.sizes, source, ..Pslg::default() };
    for (item, &tag) in (0..).zip(&points.tags) {
        let groups = grouping.of_point(tag);
        pslg.memberships.extend(groups.map(|tag| Membership { dim: 0, item, tag }));
    }
    for ((&tag, &line), &[first, last]) in curves.tags.iter().zip(&curves.lines).zip(&curves.ends) {
        let mut from = first;
        if let Some(chain) = curves.chains.get(&tag) {
            for (&at, &size) in chain.inner.iter().zip(&chain.sizes) {
                let to = pslg.points.len() as u32;
                number += 1;
                pslg.points.push(at);
                pslg.point_sizes.push(size);
                pslg.source.point_numbers.push(number);
                pslg.source.point_lines.push(line);
                pslg.segments.push([from, to]);
                from = to;
            }
        }
        pslg.segments.push([from, last]);
        for item in pslg.segment_tags.len() as u32..pslg.segments.len() as u32 {
            let groups = grouping.further_of_curve(tag);
            pslg.memberships.extend(groups.map(|tag| Membership { dim: 1, item, tag }));
        }
        let count = pslg.segments.len();
        pslg.segment_tags.resize(count, grouping.curve(tag));
        pslg.source.segment_lines.resize(count, line);
        pslg.source.segment_numbers.resize(count, i64::from(tag));
    }
    pslg
}
