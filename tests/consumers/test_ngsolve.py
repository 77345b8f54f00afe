"""NGSolve on our meshes: regions and boundaries by name, a problem with a known answer."""

import ngsolve as ng
import pytest
from netgen.read_gmsh import ReadGmsh

import answers


@pytest.fixture(scope="module")
def mesh(named_rooms):
    # The reader adds the end of the name itself.
    return ng.Mesh(ReadGmsh(str(named_rooms("rooms.msh", "--for", "ngsolve").with_suffix(""))))


def test_regions_and_boundaries_are_found_by_name(mesh):
    names = {dim: {n for (d, _), n in answers.GROUPS.items() if d == dim} for dim in (1, 2)}
    assert set(mesh.GetMaterials()) == names[2]
    assert set(mesh.GetBoundaries()) == names[1]
    for tag, area in answers.AREAS.items():
        region = mesh.Materials(answers.GROUPS[2, tag])
        assert ng.Integrate(1, mesh, definedon=region) == pytest.approx(area, rel=1e-12)
    for tag, length in answers.LENGTHS.items():
        side = mesh.Boundaries(answers.GROUPS[1, tag])
        assert ng.Integrate(1, mesh, ng.BND, definedon=side) == pytest.approx(length, rel=1e-12)


def test_a_quadratic_harmonic_solution_is_exact_with_quadratic_elements(mesh):
    exact = ng.x**2 - ng.y**2 + ng.x * ng.y
    space = ng.H1(mesh, order=2, dirichlet="wall|left|right|pillar")
    u, v = space.TnT()
    stiffness = ng.BilinearForm(ng.grad(u) * ng.grad(v) * ng.dx).Assemble()
    solution = ng.GridFunction(space)
    solution.Set(exact, ng.BND)
    residual = -stiffness.mat * solution.vec
    solution.vec.data += stiffness.mat.Inverse(space.FreeDofs()) * residual
    error = ng.sqrt(ng.Integrate((solution - exact) ** 2, mesh))
    assert error < 1e-12
