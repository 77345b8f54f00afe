"""What each program of the Python environment sees of the rooms with names, for the table."""

import importlib.metadata

import gmsh
import meshio
import mfem.ser as mfem
import netgen.read_gmsh
import ngsolve as ng
import numpy as np
import pytest
import skfem
import trimesh
from skfem.helpers import dot, grad
from vtkmodules.util.numpy_support import vtk_to_numpy

import answers
import survey
import table
import vtk_files
from test_gltf import parse
from test_mfem import integrals, solve
from test_msh_variants import corners, sizes

FIXED = [answers.GROUPS[1, tag] for tag in answers.FIXED]
version = importlib.metadata.version


def numbered(dim, sizes, names=None):
    """Groups by number, with the names of those that have one."""
    return [(dim, tag, (names or {}).get((dim, tag)), size) for tag, size in sizes.items()]


def test_gmsh(named_rooms, hold):
    gmsh.initialize(["gmsh", "-v", "2"])
    gmsh.open(str(named_rooms("rooms.msh", "--for", "gmsh")))
    points = gmsh.model.mesh.getNodes()[1].reshape(-1, 3)[:, :2]
    groups, triangles = [], 0
    for dim, tag in gmsh.model.getPhysicalGroups():
        entities = gmsh.model.getEntitiesForPhysicalGroup(dim, tag)
        parts = [corners(gmsh.model, dim, entity) for entity in entities]
        size = sum(len(part) if dim == 0 else sizes(part).sum() for part in parts)
        groups.append((dim, tag, gmsh.model.getPhysicalName(dim, tag), float(size)))
        triangles += sum(map(len, parts)) if dim == 2 else 0
    gmsh.finalize()
    hold("Gmsh", version("gmsh"), ".msh 4.1", "gmsh", points, triangles, groups)


def test_vtk(named_rooms, hold):
    grid = vtk_files.read(named_rooms("rooms.vtu", "--for", "paraview"))
    points = vtk_to_numpy(grid.GetPoints().GetData())[:, :2]
    tags = vtk_to_numpy(grid.GetCellData().GetArray("tag"))
    cells = []
    for index in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(index)  # one object, of which the next call makes the next cell
        dim = cell.GetCellDimension()
        cells.append((dim, cell.ComputeArea() if dim == 2 else cell.GetLength2() ** 0.5))
    groups, fields = [], grid.GetFieldData()
    arrays = [fields.GetArray(index) for index in range(fields.GetNumberOfArrays())]
    names = {tuple(vtk_to_numpy(array)): array.GetName() for array in arrays}
    for dim in (1, 2):
        chosen = [index for index, (of_cell, _) in enumerate(cells) if of_cell == dim]
        found = answers.measures(tags[chosen], [cells[index][1] for index in chosen])
        groups += [(dim, tag, names.get((tag, dim)), size) for tag, size in found.items()]
    triangles = sum(dim == 2 for dim, _ in cells)
    hold("VTK", version("vtk"), ".vtu", "paraview", points, triangles, groups)


@pytest.mark.parametrize("file", [".vtu", ".msh 2.2"])
def test_meshio(file, named_rooms, hold):
    mesh = meshio.read(named_rooms(f"rooms{file.split()[0]}"))
    names = {(int(dim), int(tag)): name for name, (tag, dim) in
             ((n, pair) for n, pair in mesh.field_data.items() if n != "meshwright")}  # fmt: skip
    tags = mesh.cell_data_dict.get("gmsh:physical", {})
    groups = []
    for dim, kind in enumerate(("vertex", "line", "triangle")):
        if kind in tags:
            cells = mesh.points[mesh.cells_dict[kind]][..., :2]
            of_cells = np.ones(len(cells)) if dim == 0 else sizes(cells)
            groups += numbered(dim, answers.measures(tags[kind], of_cells), names)
    triangles = len(mesh.cells_dict["triangle"])
    hold("meshio", version("meshio"), file, None, mesh.points[:, :2], triangles, groups)


@skfem.BilinearForm
def conduction(u, v, w):
    return w.k * dot(grad(u), grad(v))


@pytest.mark.parametrize("file", [".msh 2.2", ".vtu"])
def test_scikit_fem(file, named_rooms, hold):
    path = named_rooms(f"rooms{file.split()[0]}", "--for", "scikit-fem")
    mesh = skfem.MeshTri.load(path)
    areas, groups = np.abs(sizes(mesh.p.T[mesh.t.T])), []
    for name, members in mesh.subdomains.items():
        groups.append((2, None, name, areas[members].sum()))
    for name, members in mesh.boundaries.items():
        groups.append((1, None, name, sizes(mesh.p.T[mesh.facets.T[members]]).sum()))
    basis = skfem.Basis(mesh, skfem.ElementTriP1())
    piecewise = skfem.Basis(mesh, skfem.ElementTriP0())
    k = piecewise.zeros()
    for tag, conductivity in answers.CONDUCTIVITY.items():
        k[mesh.subdomains[answers.GROUPS[2, tag]]] = conductivity
    matrix = conduction.assemble(basis, k=piecewise.interpolate(k))
    exact = answers.temperature(*mesh.p)
    solution = skfem.solve(*skfem.condense(matrix, x=exact, D=basis.get_dofs(FIXED)))
    error = np.abs(solution - exact).max()
    name, preset = "scikit-fem", "scikit-fem"
    hold(name, version(name), file, preset, mesh.p.T, mesh.nelements, groups, float(error))


