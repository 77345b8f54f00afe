"""What a program sees of the rooms with names, judged against the answers.

A row of the README's table is what one program saw of one file. `docs/consumers.json` keeps the
rows; a program that sees more or less than its row there says fails its test. With the environment
variable `MESHWRIGHT_RECORD` set the rows are written anew, and `table.py` makes the README's table
of them.
"""

import json
import os
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

import answers

RECORD = Path(__file__).resolve().parents[2] / "docs" / "consumers.json"
EXACT, SINGLE = "bit for bit", "single precision"


@dataclass
class Seen:
    """What a program says of a file that it has read."""

    program: str
    version: str
    file: str
    preset: str | None
    points: np.ndarray  # (n, 2)
    triangles: int
    # Each group as (dimension, number, name, length or area or number of points); what the program
    # does not know of it is None.
    groups: list = field(default_factory=list)
    error: float | None = None  # of the problem's solution, at most
    digits: int | None = None  # how many the program prints, where it does not print them all
    method_error: float = 0.0  # what its method may be off, by the range of the solution
    at_points: dict | None = None  # the points that have each number, for programs that know no edges


def judge(seen, mesh):
    """The row of the table."""
    points = np.asarray(seen.points, dtype=float)
    coordinates, tolerance = judge_points(points, mesh.points, seen.digits)
    assert seen.triangles == len(mesh.triangles)
    lengths = answers.LENGTHS | {21: answers.LENGTHS[3]}

    def kept(dim, sizes):
        """Whether the numbers, the names or both are kept of these groups."""
        found = [group for group in seen.groups if group[0] == dim]
        named = {tag: answers.GROUPS[dim, tag] for tag in sizes}
        numbers = {number: size for _, number, _, size in found}
        names = {name: size for _, _, name, size in found}

        def all_there(sizes, keys):
            return all(
                key in sizes and abs(sizes[key] - wanted) <= tolerance * wanted
                for key, wanted in keys.items()
            )

        by_name = {named[tag]: size for tag, size in sizes.items()}
        by = {"names": all_there(names, by_name), "numbers": all_there(numbers, sizes)}
        return [what for what, there in by.items() if there]

    solved = None
    if seen.error is not None:
        assert seen.error <= max(tolerance, 1e-9, seen.method_error), f"off by {seen.error}"
        solved = f"to {seen.method_error:.0%}" if seen.method_error else "exactly"
    boundaries = kept(1, {tag: lengths[tag] for tag in answers.FIXED})
    interface = kept(1, {7: lengths[7]})
    if seen.at_points is not None:
        numbers_stand_at_points(seen.at_points, mesh)
        boundaries = interface = ["numbers of points"]
    return {
        "program": seen.program,
        "version": seen.version,
        "preset": seen.preset,
        "file": seen.file,
        "coordinates": coordinates,
        "regions": kept(2, answers.AREAS),
        "boundaries": boundaries,
        "interface": interface,
        "second group of an edge": kept(1, {21: lengths[21]}),
        "group of a point": kept(0, {40: 1}),
        "solved": solved,
    }


def numbers_stand_at_points(found, mesh):
    """Asserts that the points with a number are on an edge that has it, and that all points of edges
    have one."""
    wanted = {}
    for edge, tag in zip(mesh.edges, mesh.edge_tags.tolist()):
        for end in edge:
            wanted.setdefault(tuple(mesh.points[end]), set()).add(tag)
    numbered = {tuple(point): tag for tag, points in found.items() for point in points}
    assert numbered.keys() == wanted.keys()
    assert all(tag in wanted[point] for point, tag in numbered.items())
    assert set(numbered.values()) >= set(answers.LENGTHS)


def judge_points(found, wanted, digits):
    """How exactly the points are kept, in any order, and how far lengths and areas may be off."""
    assert found.shape == wanted.shape
    if np.array_equal(in_order(found), in_order(wanted)):
        return EXACT, 1e-12  # a length is summed by the program, in its own order
    distances = np.linalg.norm(found[:, None] - wanted[None], axis=2)
    assert sorted(distances.argmin(axis=1)) == list(range(len(wanted))), "every point is there"
    digits = digits or 7
    tolerance = 2 * 10.0 ** (1 - digits)
    assert distances.min(axis=1).max() < tolerance
    return SINGLE if digits == 7 else f"{digits} digits", max(tolerance, 1e-12)


def in_order(points):
    """The points by x, then by y."""
    return points[np.lexsort(points.T[::-1])]


def rows():
    """The rows that are recorded."""
    return json.loads(RECORD.read_text()) if RECORD.exists() else []


def key(row):
    """What tells one row from another."""
    return row["program"].lower(), row["file"]


def hold(seen, mesh):
    """Holds what a program saw against its row, or records it."""
    row = judge(seen, mesh)
    recorded = {key(other): other for other in rows()}
    if "MESHWRIGHT_RECORD" in os.environ:
        recorded[key(row)] = row
        lines = [json.dumps(recorded[k], ensure_ascii=False) for k in sorted(recorded)]
        RECORD.write_text("[\n" + ",\n".join(lines) + "\n]\n")
    else:
        # The row names the version that was seen; another one must see the same.
        assert row == recorded.get(key(row), {}) | {"version": row["version"]}
