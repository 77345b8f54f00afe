//! The JSON of a glTF file.

use std::io;

use gltf_json::accessor::{ComponentType, GenericComponentType, Type};
use gltf_json::buffer::{Target, View};
use gltf_json::extras::{Extras, RawValue};
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::validation::Checked::Valid;
use gltf_json::validation::USize64;
use gltf_json::{Accessor, Buffer, Index, Material, Mesh, Node, Root, Scene, extensions};
use serde_json::json;

use super::parts::{Frame, Part};
use crate::groups::{Entry, Table};

const UNLIT: &str = "KHR_materials_unlit";

/// What stands in the JSON where the bytes are to stand. It is in no name: those have no control
/// characters.
pub(super) const PLACEHOLDER: &str = "\u{7f}bytes\u{7f}";

/// The JSON that describes the parts, whose bytes follow each other: in a chunk of their own, or
/// `within` the JSON.
pub(super) fn document(
    table: &Table,
    frame: &Frame,
    parts: &[Part],
    within: bool,
) -> io::Result<Vec<u8>> {
    let mut root = Root::default();
    root.asset.generator = Some(concat!("meshwright ", env!("CARGO_PKG_VERSION")).to_owned());
    root.extras = extras(&json!({ "origin": frame.origin, "scale": frame.scale }))?;
    if !parts.is_empty() {
        let length = USize64(parts.iter().map(Part::bytes).sum());
        let buffer = root.push(Buffer {
            byte_length: length,
            name: None,
            uri: within.then(|| PLACEHOLDER.to_owned()),
            extensions: None,
            extras: None,
        });
        let material = root.push(material());
        root.extensions_used.push(UNLIT.to_owned());
        let mut offset = 0;
        let mut nodes = Vec::new();
        for part in parts {
            let views = views(&mut root, buffer, part, &mut offset);
            let mesh = mesh(&mut root, views, material, part, &table.entries[part.group]);
            nodes.push(node(&mut root, mesh, &table.entries[part.group])?);
        }
        let scene = Scene { extensions: None, extras: None, name: None, nodes };
        root.scene = Some(root.push(scene));
    }
    Ok(serde_json::to_vec(&root)?)
}

/// A sheet that shows its vertex colours from both sides, without light.
fn material() -> Material {
    let unlit = extensions::material::Unlit {};
    let extensions = extensions::material::Material { unlit: Some(unlit) };
    Material { double_sided: true, extensions: Some(extensions), ..Material::default() }
}

/// The views of positions, colours and indices.
fn views(
    root: &mut Root,
    buffer: Index<Buffer>,
    part: &Part,
    offset: &mut u64,
) -> [Index<View>; 3] {
    let targets = [Target::ArrayBuffer, Target::ArrayBuffer, Target::ElementArrayBuffer];
    let sizes = part.sizes();
    [0, 1, 2].map(|i| {
        let view = View {
            buffer,
            byte_length: USize64(sizes[i]),
            byte_offset: Some(USize64(*offset)),
            byte_stride: None,
            name: None,
            target: Some(Valid(targets[i])),
            extensions: None,
            extras: None,
        };
        *offset += sizes[i];
        root.push(view)
    })
}

fn mesh(
    root: &mut Root,
    [positions, colors, indices]: [Index<View>; 3],
    material: Index<Material>,
    part: &Part,
    entry: &Entry,
) -> Index<Mesh> {
    let count = part.vertices.len();
    let positions = Accessor {
        min: Some(json!(part.least)),
        max: Some(json!(part.most)),
        ..accessor(positions, count, ComponentType::F32, Type::Vec3)
    };
    let colors =
        Accessor { normalized: true, ..accessor(colors, count, ComponentType::U8, Type::Vec4) };
    let indices = accessor(indices, part.indices.len(), ComponentType::U32, Type::Scalar);
    let attributes = [
        (Valid(Semantic::Positions), root.push(positions)),
        (Valid(Semantic::Colors(0)), root.push(colors)),
    ];
    let primitive = Primitive {
        attributes: attributes.into(),
        extensions: None,
        extras: None,
        indices: Some(root.push(indices)),
        material: Some(material),
        mode: Valid(if entry.dim == 1 { Mode::Lines } else { Mode::Triangles }),
        targets: None,
    };
    root.push(Mesh {
        extensions: None,
        extras: None,
        name: Some(entry.name.clone()),
        primitives: vec![primitive],
        weights: None,
    })
}

fn accessor(view: Index<View>, count: usize, kind: ComponentType, shape: Type) -> Accessor {
    Accessor {
        buffer_view: Some(view),
        byte_offset: None,
        count: USize64(count as u64),
        component_type: Valid(GenericComponentType(kind)),
        extensions: None,
        extras: None,
        type_: Valid(shape),
        min: None,
        max: None,
        name: None,
        normalized: false,
        sparse: None,
    }
}

fn node(root: &mut Root, mesh: Index<Mesh>, entry: &Entry) -> io::Result<Index<Node>> {
    let extras = extras(&json!({ "tag": entry.tag, "dim": entry.dim }))?;
    let name = Some(entry.name.clone());
    Ok(root.push(Node { mesh: Some(mesh), name, extras, ..Node::default() }))
}

fn extras(value: &serde_json::Value) -> io::Result<Extras> {
    Ok(Some(RawValue::from_string(value.to_string())?))
}
