//! Surfaces as regions, each with a seed strictly inside.

use std::collections::BTreeMap;

use super::contours::{Contour, Polygon, contours};
use super::faces;
use super::groups::Grouping;
use super::linework::Linework;
use super::overlaps::{Area, overlap};
use super::seeds::{Stretch, stretches};
use crate::error::{Notice, Warning};
use crate::geo::error::Problem;
use crate::geo::model::Surface;
use crate::geo::sources::{Answer, Sources};
use crate::geo::syntax::Place;
use crate::pslg::Region;

/// A surface's contours, and the parts that they enclose.
struct Parts {
    tag: i32,
    place: Place,
    polygons: Vec<Polygon>,
    /// The outer contour of each part and the contours of its holes, as indices.
    parts: Vec<(usize, Vec<usize>)>,
}

/// A region for each face of each surface, and the place of the surface's statement.
///
/// # Errors
/// A surface whose boundary is open, that encloses nothing, or that overlaps another.
pub(super) fn regions(
    linework: &Linework,
    grouping: &Grouping,
    sources: &Sources,
    warnings: &mut Vec<Warning>,
) -> Answer<Vec<(Region, Place)>> {
    let mut all = Vec::new();
    let mut known: BTreeMap<Vec<i32>, i32> = BTreeMap::new();
    for (&tag, surface) in &linework.surfaces {
        let mut curves: Vec<i32> = surface.curves().map(i32::abs).collect();
        curves.sort_unstable();
        let first = *known.entry(curves).or_insert(tag);
        if first != tag {
            let notice = Notice::SameSurface { surface: tag, first };
            let file = sources.name(surface.place.file).to_owned();
            warnings.push(Warning { file, line: sources.line(surface.place), notice });
            continue;
        }
        all.push(parts(linework, tag, surface)?);
    }
    let mut found = Vec::new();
    let mut areas = Vec::new();
    let mut owners = Vec::new();
    for parts in &all {
        let surface = &linework.surfaces[&parts.tag];
        let (walls, points) = embedded(linework, surface);
        for (outer, holes) in &parts.parts {
            let polygons: Vec<&Polygon> =
                std::iter::once(outer).chain(holes).map(|&i| &parts.polygons[i]).collect();
            let stretches: Vec<Stretch> = stretches(&polygons, &walls, &points);
            let Some(best) = stretches.first() else {
                return Err(Problem::Empty { surface: parts.tag }.at(parts.place));
            };
            let tag = grouping.surface(parts.tag);
            let divided = if walls.is_empty() {
                Vec::new()
            } else {
                faces::seeds(&polygons, &walls, &points)
            };
            let seeds = if divided.is_empty() { vec![best.at(0.5)] } else { divided };
            found.extend(seeds.into_iter().map(|seed| {
                let region = Region { seed, tag, attribute: f64::from(tag), max_area: None };
                (region, parts.place)
            }));
            areas.push(Area { polygons, stretches });
            owners.push(parts);
        }
    }
    if let Some(([i, j], at)) = overlap(&areas) {
        let (first, second) = in_order(owners[i], owners[j]);
        let (surface, other) = (second.tag, first.tag);
        let line = sources.line(first.place);
        return Err(Problem::Overlap { surface, other, line, at }.at(second.place));
    }
    Ok(found)
}

/// Two surfaces, the one that stands first in the script first.
fn in_order<'a>(a: &'a Parts, b: &'a Parts) -> (&'a Parts, &'a Parts) {
    let key = |parts: &Parts| (parts.place.file, parts.place.offset);
    if key(a) <= key(b) { (a, b) } else { (b, a) }
}

