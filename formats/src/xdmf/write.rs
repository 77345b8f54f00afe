//! Writing `.xdmf`.

use std::io::{self, Write};

use quick_xml::escape::escape;

use crate::arrays::{Array, Block, Kind, of_points, of_triangles};
use crate::groups::{Entry, Note, Rules, Table};
use crate::mesh::Mesh;
use crate::nodes::{Nodes, Order};
use crate::rows::Rows;

/// Writes a mesh, and says what became of its tags.
///
/// Tags are kept, also those below 1. Groups of points and further groups of an edge are not
/// written.
///
/// # Errors
/// Those of `out`; [`io::ErrorKind::FileTooLarge`] for more nodes than 32 bits can number.
///
/// ```
/// use meshwright_formats::{Mesh, Order, xdmf};
/// let mesh = Mesh {
///     points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 0.5]],
///     triangles: vec![[0, 1, 2]],
///     triangle_tags: vec![7],
///     ..Mesh::default()
/// };
/// let mut text = Vec::new();
/// xdmf::write_with(&mesh, Order::First, &mut text)?;
/// let text = String::from_utf8(text)?;
/// assert!(text.contains("<Topology TopologyType=\"Triangle\" NumberOfElements=\"1\""));
/// assert!(text.contains("0 0\n1 0\n0 0.5\n"));
/// assert!(text.contains("<Information Name=\"region 7\" Value=\"region_7\"/>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write_with(mesh: &Mesh, order: Order, out: &mut impl Write) -> io::Result<Vec<Note>> {
    let (table, mut notes) = Table::new(mesh, Rules::default());
    let nodes = Nodes::new(mesh, order)?;
    let mut file = File { rows: Rows::new(out) };
    file.rows.text(
        "<?xml version=\"1.0\"?>\n\
         <Xdmf Version=\"3.0\" xmlns:xi=\"https://www.w3.org/2001/XInclude\">\n  <Domain>\n",
    )?;
    file.mesh(&nodes, &table, &mut notes)?;
    if !mesh.edges.is_empty() {
        file.boundary(&nodes, &table)?;
    }
    file.rows.text("  </Domain>\n</Xdmf>\n")?;
    file.rows.finish()?;
    Ok(notes)
}

struct File<'a, W> {
    rows: Rows<'a, W>,
}