class Temperature(mfem.PyCoefficient):
    def EvalValue(self, place):
        return float(answers.temperature(*place[:2]))


def test_mfem(named_rooms, hold):
    mesh = mfem.Mesh(str(named_rooms("rooms.msh", "--for", "mfem")), 1, 1)
    groups = []
    for dim, sets, of_elements in (
        (1, mesh.bdr_attribute_sets,
         (mesh.GetNBE(), mesh.GetBdrAttribute, mesh.GetBdrElementTransformation)),
        (2, mesh.attribute_sets, (mesh.GetNE(), mesh.GetAttribute, mesh.GetElementTransformation)),
    ):  # fmt: skip
        names = {}
        for name in sets.GetAttributeSetNames():
            attributes = sets.GetAttributeSet(name)
            names |= {(dim, attributes[i]): name for i in range(attributes.Size())}
        groups += numbered(dim, integrals(mesh, *of_elements), names)

    space = mfem.FiniteElementSpace(mesh, mfem.H1_FECollection(1, 2))
    k = mfem.Vector(mesh.attributes.Max())
    k.Assign(1e30)
    for tag, conductivity in answers.CONDUCTIVITY.items():
        k[tag - 1] = conductivity
    diffusion = mfem.DiffusionIntegrator(mfem.PWConstCoefficient(k))
    solution = solve(space, answers.FIXED, Temperature(), diffusion)
    exact = mfem.GridFunction(space)
    exact.ProjectCoefficient(Temperature())
    error = np.abs(solution.GetDataArray() - exact.GetDataArray()).max()
    points = np.array([mesh.GetVertexArray(i)[:2] for i in range(mesh.GetNV())])
    hold("MFEM", version("mfem"), ".msh 2.2", "mfem", points, mesh.GetNE(), groups, float(error))


def test_ngsolve(named_rooms, hold):
    # The reader adds the end of the name itself.
    path = named_rooms("rooms.msh", "--for", "ngsolve").with_suffix("")
    mesh = ng.Mesh(netgen.read_gmsh.ReadGmsh(str(path)))
    groups = []
    for dim, names, where, kind in (
        (1, set(mesh.GetBoundaries()), mesh.Boundaries, ng.BND),
        (2, set(mesh.GetMaterials()), mesh.Materials, ng.VOL),
    ):
        for name in sorted(names):
            groups.append((dim, None, name, ng.Integrate(1, mesh, kind, definedon=where(name))))
    k = mesh.MaterialCF({answers.GROUPS[2, tag]: k for tag, k in answers.CONDUCTIVITY.items()})
    exact = 10 * (ng.x - 1.3) / ng.IfPos(1.3 - ng.x, 2, 5) - 2 * ng.y + 1
    space = ng.H1(mesh, order=1, dirichlet="|".join(FIXED))
    u, v = space.TnT()
    stiffness = ng.BilinearForm(k * ng.grad(u) * ng.grad(v) * ng.dx).Assemble()
    solution = ng.GridFunction(space)
    solution.Set(exact, ng.BND)
    residual = -stiffness.mat * solution.vec
    solution.vec.data += stiffness.mat.Inverse(space.FreeDofs()) * residual
    points = np.array([vertex.point for vertex in mesh.vertices])[:, :2]
    error = np.abs(np.array(solution.vec) - answers.temperature(*points.T)).max()
    hold("NGSolve", version("ngsolve"), ".msh 2.2", "ngsolve", points, mesh.ne, groups, float(error))


def test_trimesh_stl(named_rooms, hold):
    scene = trimesh.load(named_rooms("rooms.stl"), force="scene")
    parts = scene.geometry
    groups = [(2, None, name, part.area) for name, part in parts.items()]
    points = np.unique(np.concatenate([part.vertices[:, :2] for part in parts.values()]), axis=0)
    triangles = sum(len(part.faces) for part in parts.values())
    hold("trimesh", version("trimesh"), ".stl", None, points, triangles, groups)


def test_trimesh_glb(named_rooms, hold):
    file = named_rooms("rooms.glb")
    scene = trimesh.load(file)
    origin = np.array(parse(file)[0]["extras"]["origin"])  # which it does not keep
    groups, points, triangles = [], [], 0
    for told in scene.graph.transforms.edge_data.values():
        name, tag, dim = told["geometry"], told["metadata"]["tag"], told["metadata"]["dim"]
        part = scene.geometry[name]
        groups.append((dim, tag, name, part.area if dim == 2 else part.length))
        if dim == 2:
            points.append(part.vertices[:, :2] + origin)
            triangles += len(part.faces)
    points = np.unique(np.concatenate(points).round(6), axis=0)
    hold("trimesh", version("trimesh"), ".glb", None, points, triangles, groups)


def test_the_readme_has_the_table_that_was_recorded():
    rows = survey.rows()
    assert len(rows) >= 20
    assert table.table(rows) in table.README.read_text()
