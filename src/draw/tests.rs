use meshwright_formats::{Group, Provenance, Region};

use super::trails::{Walk, trails};
use super::*;

/// Two triangles over the unit square, one of region 1, one of region 2.
fn square() -> Mesh {
    Mesh {
        points: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        provenance: vec![Provenance::Input; 4],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        triangle_tags: vec![1, 2],
        edges: vec![[0, 1], [1, 2], [2, 3], [3, 0]],
        edge_tags: vec![7, 7, 0, 8],
        groups: vec![Group { dim: 1, tag: 7, name: "wall <&>".into() }],
        ..Mesh::default()
    }
}

fn svg_of(mesh: &Mesh, options: &Options) -> String {
    let mut svg = Vec::new();
    super::mesh(mesh, options, &mut svg).expect("a Vec takes everything");
    String::from_utf8(svg).expect("SVG is UTF-8")
}

fn outline_of(pslg: &Pslg, options: &Options) -> String {
    let mut svg = Vec::new();
    outline(pslg, options, &mut svg).expect("a Vec takes everything");
    String::from_utf8(svg).expect("SVG is UTF-8")
}

/// Every pair of numbers that the paths of a picture visit, in pixels.
fn visited(svg: &str) -> Vec<[f64; 2]> {
    let mut places = Vec::new();
    for path in svg.split(" d=\"").skip(1).map(|rest| rest.split('"').next().unwrap()) {
        if path.starts_with('M') {
            continue; // the legend's swatches
        }
        let mut numbers = Vec::new();
        let mut word = String::new();
        for c in path.replace("h0", "").chars() {
            if !c.is_ascii_digit() && !word.is_empty() && word != "-" {
                numbers.push(word.parse::<i64>().unwrap());
                word.clear();
            }
            if c.is_ascii_digit() || c == '-' {
                word.push(c);
            }
        }
        numbers.extend(word.parse::<i64>().ok());
        let (mut x, mut y) = (0, 0);
        for pair in numbers.chunks_exact(2) {
            (x, y) = (x + pair[0], y + pair[1]);
            // After `z` the pen is at the polygon's start: only paths of one polygon are read on.
            places.push([x as f64 / 100.0, y as f64 / 100.0]);
        }
    }
    places
}

#[test]
fn the_same_mesh_gives_the_same_bytes() {
    let options = Options::default();
    assert_eq!(svg_of(&square(), &options), svg_of(&square(), &options));
}

#[test]
fn y_points_upwards() {
    let pslg = Pslg { points: vec![[0.0, 0.0], [0.0, 1.0]], ..Pslg::default() };
    let frame = Frame::of(pslg.points.iter(), &Options::default());
    assert!(frame.pixel([0.0, 1.0])[1] < frame.pixel([0.0, 0.0])[1]);
}

#[test]
fn names_are_escaped_and_tags_without_a_name_are_numbered() {
    let svg = svg_of(&square(), &Options::default());
    assert!(svg.contains("wall &lt;&amp;&gt; (7)"), "{svg}");
    assert!(svg.contains(">boundary 8<") && svg.contains(">boundary without a tag<"), "{svg}");
    assert!(svg.contains(">region 1<") && svg.contains(">region 2<"), "{svg}");
}

#[test]
fn a_picture_without_legend_has_no_text() {
    let svg = svg_of(&square(), &Options { legend: false, ..Options::default() });
    assert!(!svg.contains("<text"), "{svg}");
}

#[test]
fn every_extent_of_doubles_fits_the_page() {
    for size in [5e-324, 1e-300, 1.0, 1e300, f64::MAX] {
        let mut mesh = square();
        for point in &mut mesh.points {
            *point = point.map(|x| (2.0 * x - 1.0) * size);
        }
        for [x, y] in visited(&svg_of(&mesh, &Options::default())) {
            assert!((0.0..=960.0).contains(&x) && (0.0..=1440.0).contains(&y), "{size}: {x} {y}");
        }
    }
}

