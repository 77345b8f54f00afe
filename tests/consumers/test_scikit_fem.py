"""Problems with known answers, solved by scikit-fem on our meshes."""

import numpy as np
import pytest
import skfem
from skfem.helpers import dot, grad

import answers
from conftest import mesh_into


@pytest.fixture(scope="module", params=["msh", "vtu"])
def mesh(rooms, request):
    return skfem.MeshTri.load(getattr(rooms, request.param))


@skfem.BilinearForm
def stiffness(u, v, _):
    return dot(grad(u), grad(v))


def solve(basis, exact, source=None):
    """Solves −Δu = source with the exact solution as boundary values."""
    matrix = stiffness.assemble(basis)
    load = np.zeros(basis.N) if source is None else source.assemble(basis)
    boundary = basis.get_dofs()
    values = basis.project(exact)
    return skfem.solve(*skfem.condense(matrix, load, x=values, D=boundary))


def norm_of_error(basis, solution, exact):
    @skfem.Functional
    def squared(w):
        return (w["u"] - exact(w.x)) ** 2

    return np.sqrt(squared.assemble(basis, u=basis.interpolate(solution)))


def test_regions_and_sides_are_found_by_name(mesh, rooms):
    regions = {f"region_{tag}": area for tag, area in answers.AREAS.items()}
    assert set(mesh.subdomains) == set(regions)
    areas = rooms.mesh.triangle_areas()
    for name, area in regions.items():
        assert areas[mesh.subdomains[name]].sum() == pytest.approx(area, rel=1e-12)
    # It keeps no names of edges inside, so the partition (7) is not among the sides.
    assert set(mesh.boundaries) == {f"boundary_{tag}" for tag in (1, 2, 3, 9)}
    for tag in (1, 2, 3, 9):
        ends = mesh.p[:, mesh.facets[:, mesh.boundaries[f"boundary_{tag}"]]]
        lengths = np.hypot(*(ends[:, 1] - ends[:, 0]))
        assert lengths.sum() == pytest.approx(answers.LENGTHS[tag], rel=1e-12)


def test_a_linear_solution_is_exact(mesh):
    def exact(x):
        return 3 * x[0] - 2 * x[1] + 1

    basis = skfem.Basis(mesh, skfem.ElementTriP1())
    assert np.abs(solve(basis, exact) - exact(mesh.p)).max() < 1e-12


def test_a_quadratic_harmonic_solution_is_exact_with_quadratic_elements(mesh):
    def exact(x):
        return x[0] ** 2 - x[1] ** 2 + x[0] * x[1]

    basis = skfem.Basis(mesh, skfem.ElementTriP2())
    assert norm_of_error(basis, solve(basis, exact), exact) < 1e-12


def test_the_flux_through_named_sides_balances(mesh):
    """u = 0 on the left, 1 on the right, no flux through the rest: what enters must leave."""
    basis = skfem.Basis(mesh, skfem.ElementTriP1())
    matrix = stiffness.assemble(basis)
    left, right = (basis.get_dofs(f"boundary_{tag}").flatten() for tag in (2, 3))
    values = basis.zeros()
    values[right] = 1
    fixed = np.concatenate([left, right])
    solution = skfem.solve(*skfem.condense(matrix, x=values, D=fixed))
    reaction = matrix @ solution
    assert reaction[right].sum() == pytest.approx(-reaction[left].sum(), rel=1e-10)
    assert 0.2 < reaction[right].sum() < 0.7 / 2.1, "less than without the pillar"
    # The maximum principle: a mesh that is Delaunay has an M-matrix.
    assert -1e-12 < solution.min() and solution.max() < 1 + 1e-12


def test_the_matrix_has_no_positive_entry_off_its_diagonal(mesh):
    matrix = stiffness.assemble(skfem.Basis(mesh, skfem.ElementTriP1())).tocoo()
    off_diagonal = matrix.data[matrix.row != matrix.col]
    assert off_diagonal.max() < 1e-12


def test_the_error_of_a_smooth_solution_falls_with_the_square_of_the_size(tmp_path):
    def exact(x):
        return np.sin(np.pi * x[0]) * np.sin(np.pi * x[1])

    @skfem.LinearForm
    def source(v, w):
        return 2 * np.pi**2 * exact(w.x) * v

    errors = []
    for level in range(4):
        folder = tmp_path / str(level)
        folder.mkdir()
        files = mesh_into(folder, "untagged.poly", "--max-area", 0.02 / 4**level)
        basis = skfem.Basis(skfem.MeshTri.load(files.msh), skfem.ElementTriP1(), intorder=6)
        errors.append(norm_of_error(basis, solve(basis, exact, source), exact))
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert orders.mean() == pytest.approx(2, abs=0.25), errors


@pytest.mark.parametrize("name", ["rooms.msh", "rooms.vtu"])
def test_what_is_written_for_it_has_all_names(name, named_rooms):
    mesh = skfem.MeshTri.load(named_rooms(name, "--for", "scikit-fem"))
    assert set(mesh.subdomains) == {"hall", "cabinet"}
    assert {"wall", "left", "right", "pillar"} <= set(mesh.boundaries)
    for tag, name in ((1, "wall"), (2, "left"), (9, "pillar")):
        ends = mesh.p[:, mesh.facets[:, mesh.boundaries[name]]]
        lengths = np.hypot(*(ends[:, 1] - ends[:, 0]))
        assert lengths.sum() == pytest.approx(answers.LENGTHS[tag], rel=1e-12)


def test_second_order_elements_are_read(named_rooms):
    mesh = skfem.Mesh.load(named_rooms("rooms.msh", "--order", "2"))
    assert isinstance(mesh, skfem.MeshTri2)
    area = skfem.Functional(lambda w: 1 + 0 * w.x[0]).assemble(
        skfem.Basis(mesh, skfem.ElementTriP2())
    )
    assert area == pytest.approx(sum(answers.AREAS.values()), rel=1e-12)
