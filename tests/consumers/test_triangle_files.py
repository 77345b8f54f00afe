"""Triangle's own files, as its Python package reads them and as Triangle itself takes the mesh."""

from dataclasses import dataclass

import numpy as np
import pytest
import triangle

import msh
from conftest import FIXTURES, run


@dataclass
class Files:
    """The files of one mesh."""

    data: dict  # `.node`, `.ele`, `.poly` and `.neigh` as the package loads them
    edges: np.ndarray  # `.edge`, which it loads only of Voronoi diagrams: ends from 0, markers
    mesh: msh.Mesh  # the `.msh` of the same run


@pytest.fixture(scope="module")
def rooms(tmp_path_factory):
    folder = tmp_path_factory.mktemp("triangle")
    names = ("mesh.node", "mesh.ele", "mesh.poly", "mesh.neigh", "edges.edge", "mesh.msh")
    outputs = [word for name in names for word in ("-o", folder / name)]
    run("mesh", FIXTURES / "two_rooms.poly", *outputs)
    data = triangle.load(str(folder), "mesh")
    # The package counts neighbours from zero, "none" as well.
    data["triangle_neighbors"] = np.maximum(data["triangle_neighbors"], -1)
    rows = np.loadtxt(folder / "edges.edge", dtype=int, skiprows=1)
    edges = np.column_stack((rows[:, 1:3] - 1, rows[:, 3]))
    return Files(data, edges, msh.read(folder / "mesh.msh"))


def marked(edges, markers):
    """The markers by edge."""
    pairs = [tuple(sorted(edge)) for edge in np.asarray(edges).tolist()]
    assert len(set(pairs)) == len(pairs), "every edge once"
    return dict(zip(pairs, np.ravel(markers).tolist()))


def adjacent(triangles, neighbors):
    """By triangle and corner: the corners of the triangle opposite, or nothing."""
    corners = [frozenset(t) for t in np.asarray(triangles).tolist()]
    return {
        (corners[t], corner): corners[n] if n >= 0 else None
        for t, row in enumerate(neighbors.tolist())
        for corner, n in zip(triangles[t].tolist(), row)
    }


def test_points_triangles_and_segments_are_those_of_the_msh_file(rooms):
    data, mesh = rooms.data, rooms.mesh
    assert np.array_equal(data["vertices"], mesh.points)
    assert np.array_equal(data["triangles"], mesh.triangles)
    assert np.array_equal(data["triangle_attributes"].ravel(), mesh.triangle_tags)
    assert np.array_equal(data["segments"], mesh.edges)
    assert np.array_equal(data["segment_markers"].ravel(), mesh.edge_tags)
    assert len(data["holes"]) == 1 and len(data["vertex_markers"]) == len(mesh.points)


def test_triangle_takes_the_mesh_as_its_own(rooms):
    data, mesh = rooms.data, rooms.mesh
    names = "vertices vertex_markers triangles triangle_attributes segments segment_markers"
    made = triangle.triangulate({name: data[name] for name in names.split()}, "rpen")
    assert np.array_equal(made["vertices"], mesh.points), "nothing is added"

    ours = adjacent(data["triangles"], data["triangle_neighbors"])
    assert ours == adjacent(made["triangles"], made["neighbors"])
    assert None in ours.values()

    markers = marked(rooms.edges[:, :2], rooms.edges[:, 2])
    assert markers == marked(made["edges"], made["edge_markers"])
    assert set(markers.values()) == {0, 1, 2, 3, 7, 9}

