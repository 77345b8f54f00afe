"""Triangle's own meshes of Lake Superior before our judge."""

import numpy as np
import pytest
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


def verdicts(data, flags, folder):
    """What `check` says of Triangle's mesh: verdict and rest of the line, by promise."""
    outline = data / "paper" / "superior.poly"
    made = triangle.triangulate(read_poly(outline), flags + "e")
    on_boundary = made["edge_markers"].ravel() != 0
    edges = made["edges"][on_boundary]
    mesh = msh.Mesh(
        made["vertices"],
        made["triangles"],
        np.ones(len(made["triangles"]), int),
        edges,
        np.ones(len(edges), int),
        {},
    )
    path = folder / "triangle.msh"
    msh.write(path, mesh)
    return path, outline
