"""What is known of `two_rooms.poly` without a mesher."""

import math

import numpy as np

AREAS = {11: 1.2 * 0.7 - 2 * 0.15**2, 12: 0.9 * 0.7}
LENGTHS = {1: 4.2, 2: 0.7, 3: 0.7, 7: 0.7, 9: 4 * 0.15 * math.sqrt(2)}
NAMES = {(1, tag): f"boundary_{tag}" for tag in LENGTHS} | {
    (2, tag): f"region_{tag}" for tag in AREAS
}
# The same rooms with names, in `named_rooms.geo`; the right side is in a second group.
GROUPS = {
    (0, 40): "probe", (1, 1): "wall", (1, 2): "left", (1, 3): "right", (1, 7): "partition",
    (1, 9): "pillar", (1, 21): "cold", (2, 11): "hall", (2, 12): "cabinet",
}  # fmt: skip
# A problem that is solved without an error by linear elements: heat flows from room to room, 10 for
# each unit of length, and the temperature is linear in each room. The conductivities are those of
# the regions; the temperature is given on `FIXED`.
CONDUCTIVITY = {11: 2.0, 12: 5.0}
FIXED = (1, 2, 3, 9)
CORNERS = [
    (0.1, 0.2), (1.3, 0.2), (2.2, 0.2), (2.2, 0.9), (1.3, 0.9), (0.1, 0.9),
    (0.75, 0.55), (0.6, 0.7), (0.45, 0.55), (0.6, 0.4),
]  # fmt: skip


def temperature(x, y):
    """The solution of the problem."""
    conductivity = np.where(np.asarray(x) < 1.3, CONDUCTIVITY[11], CONDUCTIVITY[12])
    return 10 * (x - 1.3) / conductivity - 2 * y + 1


def measures(tags, sizes):
    """The sum of the sizes of each tag's cells."""
    tags, sizes = np.asarray(tags), np.asarray(sizes)
    return {int(tag): float(sizes[tags == tag].sum()) for tag in np.unique(tags)}


def same(found, wanted):
    """Whether two tables of measures agree to rounding."""
    return found.keys() == wanted.keys() and all(
        math.isclose(found[tag], wanted[tag], rel_tol=1e-12) for tag in wanted
    )
