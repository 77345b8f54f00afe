//! Writing legacy `.vtk`.

use std::io::{self, Write};

use crate::arrays::{Array, Block, cells, coordinates, of_cells, of_groups, of_points};
use crate::groups::{Note, Rules, Table};
use crate::mesh::Mesh;
use crate::nodes::{Nodes, Order};
use crate::rows::Rows;

/// What may be asked of a `.vtk` file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// Numbers as bytes, not as text: smaller and faster.
    pub binary: bool,
    /// How many nodes a cell has.
    pub order: Order,
}

/// Writes a mesh with all that it holds, and says what became of its tags.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more cells than numbers of 32 bits can
/// count.
///
/// ```
/// use meshwright_formats::{Mesh, vtk};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![-7],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// vtk::write_with(&mesh, vtk::Options::default(), &mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.contains("\nPOINTS 3 double\n0 0 0 1 0 0 0 0.5 0\n"));
/// assert!(text.contains("\nCELLS 1 4\n3 0 1 2\nCELL_TYPES 1\n5\n"));
/// assert!(text.contains("\ntag 1 1 int\n-7\n"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_with(mesh: &Mesh, options: Options, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let (table, mut notes) = Table::new(mesh, Rules::default());
    let nodes = Nodes::new(mesh, options.order)?;
    let [connectivity, offsets, kinds] = cells(&nodes);
    let (count, size) = (offsets.length, connectivity.length + offsets.length);
    i32::try_from(size).map_err(|_| io::ErrorKind::FileTooLarge)?;
    let mut file = File { rows: Rows::new(out), binary: options.binary };
    let kind = if options.binary { "BINARY" } else { "ASCII" };
    file.rows.text(&format!(
        "# vtk DataFile Version 3.0\nmeshwright\n{kind}\nDATASET UNSTRUCTURED_GRID\n"
    ))?;
    file.fields(&of_groups(&table.entries))?;
    file.rows.text(&format!("POINTS {} double\n", nodes.len()))?;
    file.numbers(&coordinates(&nodes), Width::Eight)?;
    file.rows.text(&format!("CELLS {count} {size}\n"))?;
    file.cells(&nodes)?;
    file.rows.text(&format!("CELL_TYPES {count}\n"))?;
    file.numbers(&kinds, Width::Four)?;
    file.rows.text(&format!("CELL_DATA {count}\n"))?;
    file.fields(&of_cells(mesh, &table, &mut notes))?;
    file.rows.text(&format!("POINT_DATA {}\n", nodes.len()))?;
    file.fields(&of_points(&nodes, &mut notes))?;
    file.rows.finish()?;
    Ok(notes)
}

/// Bytes of a whole number.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Width {
    Four,
    Eight,
}

struct File<'a, W> {
    rows: Rows<'a, W>,
    binary: bool,
}

impl<W: Write> File<'_, W> {
    fn fields(&mut self, arrays: &[Array]) -> io::Result<()> {
        if arrays.is_empty() {
            return Ok(());
        }
        self.rows.text(&format!("FIELD FieldData {}\n", arrays.len()))?;
        for array in arrays {
            let (kind, width) = kind(array);
            let (name, tuples) = (encoded(&array.name), array.length / array.components);
            self.rows.text(&format!("{name} {} {tuples} {kind}\n", array.components))?;
            self.numbers(array, width)?;
        }
        Ok(())
    }

    fn numbers(&mut self, array: &Array, width: Width) -> io::Result<()> {
        array.blocks(|block| {
            match (block, width) {
                (Block::Real(values), _) if self.binary => {
                    values.iter().for_each(|value| self.rows.bytes(&value.to_be_bytes()));
                }
                (Block::Whole(values), Width::Eight) if self.binary => {
                    values.iter().for_each(|value| self.rows.bytes(&value.to_be_bytes()));
                }
                (Block::Whole(values), Width::Four) if self.binary => {
                    values.iter().for_each(|value| self.rows.bytes(&(*value as i32).to_be_bytes()));
                }
                (Block::Real(values), _) => {
                    for line in values.chunks(PER_LINE) {
                        line.iter().for_each(|&value| self.rows.real(value));
                        self.rows.end()?;
                    }
                }
                (Block::Whole(values), _) => {
                    for line in values.chunks(PER_LINE) {
                        line.iter().for_each(|&value| self.rows.integer(value));
                        self.rows.end()?;
                    }
                }
            }
            self.rows.hand_on()
        })?;
        self.close()
    }

    /// The cells: how many nodes, and which.
    fn cells(&mut self, nodes: &Nodes) -> io::Result<()> {
        let mesh = nodes.mesh;
        for edge in 0..mesh.edges.len() {
            self.cell(nodes.edge(edge))?;
        }
        for triangle in 0..mesh.triangles.len() {
            self.cell(nodes.triangle(triangle))?;
        }
        self.close()
    }

    fn cell(&mut self, nodes: impl Iterator<Item = u32> + Clone) -> io::Result<()> {
        let count = nodes.clone().count() as u32;
        for number in std::iter::once(count).chain(nodes) {
            if self.binary {
                self.rows.bytes(&number.to_be_bytes());
            } else {
                self.rows.integer(number);
            }
        }
        if self.binary { self.rows.hand_on() } else { self.rows.end() }
    }

    /// A line ends after bytes too.
    fn close(&mut self) -> io::Result<()> {
        if self.binary { self.rows.text("\n") } else { Ok(()) }
    }
}

