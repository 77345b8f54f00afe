//! From the geometry to an outline: curves become segments, surfaces become regions.

mod chain;
mod contours;
mod curves;
mod faces;
mod groups;
mod overlaps;
mod path;
mod plane;
mod seeds;
mod sizes;
mod surfaces;

use std::collections::BTreeMap;

use super::error::Problem;
use super::evaluate::Options;
use super::model::Model;
use super::sources::{Answer, Sources};
use super::syntax::Place;
use crate::error::{Notice, Warning};
use crate::pslg::{Enclosed, Membership, Pslg, Source};
use curves::Linework;
use groups::Grouping;

/// Makes the outline of everything that the surfaces cover.
pub(super) fn outline(
    model: &Model,
    options: &Options,
    sources: &Sources,
    end: Place,
) -> Answer<(Pslg, Vec<Warning>)> {
    if model.surfaces.is_empty() {
        return Err(Problem::Nothing.at(end));
    }
    let mut warnings = Vec::new();
    let linework = Linework::new(model, options, sources)?;
    if linework.plane.at != 0.0 || linework.plane.normal != 2 {
        let ([first, second], at) = (linework.plane.axes(), linework.plane.at);
        let normal = ['x', 'y', 'z'][linework.plane.normal];
        let notice = Notice::AxisPlane { normal, at, first, second };
        warnings.push(Warning { file: sources.name(0).to_owned(), line: 1, notice });
    }
    let grouping = Grouping::new(model, sources, &mut warnings);
    let regions = surfaces::regions(&linework, &grouping, sources, &mut warnings)?;
    let mut pslg = segments(&linework, &grouping, sources);
    pslg.enclosed = Enclosed::Seeded;
    for (region, place) in regions {
        pslg.regions.push(region);
        pslg.source.region_lines.push(sources.line(place));
    }
    pslg.groups = grouping.names();
    Ok((pslg, warnings))
}

/// Points and segments: first the points of the script, then those on its curves.
fn segments(linework: &Linework, grouping: &Grouping, sources: &Sources) -> Pslg {
    let mut pslg = Pslg {
        source: Source { file: sources.name(0).to_owned(), first_number: 1, ..Source::default() },
        ..Pslg::default()
    };
    let model = linework.model;
    let mut index = BTreeMap::new();
    for (&tag, &at) in &linework.points {
        index.insert(tag, pslg.points.len() as u32);
        pslg.points.push(at);
        pslg.point_sizes.push(linework.sizes[&tag]);
        pslg.source.point_numbers.push(i64::from(tag));
        pslg.source.point_lines.push(sources.line(model.points[&tag].place));
        let item = index[&tag];
        let groups = grouping.of_point(tag).iter();
        pslg.memberships.extend(groups.map(|&tag| Membership { dim: 0, item, tag }));
    }
    let mut number = linework.points.last_key_value().map_or(0, |(&tag, _)| i64::from(tag));
    for (&tag, chain) in &linework.chains {
        let curve = &model.curves[&tag];
        let [first, last] = curve.ends().map(|point| index[&point]);
        let line = sources.line(curve.place);
        let mut from = first;
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
        pslg.segments.push([from, last]);
        for item in pslg.segment_tags.len() as u32..pslg.segments.len() as u32 {
            let groups = grouping.further_of_curve(tag).iter();
            pslg.memberships.extend(groups.map(|&tag| Membership { dim: 1, item, tag }));
        }
        let count = chain.inner.len() + 1;
        pslg.segment_tags.resize(pslg.segments.len(), grouping.curve(tag));
        let lines = pslg.source.segment_lines.len() + count;
        pslg.source.segment_lines.resize(lines, line);
        pslg.source.segment_numbers.resize(lines, i64::from(tag));
    }
    pslg
}
