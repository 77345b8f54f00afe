//! Writing an outline as Triangle's `.poly`, so that a failure can be looked at by every tool.

use std::fmt::Write as _;

use meshwright::Pslg;

/// The `.poly` text of an outline, zero-based; every number reads back to the same double.
#[must_use]
pub fn text(outline: &Pslg, comment: &str) -> String {
    let mut text = String::new();
    for line in comment.lines() {
        let _ = writeln!(text, "# {line}");
    }
    let _ = writeln!(text, "{} 2 0 0", outline.points.len());
    for (i, [x, y]) in outline.points.iter().enumerate() {
        let _ = writeln!(text, "{i} {x:?} {y:?}");
    }
    let _ = writeln!(text, "{} 1", outline.segments.len());
    for (i, ([a, b], tag)) in outline.segments.iter().zip(&outline.segment_tags).enumerate() {
        let _ = writeln!(text, "{i} {a} {b} {tag}");
    }
    let _ = writeln!(text, "{}", outline.holes.len());
    for (i, [x, y]) in outline.holes.iter().enumerate() {
        let _ = writeln!(text, "{i} {x:?} {y:?}");
    }
    let _ = writeln!(text, "{}", outline.regions.len());
    for (i, region) in outline.regions.iter().enumerate() {
        let [x, y] = region.seed;
        let area = region.max_area.unwrap_or(-1.0);
        let _ = writeln!(text, "{i} {x:?} {y:?} {:?} {area:?}", region.attribute);
    }
    text
}
