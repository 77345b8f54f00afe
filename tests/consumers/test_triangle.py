"""Triangle's own meshes of Lake Superior before our judge."""

import json

import numpy as np
import triangle

import msh
from conftest import run


def read_poly(path):
    """The arrays that Triangle's Python package takes; enough for this file (one-based)."""
    lines = [line.split("#")[0].split() for line in path.read_text().splitlines()]
    rows = iter([line for line in lines if line])
    count = int(next(rows)[0])
    vertices = [[float(x) for x in next(rows)[1:3]] for _ in range(count)]
    count = int(next(rows)[0])
    segments = [[int(i) - 1 for i in next(rows)[1:3]] for _ in range(count)]
    count = int(next(rows)[0])
    holes = [[float(x) for x in next(rows)[1:3]] for _ in range(count)]
    return {"vertices": vertices, "segments": segments, "holes": holes}


def judged(data, flags, folder, code):
    """The certificate of Triangle's mesh, by the code of each guarantee; `check` exits as told."""
    outline = data / "paper" / "superior.poly"
    made = triangle.triangulate(read_poly(outline), flags + "e")
    edges = made["edges"][made["edge_markers"].ravel() != 0]
    # Our names for what has no number in the outline.
    names = {(1, 1): "boundary", (2, 1): "region"}
    tags = [np.ones(len(cells), int) for cells in (made["triangles"], edges)]
    path = folder / "triangle.msh"
    mesh = msh.Mesh(made["vertices"], made["triangles"], tags[0], edges, tags[1], names)
    msh.write(path, mesh)
    report = json.loads(run("check", path, "--input", outline, "--json", "--quiet", code=code))
    assert report["mesh"]["points"] == len(mesh.points)
    return {one["code"]: one for one in report["certificate"]["guarantees"]}


def fails(guarantees):
    return [code for code, one in guarantees.items() if one["verdict"] == "fails"]


def test_without_D_subsegments_are_encroached(data, tmp_path):
    guarantees = judged(data, "pq26.45", tmp_path, code=4)
    assert fails(guarantees) == ["G3", "G10"], "Triangle protects smaller lenses than discs"
    [first, *_] = guarantees["G3"]["first"]
    assert "inside the diametral disc" in first["text"]


def test_with_D_every_promise_is_kept(data, tmp_path):
    guarantees = judged(data, "pq26.45D", tmp_path, code=0)
    assert fails(guarantees) == []
    unjudged = [code for code, one in guarantees.items() if one["verdict"] == "not judged"]
    assert unjudged == ["G8", "G9"], "Triangle does not say how its points came to be"
