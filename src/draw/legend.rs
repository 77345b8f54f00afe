//! The lines of text below a picture.

use std::fmt::Write;

use super::palette;

/// More entries than this are counted, not shown.
const MOST: usize = 28;
const LINE: f64 = 20.0;
const FONT_SIZE: f64 = 12.5;
/// Mean width of a character of that size: the page knows no font.
const CHARACTER: f64 = 6.9;

/// What a picture's colours and marks mean.
#[derive(Debug, Default)]
pub struct Legend {
    entries: Vec<(Swatch, String)>,
    /// How many entries at the front were put there first.
    first: usize,
}

/// The sign before an entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Swatch {
    /// A stretch of line.
    Line(&'static str),
    /// A filled area.
    Area(&'static str),
    /// A dot.
    Dot(&'static str),
    /// A small cross.
    Cross(&'static str),
    /// A diamond.
    Diamond(&'static str),
    /// A ring with a number in it.
    Ring(&'static str),
}

impl Legend {
    /// Adds an entry.
    pub fn add(&mut self, swatch: Swatch, text: impl Into<String>) {
        self.entries.push((swatch, text.into()));
    }

    /// Adds an entry before those that are not the first.
    pub fn add_first(&mut self, swatch: Swatch, text: impl Into<String>) {
        self.entries.insert(self.first, (swatch, text.into()));
        self.first += 1;
    }

    /// Adds the entries of another legend that are not there yet.
    pub fn add_new(&mut self, other: Self) {
        for entry in other.entries {
            if !self.entries.contains(&entry) {
                self.entries.push(entry);
            }
        }
    }

    /// The legend of a page of this width, beginning at this height: its SVG and its own height.
    pub fn lay_out(&self, width: f64, top: f64) -> (String, f64) {
        if self.entries.is_empty() {
            return (String::new(), 0.0);
        }
        let (left, right) = (20.0, width - 12.0);
        let (mut x, mut y) = (left, top + LINE * 0.6);
        let mut svg = format!(
            "<g font-family=\"system-ui,'Segoe UI',Roboto,'DejaVu Sans',sans-serif\" \
             font-size=\"{FONT_SIZE}\" fill=\"{}\">\n",
            palette::TEXT
        );
        let more = self.entries.len().saturating_sub(MOST);
        let and_more = (more > 0).then(|| (None, format!("and {more} more")));
        let shown =
            self.entries.iter().take(MOST).map(|(swatch, text)| (Some(*swatch), text.clone()));
        for (swatch, text) in shown.chain(and_more) {
            let needs = 26.0 + CHARACTER * text.chars().count() as f64;
            if x > left && x + needs > right {
                (x, y) = (left, y + LINE);
            }
            if let Some(swatch) = swatch {
                swatch.draw(x, y, &mut svg);
            }
            let indent = if swatch.is_some() { 24.0 } else { 0.0 };
            write!(svg, "<text x=\"{:.1}\" y=\"{:.1}\">", x + indent, y + 4.4)
                .expect("writing to a string succeeds");
            escape(&text, &mut svg);
            svg.push_str("</text>\n");
            x += needs + 18.0;
        }
        svg.push_str("</g>\n");
        (svg, y - top + LINE)
    }
}

impl Swatch {
    fn draw(self, x: f64, y: f64, svg: &mut String) {
        let middle = x + 9.0;
        let shape = match self {
            Swatch::Line(colour) => {
                format!("<path d=\"M{x:.1} {y:.1}h18\" stroke=\"{colour}\" stroke-width=\"2.2\"/>")
            }
            Swatch::Area(colour) => format!(
                "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"16\" height=\"12\" rx=\"2\" \
                 fill=\"{colour}\" stroke=\"{}\" stroke-opacity=\".5\" stroke-width=\".6\"/>",
                x + 1.0,
                y - 6.0,
                palette::INNER_EDGE
            ),
            Swatch::Dot(colour) => {
                format!("<circle cx=\"{middle:.1}\" cy=\"{y:.1}\" r=\"3\" fill=\"{colour}\"/>")
            }
            Swatch::Cross(colour) => format!(
                "<path d=\"M{:.1} {:.1}l8 8m0-8l-8 8\" stroke=\"{colour}\" stroke-width=\"1.6\" \
                 stroke-linecap=\"round\"/>",
                middle - 4.0,
                y - 4.0
            ),
            Swatch::Diamond(colour) => format!(
                "<path d=\"M{:.1} {y:.1}l5-5 5 5-5 5z\" fill=\"{colour}\" stroke=\"{}\" \
                 stroke-width=\".8\"/>",
                middle - 5.0,
                palette::TEXT
            ),
            Swatch::Ring(colour) => format!(
                "<circle cx=\"{middle:.1}\" cy=\"{y:.1}\" r=\"6\" fill=\"none\" \
                 stroke=\"{colour}\" stroke-width=\"2\"/>"
            ),
        };
        svg.push_str(&shape);
    }
}

/// Text as XML takes it: no markup, no control characters.
pub fn escape(text: &str, svg: &mut String) {
    for character in text.chars() {
        match character {
            '&' => svg.push_str("&amp;"),
            '<' => svg.push_str("&lt;"),
            '>' => svg.push_str("&gt;"),
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => svg.push('\u{fffd}'),
            c => svg.push(c),
        }
    }
}
