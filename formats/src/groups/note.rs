//! What writers tell of what a file does not hold as it is.

use std::fmt::{self, Display, Formatter};

use super::{cells, kind};
use crate::mesh::{Data, Mesh};
use crate::pslg::{Group, Tag};

/// What a writer did with tags and names, for the user to know.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// What has no tag was given a number and a name.
    Untagged {
        /// 1 for edges, 2 for triangles.
        dim: u8,
        /// The number it got; none where the file holds names alone.
        number: Option<Tag>,
        /// The name it got.
        name: String,
    },
    /// A tag is written as another number.
    Renumbered {
        /// 1 for edges, 2 for triangles.
        dim: u8,
        /// The user's tag.
        tag: Tag,
        /// The number that the file holds.
        number: Tag,
        /// The name of both.
        name: String,
    },
    /// Numbers that serve a group of edges and a group of triangles.
    SharedNumbers {
        /// The numbers.
        numbers: Vec<Tag>,
    },
    /// A name that serves two groups.
    SharedName {
        /// The name.
        name: String,
    },
    /// A name that holds white space.
    NameWithSpace {
        /// The name.
        name: String,
    },
    /// A name is written otherwise than the user gave it.
    NameChanged {
        /// The user's name.
        name: String,
        /// The name that the file holds.
        written: String,
    },
    /// One tag has two names; the file holds the first.
    SecondName {
        /// The name that the file holds.
        kept: String,
        /// The other one.
        dropped: String,
    },
    /// The name of a group of points, which the file does not hold.
    PointGroup {
        /// The name.
        name: String,
    },
    /// Edges in more than one group, of which the file holds one.
    FurtherGroups {
        /// How many such memberships there are.
        count: usize,
    },
    /// Names of groups, of which the file holds the numbers alone.
    NumbersOnly {
        /// 0 for points, 1 for edges, 2 for triangles.
        dim: u8,
        /// The names and their tags.
        names: Vec<(String, Tag)>,
    },
    /// Data that stand in a column without a name.
    Column {
        /// The name of the data.
        name: String,
        /// Which attribute it is, counted from one.
        attribute: usize,
    },
    /// Data that a column of real numbers cannot hold.
    DataDropped {
        /// The name of the data.
        name: String,
    },
    /// Whole numbers of data that a real number does not hold to the last digit.
    DataRounded {
        /// The name of the data.
        name: String,
    },
    /// Data that the file does not hold.
    DataNotHeld {
        /// Their names.
        names: Vec<String>,
    },
    /// Groups of triangles, which the file does not hold.
    RegionsNotHeld {
        /// Their names, or their numbers where they have none.
        names: Vec<String>,
    },
    /// Coordinates in single precision.
    SinglePrecision {
        /// By how much they are off at most.
        error: f64,
    },
    /// Target sizes of points, which the file does not hold.
    SizesDropped,
    /// Edges between two triangles that are left out.
    Interfaces {
        /// How many.
        count: usize,
        /// Their tags.
        tags: Vec<Tag>,
    },
    /// What the format has no place for.
    NotHeld {
        /// How many there are.
        count: usize,
        /// What one of them is: `hole seed`.
        noun: &'static str,
    },
}

impl Note {
    /// Whether something may be lost or misread; else the note only tells.
    #[must_use]
    pub fn is_warning(&self) -> bool {
        !matches!(self, Self::Untagged { .. } | Self::Renumbered { .. } | Self::Column { .. })
    }
}

/// The notes of formats that hold less than a mesh does; nothing where nothing is lost.
impl Note {
    /// What the format has no place for, if there is any of it.
    pub(crate) fn not_held(count: usize, noun: &'static str) -> Option<Self> {
        (count > 0).then_some(Self::NotHeld { count, noun })
    }

    /// Data of points and triangles.
    pub(crate) fn data_not_held(mesh: &Mesh) -> Option<Self> {
        let data = mesh.point_data.iter().chain(&mesh.triangle_data);
        let names: Vec<String> = data.map(|Data { name, .. }| name.clone()).collect();
        (!names.is_empty()).then_some(Self::DataNotHeld { names })
    }

    /// Tags of triangles and their names.
    pub(crate) fn regions_not_held(mesh: &Mesh) -> Option<Self> {
        let mut tags: Vec<Tag> = mesh.triangle_tags.clone();
        tags.sort_unstable();
        tags.dedup();
        let name = |tag: &Tag| {
            let group = mesh.groups.iter().find(|group| group.dim == 2 && group.tag == *tag);
            group.map(|group| format!("`{}`", group.name)).or((*tag != 0).then(|| tag.to_string()))
        };
        let names: Vec<String> = tags.iter().filter_map(name).collect();
        (!names.is_empty()).then_some(Self::RegionsNotHeld { names })
    }

