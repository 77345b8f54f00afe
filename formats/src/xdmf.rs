//! XDMF, `.xdmf`, with the numbers in the XML: the mesh as DOLFINx reads it; written.
//!
//! ```text
//! file := Xdmf(Domain(Grid "mesh" Grid "boundary"?))
//! mesh := Topology of triangles, Geometry XY, Attribute "region", data
//! boundary := Topology of lines, the geometry of "mesh", Attribute "boundary"
//! ```
//!
//! `XDMFFile.read_mesh(name="mesh")` takes the first grid, `read_meshtags(mesh, name="boundary")`
//! the second. Names of groups are `Information` elements: `Name` is `region 7`, `Value` the name.
//! (<https://www.xdmf.org/index.php/XDMF_Model_and_Format>)

mod write;

pub use write::write_with;
