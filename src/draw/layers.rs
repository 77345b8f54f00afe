//! The layers of a picture, from the back to the front.

use std::fmt::Write;

use meshwright_formats::{Group, Mesh, Provenance, Pslg, Tag};

use super::Dots;
use super::frame::{Frame, Pixel};
use super::legend::{Legend, Swatch};
use super::palette;
use super::path::Path;
use super::trails::{Walk, trails};

/// Dots are shown unasked where each has a square of this side (in pixels) to itself.
const ROOM_FOR_A_DOT: f64 = 15.0;

/// The segments of an outline, a colour for each tag.
pub fn segments(pslg: &Pslg, frame: &Frame, page: &mut String, legend: &mut Legend) {
    lines_by_tag(
        &Lines {
            points: &pslg.points,
            edges: &pslg.segments,
            tags: &pslg.segment_tags,
            groups: &pslg.groups,
            untagged: "segment without a tag",
        },
        frame,
        page,
        legend,
    );
}

/// The edges of a mesh that lie on segments, a colour for each tag.
pub fn tagged_edges(mesh: &Mesh, frame: &Frame, page: &mut String, legend: &mut Legend) {
    lines_by_tag(
        &Lines {
            points: &mesh.points,
            edges: &mesh.edges,
            tags: &mesh.edge_tags,
            groups: &mesh.groups,
            untagged: "boundary without a tag",
        },
        frame,
        page,
        legend,
    );
}

struct Lines<'a> {
    points: &'a [[f64; 2]],
    edges: &'a [[u32; 2]],
    tags: &'a [Tag],
    groups: &'a [Group],
    untagged: &'static str,
}

fn lines_by_tag(lines: &Lines, frame: &Frame, page: &mut String, legend: &mut Legend) {
    let seen = |edge: &[u32; 2]| visible(lines.points, edge, frame);
    let mut tagged: Vec<(Tag, [u32; 2])> = (lines.edges.iter().enumerate())
        .filter(|(_, edge)| seen(edge))
        .map(|(i, edge)| (lines.tags.get(i).copied().unwrap_or(0), *edge))
        .collect();
    tagged.sort_by_key(|&(tag, _)| tag); // stable: within a tag the order of the file
    let width = line_width(tagged.len(), frame);
    // A tag keeps its colour where a zoom box hides other ones.
    let mut tags: Vec<Tag> = lines.tags.iter().copied().filter(|&tag| tag != 0).collect();
    tags.sort_unstable();
    tags.dedup();
    for group in tagged.chunk_by(|a, b| a.0 == b.0) {
        let tag = group[0].0;
        let (colour, name) = if tag == 0 {
            (palette::UNTAGGED, lines.untagged.to_string())
        } else {
            let rank = tags.binary_search(&tag).unwrap_or(0);
            (palette::boundary(rank), group_name(lines.groups, 1, tag))
        };
        let edges: Vec<[u32; 2]> = group.iter().map(|&(_, edge)| edge).collect();
        stroke(&edges, lines.points, frame, colour, width, page);
        legend.add(Swatch::Line(colour), name);
    }
}

/// The triangles, a soft colour for each region: each region as one shape.
pub fn regions(mesh: &Mesh, frame: &Frame, page: &mut String, legend: &mut Legend) {
    let mut order: Vec<u32> = (0..mesh.triangles.len() as u32).collect();
    let tag = |triangle: u32| mesh.triangle_tags.get(triangle as usize).copied().unwrap_or(0);
    order.sort_by_key(|&triangle| tag(triangle));
    let several = order.first().map(|&t| tag(t)) != order.last().map(|&t| tag(t));
    let mut rank = 0;
    for region in order.chunk_by(|&a, &b| tag(a) == tag(b)) {
        let tag = tag(region[0]);
        let colour = if tag == 0 && several {
            palette::NO_REGION
        } else {
            rank += 1;
            palette::region(rank - 1)
        };
        let rim = rim(mesh, region);
        let mut path = Path::default();
        for trail in trails(&rim, Walk::Forwards) {
            let loop_pixels = trail.iter().map(|&p| frame.pixel(mesh.points[p as usize])).collect();
            path.polygon(frame, loop_pixels);
        }
        if path.is_empty() {
            continue;
        }
        write_path(page, &path, &format!("fill=\"{colour}\""));
        if tag != 0 {
            legend.add(Swatch::Area(colour), group_name(&mesh.groups, 2, tag));
        } else if several {
            legend.add(Swatch::Area(colour), "region without a tag");
        }
    }
}

