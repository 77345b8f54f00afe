//! Writing `.poly`: an outline, or the edges of a mesh as segments.

use std::io::{self, Write};

use super::whole;
use crate::groups::{Note, further_groups, numbers_only};
use crate::mesh::Mesh;
use crate::node::Columns;
use crate::pslg::{Pslg, Region};
use crate::rows::{Rows, one_based};

/// What a `.poly` file of a mesh holds beside its edges.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options<'a> {
    /// The outline of the mesh: its hole and region seeds follow the segments, as in the files
    /// that Triangle writes. Without them the file alone does not tell what is a hole.
    pub outline: Option<&'a Pslg>,
    /// Write no points: they stand in the `.node` file of the same name, as Triangle has it.
    pub points_beside: bool,
}

/// Writes the boundary and interface edges of a mesh as segments, their tags as markers, and all
/// its points.
///
/// The file is an outline that Triangle (`-p`) and [`read`](super::read) take as it is. With the
/// `.ele` file beside it is the mesh (`-rp`). Names are not written, which a note says.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Mesh, poly};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     edges: vec![[2, 0]],
///     edge_tags: vec![-3],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// poly::write(&mesh, &mut text)?;
/// assert_eq!(text, b"3 2 0 0\n1 0 0\n2 1 0\n3 0 0.5\n1 1\n1 3 1 -3\n0\n");
/// # Ok::<(), std::io::Error>(())
/// ```
pub fn write(mesh: &Mesh, out: &mut impl Write) -> io::Result<Vec<Note>> {
    write_with(mesh, Options::default(), out)
}

/// Writes a mesh as [`write()`] does, with options.
///
/// # Errors
/// Those of `out`.
pub fn write_with(mesh: &Mesh, options: Options, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let mut notes: Vec<Note> = numbers_only(&mesh.groups, 1).into_iter().collect();
    let mut rows = Rows::new(out);
    if options.points_beside {
        // What became of them is told where they are written.
        Columns::of_mesh(mesh, &mut Vec::new()).header(0, &mut rows)?;
    } else {
        Columns::of_mesh(mesh, &mut notes).write(&mut rows)?;
    }
    let tagged = mesh.edges.iter().enumerate().map(|(edge, &ends)| (ends, mesh.edge_tag(edge)));
    segments(&mut rows, tagged)?;
    let seeds = options.outline.map(|outline| (&*outline.holes, &*outline.regions));
    let (holes, regions) = seeds.unwrap_or_default();
    self::holes(&mut rows, holes)?;
    self::regions(&mut rows, regions)?;
    rows.finish()?;
    Ok(notes)
}

/// Writes an outline; it reads back equal but for names, which notes tell, and target sizes.
///
/// # Errors
/// Those of `out`.
///
/// ```
/// use meshwright_formats::{Pslg, poly};
/// let outline = Pslg {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     segments: vec![[0, 1], [1, 2], [2, 0]],
///     segment_tags: vec![1, 1, 2],
///     ..Pslg::default()
/// };
/// let mut text = Vec::new();
/// poly::write_outline(&outline, &mut text)?;
/// let (read, _) = poly::read(&text, "corner.poly", |_| unreachable!("it holds its points"))?;
/// assert_eq!((read.points, read.segments), (outline.points, outline.segments));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_outline(outline: &Pslg, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let names = [1, 2].map(|dim| numbers_only(&outline.groups, dim));
    let mut notes: Vec<Note> = names.into_iter().flatten().collect();
    if !outline.point_sizes.is_empty() {
        notes.push(Note::SizesDropped);
    }
    if !outline.local_areas.is_empty() {
        let (count, noun) = (outline.local_areas.len(), "local area bound");
        notes.push(Note::NotHeld { count, noun });
    }
    notes.extend(further_groups(outline));
    let mut rows = Rows::new(out);
    Columns::of_outline(outline, &mut notes).write(&mut rows)?;
    let tag = |segment| outline.segment_tags.get(segment).copied().unwrap_or(0);
    let tagged = outline.segments.iter().enumerate().map(|(i, &ends)| (ends, tag(i)));
    segments(&mut rows, tagged)?;
    holes(&mut rows, &outline.holes)?;
    regions(&mut rows, &outline.regions)?;
    rows.finish()?;
    Ok(notes)
}

fn segments(
    rows: &mut Rows<impl Write>,
    tagged: impl ExactSizeIterator<Item = ([u32; 2], i32)>,
) -> io::Result<()> {
    rows.integers(&[tagged.len() as i64, 1])?;
    for (number, ([a, b], tag)) in (1..).zip(tagged) {
        rows.integers(&[number, one_based(a), one_based(b), i64::from(tag)])?;
    }
    Ok(())
}

/// The holes; Triangle wants their number also where there is none.
fn holes(rows: &mut Rows<impl Write>, seeds: &[[f64; 2]]) -> io::Result<()> {
    rows.integers(&[seeds.len() as i64])?;
    for (number, &[x, y]) in (1_i64..).zip(seeds) {
        rows.integer(number);
        rows.real(x);
        rows.real(y);
        rows.end()?;
    }
    Ok(())
}

/// The regions, each with attribute and area: readers may take one value alone for either.
fn regions(rows: &mut Rows<impl Write>, regions: &[Region]) -> io::Result<()> {
    if regions.is_empty() {
        return Ok(());
    }
    rows.integers(&[regions.len() as i64])?;
    for (number, region) in (1_i64..).zip(regions) {
        rows.integer(number);
        for coordinate in region.seed {
            rows.real(coordinate);
        }
        // An attribute that is no tag gave one by the reader's rule, and will again.
        match whole(region.attribute) {
            Some(_) => rows.integer(region.tag),
            None => rows.real(region.attribute),
        }
        rows.real(region.max_area.unwrap_or(-1.0));
        rows.end()?;
    }
    Ok(())
}
