"""DOLFINx, of FEniCSx, reads `.msh` through Gmsh, and `.xdmf` itself."""

import pytest

import programs


@pytest.mark.parametrize("name, file", [("rooms.msh", ".msh 4.1"), ("rooms.xdmf", ".xdmf")])
def test_dolfinx_sees_the_rooms_and_solves(name, file, named_rooms, hold, tmp_path):
    path = named_rooms(name, "--for", "fenicsx")
    script = programs.HERE / "see_dolfinx.py"
    seen = programs.seen_json("/usr/bin/python3", script, path, folder=tmp_path)
    hold(
        "DOLFINx", seen["version"], file, "fenicsx",
        seen["points"], seen["triangles"], seen["groups"], seen["error"],
    )  # fmt: skip