/// The directed edges of these triangles whose reverse is no edge of them.
fn rim(mesh: &Mesh, triangles: &[u32]) -> Vec<[u32; 2]> {
    // (low end, high end, direction): an edge and its reverse stand side by side.
    let mut edges: Vec<(u32, u32, bool)> = triangles
        .iter()
        .map(|&t| mesh.triangles[t as usize])
        .filter(|corners| in_range(mesh, corners))
        .flat_map(|[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(|[a, b]| (a.min(b), a.max(b), a < b))
        .collect();
    edges.sort_unstable();
    let mut rim = Vec::new();
    for same in edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
        let (low, high, _) = same[0];
        let forwards = same.iter().filter(|edge| edge.2).count();
        let backwards = same.len() - forwards;
        // In a mesh each direction comes once at most; a faulty one may hold more.
        rim.extend(std::iter::repeat_n([low, high], forwards.saturating_sub(backwards)));
        rim.extend(std::iter::repeat_n([high, low], backwards.saturating_sub(forwards)));
    }
    rim
}

/// The edges between triangles that lie on no segment, thin.
pub fn inner_edges(mesh: &Mesh, frame: &Frame, page: &mut String) {
    let undirected = |[a, b]: [u32; 2]| [a.min(b), a.max(b)];
    let mut known: Vec<[u32; 2]> = mesh.edges.iter().copied().map(undirected).collect();
    known.sort_unstable();
    let mut edges: Vec<[u32; 2]> = mesh
        .triangles
        .iter()
        .filter(|corners| in_range(mesh, corners.as_slice()))
        .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
        .map(undirected)
        .filter(|edge| visible(&mesh.points, edge, frame))
        .collect();
    edges.sort_unstable();
    edges.dedup();
    edges.retain(|edge| known.binary_search(edge).is_err());
    let width = (0.4 * line_width(edges.len(), frame)).max(8.0);
    stroke(&edges, &mesh.points, frame, palette::INNER_EDGE, width, page);
}

/// The points of an outline.
pub fn outline_points(
    pslg: &Pslg,
    dots: Dots,
    frame: &Frame,
    page: &mut String,
    legend: &mut Legend,
) {
    let pixels: Vec<Pixel> = shown(&pslg.points, frame).map(|(_, pixel)| pixel).collect();
    let width = dot_width(pixels.len(), frame).min(40.0 * short_line(pslg, frame)).max(120.0);
    if room_for(pixels.len(), dots, frame) {
        let (colour, name) = palette::point_kind(Provenance::Input);
        draw_dots(&pixels, colour, width, page);
        if !pixels.is_empty() {
            legend.add(Swatch::Dot(colour), name.trim_start_matches("input "));
        }
    }
}

/// The points of a mesh, a colour for each kind.
pub fn mesh_points(mesh: &Mesh, dots: Dots, frame: &Frame, page: &mut String, legend: &mut Legend) {
    let pixels: Vec<(usize, Pixel)> = shown(&mesh.points, frame).collect();
    if !room_for(pixels.len(), dots, frame) {
        return;
    }
    let width = dot_width(pixels.len(), frame);
    if mesh.provenance.len() != mesh.points.len() {
        let pixels: Vec<Pixel> = pixels.iter().map(|&(_, pixel)| pixel).collect();
        draw_dots(&pixels, palette::UNTAGGED, width, page);
        return;
    }
    use Provenance::{Circumcenter, Input, Midpoint, Shell};
    // The few of interest in front of the many.
    for kind in [Circumcenter, Midpoint, Shell, Input] {
        let of_kind: Vec<Pixel> = pixels
            .iter()
            .filter(|&&(point, _)| mesh.provenance[point] == kind)
            .map(|&(_, pixel)| pixel)
            .collect();
        if !of_kind.is_empty() {
            let (colour, name) = palette::point_kind(kind);
            draw_dots(&of_kind, colour, width, page);
            legend.add(Swatch::Dot(colour), name);
        }
    }
}

/// Hole seeds as crosses, region seeds as diamonds in their region's colour.
pub fn seeds(pslg: &Pslg, frame: &Frame, page: &mut String, legend: &mut Legend) {
    let mut crosses = Path::default();
    for (_, [x, y]) in shown(&pslg.holes, frame) {
        crosses.line(frame, &[[x - 4.0, y - 4.0], [x + 4.0, y + 4.0]]);
        crosses.line(frame, &[[x - 4.0, y + 4.0], [x + 4.0, y - 4.0]]);
    }
    if !crosses.is_empty() {
        write_path(page, &crosses, &format!("stroke=\"{}\" stroke-width=\"160\"", palette::HOLE));
        legend.add(Swatch::Cross(palette::HOLE), "hole");
    }
    let mut tags: Vec<Tag> = pslg.regions.iter().map(|region| region.tag).collect();
    tags.sort_unstable();
    tags.dedup();
    for (rank, &tag) in tags.iter().enumerate() {
        let mut diamonds = Path::default();
        for region in pslg.regions.iter().filter(|region| region.tag == tag) {
            let [x, y] = frame.pixel(region.seed);
            if frame.shows([x, y]) {
                let corners = vec![[x - 6.0, y], [x, y - 6.0], [x + 6.0, y], [x, y + 6.0]];
                diamonds.polygon(frame, corners);
            }
        }
        if !diamonds.is_empty() {
            let colour = palette::region(rank);
            let style =
                format!("fill=\"{colour}\" stroke=\"{}\" stroke-width=\"90\"", palette::TEXT);
            write_path(page, &diamonds, &style);
            legend.add(Swatch::Diamond(colour), group_name(&pslg.groups, 2, tag));
        }
    }
}

/// `name (tag)`, or `boundary 3` and `region 3` for a tag without a name.
fn group_name(groups: &[Group], dim: u8, tag: Tag) -> String {
    match groups.iter().find(|group| group.dim == dim && group.tag == tag) {
        Some(group) => format!("{} ({tag})", group.name),
        None if dim == 1 => format!("boundary {tag}"),
        None => format!("region {tag}"),
    }
}

fn stroke(
    edges: &[[u32; 2]],
    points: &[[f64; 2]],
    frame: &Frame,
    colour: &str,
    width: f64,
    page: &mut String,
) {
    let mut path = Path::default();
    for trail in trails(edges, Walk::BothWays) {
        let pixels: Vec<Pixel> = trail.iter().map(|&p| frame.pixel(points[p as usize])).collect();
        path.line(frame, &pixels);
    }
    write_path(page, &path, &format!("stroke=\"{colour}\" stroke-width=\"{width:.0}\""));
}

/// Adds a path to a page; an empty one adds nothing.
pub fn write_path(page: &mut String, path: &Path, style: &str) {
    if !path.is_empty() {
        writeln!(page, "<path {style} d=\"{}\"/>", path.data())
            .expect("writing to a string succeeds");
    }
}

fn draw_dots(pixels: &[Pixel], colour: &str, width: f64, page: &mut String) {
    let mut path = Path::default();
    for &pixel in pixels {
        path.dot(pixel);
    }
    write_path(page, &path, &format!("stroke=\"{colour}\" stroke-width=\"{width:.0}\""));
}

fn shown<'a>(
    points: &'a [[f64; 2]],
    frame: &'a Frame,
) -> impl Iterator<Item = (usize, Pixel)> + 'a {
    let pixels = points.iter().map(|&point| frame.pixel(point));
    pixels.enumerate().filter(|&(_, pixel)| frame.shows(pixel))
}