impl<W: Write> File<'_, W> {
    fn mesh(&mut self, nodes: &Nodes, table: &Table, notes: &mut Vec<Note>) -> io::Result<()> {
        let (mesh, count) = (nodes.mesh, nodes.mesh.triangles.len());
        let (kind, corners) = match nodes.order {
            Order::First => ("Triangle", 3),
            Order::Second => ("Triangle_6", 6),
        };
        let topology = Array::wholes("", Kind::Int64, [count, corners * count], |items, out| {
            out.extend(items.flat_map(|t| nodes.triangle(t)).map(i64::from));
        });
        let tags = Array::whole("region", Kind::Int32, count, |triangle| {
            let group = table.region(mesh.triangle_tag(triangle));
            table.entries[group].number.into()
        });
        let points = Array::reals("", 2, nodes.len(), |items, out| {
            out.extend(items.flat_map(|node| nodes.point(node)));
        });
        self.rows.text("    <Grid Name=\"mesh\" GridType=\"Uniform\">\n")?;
        self.topology(kind, corners, &topology.in_tuples(corners))?;
        self.rows.text("      <Geometry GeometryType=\"XY\">\n")?;
        self.item(&points)?;
        self.rows.text("      </Geometry>\n")?;
        self.attribute("Cell", &tags)?;
        for array in of_triangles(mesh, 0, &["region"], notes) {
            self.attribute("Cell", &array)?;
        }
        for array in of_points(nodes, notes) {
            self.attribute("Node", &array)?;
        }
        self.names(2, "region", &table.entries)?;
        self.rows.text("    </Grid>\n")
    }

    fn boundary(&mut self, nodes: &Nodes, table: &Table) -> io::Result<()> {
        let count = nodes.mesh.edges.len();
        let (kind, corners) = match nodes.order {
            Order::First => ("PolyLine", 2),
            Order::Second => ("Edge_3", 3),
        };
        let topology = Array::wholes("", Kind::Int64, [count, corners * count], |items, out| {
            out.extend(items.flat_map(|edge| nodes.edge(edge)).map(i64::from));
        });
        let tags = Array::whole("boundary", Kind::Int32, count, |edge| {
            table.entries[table.edges[edge] as usize].number.into()
        });
        self.rows.text("    <Grid Name=\"boundary\" GridType=\"Uniform\">\n")?;
        self.topology(kind, corners, &topology.in_tuples(corners))?;
        self.rows.text(
            "      <xi:include xpointer=\"xpointer(/Xdmf/Domain/Grid[@Name='mesh']/Geometry)\"/>\n",
        )?;
        self.attribute("Cell", &tags)?;
        self.names(1, "boundary", &table.entries)?;
        self.rows.text("    </Grid>\n")
    }

    fn topology(&mut self, kind: &str, corners: usize, array: &Array) -> io::Result<()> {
        let count = array.length / corners;
        self.rows.text(&format!(
            "      <Topology TopologyType=\"{kind}\" NumberOfElements=\"{count}\" \
             NodesPerElement=\"{corners}\">\n"
        ))?;
        self.item(array)?;
        self.rows.text("      </Topology>\n")
    }

    fn attribute(&mut self, center: &str, array: &Array) -> io::Result<()> {
        let name = escape(&array.name);
        let kind = if array.components == 1 { "Scalar" } else { "Matrix" };
        self.rows.text(&format!(
            "      <Attribute Name=\"{name}\" AttributeType=\"{kind}\" Center=\"{center}\">\n"
        ))?;
        self.item(array)?;
        self.rows.text("      </Attribute>\n")
    }

    /// The numbers of an array, a tuple a line.
    fn item(&mut self, array: &Array) -> io::Result<()> {
        let components = array.components;
        let kind = match array.kind {
            Kind::Float64 => "NumberType=\"Float\" Precision=\"8\"",
            Kind::Int64 => "NumberType=\"Int\" Precision=\"8\"",
            Kind::Int32 | Kind::UInt8 => "NumberType=\"Int\" Precision=\"4\"",
        };
        let tuples = array.length / components;
        self.rows.text(&format!(
            "        <DataItem Dimensions=\"{tuples} {components}\" {kind} Format=\"XML\">\n"
        ))?;
        array.blocks(|block| match block {
            Block::Real(values) => values.chunks(components).try_for_each(|tuple| {
                tuple.iter().for_each(|&value| self.rows.real(value));
                self.rows.end()
            }),
            Block::Whole(values) => values.chunks(components).try_for_each(|tuple| {
                tuple.iter().for_each(|&value| self.rows.integer(value));
                self.rows.end()
            }),
        })?;
        self.rows.text("        </DataItem>\n")
    }

    fn names(&mut self, dim: u8, kind: &str, entries: &[Entry]) -> io::Result<()> {
        for Entry { number, name, .. } in entries.iter().filter(|entry| entry.dim == dim) {
            let name = escape(name.as_str());
            self.rows.text(&format!(
                "      <Information Name=\"{kind} {number}\" Value=\"{name}\"/>\n"
            ))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Data, Values};
    use crate::pslg::Group;

    #[test]
    fn a_whole_file_of_second_order() {
        let mesh = Mesh {
            points: vec![[0.0, 0.0], [2.0, 0.0], [0.0, 0.1]],
            triangles: vec![[0, 1, 2]],
            triangle_tags: vec![7],
            edges: vec![[0, 1]],
            edge_tags: vec![3],
            groups: vec![Group { dim: 1, tag: 3, name: "a<b".into() }],
            triangle_data: vec![Data {
                name: "v".into(),
                components: 2,
                values: Values::Real(vec![0.5, 1.5]),
            }],
            ..Mesh::default()
        };
        let mut text = Vec::new();
        write_with(&mesh, Order::Second, &mut text).unwrap();
        let expected = "\
<?xml version=\"1.0\"?>
<Xdmf Version=\"3.0\" xmlns:xi=\"https://www.w3.org/2001/XInclude\">
  <Domain>
    <Grid Name=\"mesh\" GridType=\"Uniform\">
      <Topology TopologyType=\"Triangle_6\" NumberOfElements=\"1\" NodesPerElement=\"6\">
        <DataItem Dimensions=\"1 6\" NumberType=\"Int\" Precision=\"8\" Format=\"XML\">
0 1 2 3 5 4
        </DataItem>
      </Topology>
      <Geometry GeometryType=\"XY\">
        <DataItem Dimensions=\"6 2\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">
0 0
2 0
0 0.1
1 0
0 0.05
1 0.05
        </DataItem>
      </Geometry>
      <Attribute Name=\"region\" AttributeType=\"Scalar\" Center=\"Cell\">
        <DataItem Dimensions=\"1 1\" NumberType=\"Int\" Precision=\"4\" Format=\"XML\">
7
        </DataItem>
      </Attribute>
      <Attribute Name=\"v\" AttributeType=\"Matrix\" Center=\"Cell\">
        <DataItem Dimensions=\"1 2\" NumberType=\"Float\" Precision=\"8\" Format=\"XML\">
0.5 1.5
        </DataItem>
      </Attribute>
      <Information Name=\"region 7\" Value=\"region_7\"/>
    </Grid>
    <Grid Name=\"boundary\" GridType=\"Uniform\">
      <Topology TopologyType=\"Edge_3\" NumberOfElements=\"1\" NodesPerElement=\"3\">
        <DataItem Dimensions=\"1 3\" NumberType=\"Int\" Precision=\"8\" Format=\"XML\">
0 1 3
        </DataItem>
      </Topology>
      <xi:include xpointer=\"xpointer(/Xdmf/Domain/Grid[@Name='mesh']/Geometry)\"/>
      <Attribute Name=\"boundary\" AttributeType=\"Scalar\" Center=\"Cell\">
        <DataItem Dimensions=\"1 1\" NumberType=\"Int\" Precision=\"4\" Format=\"XML\">
3
        </DataItem>
      </Attribute>
      <Information Name=\"boundary 3\" Value=\"a&lt;b\"/>
    </Grid>
  </Domain>
</Xdmf>
";
        assert_eq!(String::from_utf8(text).unwrap(), expected);
    }
}
