#!/bin/sh
# A membrane over Lake Superior, fixed at its shores and islands, under a load of 1: outline, mesh,
# deflection, a file for ParaView.
#
#   sh examples/membrane.sh [FOLDER]
#
# It needs Python with scikit-fem and the command `meshwright`; the environment variables PYTHON and
# MESHWRIGHT name others.
set -eu
here=$(dirname "$0")
folder=${1:-.}
meshwright=${MESHWRIGHT:-meshwright}

"$meshwright" mesh "$here/lake_superior.poly" --max-area 0.001 --for scikit-fem -o "$folder/lake.msh"
# Exit code 4 stops here a mesh that breaks a promise.
"$meshwright" check "$folder/lake.msh" --input "$here/lake_superior.poly" --quiet

"${PYTHON:-python3}" - "$folder" <<'PYTHON'
import sys

import skfem
from skfem.models.poisson import laplace, unit_load

folder = sys.argv[1]
mesh = skfem.MeshTri.load(f"{folder}/lake.msh")
basis = skfem.Basis(mesh, skfem.ElementTriP1())
matrix, load = laplace.assemble(basis), unit_load.assemble(basis)
deflection = skfem.solve(*skfem.condense(matrix, load, D=basis.get_dofs("boundary")))
mesh.save(f"{folder}/membrane.vtu", point_data={"deflection": deflection})
print(f"largest deflection {deflection.max():.6f}, volume {load @ deflection:.6f}")
PYTHON
echo "wrote $folder/membrane.vtu"