fn parts(linework: &Linework, tag: i32, surface: &Surface) -> Answer<Parts> {
    let ends = |curve: i32| linework.curves.ends(curve);
    let mut found: Vec<Contour> = Vec::new();
    for (i, (_, curves)) in surface.loops.iter().enumerate() {
        let open = |point: u32| {
            let point = linework.points.tags[point as usize];
            Problem::Open { surface: tag, point }.at(surface.place)
        };
        found.extend(contours(i, curves, ends).map_err(open)?);
    }
    let loops: Vec<i32> = found.iter().map(|contour| surface.loops[contour.of_loop].0).collect();
    let polygon = |contour: &Contour| {
        let mut places = Vec::with_capacity(contour.curves.len());
        contour.curves.iter().for_each(|&curve| linework.add_places(curve, &mut places));
        Polygon::new(places)
    };
    let polygons: Vec<Polygon> = found.iter().map(polygon).collect();
    let holders = holders(&polygons);
    if !surface.tools.is_empty() {
        let tool_of: Vec<usize> = found.iter().map(|c| surface.tool_of(c.of_loop)).collect();
        if !tools_are_inside(&polygons, &holders, &tool_of) {
            return Err(Problem::NotInside { surface: tag }.at(surface.place));
        }
    }
    let Some(largest) =
        (0..polygons.len()).max_by(|&i, &j| polygons[i].area.total_cmp(&polygons[j].area))
    else {
        return Err(Problem::Empty { surface: tag }.at(surface.place));
    };
    // Another loop outside of the largest is a slip; a loop of several contours may hold such.
    let outside = (0..polygons.len())
        .find(|&i| found[i].of_loop != found[largest].of_loop && holders[i].is_empty());
    if let Some(outside) = outside {
        let (outside, outer) = (loops[outside], loops[largest]);
        return Err(Problem::LoopOutside { surface: tag, outside, outer }.at(surface.place));
    }
    let depth = |i: usize| holders[i].len();
    let mut parts: Vec<(usize, Vec<usize>)> = Vec::new();
    for outer in (0..polygons.len()).filter(|&i| depth(i) % 2 == 0) {
        let is_hole = |&i: &usize| depth(i) == depth(outer) + 1 && holders[i].contains(&outer);
        parts.push((outer, (0..polygons.len()).filter(is_hole).collect()));
    }
    Ok(Parts { tag, place: surface.place, polygons, parts })
}

/// Whether what is cut out of an object lies inside it and apart from one another: the polygons of
/// tools (numbered from 1) enclose no polygon of the object (0) or of another tool, lie inside the
/// object, and none of these meet.
fn tools_are_inside(polygons: &[Polygon], holders: &[Vec<usize>], tool_of: &[usize]) -> bool {
    let is_placed = |i: usize| {
        let tools = holders[i].iter().map(|&j| tool_of[j]);
        let in_object = tools.clone().filter(|&tool| tool == 0).count() % 2 == 1;
        let in_others = tools.filter(|&tool| tool != 0 && tool != tool_of[i]).count() > 0;
        !in_others && (tool_of[i] == 0 || in_object)
    };
    let apart = |i: usize, j: usize| tool_of[i] == tool_of[j] || !polygons[i].meets(&polygons[j]);
    (0..polygons.len()).all(|i| is_placed(i) && (0..i).all(|j| apart(i, j)))
}

/// For each polygon those that enclose it.
fn holders(polygons: &[Polygon]) -> Vec<Vec<usize>> {
    let mut by_width: Vec<usize> = (0..polygons.len()).collect();
    by_width
        .sort_by(|&i, &j| polygons[i].least[0].total_cmp(&polygons[j].least[0]).then(i.cmp(&j)));
    (0..polygons.len())
        .map(|i| {
            let inner = &polygons[i];
            let end = by_width.partition_point(|&j| polygons[j].least[0] <= inner.least[0]);
            let around = by_width[..end].iter().copied().filter(|&j| {
                let outer = &polygons[j];
                j != i
                    && (0..2)
                        .all(|k| outer.least[k] <= inner.least[k] && inner.most[k] <= outer.most[k])
            });
            around.filter(|&j| encloses(&polygons[j], inner)).collect()
        })
        .collect()
}

/// Whether a polygon encloses another one that it does not cross: by a corner of that one which
/// is not on it, or by the middle of a side.
pub(super) fn encloses(outer: &Polygon, inner: &Polygon) -> bool {
    if outer.area <= inner.area {
        return false;
    }
    let mut corners = outer.points.clone();
    corners.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let is_corner = |p: &[f64; 2]| {
        corners.binary_search_by(|q| q[0].total_cmp(&p[0]).then(q[1].total_cmp(&p[1]))).is_ok()
    };
    let free = inner.points.iter().find(|p| !is_corner(p)).copied();
    let middle = || {
        let [a, b] = inner.sides().next().unwrap_or_default();
        [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
    };
    outer.holds(free.unwrap_or_else(middle))
}

/// The sides of embedded curves, and the embedded points.
fn embedded(linework: &Linework, surface: &Surface) -> (Vec<[[f64; 2]; 2]>, Vec<[f64; 2]>) {
    let mut walls = Vec::new();
    for &curve in &surface.embedded_curves {
        let mut places = Vec::new();
        linework.add_places(curve, &mut places);
        let [_, last] = linework.curves.ends(curve);
        places.push(linework.points.at[last as usize]);
        walls.extend(places.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    let at = |&point: &i32| linework.points.at[linework.points.index(point) as usize];
    (walls, surface.embedded_points.iter().map(at).collect())
}
