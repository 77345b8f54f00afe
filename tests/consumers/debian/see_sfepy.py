"""What SfePy sees of a Medit file, and the temperature in the two rooms.

PYTHONPATH=FOLDER_OF_SFEPY /usr/bin/python3 see_sfepy.py FILE prints JSON."""

import json
import sys

import numpy as np
import sfepy
from sfepy.base.base import output
from sfepy.discrete import (Equation, Equations, FieldVariable, Function, Integral, Material,
                            Problem)  # fmt: skip
from sfepy.discrete.conditions import Conditions, EssentialBC
from sfepy.discrete.fem import FEDomain, Field, Mesh
from sfepy.solvers.ls import ScipyDirect
from sfepy.solvers.nls import Newton
from sfepy.terms import Term

output.set_output(quiet=True)
mesh = Mesh.from_file(sys.argv[1])
domain = FEDomain("rooms", mesh)
rooms = domain.create_region("rooms", "all")
cells = {tag: domain.create_region(f"cells_{tag}", f"cells of group {tag}")
         for tag in np.unique(mesh.cmesh.cell_groups)}  # fmt: skip
sides = {tag: domain.create_region(f"nodes_{tag}", f"vertices of group {tag}", "vertex")
         for tag in np.unique(mesh.cmesh.vertex_groups) if tag != 0}  # fmt: skip

volumes = mesh.cmesh.get_volumes(2)
groups = [(2, int(tag), None, float(volumes[region.cells].sum())) for tag, region in cells.items()]


def exact(x, y):
    return 10 * (x - 1.3) / np.where(x < 1.3, 2, 5) - 2 * y + 1


field = Field.from_args("temperature", np.float64, 1, rooms, approx_order=1)
u = FieldVariable("u", "unknown", field)
v = FieldVariable("v", "test", field, primary_var_name="u")
integral = Integral("i", order=2)
terms = None
for tag, conductivity in ((11, 2.0), (12, 5.0)):
    material = Material(f"m{tag}", k=conductivity)
    kind, materials = f"dw_laplace(m{tag}.k, v, u)", {f"m{tag}": material}
    term = Term.new(kind, integral, cells[tag], **materials, v=v, u=u)
    terms = term if terms is None else terms + term
given = Function("given", lambda ts, coors, **_: exact(*coors.T))
fixed = [EssentialBC(f"fixed_{tag}", region, {"u.0": given}) for tag, region in sides.items()
         if tag in (1, 2, 3, 9)]  # fmt: skip
problem = Problem("heat", equations=Equations([Equation("balance", terms)]))
problem.set_bcs(ebcs=Conditions(fixed))
problem.set_solver(Newton({}, lin_solver=ScipyDirect({})))
solution = problem.solve(save_results=False).get_parts()["u"]
print(json.dumps({
    "version": sfepy.__version__,
    "points": mesh.coors.tolist(),
    "triangles": int(mesh.n_el),
    "groups": groups,
    "at_points": {int(tag): mesh.coors[region.vertices].tolist() for tag, region in sides.items()},
    "error": float(np.abs(solution - exact(*mesh.coors.T)).max()),
}))  # fmt: skip
