"""Every kind of VTK file in VTK and meshio: encodings, compression, orders, lines alone, legacy."""

import json

import meshio
import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import answers
from conftest import ROOT, run
from vtk_files import read

XML = [
    ("--vtk-encoding", encoding, *compress)
    for encoding in ("raw", "base64", "ascii")
    for compress in ((), ("--compress",))
]
GRIDS = [
    (name, *options, "--order", order)
    for order in ("1", "2")
    for name, kinds in (("rooms.vtu", XML), ("rooms.vtk", [(), ("--binary",)]))
    for options in kinds
]
LINE, TRIANGLE, LINE_3, TRIANGLE_6 = 3, 5, 21, 22


def arrays(data):
    """The arrays of a section by name."""
    found = [data.GetArray(index) for index in range(data.GetNumberOfArrays())]
    return {array.GetName(): vtk_to_numpy(array) for array in found}


def names(grid):
    """The names of groups by dimension and number."""
    fields = arrays(grid.GetFieldData())
    assert fields.pop("meshwright") == [0]
    return {(dim, tag): name for name, (tag, dim) in fields.items()}


@pytest.fixture(scope="module", params=GRIDS, ids=" ".join)
def grid(request, named_rooms):
    """The options, and the grid with measures of its triangles."""
    name, *options = request.param
    return request.param, read(named_rooms(name, *options, "--data", "quality,excuse"))


@pytest.fixture(scope="module")
def reference(named_rooms):
    """The grid that is written where nothing is asked for, by order."""
    return {
        order: read(named_rooms("rooms.vtu", "--order", order, "--data", "quality,excuse"))
        for order in ("1", "2")
    }


# A point group and a second group of an edge have no place there.
NAMES = {key: name for key, name in answers.GROUPS.items() if key[0] > 0}


def test_every_kind_of_file_holds_the_same_bit_for_bit(grid, reference):
    options, found = grid
    wanted = reference[options[-1]]
    for section in ("GetPointData", "GetCellData", "GetFieldData"):
        here, there = (arrays(getattr(g, section)()) for g in (found, wanted))
        assert here.keys() == there.keys()
        for name, values in here.items():
            assert np.array_equal(values, there[name], equal_nan=values.dtype.kind == "f"), name
    for place in (lambda g: g.GetPoints().GetData(), lambda g: g.GetCellTypes()):
        assert np.array_equal(*(vtk_to_numpy(place(g)) for g in (found, wanted)))
    connectivity = [vtk_to_numpy(g.GetCells().GetConnectivityArray()) for g in (found, wanted)]
    assert np.array_equal(*connectivity)


def test_groups_keep_their_names_and_measures(reference):
    for order, (line, triangle) in {"1": (LINE, TRIANGLE), "2": (LINE_3, TRIANGLE_6)}.items():
        grid = reference[order]
        assert names(grid) == NAMES
        tags, kinds = arrays(grid.GetCellData())["tag"], vtk_to_numpy(grid.GetCellTypes())
        points = vtk_to_numpy(grid.GetPoints().GetData())
        for kind, wanted in ((line, answers.LENGTHS), (triangle, answers.AREAS)):
            found = dict.fromkeys(wanted, 0.0)
            for cell in np.nonzero(kinds == kind)[0]:
                ids = grid.GetCell(cell).GetPointIds()
                corners = points[[ids.GetId(i) for i in range(2 + (kind == triangle))], :2]
                found[int(tags[cell])] += size(corners)
            assert answers.same(found, wanted)


def size(corners):
    """The length or the area."""
    if len(corners) == 2:
        return float(np.hypot(*(corners[1] - corners[0])))
    (ux, uy), (vx, vy) = corners[1] - corners[0], corners[2] - corners[0]
    return float(ux * vy - uy * vx) / 2


