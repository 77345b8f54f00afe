"""Every kind of `.msh` file in Gmsh and meshio: versions, text and bytes, orders, data."""

import gmsh
import meshio
import numpy as np
import pytest

import answers
from conftest import FIXTURES, run

LINE, TRIANGLE, LINE_3, TRIANGLE_6, POINT = 1, 2, 8, 9, 15
VARIANTS = [
    ("--msh-version", version, *binary, "--order", order)
    for version in ("2.2", "4.1")
    for binary in ((), ("--binary",))
    for order in ("1", "2")
]


@pytest.fixture(scope="module", params=VARIANTS, ids=" ".join)
def variant(request, named_rooms):
    """The options and the file."""
    return request.param, named_rooms("rooms.msh", *request.param)


@pytest.fixture
def in_gmsh(variant):
    """Gmsh with the file open, which it has nothing to say about."""
    options, file = variant
    gmsh.initialize(["gmsh", "-v", "2"])
    gmsh.logger.start()
    gmsh.open(str(file))
    assert gmsh.logger.get() == []
    yield options, gmsh.model
    gmsh.logger.stop()
    gmsh.finalize()


def corners(model, dim, entity):
    """The coordinates of the corners of an entity's elements, which are of one kind."""
    [kind], _, [nodes] = model.mesh.getElements(dim, entity)
    per_element = model.mesh.getElementProperties(kind)[3]
    nodes = nodes.reshape(-1, per_element)[:, : dim + 1]
    numbers, coordinates, _ = model.mesh.getNodes()
    place = dict(zip(numbers, coordinates.reshape(-1, 3)))
    return np.array([[place[node] for node in element] for element in nodes])[..., :2]


def sizes(cells):
    """Lengths or areas (signed)."""
    sides = cells[:, 1:] - cells[:, :1]
    if sides.shape[1] == 1:
        return np.hypot(*sides[:, 0].T)
    (ux, uy), (vx, vy) = sides[:, 0].T, sides[:, 1].T
    return (ux * vy - uy * vx) / 2


def measure(model, dim, group):
    """The length or area of a physical group."""
    entities = model.getEntitiesForPhysicalGroup(dim, group)
    return sum(sizes(corners(model, dim, entity)).sum() for entity in entities)


def test_gmsh_sees_every_group_with_its_name_and_measure(in_gmsh):
    _, model = in_gmsh
    groups = [tuple(pair) for pair in model.getPhysicalGroups()]
    assert {pair: model.getPhysicalName(*pair) for pair in groups} == answers.GROUPS
    lengths = answers.LENGTHS | {21: answers.LENGTHS[3]}
    for dim, wanted in ((1, lengths), (2, answers.AREAS)):
        found = {tag: measure(model, dim, tag) for d, tag in groups if d == dim}
        assert answers.same(found, wanted)
    [probe] = model.getEntitiesForPhysicalGroup(0, 40)
    assert corners(model, 0, probe).tolist() == [[[0.1, 0.2]]]


def test_gmsh_sees_the_nodes_of_the_text_file_bit_for_bit(in_gmsh, named_rooms):
    options, model = in_gmsh
    numbers, coordinates, _ = model.mesh.getNodes()
    order = options[-1]
    text = named_rooms("rooms.msh", "--msh-version", "2.2", "--order", order).read_text()
    rows = text.split("$Nodes\n")[1].split("\n$EndNodes")[0].splitlines()[1:]
    wanted = {int(row.split()[0]): [float(x) for x in row.split()[1:]] for row in rows}
    found = {int(n): list(x) for n, x in zip(numbers, coordinates.reshape(-1, 3))}
    assert found == wanted
    assert sorted(found) == list(range(1, len(found) + 1))


def test_elements_are_of_the_order_asked_for(in_gmsh):
    options, model = in_gmsh
    kinds = [POINT, LINE, TRIANGLE] if options[-1] == "1" else [POINT, LINE_3, TRIANGLE_6]
    assert sorted(model.mesh.getElementTypes()) == sorted(kinds)
    _, elements, _ = model.mesh.getElements(2)
    qualities = model.mesh.getElementQualities(np.concatenate(elements), "minSICN")
    assert min(qualities) > 0.3


