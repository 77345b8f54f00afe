//! The bytes of `.glb` files against the specification.

use serde_json::{Value, json};

use super::{Options, write, write_with};
use crate::mesh::Mesh;
use crate::pslg::Group;

/// The JSON and the binary chunk.
fn chunks(mesh: &Mesh) -> (Value, Vec<u8>) {
    let mut bytes = Vec::new();
    write(mesh, &mut bytes).unwrap();
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!(&bytes[..4], b"glTF");
    assert_eq!((number(4), number(8)), (2, bytes.len()));
    let json = number(12);
    assert_eq!(json % 4, 0);
    assert_eq!(&bytes[16..20], b"JSON");
    let rest = &bytes[20 + json..];
    let binary = if rest.is_empty() { Vec::new() } else { rest[8..].to_vec() };
    assert_eq!(binary.len() % 4, 0);
    (serde_json::from_slice(&bytes[20..20 + json]).unwrap(), binary)
}

fn square() -> Mesh {
    let group = |dim, tag, name: &str| Group { dim, tag, name: name.into() };
    Mesh {
        points: vec![[5e6, 1.0], [5e6 + 0.5, 1.0], [5e6 + 0.5, 2.0], [5e6, 2.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        triangle_tags: vec![-7, 8],
        edges: vec![[2, 3], [3, 0]],
        edge_tags: vec![8, 8],
        groups: vec![group(1, 8, "rand außen"), group(2, 8, "sand")],
        ..Mesh::default()
    }
}

#[test]
fn each_group_is_a_node_with_its_name_and_tag() {
    let (json, _) = chunks(&square());
    let nodes = json["nodes"].as_array().unwrap();
    let told: Vec<_> = nodes.iter().map(|node| (&node["name"], &node["extras"])).collect();
    let expected = [
        (&json!("region_-7"), &json!({ "tag": -7, "dim": 2 })),
        (&json!("sand"), &json!({ "tag": 8, "dim": 2 })),
        (&json!("rand außen"), &json!({ "tag": 8, "dim": 1 })),
    ];
    assert_eq!(told, expected);
    assert_eq!(json["scenes"][0]["nodes"], json!([0, 1, 2]));
}

#[test]
fn positions_are_relative_to_the_origin_that_the_root_tells() {
    let (json, binary) = chunks(&square());
    assert_eq!(json["extras"], json!({ "origin": [5_000_000.25, 1.5], "scale": 1.0 }));
    let positions: Vec<f32> = binary[..36]
        .chunks_exact(4)
        .map(|bytes| f32::from_le_bytes(bytes.try_into().unwrap()))
        .collect();
    // The triangle of the first group has points 0, 1 and 2.
    assert_eq!(positions, [-0.25, -0.5, 0.0, 0.25, -0.5, 0.0, 0.25, 0.5, 0.0]);
    let accessor = &json["accessors"][0];
    assert_eq!(accessor["min"], json!([-0.25, -0.5, 0.0]));
    assert_eq!(accessor["max"], json!([0.25, 0.5, 0.0]));
}

#[test]
fn lines_come_after_triangles_and_all_have_colours_and_no_light() {
    let (json, _) = chunks(&square());
    let modes: Vec<_> = (0..3).map(|i| &json["meshes"][i]["primitives"][0]["mode"]).collect();
    assert_eq!(modes, [&Value::Null, &Value::Null, &json!(1)], "triangles by default; lines");
    let colors = json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].as_u64().unwrap();
    let accessor = &json["accessors"][colors as usize];
    assert_eq!(accessor["componentType"], 5121);
    assert_eq!(accessor["normalized"], true);
    assert_eq!(accessor["type"], "VEC4");
    assert_eq!(json["extensionsUsed"], json!(["KHR_materials_unlit"]));
    assert_eq!(json["materials"][0]["extensions"]["KHR_materials_unlit"], json!({}));
}

#[test]
fn views_follow_each_other_and_fill_the_buffer() {
    let (json, binary) = chunks(&square());
    let mut end = 0;
    for view in json["bufferViews"].as_array().unwrap() {
        assert_eq!(view["byteOffset"].as_u64().unwrap(), end);
        end += view["byteLength"].as_u64().unwrap();
    }
    assert_eq!(end, binary.len() as u64);
    assert_eq!(json["buffers"][0]["byteLength"], end);
}

#[test]
fn sizes_that_single_precision_cannot_hold_are_scaled() {
    for size in [1e300, 1e308, 1e-300, 5e-324] {
        let points = vec![[-size, 0.0], [size, 0.0], [0.0, size]];
        let (json, _) = chunks(&Mesh { points, triangles: vec![[0, 1, 2]], ..Mesh::default() });
        let scale = json["extras"]["scale"].as_f64().unwrap();
        let width = json["accessors"][0]["max"][0].as_f64().unwrap();
        // The position has 24 bits, of a subnormal size fewer.
        assert!((width * scale / size - 1.0).abs() < 1e-7, "{size}: {width} of {scale}");
    }
}

#[test]
fn a_mesh_without_cells_is_a_file_without_a_scene() {
    let (json, binary) = chunks(&Mesh::default());
    assert_eq!(json["scenes"], Value::Null);
    assert!(binary.is_empty());
}

#[test]
fn a_file_of_text_holds_the_same_bytes_as_base64() {
    let (mut binary_json, bytes) = chunks(&square());
    let mut text = Vec::new();
    write_with(&square(), Options { text: true, ..Options::default() }, &mut text).unwrap();
    let json: Value = serde_json::from_slice(&text).unwrap();
    let uri = json["buffers"][0]["uri"].as_str().unwrap().to_owned();
    let words = uri.strip_prefix("data:application/octet-stream;base64,").unwrap();
    assert_eq!(words.len(), bytes.len().div_ceil(3) * 4);
    // The first position, -0.25 -0.5 0: 000080be 000000bf 00000000.
    assert!(words.starts_with("AACAvgAAAL8AAAAA"), "{words}");
    binary_json["buffers"][0]["uri"] = json!(uri);
    assert_eq!(json, binary_json, "all else is the same");
}

#[test]
fn triangles_of_their_own_colours_share_no_vertex() {
    let colors = [[255, 188, 0, 255], [137, 255, 99, 255]];
    let mesh = Mesh { triangle_tags: vec![7, 7], ..square() };
    let mut bytes = Vec::new();
    let options = Options { colors: Some(&colors), ..Options::default() };
    write_with(&mesh, options, &mut bytes).unwrap();
    let length = u32::from_le_bytes(bytes[12..16].try_into().unwrap()) as usize;
    let json: Value = serde_json::from_slice(&bytes[20..20 + length]).unwrap();
    let binary = &bytes[28 + length..];
    let region = &json["meshes"][0]["primitives"][0];
    let array = |accessor: &Value, size: usize| {
        let accessor = &json["accessors"][accessor.as_u64().unwrap() as usize];
        let view = &json["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
        let start = view["byteOffset"].as_u64().unwrap() as usize;
        binary[start..start + size * accessor["count"].as_u64().unwrap() as usize].to_vec()
    };
    let light = [[255, 128, 0, 255], [64, 255, 32, 255]];
    let expected = [[light[0]; 3], [light[1]; 3]].concat().concat();
    assert_eq!(array(&region["attributes"]["COLOR_0"], 4), expected);
    assert_eq!(array(&region["indices"], 4), [0_u32, 1, 2, 3, 4, 5].map(u32::to_le_bytes).concat());
}
