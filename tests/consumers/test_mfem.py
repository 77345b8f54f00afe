"""MFEM on our meshes: attributes, their names, a problem with a known answer."""

import mfem.ser as mfem
import numpy as np
import pytest

import answers

VARIANTS = [(), ("--binary",), ("--msh-version", "4.1"), ("--order", "2")]


@pytest.fixture(scope="module", params=VARIANTS, ids=" ".join)
def mesh(request, named_rooms):
    return mfem.Mesh(str(named_rooms("rooms.msh", "--for", "mfem", *request.param)), 1, 1)


def integrals(mesh, count, attribute, transformation):
    """The length or area of each attribute."""
    tags = [attribute(i) for i in range(count)]
    sizes = []
    for i in range(count):
        element = transformation(i)
        rule = mfem.IntRules.Get(element.GetGeometryType(), 2)
        size = 0.0
        for point in range(rule.GetNPoints()):
            element.SetIntPoint(rule.IntPoint(point))
            size += rule.IntPoint(point).weight * element.Weight()
        sizes.append(size)
    return answers.measures(tags, sizes)


def test_attributes_are_the_numbers_of_groups(mesh):
    assert (mesh.Dimension(), mesh.SpaceDimension()) == (2, 2)
    areas = integrals(mesh, mesh.GetNE(), mesh.GetAttribute, mesh.GetElementTransformation)
    assert answers.same(areas, answers.AREAS)
    lengths = integrals(mesh, mesh.GetNBE(), mesh.GetBdrAttribute, mesh.GetBdrElementTransformation)
    assert answers.same(lengths, answers.LENGTHS)


def test_attributes_have_the_names_of_groups(mesh):
    for dim, sets in ((1, mesh.bdr_attribute_sets), (2, mesh.attribute_sets)):
        names = {name for (d, _), name in answers.GROUPS.items() if d == dim}
        assert set(sets.GetAttributeSetNames()) == names


class Exact(mfem.PyCoefficient):
    """x² − y² + xy, which is harmonic."""

    def EvalValue(self, place):
        x, y = place[:2]
        return x * x - y * y + x * y


def solve(space, boundary, value, diffusion):
    """−∇·(k∇u) = 0 with `value` on the attributes of the `boundary`, `diffusion` being k's integrator."""
    fixed = mfem.intArray(space.GetMesh().bdr_attributes.Max())
    fixed.Assign(0)
    for tag in boundary:
        fixed[tag - 1] = 1
    unknowns = mfem.intArray()
    space.GetEssentialTrueDofs(fixed, unknowns)
    solution = mfem.GridFunction(space)
    solution.Assign(0.0)
    solution.ProjectBdrCoefficient(value, fixed)
    form, load = mfem.BilinearForm(space), mfem.LinearForm(space)
    form.AddDomainIntegrator(diffusion)
    form.Assemble()
    load.Assemble()
    matrix, right, unknown = mfem.OperatorPtr(), mfem.Vector(), mfem.Vector()
    form.FormLinearSystem(unknowns, solution, load, matrix, unknown, right)
    smoother = mfem.GSSmoother(mfem.OperatorHandle2SparseMatrix(matrix))
    mfem.PCG(matrix, smoother, right, unknown, 0, 500, 1e-28, 0.0)
    form.RecoverFEMSolution(unknown, load, solution)
    return solution


def test_a_quadratic_harmonic_solution_is_exact_with_quadratic_elements(mesh):
    space = mfem.FiniteElementSpace(mesh, mfem.H1_FECollection(2, 2))
    solution = solve(space, answers.FIXED, Exact(), mfem.DiffusionIntegrator())
    assert solution.ComputeL2Error(Exact()) < 1e-11
    assert np.isfinite(solution.GetDataArray()).all()
