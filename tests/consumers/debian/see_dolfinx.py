"""What DOLFINx sees of a `.msh` or `.xdmf` file, and the temperature in the two rooms.

/usr/bin/python3 see_dolfinx.py FILE prints JSON."""

import json
import sys

import dolfinx
import gmsh
import numpy as np
import ufl
from dolfinx.fem import (Constant, Function, FunctionSpace, assemble_scalar, dirichletbc, form,
                         locate_dofs_topological)  # fmt: skip
from dolfinx.fem.petsc import LinearProblem
from dolfinx.io import XDMFFile, gmshio
from mpi4py import MPI
from petsc4py import PETSc


def read(file):
    """The mesh, the numbers of its triangles and of its edges."""
    if file.endswith(".msh"):
        # What `gmshio.read_from_msh` does; that one forgets to return the mesh in 0.5.2.
        gmsh.initialize(["gmsh", "-v", "1"])
        gmsh.open(file)
        return gmshio.model_to_mesh(gmsh.model, MPI.COMM_WORLD, 0, gdim=2)
    with XDMFFile(MPI.COMM_WORLD, file, "r", encoding=XDMFFile.Encoding.ASCII) as xdmf:
        mesh = xdmf.read_mesh(name="mesh")
        mesh.topology.create_connectivity(1, 2)
        return mesh, xdmf.read_meshtags(mesh, "mesh"), xdmf.read_meshtags(mesh, "boundary")


mesh, cells, facets = read(sys.argv[1])
mesh.topology.create_connectivity(1, 2)
groups = []
for dim, tags, measure in ((2, cells, ufl.dx), (1, facets, ufl.ds), (1, facets, ufl.dS)):
    dx = measure(domain=mesh, subdomain_data=tags)
    one = Constant(mesh, PETSc.ScalarType(1))
    one = one("+") if measure is ufl.dS else one
    for tag in np.unique(tags.values).tolist():
        size = assemble_scalar(form(one * dx(tag)))
        if size > 0:
            groups.append((dim, tag, None, float(size.real)))

piecewise = FunctionSpace(mesh, ("DG", 0))
k = Function(piecewise)
for tag, conductivity in ((11, 2.0), (12, 5.0)):
    k.x.array[cells.find(tag)] = conductivity


def exact(x):
    return 10 * (x[0] - 1.3) / np.where(x[0] < 1.3, 2, 5) - 2 * x[1] + 1


space = FunctionSpace(mesh, ("Lagrange", 1))
wanted = Function(space)
wanted.interpolate(exact)
fixed = np.concatenate([facets.find(tag) for tag in (1, 2, 3, 9)])
given = dirichletbc(wanted, locate_dofs_topological(space, 1, fixed))
u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
problem = LinearProblem(
    k * ufl.dot(ufl.grad(u), ufl.grad(v)) * ufl.dx,
    Constant(mesh, PETSc.ScalarType(0)) * v * ufl.dx,
    bcs=[given],
    petsc_options={"ksp_type": "preonly", "pc_type": "lu"},
)
solution = problem.solve()
print(json.dumps({
    "version": dolfinx.__version__,
    "points": mesh.geometry.x[:, :2].tolist(),
    "triangles": mesh.topology.index_map(2).size_local,
    "groups": groups,
    "error": float(np.abs(solution.x.array - wanted.x.array).max()),
}))  # fmt: skip
