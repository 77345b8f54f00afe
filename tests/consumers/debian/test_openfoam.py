"""OpenFOAM reads one layer of prisms, `.msh` 2.2, by gmshToFoam."""

import re
import shutil

import numpy as np
import pytest

import programs

ROOT = {"WM_PROJECT_DIR": "/usr/share/openfoam"}
STEPS = "60"


def blocks(text):
    """The entries `name { … }` of a file that has no such entry within another."""
    return dict(re.findall(r"(\w+)\s*\{(.*?)\}\s*(?=\w+\s*\{|\)|$)", text, re.S))


def numbers(text, kind=float):
    """The numbers in a list, brackets apart."""
    return np.array(re.sub(r"[()]", " ", text).split(), dtype=kind)


def listed(file):
    """What stands in the list of a file."""
    return re.search(r"\n\d+\s*\n?\((.*)\)", file.read_text().split("// *", 1)[1], re.S)[1]


class Case:
    """The mesh of a case, as its files tell it."""

    def __init__(self, folder):
        mesh = folder / "constant" / "polyMesh"
        self.points = numbers(listed(mesh / "points")).reshape(-1, 3)
        faces = re.findall(r"\d\(([\d ]+)\)", listed(mesh / "faces"))
        self.faces = [np.array(face.split(), dtype=int) for face in faces]
        self.patches = {
            name: range(start := int(entry["startFace"]), start + int(entry["nFaces"]))
            for name, text in blocks(listed(mesh / "boundary")).items()
            for entry in [dict(re.findall(r"(\w+)\s+(\w+);", text))]
        }
        zones = {kind: blocks(listed(mesh / f"{kind}Zones")) for kind in ("cell", "face")}
        self.zones = {
            kind: {
                name: numbers(re.search(r"Labels\s+List<label>\s+\d+\s*\(([^)]*)\)", text)[1], int)
                for name, text in of_kind.items()
            }
            for kind, of_kind in zones.items()
        }

    def length(self, face):
        """The length of the edge that became this face of height 1."""
        ground = self.points[self.faces[face]]
        ground = ground[ground[:, 2] == 0]
        return float(np.linalg.norm(ground[1] - ground[0]))

    def centre(self, face):
        """The middle of a face, which is a rectangle."""
        return self.points[self.faces[face]].mean(axis=0)


def temperature(x, y):
    """Linear, for this solver has one conductivity."""
    return 3 * x - 2 * y + 1


def field(case):
    """The file of the unknown, with the temperature at each face of the boundary."""
    lines = ["FoamFile { version 2.0; format ascii; class volScalarField; object T; }",
             "dimensions [0 0 0 1 0 0 0];", "internalField uniform 0;", "boundaryField {"]  # fmt: skip
    for name, faces in case.patches.items():
        values = " ".join(repr(float(temperature(*case.centre(face)[:2]))) for face in faces)
        kind = f"type fixedValue; value nonuniform List<scalar> {len(faces)} ({values});"
        lines.append(f"{name} {{ {'type empty;' if name == 'frontAndBack' else kind} }}")
    return "\n".join([*lines, "}"])


@pytest.fixture(scope="module")
def folder(named_rooms, tmp_path_factory):
    """A case with the mesh in it, its front and back marked as the plane's."""
    folder = tmp_path_factory.mktemp("openfoam") / "case"
    shutil.copytree(programs.HERE / "openfoam", folder)
    file = named_rooms("rooms.msh", "--for", "openfoam")
    programs.execute("gmshToFoam", file, folder=folder, **ROOT)
    boundary = folder / "constant" / "polyMesh" / "boundary"
    before, name, after = boundary.read_text().partition("frontAndBack")
    boundary.write_text(before + name + re.sub(r"type +patch", "type empty", after, count=1))
    return folder


def test_checkmesh_finds_nothing(folder):
    said = programs.execute("checkMesh", folder=folder, **ROOT)
    assert "Mesh OK." in said and "***" not in said, said


def test_openfoam_sees_the_rooms_and_solves(folder, hold):
    case = Case(folder)
    (folder / "0").mkdir()
    (folder / "0" / "T").write_text(field(case))
    programs.execute("laplacianFoam", folder=folder, **ROOT)
    said = programs.execute(
        "postProcess", "-func", "writeCellCentres", "-time", STEPS, folder=folder, **ROOT
    )
    assert "End" in said

    def cells(name):
        text = (folder / STEPS / name).read_text()
        return numbers(re.search(r"internalField.*?\n\(\n(.*?)\n\)", text, re.S)[1])

    x, y = cells("Cx"), cells("Cy")
    error = np.abs(cells("T") - temperature(x, y)).max()
    ground = case.points[case.points[:, 2] == 0][:, :2]
    lids = case.patches["frontAndBack"]
    areas = np.zeros(len(x))
    owners = numbers(listed(folder / "constant" / "polyMesh" / "owner"), int)
    for face in lids:
        (ax, ay, z), (bx, by, _), (cx, cy, _) = case.points[case.faces[face]]
        if z == 0:
            areas[owners[face]] = abs((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2
    groups = [(2, None, name, areas[zone].sum()) for name, zone in case.zones["cell"].items()]
    sides = {name: faces for name, faces in case.patches.items() if name != "frontAndBack"}
    for name, faces in (sides | case.zones["face"]).items():
        if len(faces):
            groups.append((1, None, name, sum(map(case.length, faces))))
    version = programs.version("openfoam")
    triangles = len(lids) // 2
    # At the boundary it takes no account of sides that are not at right angles to the line from the
    # middle of a cell: a linear field is not exact there.
    range_ = np.ptp(temperature(*ground.T))
    hold("OpenFOAM", version, ".msh 2.2", "openfoam", ground, triangles, groups,
         float(error / range_), method_error=0.02)  # fmt: skip
