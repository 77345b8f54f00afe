"""Debian's programs: how they are run, and what they are called."""

import json
import re
import shutil
import subprocess
from pathlib import Path

HERE = Path(__file__).parent
PACKAGES = HERE / "packages.txt"


def version(package):
    """The upstream part of a package's version."""
    done = subprocess.run(
        ["dpkg-query", "--show", "--showformat=${Version}", package],
        capture_output=True, text=True,
    )  # fmt: skip
    assert done.returncode == 0, f"the Debian package {package} is not installed"
    return re.sub(r"^\d+:|[+-].*$", "", done.stdout)


def execute(*command, folder, timeout=300, **environment):
    """Runs a program in a folder; it must succeed. Returns what it prints."""
    name = str(command[0])
    assert shutil.which(name), f"{name} is missing: tests/solvers names its Debian package"
    words = ["env", *(f"{key}={value}" for key, value in environment.items()), *map(str, command)]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, timeout=timeout)
    assert done.returncode == 0, f"{name}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def seen_json(*command, folder, **more):
    """What a program prints as JSON, in its last line."""
    return json.loads(execute(*command, folder=folder, **more).splitlines()[-1])


def seen_lines(text):
    """The lines `point X Y`, `triangle NUMBER AREA`, `edge NUMBER LENGTH`, `error E`: points, the
    number of triangles, groups by number, error."""
    rows = {"point": [], "triangle": [], "edge": [], "error": []}
    for line in text.splitlines():
        word, *numbers = line.split()
        rows[word].append([float(x) for x in numbers])
    groups = {}
    for dim, word in ((1, "edge"), (2, "triangle")):
        for number, size in rows[word]:
            groups[dim, int(number)] = groups.get((dim, int(number)), 0.0) + size
    [[error]] = rows["error"]
    points = [row[:2] for row in rows["point"]]
    numbered = [(dim, number, None, size) for (dim, number), size in groups.items()]
    return points, len(rows["triangle"]), numbered, error
