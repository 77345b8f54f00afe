//! The words for what may be chosen: in options, in `--json` and in certificate files alike.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use meshwright::formats::Order;
use meshwright::formats::msh::Version;
use meshwright::formats::selection::Cells;
use meshwright::formats::vtu::Encoding;
use meshwright::{Excuse, Parameters, Region, Rule, Splitting, Steiner};

/// Everything that may be asked for at once.
pub const PROFILES: [(&str, Profile); 2] =
    [("default", Profile(Parameters::default)), ("paper", Profile(Parameters::paper))];
/// What is meshed.
pub const REGIONS: [(&str, Region); 3] =
    [("domain", Region::Domain), ("hull", Region::Hull), ("global", Region::Global)];
/// When a small angle is left alone.
pub const EXCUSES: [(&str, Excuse); 2] =
    [("measured", Excuse::Measured), ("midpoints", Excuse::Midpoints)];
/// Where segments are split.
pub const SPLITTINGS: [(&str, Splitting); 3] =
    [("ladder", Splitting::Ladder), ("shells", Splitting::Shells), ("augment", Splitting::Augment)];
/// Where the point goes that removes a bad triangle.
pub const STEINERS: [(&str, Steiner); 3] = [
    ("off-center", Steiner::OffCenter),
    ("circumcenter", Steiner::Circumcenter),
    ("look-ahead", Steiner::LookAhead),
];
/// Which small angles are attacked.
pub const RULES: [(&str, Rule); 3] =
    [("adaptive", Rule::Adaptive), ("ruppert", Rule::Ruppert), ("terminator", Rule::Terminator)];

/// Versions of `.msh` files.
pub const MSH_VERSIONS: [(&str, Version); 2] = [("2.2", Version::V2_2), ("4.1", Version::V4_1)];
/// How many nodes an element has.
pub const ORDERS: [(&str, Order); 2] = [("1", Order::First), ("2", Order::Second)];

/// How the arrays of VTK's XML files are written.
pub const ENCODINGS: [(&str, Encoding); 3] =
    [("raw", Encoding::Raw), ("base64", Encoding::Base64), ("ascii", Encoding::Ascii)];
/// What cells a file holds.
pub const CELLS: [(&str, Cells); 3] =
    [("all", Cells::All), ("faces", Cells::Faces), ("segments", Cells::Segments)];
/// What becomes of edges between two triangles.
pub const INTERIORS: [(&str, Interior); 2] = [("keep", Interior::Keep), ("drop", Interior::Drop)];
/// What is written beside the mesh.
pub const EXTRAS: [(&str, Extra); 2] = [("quality", Extra::Quality), ("excuse", Extra::Excuse)];
/// What the colours of a picture tell.
pub const COLORS: [(&str, Color); 2] = [("region", Color::Region), ("quality", Color::Quality)];

/// What becomes of edges between two triangles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interior {
    /// They are written.
    Keep,
    /// They are left out.
    Drop,
}

/// What is written beside the mesh.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extra {
    /// Measures of triangles.
    Quality,
    /// Which triangles have an excused angle.
    Excuse,
}

/// What the colours of a picture tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Color {
    /// Regions.
    Region,
    /// The smallest angle of each triangle.
    Quality,
}

/// What takes a face out.
pub const HOLES: [(&str, Holes); 3] =
    [("seeds", Holes::Seeds), ("even-odd", Holes::EvenOdd), ("none", Holes::None)];

/// What takes a face out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holes {
    /// A hole seed in it.
    Seeds,
    /// Nesting: an even number of loops around it.
    EvenOdd,
    /// Nothing.
    None,
}

/// What the other options start from.
#[derive(Debug, Clone, Copy)]
pub struct Profile(fn() -> Parameters);

impl Profile {
    /// The parameters where nothing else is said.
    pub fn parameters(self) -> Parameters {
        self.0()
    }
}

/// One of a few words, each with its value.
pub fn one_of<T: Clone + Send + Sync + 'static, const N: usize>(
    choices: [(&'static str, T); N],
) -> impl TypedValueParser<Value = T> {
    let words = PossibleValuesParser::new(choices.each_ref().map(|(word, _)| *word));
    words.map(move |word| {
        let chosen = choices.iter().find(|(choice, _)| *choice == word);
        chosen.expect("the parser lets only the choices through").1.clone()
    })
}

/// The word for a value.
pub fn word<T: PartialEq>(choices: &[(&'static str, T)], value: &T) -> &'static str {
    choices.iter().find(|(_, choice)| choice == value).map_or("other", |(word, _)| word)
}

/// The value of a word.
pub fn value<T: Copy>(choices: &[(&str, T)], word: &str) -> Option<T> {
    choices.iter().find(|(choice, _)| *choice == word).map(|&(_, value)| value)
}
