"""Records how many points Triangle makes of each outline in a folder, as the page of experiments
shows them:

    cargo run --release -p meshwright-campaigns --bin experiments -- --outlines FOLDER
    python triangle_points.py FOLDER docs/experiments/triangle.csv
"""

import sys
from pathlib import Path

import triangle

FLAGS = "pq26.45D"
HEAD = "outline,fingerprint,points"


def read_poly(path):
    """The arrays that Triangle's Python package takes, of a file with its points inside."""
    lines = [line.split("#")[0].split() for line in path.read_text().splitlines()]
    rows = iter([line for line in lines if line])
    points = [next(rows) for _ in range(int(next(rows)[0]))]
    segments = [next(rows) for _ in range(int(next(rows)[0]))]
    holes = [next(rows) for _ in range(int(next(rows)[0]))]
    first = int(points[0][0])
    read = {
        "vertices": [[float(x) for x in row[1:3]] for row in points],
        "segments": [[int(i) - first for i in row[1:3]] for row in segments],
    }
    if holes:
        read["holes"] = [[float(x) for x in row[1:3]] for row in holes]
    return read


def row(path):
    """A file's row: the name and fingerprint of its first line, and Triangle's points."""
    comment = path.read_text().split("\n", 1)[0]
    made = triangle.triangulate(read_poly(path), FLAGS)
    return f"{comment.removeprefix('# ')},{len(made['vertices'])}"


def record(folder):
    """The whole table."""
    return "\n".join([HEAD, *map(row, sorted(folder.glob("*.poly"))), ""])


if __name__ == "__main__":
    Path(sys.argv[2]).write_text(record(Path(sys.argv[1])))
