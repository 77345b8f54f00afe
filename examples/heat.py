"""Heat that flows through two rooms: outline, mesh, temperature, a file for ParaView.

    python examples/heat.py [FOLDER]

The window is at 5 degrees, the heater at 40; nothing flows through the other walls, nor through the
column. The cabinet conducts three times as well as the hall. It needs scikit-fem and the command
`meshwright`, or its path in the environment variable MESHWRIGHT.
"""

import os
import subprocess
import sys
from pathlib import Path

import skfem
from skfem.helpers import dot, grad

CONDUCTIVITY = {"hall": 1.0, "cabinet": 3.0}
TEMPERATURE = {"window": 5.0, "heater": 40.0}


def mesh(outline, file):
    """Meshes an outline for scikit-fem, with triangles of 0.02 m² at most."""
    command = os.environ.get("MESHWRIGHT", "meshwright")
    options = ["--max-area", "0.02", "--for", "scikit-fem", "-o", file]
    subprocess.run([command, "mesh", outline, *options], check=True)
    return skfem.MeshTri.load(file)


@skfem.BilinearForm
def conduction(u, v, w):
    return w.k * dot(grad(u), grad(v))


def solve(mesh):
    """The temperature at each point, and the heat that flows in through each group."""
    basis = skfem.Basis(mesh, skfem.ElementTriP1())
    of_triangles = skfem.Basis(mesh, skfem.ElementTriP0())
    k = of_triangles.zeros()
    for region, conductivity in CONDUCTIVITY.items():
        k[mesh.subdomains[region]] = conductivity
    matrix = conduction.assemble(basis, k=of_triangles.interpolate(k))
    temperature = basis.zeros()
    nodes = {group: basis.get_dofs(group).flatten() for group in TEMPERATURE}
    for group, given in TEMPERATURE.items():
        temperature[nodes[group]] = given
    fixed = basis.get_dofs(list(TEMPERATURE))
    temperature = skfem.solve(*skfem.condense(matrix, x=temperature, D=fixed))
    flow = matrix @ temperature
    return temperature, {group: flow[nodes[group]].sum() for group in TEMPERATURE}


def main(folder):
    rooms = mesh(Path(__file__).with_name("rooms.geo"), folder / "rooms.msh")
    temperature, flow = solve(rooms)
    for group, power in flow.items():
        print(f"{group}: {power:.4f} W for each metre of height")
    rooms.save(folder / "heat.vtu", point_data={"temperature": temperature})
    print(f"wrote {folder / 'heat.vtu'}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
