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
    lines = [f"{line_of(HEAD)}{'|---' * len(HEAD)}|\n", *map(line_of, map(cells, rows))]
    return "".join(lines)


def line_of(words):
    return "".join(f"| {word} " if word else "| " for word in words) + "|\n"


def renew():
    """Puts the table where the old one stands."""
    text = README.read_text()
    renewed, count = re.subn(re.escape(line_of(HEAD)) + r"(\|.*\n)*", lambda _: table(survey.rows()), text)
    assert count == 1, "the README has one such table"
    README.write_text(renewed)


if __name__ == "__main__":
    renew()
