"""Triangle's own meshes of Lake Superior before our judge."""

import json
import subprocess

import numpy as np
import triangle

import msh
from conftest import ROOT, run
from triangle_points import HEAD, read_poly, row


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


def test_the_recorded_points_are_triangles_own(tmp_path):
    experiments = "cargo run --release --locked --quiet -p meshwright-campaigns --bin experiments"
    outlines = subprocess.run(experiments.split() + ["--", "--outlines", tmp_path], cwd=ROOT)
    assert outlines.returncode == 0
    head, *recorded = (ROOT / "docs/experiments/triangle.csv").read_text().splitlines()
    files = sorted(tmp_path.glob("*.poly"))
    assert head == HEAD and [line.split(",")[0] for line in recorded] == [f.stem for f in files]
    # The thinnest wedges alone take longer than all others together.
    quick = [f for f in files if f.stem not in ("wedge_0.001", "wedge_0.01")]
    assert [row(f) for f in quick] == [line for line in recorded if line.split(",")[0] in {f.stem for f in quick}]
