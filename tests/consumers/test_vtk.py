"""The `.vtu` file in VTK, the library of ParaView."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import VTK_LINE, VTK_TRIANGLE

import answers
from vtk_files import read


@pytest.fixture(scope="module")
def grid(rooms):
    return read(rooms.vtu)


def cells(grid, kind, corners):
    """The cells of a kind, and where they stand among all cells."""
    kinds = vtk_to_numpy(grid.GetCellTypes())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    places = np.nonzero(kinds == kind)[0]
    assert (np.diff(offsets)[places] == corners).all()
    return connectivity[offsets[places][:, None] + np.arange(corners)], places


def test_points_are_the_same_bit_for_bit(grid, rooms):
    points = vtk_to_numpy(grid.GetPoints().GetData())
    assert points.dtype == np.float64
    assert np.array_equal(points[:, :2], rooms.mesh.points)
    assert not points[:, 2].any()


def test_cells_and_tags_are_the_same(grid, rooms):
    tags = vtk_to_numpy(grid.GetCellData().GetArray("gmsh:physical"))
    mesh = rooms.mesh
    assert grid.GetNumberOfCells() == len(mesh.edges) + len(mesh.triangles)
    for kind, wanted, wanted_tags in (
        (VTK_LINE, mesh.edges, mesh.edge_tags),
        (VTK_TRIANGLE, mesh.triangles, mesh.triangle_tags),
    ):
        found, places = cells(grid, kind, wanted.shape[1])
        assert np.array_equal(found, wanted)
        assert np.array_equal(tags[places], wanted_tags)


def test_names_of_groups_are_field_data(grid):
    fields = grid.GetFieldData()
    found = {}
    for index in range(fields.GetNumberOfArrays()):
        array = fields.GetArray(index)
        assert array is not None, "no array of strings"
        if array.GetName() == "meshwright":
            continue  # the mark of our files
        tag, dim = vtk_to_numpy(array)
        found[int(dim), int(tag)] = array.GetName()
    assert found == answers.NAMES


def test_every_point_says_how_it_came_to_be(grid):
    arrays = grid.GetPointData()
    kinds = vtk_to_numpy(arrays.GetArray("provenance"))
    assert (kinds[:10] == 0).all(), "the outline's points"
    assert set(kinds[10:]) <= {1, 2, 3}
