"""The formats of single solvers, as meshio and trimesh read them: numbers or names, measures."""

import xml.etree.ElementTree as ET

import meshio
import numpy as np
import pytest
import trimesh

import answers
from test_msh_variants import sizes

BOUNDARIES = {name: answers.LENGTHS[tag] for (dim, tag), name in answers.GROUPS.items()
              if dim == 1 and tag in answers.LENGTHS}  # fmt: skip
REGIONS = {answers.GROUPS[2, tag]: area for tag, area in answers.AREAS.items()}


def measures(mesh, kind, tags):
    """The length or area of each tag."""
    corners = mesh.points[mesh.cells_dict[kind]][..., :2]
    return answers.measures(tags, sizes(corners))


def test_medit_keeps_the_numbers(named_rooms):
    mesh = meshio.read(named_rooms("rooms.mesh"))
    for kind, wanted in (("line", answers.LENGTHS), ("triangle", answers.AREAS)):
        assert answers.same(measures(mesh, kind, mesh.cell_data_dict["medit:ref"][kind]), wanted)
    assert [tuple(p) for p in mesh.points[:10]] == answers.CORNERS


def test_su2_keeps_the_boundary_by_name(named_rooms):
    file = named_rooms("rooms.su2")
    mesh = meshio.read(file)
    tags = mesh.cell_data_dict["su2:tag"]["line"]
    # meshio replaces the names by numbers, in the order of the file.
    names = [line.split("= ")[1] for line in file.read_text().splitlines() if "_TAG=" in line]
    found = {names[tag - 1]: size for tag, size in measures(mesh, "line", tags).items()}
    assert answers.same(found, {n: s for n, s in BOUNDARIES.items() if n != "partition"})
    assert sizes(mesh.points[mesh.cells_dict["triangle"]]).sum() == pytest.approx(
        sum(answers.AREAS.values()), rel=1e-12
    )


@pytest.mark.parametrize("order, kind", [("1", "triangle"), ("2", "triangle6")])
def test_inp_keeps_regions_and_boundaries_as_sets(order, kind, named_rooms, tmp_path):
    # meshio knows the second-order triangle by its name in plane strain alone.
    text = named_rooms("rooms.inp", "--order", order).read_text().replace("CPS6", "CPE6")
    file = tmp_path / "rooms.inp"
    file.write_text(text)
    mesh = meshio.read(file)
    triangles = mesh.cells_dict[kind]
    areas = sizes(mesh.points[triangles[:, :3], :2])
    for name, area in REGIONS.items():
        [members] = mesh.cell_sets_dict[name].values()
        assert areas[members].sum() == pytest.approx(area, rel=1e-12)
    x, y, _ = mesh.points.T
    assert set(mesh.point_sets["left"]) == set(np.nonzero(x == 0.1)[0])
    assert set(mesh.point_sets["partition"]) == set(np.nonzero(x == 1.3)[0])
    assert mesh.points[mesh.point_sets["probe"], :2].tolist() == [[0.1, 0.2]]


def test_surfaces_of_inp_are_the_sides_of_their_elements(named_rooms):
    text = named_rooms("rooms.inp").read_text()
    rows = [row.split(", ") for row in text.split("*ELEMENT")[1].split("*")[0].splitlines()[1:]]
    corners = {row[0]: [int(n) - 1 for n in row[1:]] for row in rows}
    mesh = meshio.read(named_rooms("rooms.inp"))
    found = dict.fromkeys(BOUNDARIES | {"cold": 0.0}, 0.0)
    for surface in text.split("*SURFACE, NAME=")[1:]:
        name = surface.split(",")[0]
        for line in surface.split("*")[0].splitlines()[1:]:
            element, side = line.split(", ")
            start = int(side[1]) - 1
            ends = [corners[element][i] for i in (start, (start + 1) % 3)]
            found[name] += float(np.hypot(*(mesh.points[ends[1]] - mesh.points[ends[0]])[:2]))
    assert answers.same(found, BOUNDARIES | {"cold": answers.LENGTHS[3]})


@pytest.mark.parametrize("order, per_triangle, per_line", [("1", 3, 2), ("2", 6, 3)])
def test_xdmf_has_a_grid_of_triangles_and_one_of_lines(order, per_triangle, per_line, named_rooms):
    root = ET.parse(named_rooms("rooms.xdmf", "--order", order)).getroot()
    mesh, boundary = root.find("Domain").findall("Grid")

    def item(element, kind=float):
        data = element.find("DataItem")
        shape = [int(n) for n in data.get("Dimensions").split()]
        return np.array(data.text.split(), dtype=kind).reshape(shape)

    points = item(mesh.find("Geometry"))
    for grid, count, attribute, wanted in (
        (mesh, per_triangle, "region", answers.AREAS),
        (boundary, per_line, "boundary", answers.LENGTHS),
    ):
        cells = item(grid.find("Topology"), int)
        assert cells.shape[1] == count
        corners = points[cells[:, : 3 if grid is mesh else 2]]
        tags = item(grid.find(f"Attribute[@Name='{attribute}']"), int).ravel()
        assert answers.same(answers.measures(tags, sizes(corners)), wanted)
        names = {e.get("Name"): e.get("Value") for e in grid.findall("Information")}
        dim = 2 if grid is mesh else 1
        for tag in wanted:
            assert names[f"{attribute} {tag}"] == answers.GROUPS[dim, tag]


@pytest.mark.parametrize("name, options", [("rooms.stl", ()), ("rooms.stl", ("--binary",)),
                                           ("rooms.obj", ())])  # fmt: skip
def test_trimesh_sees_the_whole_area(name, options, named_rooms):
    mesh = trimesh.load(named_rooms(name, *options), force="mesh")
    assert mesh.area == pytest.approx(sum(answers.AREAS.values()), rel=1e-6)
    assert (mesh.face_normals[:, 2] > 0.99).all(), "all triangles show the same side"


def test_obj_and_stl_keep_the_names_of_regions(named_rooms):
    obj = named_rooms("rooms.obj").read_text().splitlines()
    names = [line.split()[1] for line in obj if line.startswith("g ")]
    assert names == ["hall", "cabinet", "wall", "left", "right", "partition", "pillar"]
    stl = named_rooms("rooms.stl").read_text().splitlines()
    assert [line for line in stl if "solid" in line] == [
        "solid hall", "endsolid hall", "solid cabinet", "endsolid cabinet"
    ]  # fmt: skip
