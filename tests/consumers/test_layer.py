"""One layer of prisms, as `gmshToFoam` takes it, in Gmsh."""

import gmsh
import numpy as np
import pytest

import answers

PRISM, QUADRANGLE, TRIANGLE = 6, 3, 2


@pytest.fixture(params=[("--for", "openfoam"), ("--layer", "0.25")], ids=" ".join)
def layer(request, named_rooms):
    """The thickness and Gmsh with the file open."""
    file = named_rooms("rooms.msh", *request.param)
    gmsh.initialize(["gmsh", "-v", "2"])
    gmsh.logger.start()
    gmsh.open(str(file))
    assert gmsh.logger.get() == []
    yield 1.0 if request.param[1] == "openfoam" else 0.25, gmsh.model
    gmsh.logger.stop()
    gmsh.finalize()


def sizes(model, dim, tag):
    """The volumes or areas of the elements of a group, all of which must be well turned."""
    found = []
    for entity in model.getEntitiesForPhysicalGroup(dim, tag):
        _, elements, _ = model.mesh.getElements(dim, entity)
        for part in elements:
            found.extend(model.mesh.getElementQualities(part, "volume"))
    return np.array(found)


def test_regions_are_volumes_and_boundaries_are_walls(layer):
    thickness, model = layer
    names = {tuple(group): model.getPhysicalName(*group) for group in model.getPhysicalGroups()}
    wanted = {(dim + 1, tag): name for (dim, tag), name in answers.GROUPS.items()
              if dim == 2 or tag in answers.LENGTHS}  # fmt: skip
    [ends] = set(names) - set(wanted)
    assert names == wanted | {ends: "frontAndBack"}
    for tag, area in answers.AREAS.items():
        volumes = sizes(model, 3, tag)
        assert volumes.min() > 0, "no prism is inside out"
        assert volumes.sum() == pytest.approx(area * thickness, rel=1e-12)
    for tag, length in answers.LENGTHS.items():
        assert sizes(model, 2, tag).sum() == pytest.approx(length * thickness, rel=1e-12)
    both = 2 * sum(answers.AREAS.values())
    assert sizes(model, *ends).sum() == pytest.approx(both, rel=1e-12)


def test_every_outer_side_of_a_prism_is_in_a_group(layer):
    _, model = layer
    kinds, _, nodes = model.mesh.getElements()
    nodes = dict(zip(kinds, nodes))
    prisms = nodes[PRISM].reshape(-1, 6)
    sides = {}
    for prism in prisms:
        for side in ((0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)):
            key = frozenset(prism[list(side)].tolist())
            sides[key] = sides.get(key, 0) + 1
    outer = {side for side, count in sides.items() if count == 1}
    faces = {frozenset(f) for f in nodes[TRIANGLE].reshape(-1, 3).tolist()}
    faces |= {frozenset(f) for f in nodes[QUADRANGLE].reshape(-1, 4).tolist()}
    assert outer <= faces
    assert all(sides[face] == 2 for face in faces - outer), "else a partition between rooms"