fn visible(points: &[[f64; 2]], &[a, b]: &[u32; 2], frame: &Frame) -> bool {
    let end = |p: u32| points.get(p as usize).map(|&point| frame.pixel(point));
    match (end(a), end(b)) {
        (Some(a), Some(b)) => frame.clip_line(a, b).is_some(),
        _ => false,
    }
}

fn in_range(mesh: &Mesh, corners: &[u32]) -> bool {
    corners.iter().all(|&corner| (corner as usize) < mesh.points.len())
}

/// In hundredths of a pixel: thinner where many lines share the page.
fn line_width(lines: usize, frame: &Frame) -> f64 {
    let room = (frame.width * frame.height / (lines.max(1) as f64)).sqrt();
    (room * 14.0).clamp(40.0, 170.0).round()
}

/// In hundredths of a pixel.
fn dot_width(dots: usize, frame: &Frame) -> f64 {
    let room = (frame.width * frame.height / (dots.max(1) as f64)).sqrt();
    (room * 22.0).clamp(180.0, 480.0).round()
}

/// The length in pixels that a quarter of the segments do not reach.
fn short_line(pslg: &Pslg, frame: &Frame) -> f64 {
    let length = |segment: &[u32; 2]| {
        let [a, b] = segment.map(|p| pslg.points.get(p as usize).map(|&p| frame.pixel(p)));
        let (a, b) = (a?, b?);
        (frame.shows(a) || frame.shows(b)).then(|| libm::hypot(a[0] - b[0], a[1] - b[1]))
    };
    let mut lengths: Vec<f64> = pslg.segments.iter().filter_map(length).collect();
    lengths.sort_unstable_by(f64::total_cmp);
    lengths.get(lengths.len() / 4).copied().unwrap_or(f64::INFINITY)
}

fn room_for(points: usize, dots: Dots, frame: &Frame) -> bool {
    match dots {
        Dots::All => true,
        Dots::None => false,
        Dots::Auto => points as f64 * ROOM_FOR_A_DOT * ROOM_FOR_A_DOT <= frame.width * frame.height,
    }
}