def test_the_middle_node_of_a_line_lies_in_its_middle(in_gmsh):
    options, model = in_gmsh
    if options[-1] == "1":
        return
    numbers, coordinates, _ = model.mesh.getNodes()
    place = dict(zip(numbers, coordinates.reshape(-1, 3)))
    kinds, _, nodes = model.mesh.getElements()
    lines = dict(zip(kinds, nodes))[LINE_3].reshape(-1, 3)
    for a, b, middle in lines:
        assert np.array_equal(place[middle], (place[a] + place[b]) / 2)


def test_nodes_lie_on_what_has_the_lowest_dimension(in_gmsh):
    _, model = in_gmsh
    count = 0
    for dim, entity in model.getEntities():
        _, coordinates, _ = model.mesh.getNodes(dim, entity)
        count += len(coordinates) // 3
        if dim == 2:
            x, y, _ = coordinates.reshape(-1, 3).T
            assert ((0.1 < x) & (x < 2.2) & (0.2 < y) & (y < 0.9)).all()
    assert count == len(model.mesh.getNodes()[0])


def test_gmsh_writes_it_again_with_all_groups(in_gmsh, tmp_path):
    _, model = in_gmsh
    gmsh.write(str(tmp_path / "again.msh"))
    gmsh.open(str(tmp_path / "again.msh"))
    groups = {tuple(p): model.getPhysicalName(*p) for p in model.getPhysicalGroups()}
    assert groups == answers.GROUPS


def test_meshio_sees_every_group(variant):
    mesh = meshio.read(variant[1])
    names = {(int(dim), int(tag)): name for name, (tag, dim) in mesh.field_data.items()}
    assert names == answers.GROUPS
    physical = mesh.cell_data["gmsh:physical"]
    for kind, wanted in (("line", answers.LENGTHS), ("triangle", answers.AREAS)):
        found = dict.fromkeys(wanted, 0.0)
        for block, tags in zip(mesh.cells, physical):
            if block.type in (kind, kind + "3", kind + "6"):
                cells = mesh.points[block.data[:, : 2 + (kind == "triangle")], :2]
                for tag, size in zip(tags, sizes(cells)):
                    if tag != 21:  # there in 2.2 alone: in 4.1 meshio keeps one group of an edge
                        found[int(tag)] += float(size)
        assert answers.same(found, wanted)


def sloped(folder, options):
    """A file with an attribute that is linear, 3x − 2y + 1."""
    file = folder / "sloped.msh"
    run("mesh", FIXTURES / "sloped.poly", "--max-area", "0.1", *options, "-o", file)
    return file


@pytest.mark.parametrize("options", VARIANTS, ids=" ".join)
def test_gmsh_shows_the_data_of_nodes(options, tmp_path):
    gmsh.initialize(["gmsh", "-v", "2"])
    gmsh.open(str(sloped(tmp_path, options)))
    [view] = gmsh.view.getTags()
    kind, nodes, values, _, components = gmsh.view.getModelData(view, 0)
    places = np.array([gmsh.model.mesh.getNode(node)[0] for node in nodes])
    gmsh.finalize()
    assert (kind, components) == ("NodeData", 1)
    assert np.allclose(np.ravel(values), 3 * places[:, 0] - 2 * places[:, 1] + 1, atol=1e-12)


# In 4.1 meshio takes the nodes entity by entity and leaves their data in the order of the file.
@pytest.mark.parametrize("options", VARIANTS[:4], ids=" ".join)
def test_meshio_reads_the_data_of_nodes(options, tmp_path):
    mesh = meshio.read(sloped(tmp_path, options))
    [values] = mesh.point_data.values()
    x, y, _ = mesh.points.T
    assert np.allclose(np.ravel(values), 3 * x - 2 * y + 1, atol=1e-12)


def test_gmsh_reads_the_second_order_elements_of_medit(named_rooms):
    gmsh.initialize(["gmsh", "-v", "2"])
    gmsh.logger.start()
    gmsh.open(str(named_rooms("rooms.mesh", "--order", "2")))
    complaints, kinds = gmsh.logger.get(), set(gmsh.model.mesh.getElementTypes())
    areas = {}
    for dim, entity in gmsh.model.getEntities(2):
        [found] = gmsh.model.mesh.getElements(dim, entity)[1]
        areas[entity] = float(gmsh.model.mesh.getElementQualities(found, "volume").sum())
    gmsh.finalize()
    assert complaints == []
    assert {LINE_3, TRIANGLE_6} <= kinds <= {LINE_3, TRIANGLE_6, POINT}
    assert answers.same(areas, answers.AREAS), "an entity has the number of its elements"
