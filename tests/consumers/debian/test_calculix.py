"""CalculiX reads `.inp`: regions are sets of elements, boundaries sets of nodes and surfaces."""

import re
import shutil

import numpy as np
import pytest

import answers
import programs

FLUX = 10.0  # through each unit of length from room to room


def temperature(x):
    """The solution where the temperature is the same all along the left side."""
    return answers.temperature(x, 0.0) - 1


@pytest.fixture(scope="module")
def run(named_rooms, tmp_path_factory):
    """The files of the mesh and of the results."""
    folder = tmp_path_factory.mktemp("calculix")
    shutil.copy(named_rooms("rooms.inp", "--for", "calculix"), folder)
    shutil.copy(programs.HERE / "calculix.inp", folder / "rooms_heat.inp")
    text = (folder / "rooms.inp").read_text()
    points = nodes(text)
    pillar = text.split("*NSET, NSET=pillar\n")[1].split("*")[0].replace(",", " ").split()
    given = [f"{node}, 11, 11, {float(temperature(points[int(node)][0]))!r}" for node in pillar]
    (folder / "pillar.inp").write_text("\n".join(["*BOUNDARY", *given, ""]))
    programs.execute("ccx", "rooms_heat", folder=folder, OMP_NUM_THREADS="1")
    return (folder / "rooms_heat.frd").read_text(), (folder / "rooms_heat.dat").read_text(), points


def nodes(text):
    """The coordinates of the nodes of our file, by number."""
    rows = text.split("*NODE, NSET=NALL\n")[1].split("*")[0].splitlines()
    rows = [row.split(", ") for row in rows]
    return {int(row[0]): np.array([float(x) for x in row[1:3]]) for row in rows}


def mesh_of(frd):
    """The nodes and the triangles as CalculiX writes them, by number."""
    places = re.findall(r"^ -1\s+(\d+) *(\S{11,12}) *(\S{11,12}) *(\S{11,12})$", frd.split("    2C")[1]
                        .split(" -3")[0].replace("E+00-", "E+00 -"), re.M)  # fmt: skip
    points = {int(node): np.array([float(x), float(y)]) for node, x, y, _ in places}
    cells = re.findall(r"^ -1 +(\d+) .*\n -2 +(\d+) +(\d+) +(\d+)$", frd.split("    3C")[1], re.M)
    return points, {int(cell): [int(node) for node in corners] for cell, *corners in cells}


def tables(dat):
    """The tables of a file of results: what is told, of which set, its rows."""
    _, *parts = re.split(r"^ (\D+) for set (\w+) and time.*$", dat, flags=re.M)
    for head, name, rows in zip(parts[::3], parts[1::3], parts[2::3]):
        yield head, name.lower(), [line.split() for line in rows.splitlines() if line.split()]


def test_calculix_sees_the_rooms_and_solves(run, hold):
    frd, dat, exact = run
    points, cells = mesh_of(frd)
    groups, error = [], None
    for head, name, rows in tables(dat):
        if head == "temperatures" and name == "nall":
            found = {int(node): float(value) for node, value in rows}
            error = max(abs(found[node] - temperature(exact[node][0])) for node in exact)
            assert found.keys() == exact.keys()
        elif head == "temperatures" and name == "probe":
            groups.append((0, None, name, len(rows)))
        elif head == "total volume":
            groups.append((2, None, name, float(rows[0][0])))
        elif head.startswith("heat flux at"):
            length = 0.0
            for cell, face, *_ in rows[1:]:
                side = int(face) - 3  # faces 1 and 2 of a wedge are its triangles
                ends = [cells[int(cell)][(side + end) % 3] for end in (0, 1)]
                length += float(np.linalg.norm(exact[ends[1]] - exact[ends[0]]))
            groups.append((1, None, name, length))
    version = programs.version("calculix-ccx")
    places = [points[node] for node in sorted(points)]
    hold("CalculiX", version, ".inp", "calculix", places, len(cells), groups, error, 6)


def test_what_flows_in_on_the_left_flows_through_the_partition_and_out(run):
    _, dat, _ = run
    totals = {name: float(rows[0][0]) for head, name, rows in tables(dat)
              if head.startswith("total surface flux")}  # fmt: skip
    wanted = {"left": 7.0, "right": -7.0, "cold": -7.0, "partition": -7.0, "wall": 0.0, "pillar": 0.0}
    assert totals == pytest.approx(wanted, abs=1e-5)