    /// Coordinates that single precision does not hold.
    pub(crate) fn single_precision(mesh: &Mesh) -> Option<Self> {
        let error = |x: &f64| (x - f64::from(*x as f32)).abs();
        let error = mesh.points.iter().flatten().map(error).fold(0.0, f64::max);
        (error > 0.0).then_some(Self::SinglePrecision { error })
    }
}

impl Display for Note {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Self::Untagged { dim, number: Some(number), name } => {
                write!(f, "untagged {} are group {number}, `{name}`", cells(*dim))
            }
            Self::Untagged { dim, number: None, name } => {
                write!(f, "untagged {} are group `{name}`", cells(*dim))
            }
            Self::Renumbered { dim, tag, number, name } => {
                write!(f, "{} {tag} is written as {number}, `{name}`", kind(*dim))
            }
            Self::SharedNumbers { numbers } => {
                let (noun, verb) =
                    if numbers.len() == 1 { ("number", "stands") } else { ("numbers", "stand") };
                write!(f, "{noun} {} {verb} for a boundary and for a region", listed(numbers))?;
                write!(f, "; GetDP and scikit-fem mix them up")
            }
            Self::SharedName { name } => {
                write!(f, "`{name}` names two groups; readers that go by names keep one")
            }
            Self::NameWithSpace { name } => {
                write!(f, "the name `{name}` holds a space; some solvers cut it there")
            }
            Self::NameChanged { name, written } => {
                write!(f, "the name `{name}` is written as `{written}`")
            }
            Self::SecondName { kept, dropped } => {
                write!(f, "the group `{kept}` has a second name, `{dropped}`, which is not written")
            }
            Self::PointGroup { name } => {
                write!(f, "the point group `{name}` is not written")
            }
            Self::FurtherGroups { count } => {
                write!(f, "edges keep one group each; {count} further memberships are not written")
            }
            Self::NumbersOnly { dim, names } => {
                let names: Vec<_> = names.iter().map(|(n, tag)| format!("`{n}` ({tag})")).collect();
                let plural = match dim {
                    0 => "points",
                    1 => "boundaries",
                    _ => "regions",
                };
                write!(f, "{plural} have numbers here, no names: {}", listed(&names))
            }
            Self::Column { name, attribute } => {
                write!(f, "the data `{name}` are attribute {attribute}")
            }
            Self::DataDropped { name } => {
                write!(f, "the data `{name}` are not written: an attribute is one real number")
            }
            Self::DataRounded { name } => {
                write!(f, "some of the data `{name}` are rounded: whole numbers above 2^53")
            }
            Self::DataNotHeld { names } => {
                let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
                write!(f, "the format has no place for data: {}", listed(&names))
            }
            Self::RegionsNotHeld { names } => {
                write!(f, "the format has no place for regions: {}", listed(names))
            }
            Self::SinglePrecision { error } => {
                write!(f, "coordinates are rounded to single precision, by up to {error:.1e}")
            }
            Self::SizesDropped => write!(f, "the target sizes of points are not written"),
            Self::Interfaces { count, tags } => {
                let (noun, verb) = if *count == 1 { ("edge", "is") } else { ("edges", "are") };
                let of = if tags.len() == 1 { "boundary" } else { "boundaries" };
                write!(f, "{count} {noun} between two triangles {verb} not written: ")?;
                write!(f, "{of} {}", listed(tags))
            }
            Self::NotHeld { count: 1, noun } => {
                write!(f, "1 {noun} is not written: the format has no place for it")
            }
            Self::NotHeld { count, noun } => {
                write!(f, "{count} {noun}s are not written: the format has no place for them")
            }
        }
    }
}

fn listed(items: &[impl ToString]) -> String {
    let shown: Vec<String> = items.iter().take(5).map(ToString::to_string).collect();
    let more = if items.len() > 5 { ", …" } else { "" };
    shown.join(", ") + more
}

/// What a file that holds numbers alone does to the names of edges (1) or triangles (2).
pub(crate) fn numbers_only(groups: &[Group], dim: u8) -> Option<Note> {
    let groups = groups.iter().filter(|group| group.dim == dim);
    let names: Vec<_> = groups.map(|group| (group.name.clone(), group.tag)).collect();
    (!names.is_empty()).then_some(Note::NumbersOnly { dim, names })
}
