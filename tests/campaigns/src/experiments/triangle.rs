//! What Triangle makes of the outlines of [`growth`](super::growth), as recorded in
//! `docs/experiments/triangle.csv`.
//!
//! Triangle is another program: the page needs none, so its numbers are recorded by a step of their
//! own (see the README of the campaigns). Each stands beside a fingerprint of its outline; where the
//! outline has changed since, the record is out of date and the page is not made.

use meshwright::Pslg;

use crate::poly;

/// The record: `outline,fingerprint,points`.
const RECORD: &str = include_str!("../../../../docs/experiments/triangle.csv");

/// The number of points that Triangle (`-pq26.45D`) makes of an outline.
///
/// # Errors
/// It is not recorded, or of another outline of that name.
pub fn points(name: &str, outline: &Pslg) -> Result<usize, String> {
    let outdated = |what: &str| {
        format!(
            "docs/experiments/triangle.csv: {what} `{name}`; tests/campaigns/README.md says how to record it"
        )
    };
    let rows = RECORD.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let row = rows.filter(|row| row[0] == name).collect::<Vec<_>>();
    match &row[..] {
        [row] if row.len() == 3 && row[1] == fingerprint(outline) => {
            row[2].parse().map_err(|_| outdated("no number for"))
        }
        [_] => Err(outdated("another outline of the name")),
        _ => Err(outdated("no row for")),
    }
}

/// 64 bits (FNV-1a) of the outline's `.poly` text.
#[must_use]
pub fn fingerprint(outline: &Pslg) -> String {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    let hash = poly::text(outline, "").bytes().fold(0xcbf2_9ce4_8422_2325, step);
    format!("{hash:016x}")
}

/// The `.poly` text that Triangle is given: the first line names the outline and its fingerprint.
#[must_use]
pub fn text(name: &str, outline: &Pslg) -> String {
    poly::text(outline, &format!("{name},{}", fingerprint(outline)))
}
