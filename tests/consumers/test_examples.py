"""The worked pipelines of `examples/`, from the outline to the file for ParaView."""

import os
import re
import subprocess
import sys

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

import msh
import vtk_files
from conftest import ROOT


def execute(*command):
    """Runs an example with the command that the tests run; returns what it prints."""
    meshwright = os.environ.get("MESHWRIGHT", ROOT / "target" / "release" / "meshwright")
    environment = os.environ | {"MESHWRIGHT": str(meshwright), "PYTHON": sys.executable}
    done = subprocess.run(
        list(map(str, command)), capture_output=True, text=True, env=environment, timeout=120
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def field(file, name):
    """The places of the points, and a field there."""
    grid = vtk_files.read(file)
    points = vtk_to_numpy(grid.GetPoints().GetData())
    return points, vtk_to_numpy(grid.GetPointData().GetArray(name))


def test_heat_flows_from_the_heater_to_the_window(tmp_path):
    said = execute(sys.executable, ROOT / "examples" / "heat.py", tmp_path)
    window, heater = (float(re.search(rf"{name}: (\S+) W", said)[1]) for name in ("window", "heater"))
    assert heater == pytest.approx(-window, abs=1e-3)
    # Without the column the rooms are two strips in a row, of width 3.
    assert 0.9 < heater / (3 * 35 / (4 / 1 + 3 / 3)) < 1
    points, temperature = field(tmp_path / "heat.vtu", "temperature")
    assert len(points) > 500
    assert (temperature[points[:, 0] == 0] == 5).all()
    assert (temperature[points[:, 0] == 7] == 40).all()
    assert 5 <= temperature.min() and temperature.max() <= 40


def test_the_membrane_hangs_from_the_shores_of_the_lake(tmp_path):
    said = execute("sh", ROOT / "examples" / "membrane.sh", tmp_path)
    points, deflection = field(tmp_path / "membrane.vtu", "deflection")
    largest = float(re.search(r"largest deflection (\S+),", said)[1])
    assert largest == pytest.approx(deflection.max(), abs=1e-6)
    assert deflection.min() == 0 and np.count_nonzero(deflection == 0) > 1000, "the shores"
    assert (deflection[deflection != 0] > 0).all()
    # A disc of the lake's area would hang lower.
    area = msh.read(tmp_path / "lake.msh").triangle_areas().sum()
    assert 0.01 < largest / (area / (4 * np.pi)) < 1
