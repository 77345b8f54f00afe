"""The `.glb` file before the Khronos validator, and what it holds."""

import base64
import json
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest

import answers

HERE = Path(__file__).parent
TRIANGLES, LINES = 4, 1
DTYPES = {5126: np.float32, 5125: np.uint32, 5123: np.uint16, 5121: np.uint8}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def parse(path):
    """The JSON and the binary chunk."""
    data = path.read_bytes()
    if path.suffix == ".gltf":
        document = json.loads(data)
        kind, text = document["buffers"][0]["uri"].split(",")
        assert kind == "data:application/octet-stream;base64"
        return document, base64.b64decode(text, validate=True)
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    document = json.loads(data[20 : 20 + size])
    size_of_binary, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0"
    start = 28 + size
    return document, data[start : start + size_of_binary]


def array(gltf, index):
    """The numbers of an accessor."""
    document, binary = gltf
    accessor = document["accessors"][index]
    view = document["bufferViews"][accessor["bufferView"]]
    assert "byteStride" not in view
    start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
    width = WIDTHS[accessor["type"]]
    numbers = np.frombuffer(
        binary, DTYPES[accessor["componentType"]], accessor["count"] * width, start
    )
    return numbers.reshape(-1, width) if width > 1 else numbers


@pytest.fixture(scope="module")
def gltf(rooms):
    return parse(rooms.glb)


def validate(file):
    """What the validator reports, which must be no error and no warning."""
    done = subprocess.run(
        ["node", HERE / "validate_gltf.cjs", file], capture_output=True, text=True, check=True
    )
    report = json.loads(done.stdout)
    issues = report["issues"]
    assert issues["numErrors"] == issues["numWarnings"] == 0, issues["messages"]
    return report


@pytest.mark.parametrize("mesh", ["rooms", "untagged"])
def test_the_validator_has_nothing_to_say(mesh, request):
    files = request.getfixturevalue(mesh)
    assert validate(files.glb)["info"]["totalTriangleCount"] == len(files.mesh.triangles)


@pytest.mark.parametrize("color", ["region", "quality"])
@pytest.mark.parametrize("name", ["rooms.glb", "rooms.gltf"])
def test_the_validator_has_nothing_to_say_of_text_and_colours(name, color, named_rooms):
    report = validate(named_rooms(name, "--color", color))
    assert report["info"]["totalTriangleCount"] > 0


@pytest.mark.parametrize("color", ["region", "quality"])
def test_text_holds_what_bytes_hold(color, named_rooms):
    text, binary = (parse(named_rooms(f"rooms.{end}", "--color", color)) for end in ("gltf", "glb"))
    del text[0]["buffers"][0]["uri"]
    assert text == binary


def test_worse_triangles_are_darker(named_rooms):
    gltf = parse(named_rooms("rooms.glb", "--color", "quality"))
    for (dim, _), node in groups(gltf).items():
        [primitive] = gltf[0]["meshes"][node["mesh"]]["primitives"]
        if dim == 1:
            continue
        corners = array(gltf, primitive["attributes"]["POSITION"]).reshape(-1, 3, 3)
        colors = array(gltf, primitive["attributes"]["COLOR_0"]).reshape(-1, 3, 4)
        assert (colors == colors[:, :1]).all(), "one colour for each triangle"
        sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).astype(float)
        area = np.abs(np.linalg.det(corners[:, 1:, :2] - corners[:, :1, :2])) / 2
        shortest = sides.min(axis=1)
        sine = 2 * area * shortest / sides.prod(axis=1)  # of the smallest angle
        green = colors[:, 0, 1].astype(int)
        order = np.argsort(sine)
        assert (np.diff(green[order]) >= -1).all()


def groups(gltf):
    """The nodes that hold a group, by dimension and tag."""
    nodes = [node for node in gltf[0]["nodes"] if "mesh" in node]
    found = {(node["extras"]["dim"], node["extras"]["tag"]): node for node in nodes}
    assert len(found) == len(nodes)
    return found


def test_each_group_is_a_node_with_its_name_and_tag(gltf):
    assert {key: node["name"] for key, node in groups(gltf).items()} == answers.NAMES


def test_each_node_holds_the_cells_of_its_group(gltf, rooms):
    mesh = rooms.mesh
    for (dim, tag), node in groups(gltf).items():
        [primitive] = gltf[0]["meshes"][node["mesh"]]["primitives"]
        assert primitive.get("mode", TRIANGLES) == (LINES if dim == 1 else TRIANGLES)
        cells = (mesh.edges, mesh.triangles)[dim - 1]
        tags = (mesh.edge_tags, mesh.triangle_tags)[dim - 1]
        wanted = mesh.points[cells[tags == tag]]
        positions = array(gltf, primitive["attributes"]["POSITION"])
        found = positions[array(gltf, primitive["indices"]).reshape(-1, dim + 1)]
        assert found.shape[:2] == wanted.shape[:2]
        origin = np.array(gltf[0]["scenes"][0].get("extras", gltf[0].get("extras", {}))["origin"])
        assert np.abs(found[..., :2] + origin[:2] - wanted).max() < 2e-7
        assert not found[..., 2].any()
