"""The `.msh` file itself, and its readers Gmsh and meshio."""

import gmsh
import meshio
import numpy as np
import pytest

import answers


def test_the_file_holds_the_domain(rooms):
    mesh = rooms.mesh
    assert answers.same(answers.measures(mesh.triangle_tags, mesh.triangle_areas()), answers.AREAS)
    assert answers.same(answers.measures(mesh.edge_tags, mesh.edge_lengths()), answers.LENGTHS)
    assert mesh.names == answers.NAMES
    assert mesh.triangle_areas().min() > 0, "counter-clockwise"
    assert set(mesh.triangles.ravel()) == set(range(len(mesh.points))), "every node is used"


def test_the_points_of_the_outline_come_first_and_bit_for_bit(rooms):
    assert [tuple(p) for p in rooms.mesh.points[:10]] == answers.CORNERS


def test_the_area_bound_of_a_region_holds_there(rooms):
    areas = rooms.mesh.triangle_areas()
    assert areas[rooms.mesh.triangle_tags == 11].max() <= 0.02
    assert areas[rooms.mesh.triangle_tags == 12].max() > 0.02


def test_what_has_no_number_gets_a_stated_name(untagged):
    assert sorted(untagged.mesh.names.values()) == ["boundary", "region"]
    assert all(tag > 0 for _, tag in untagged.mesh.names)


@pytest.fixture
def in_gmsh(rooms):
    gmsh.initialize(["gmsh", "-v", "2"])
    gmsh.logger.start()
    gmsh.open(str(rooms.msh))
    yield gmsh.model
    gmsh.logger.stop()
    gmsh.finalize()


def elements_of_group(model, dim, tag):
    """The nodes of the elements in a physical group, one-based."""
    nodes = [
        model.mesh.getElements(dim, entity)[2][0].reshape(-1, dim + 1)
        for entity in model.getEntitiesForPhysicalGroup(dim, tag)
    ]
    return np.concatenate(nodes).astype(int)


def test_gmsh_opens_it_without_a_word(in_gmsh):
    complaints = [line for line in gmsh.logger.get() if line.startswith(("Warning", "Error"))]
    assert complaints == []


def test_gmsh_sees_every_node_bit_for_bit(in_gmsh, rooms):
    numbers, coordinates, _ = in_gmsh.mesh.getNodes()
    points = coordinates.reshape(-1, 3)[np.argsort(numbers)]
    assert sorted(numbers) == list(range(1, len(rooms.mesh.points) + 1))
    assert np.array_equal(points[:, :2], rooms.mesh.points)
    assert not points[:, 2].any()


def test_gmsh_sees_every_group_by_number_and_name(in_gmsh, rooms):
    groups = in_gmsh.getPhysicalGroups()
    assert {(d, t): in_gmsh.getPhysicalName(d, t) for d, t in groups} == answers.NAMES
    for dim, tag in groups:
        cells, tags = (
            (rooms.mesh.edges, rooms.mesh.edge_tags),
            (rooms.mesh.triangles, rooms.mesh.triangle_tags),
        )[dim - 1]
        found = elements_of_group(in_gmsh, dim, tag) - 1
        assert sorted(map(tuple, found)) == sorted(map(tuple, cells[tags == tag]))


def test_gmsh_finds_no_flat_triangle(in_gmsh):
    _, elements, _ = in_gmsh.mesh.getElements(2)
    assert min(in_gmsh.mesh.getElementQualities(elements[0], "minSICN")) > 0.3


def same_as_reference(mesh, reference):
    """Whether meshio's mesh is the reference: points, cells, tags and names."""
    assert np.array_equal(mesh.points[:, :2], reference.points)
    cells = mesh.cells_dict
    tags = mesh.cell_data_dict["gmsh:physical"]
    assert set(cells) == {"line", "triangle"}
    assert np.array_equal(cells["line"], reference.edges)
    assert np.array_equal(cells["triangle"], reference.triangles)
    assert np.array_equal(tags["line"], reference.edge_tags)
    assert np.array_equal(tags["triangle"], reference.triangle_tags)
    fields = {name: pair for name, pair in mesh.field_data.items() if name != "meshwright"}
    names = {(int(dim), int(tag)): name for name, (tag, dim) in fields.items()}
    assert names == reference.names


def test_meshio_reads_the_same_from_msh(rooms):
    same_as_reference(meshio.read(rooms.msh), rooms.mesh)


def test_meshio_reads_the_same_from_vtu(rooms):
    same_as_reference(meshio.read(rooms.vtu), rooms.mesh)
