"""One mesh of a domain with two regions, a hole, an interface and numbered sides, as three files."""

import os
import subprocess
from dataclasses import dataclass
from pathlib import Path

import pytest

import msh
import survey

ROOT = Path(__file__).resolve().parents[2]
FIXTURES = ROOT / "tests" / "fixtures"


def run(*arguments, code=0):
    """Runs the command with these arguments and returns what it says; it must exit with `code`."""
    command = [os.environ.get("MESHWRIGHT", ROOT / "target" / "release" / "meshwright")]
    done = subprocess.run(
        command + [str(a) for a in arguments], capture_output=True, text=True, timeout=60
    )
    said = done.stdout + done.stderr
    assert done.returncode == code, f"exit code {done.returncode}\n{said}"
    return said


@dataclass
class Files:
    """The files of one mesh, and the `.msh` as read by our own reader."""

    msh: Path
    vtu: Path
    glb: Path
    mesh: msh.Mesh


def mesh_into(folder, outline, *options):
    """Meshes a fixture into the three formats."""
    files = [folder / f"mesh.{extension}" for extension in ("msh", "vtu", "glb")]
    run("mesh", FIXTURES / outline, *options, *(x for f in files for x in ("-o", f)))
    return Files(*files, msh.read(files[0]))


@pytest.fixture(scope="session")
def named_rooms(tmp_path_factory):
    """Writes the rooms whose groups have names: a file's name and options in, its path out."""
    folder = tmp_path_factory.mktemp("named_rooms")
    files = {}

    def write(name, *options):
        key = (name, *options)
        if key not in files:
            files[key] = folder / str(len(files)) / name
            files[key].parent.mkdir()
            run("mesh", FIXTURES / "named_rooms.geo", *options, "-o", files[key])
        return files[key]

    return write


@pytest.fixture(scope="session")
def hold(named_rooms):
    """Holds what a program saw of the rooms with names against its row of the table."""
    mesh = msh.read(named_rooms("rooms.msh"))
    return lambda *seen, **more: survey.hold(survey.Seen(*seen, **more), mesh)


@pytest.fixture(scope="session")
def rooms(tmp_path_factory):
    return mesh_into(tmp_path_factory.mktemp("rooms"), "two_rooms.poly")


@pytest.fixture(scope="session")
def untagged(tmp_path_factory):
    return mesh_into(tmp_path_factory.mktemp("untagged"), "untagged.poly", "--max-area", "0.05")


@pytest.fixture(scope="session")
def data():
    """The folder of the large test collection."""
    if "MESHWRIGHT_DATA" not in os.environ:
        pytest.skip("MESHWRIGHT_DATA is not set")
    return Path(os.environ["MESHWRIGHT_DATA"])