#[test]
fn nothing_is_written_far_outside_a_zoom_box() {
    let zoom = Some([0.499, 0.499, 0.501, 0.501]);
    let svg = svg_of(&square(), &Options { zoom, legend: false, ..Options::default() });
    let places = visited(&svg);
    assert!(!places.is_empty());
    for [x, y] in places {
        assert!((-9.0..=969.0).contains(&x) && (-9.0..=969.0).contains(&y), "{x} {y}");
    }
}

#[test]
fn no_input_makes_a_picture_fail() {
    let empty = Options::default();
    svg_of(&Mesh::default(), &empty);
    outline_of(&Pslg::default(), &empty);
    let mut broken = square();
    broken.triangles.push([0, 1, 99]);
    broken.edges.push([3, 99]);
    broken.edge_tags.clear();
    broken.points[1] = [f64::NAN, f64::INFINITY];
    for zoom in [None, Some([0.0; 4]), Some([f64::NAN; 4]), Some([1.0, 1.0, -1.0, -1.0])] {
        for width in [0.0, f64::NAN, -1.0, 1e300] {
            svg_of(&broken, &Options { zoom, width, ..Options::default() });
        }
    }
}

#[test]
fn faults_are_numbered_and_explained() {
    let marks = vec![
        Mark::Fault { place: [0.5, 0.5], text: "segments 12 and 40 cross".into() },
        Mark::Excused([[0.0, 0.0], [1e-4, 0.0], [1e-4, 1e-4]]),
    ];
    let svg = svg_of(&square(), &Options { marks, ..Options::default() });
    assert!(svg.contains(">1: segments 12 and 40 cross<"), "{svg}");
    assert!(svg.contains(">angle excused by the outline<"), "{svg}");
    assert_eq!(svg.matches("<circle").count(), 2 * 2 + 1 + 1, "{svg}"); // rings, swatch, dot
}

#[test]
fn many_tiny_triangles_in_one_place_share_a_ring() {
    let tiny = |x: f64| Mark::Excused([[x, 0.5], [x + 1e-5, 0.5], [x, 0.5 + 1e-5]]);
    let marks = (0..50).map(|i| tiny(0.5 + 1e-6 * f64::from(i))).collect();
    let svg = svg_of(&square(), &Options { marks, legend: false, ..Options::default() });
    assert_eq!(svg.matches("<circle").count(), 2, "{svg}");
}

#[test]
fn seeds_are_drawn_with_their_regions_name() {
    let region = Region { seed: [0.2, 0.2], tag: 3, attribute: 3.0, max_area: None };
    let pslg = Pslg {
        points: vec![[0.0, 0.0], [1.0, 1.0]],
        segments: vec![[0, 1]],
        segment_tags: vec![0],
        holes: vec![[0.5, 0.2]],
        regions: vec![region],
        groups: vec![Group { dim: 2, tag: 3, name: "steel".into() }],
        ..Pslg::default()
    };
    let svg = outline_of(&pslg, &Options::default());
    assert!(svg.contains(">hole<") && svg.contains(">steel (3)<"), "{svg}");
}

#[test]
fn trails_walk_each_edge_once() {
    let edges = [[0, 1], [1, 2], [2, 0], [2, 3], [3, 4], [5, 6]];
    let mut walked: Vec<[u32; 2]> = trails(&edges, Walk::BothWays)
        .iter()
        .flat_map(|trail| trail.windows(2).map(|e| [e[0].min(e[1]), e[0].max(e[1])]))
        .collect();
    walked.sort_unstable();
    assert_eq!(walked, [[0, 1], [0, 2], [1, 2], [2, 3], [3, 4], [5, 6]]);
}

#[test]
fn directed_loops_come_back_closed() {
    let edges = [[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]];
    let loops = trails(&edges, Walk::Forwards);
    assert_eq!(loops, [vec![0, 1, 2, 0], vec![3, 4, 5, 3]]);
}