/// Numbers of a line of text: points are not split.
const PER_LINE: usize = 12;

/// The type of an array's numbers.
fn kind(array: &Array) -> (&'static str, Width) {
    let fits = array.blocks(|block| match block {
        Block::Real(_) => Err("double"),
        Block::Whole(values) if values.iter().all(|&value| i32::try_from(value).is_ok()) => Ok(()),
        Block::Whole(_) => Err("vtktypeint64"),
    });
    match fits {
        Ok(()) => ("int", Width::Four),
        Err(kind) => (kind, Width::Eight),
    }
}

/// A name as one word of plain letters, which VTK decodes.
fn encoded(name: &str) -> String {
    let byte = |byte: u8| match byte {
        b'%' | b'"' => format!("%{byte:02X}"),
        b'!'..=b'~' => char::from(byte).to_string(),
        _ => format!("%{byte:02X}"),
    };
    name.bytes().map(byte).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Data, Values};
    use crate::pslg::Group;

    fn mesh() -> Mesh {
        let data = |name: &str, components, values| Data { name: name.into(), components, values };
        Mesh {
            points: vec![[0.0, 0.0], [2.0, 0.0], [0.0, 0.1]],
            triangles: vec![[0, 1, 2]],
            triangle_tags: vec![7],
            edges: vec![[0, 1]],
            edge_tags: vec![3],
            groups: vec![Group { dim: 1, tag: 3, name: "süd wand".into() }],
            point_data: vec![data("v", 2, Values::Real(vec![0.5, 1.0, 1.5, 2.0, 2.5, 3.0]))],
            triangle_data: vec![data("big", 1, Values::Integer(vec![1 << 40]))],
            ..Mesh::default()
        }
    }

    fn written(options: Options) -> Vec<u8> {
        let mut bytes = Vec::new();
        write_with(&mesh(), options, &mut bytes).unwrap();
        bytes
    }

    #[test]
    fn a_file_of_text() {
        let expected = "\
# vtk DataFile Version 3.0
meshwright
ASCII
DATASET UNSTRUCTURED_GRID
FIELD FieldData 3
meshwright 1 1 int
0
s%C3%BCd%20wand 1 2 int
3 1
region_7 1 2 int
7 2
POINTS 3 double
0 0 0 2 0 0 0 0.1 0
CELLS 2 7
2 0 1
3 0 1 2
CELL_TYPES 2
3 5
CELL_DATA 2
FIELD FieldData 3
gmsh:physical 1 2 int
3 7
tag 1 2 int
3 7
big 1 2 vtktypeint64
0 1099511627776
POINT_DATA 3
FIELD FieldData 1
v 2 3 double
0.5 1 1.5 2 2.5 3
";
        assert_eq!(String::from_utf8(written(Options::default())).unwrap(), expected);
    }

    #[test]
    fn binary_numbers_are_big_endian() {
        let bytes = written(Options { binary: true, order: Order::Second });
        let after = |text: &str, length: usize| {
            let start = bytes.windows(text.len()).position(|part| part == text.as_bytes()).unwrap();
            bytes[start + text.len()..][..length].to_vec()
        };
        let ints = |values: &[i32]| values.iter().flat_map(|v| v.to_be_bytes()).collect::<Vec<_>>();
        let cells = [ints(&[3, 0, 1, 3, 6, 0, 1, 2, 3, 5, 4]), b"\nCELL_TYPES 2\n".to_vec()];
        assert_eq!(after("CELLS 2 11\n", 4 * 11 + 14), cells.concat());
        assert_eq!(after("CELL_TYPES 2\n", 9), [ints(&[21, 22]), b"\n".to_vec()].concat());
        let reals = [2.0, 0.0, 0.0].map(f64::to_be_bytes).concat();
        assert_eq!(after("POINTS 6 double\n", 48)[24..], reals);
        let big = [0, 1_i64 << 40].map(i64::to_be_bytes).concat();
        assert_eq!(after("big 1 2 vtktypeint64\n", 16), big);
    }
}