def test_quality_is_what_vtk_measures(reference):
    grid = reference["1"]
    data = arrays(grid.GetCellData())
    points = vtk_to_numpy(grid.GetPoints().GetData())
    for cell in np.nonzero(vtk_to_numpy(grid.GetCellTypes()) == TRIANGLE)[0]:
        ids = grid.GetCell(cell).GetPointIds()
        a, b, c = (points[ids.GetId(i)] for i in range(3))
        lengths = np.array([np.linalg.norm(v) for v in (c - b, a - c, b - a)])
        area = np.linalg.norm(np.cross(b - a, c - a)) / 2
        squares = lengths**2
        cosines = (squares.sum() - 2 * squares) * lengths / (2 * lengths.prod())
        angles = np.degrees(np.arccos(cosines))
        assert data["min_angle"][cell] == pytest.approx(angles.min(), rel=1e-9)
        assert data["max_angle"][cell] == pytest.approx(angles.max(), rel=1e-9)
        assert data["area"][cell] == pytest.approx(area, rel=1e-12)
        radius = lengths.prod() / (4 * area)
        assert data["radius_edge"][cell] == pytest.approx(radius / lengths.min(), rel=1e-12)
    assert (data["excuse"] == 0).all(), "no angle is excused"


@pytest.mark.parametrize("options", XML, ids=" ".join)
def test_lines_alone_have_their_points_and_names(options, named_rooms):
    grid = read(named_rooms("rooms.vtp", *options))
    assert names(grid) == {key: name for key, name in NAMES.items() if key[0] == 1}
    tags = arrays(grid.GetCellData())["tag"]
    lengths = np.sqrt([grid.GetCell(i).GetLength2() for i in range(grid.GetNumberOfCells())])
    assert answers.same(answers.measures(tags, lengths), answers.LENGTHS)
    used = {grid.GetCell(i).GetPointId(end) for i in range(len(tags)) for end in (0, 1)}
    assert used == set(range(grid.GetNumberOfPoints())), "every point is used"


@pytest.mark.parametrize("variant", GRIDS, ids=" ".join)
def test_meshio_reads_them_all(variant, named_rooms, reference):
    name, *options = variant
    mesh = meshio.read(named_rooms(name, *options, "--data", "quality,excuse"))
    wanted = reference[options[-1]]
    assert np.array_equal(mesh.points, vtk_to_numpy(wanted.GetPoints().GetData()))
    found = {name: np.concatenate(parts) for name, parts in mesh.cell_data.items()}
    for name, values in arrays(wanted.GetCellData()).items():
        assert np.array_equal(found[name], values, equal_nan=values.dtype.kind == "f"), name
    if variant[0].endswith(".vtu"):
        fields = {(int(d), int(t)): n for n, (t, d) in
                  ((n, pair) for n, pair in mesh.field_data.items() if n != "meshwright")}
        assert fields == NAMES


@pytest.mark.parametrize("cells, kinds", [("faces", {TRIANGLE}), ("segments", {LINE})])
def test_parts_of_a_mesh(cells, kinds, named_rooms):
    grid = read(named_rooms("rooms.vtu", "--cells", cells))
    assert set(vtk_to_numpy(grid.GetCellTypes())) == kinds
    assert set(names(grid)) == {key for key in NAMES if key[0] == (1 if cells == "segments" else 2)}


def test_edges_between_triangles_are_left_out_where_asked(named_rooms):
    grid = read(named_rooms("rooms.vtu", "--interior-segments", "drop"))
    tags = arrays(grid.GetCellData())["tag"]
    assert 7 not in tags and {1, 2, 3, 9} <= set(tags)
    assert (1, 7) not in names(grid)


def test_an_excused_angle_is_told_at_its_triangle(tmp_path):
    outline = ROOT / "examples" / "lake_superior.poly"
    report = json.loads(run("mesh", outline, "--json", "-q"))
    run("mesh", outline, "--data", "quality,excuse", "-o", tmp_path / "lake.vtu")
    data = arrays(read(tmp_path / "lake.vtu").GetCellData())
    edges = len(data["tag"]) - report["mesh"]["triangles"]
    for place, excused in enumerate(report["certificate"]["excused"], 1):
        cell = edges + excused["triangle"]
        assert data["excuse"][cell] == place
        assert data["min_angle"][cell] == pytest.approx(excused["degrees"], rel=1e-12)
    assert np.count_nonzero(data["excuse"]) == len(report["certificate"]["excused"]) > 0
