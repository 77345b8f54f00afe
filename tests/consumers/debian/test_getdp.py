"""GetDP reads `.msh` 2.2; it knows groups by number alone."""

import shutil

import numpy as np

import answers
import programs

CORNERS = {1: 2, 2: 3, 15: 1}  # by the number of an element's kind


def elements(file):
    """The corners (n, k, 2) and the values there (n, k) of the elements in a table."""
    corners, values = [], []
    for line in file.read_text().splitlines():
        kind, _, *numbers = (float(word) for word in line.split())
        count = CORNERS[int(kind)]
        corners.append(np.reshape(numbers[: 3 * count], (count, 3))[:, :2])
        values.append(numbers[-count:])  # the place of the middle stands before them
    return np.array(corners), np.array(values)


def size(corners):
    """The number of points, the length or the area of elements."""
    if corners.shape[1] == 1:
        return len(corners)
    sides = corners[:, 1:] - corners[:, :1]
    if corners.shape[1] == 2:
        return float(np.hypot(*sides[:, 0].T).sum())
    return float(np.abs(np.linalg.det(sides)).sum() / 2)


def test_getdp_sees_the_rooms_and_solves(named_rooms, hold, tmp_path):
    shutil.copy(programs.HERE / "getdp.pro", tmp_path)
    file = named_rooms("rooms.msh", "--for", "getdp")
    programs.execute(
        "getdp", "getdp.pro", "-msh", file, "-solve", "Heat", "-pos", "Look", folder=tmp_path
    )
    parts = {number: elements(tmp_path / f"{number}.txt") for _, number in answers.GROUPS}
    groups = [
        (dim, number, None, size(parts[number][0]))
        for dim, number in answers.GROUPS if len(parts[number][0])
    ]  # fmt: skip
    rooms = [parts[number] for number in answers.AREAS]
    corners = np.concatenate([corners for corners, _ in rooms])
    values = np.concatenate([values for _, values in rooms])
    error = np.abs(values - answers.temperature(corners[..., 0], corners[..., 1])).max()
    points = np.unique(corners.reshape(-1, 2), axis=0)
    version = programs.version("getdp")
    hold("GetDP", version, ".msh 2.2", "getdp", points, len(corners), groups, float(error), 16)
