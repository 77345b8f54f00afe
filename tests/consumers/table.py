"""Writes the README's table of what survives from the rows in `docs/consumers.json`:

    python tests/consumers/table.py
"""

import re
from pathlib import Path

import survey

README = Path(__file__).resolve().parents[2] / "README.md"
COLUMNS = ("regions", "boundaries", "interface", "second group of an edge", "group of a point")
HEAD = ["program", "`--for`", "file", "coordinates", *COLUMNS, "solves"]


def cells(row):
    """A line of the table."""
    kept = (", ".join(row[column]) for column in COLUMNS)
    solves = row["solved"] or ""
    preset = f"`{row['preset']}`" if row["preset"] else ""
    version = f"{row['program']} {row['version']}"
    return [version, preset, row["file"], row["coordinates"], *kept, solves]


def table(rows):
    """The whole table."""
    lines = [HEAD, ["---"] * len(HEAD), *map(cells, rows)]
    return "".join("| " + " | ".join(line) + " |\n" for line in lines).replace("|  |", "| |")


def renew():
    """Puts the table where the old one stands."""
    text = README.read_text()
    head = re.escape("| " + " | ".join(HEAD) + " |\n")
    renewed, count = re.subn(head + r"(\|.*\n)*", lambda _: table(survey.rows()), text)
    assert count == 1, "the README has one such table"
    README.write_text(renewed)


if __name__ == "__main__":
    renew()
