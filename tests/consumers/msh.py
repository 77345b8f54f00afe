"""A reader of `.msh` 2.2 ASCII that does as little as possible: what the others are held against."""

from dataclasses import dataclass

import numpy as np

LINE, TRIANGLE, POINT = 1, 2, 15


@dataclass
class Mesh:
    """Indices are zero-based; tags are the physical numbers."""

    points: np.ndarray  # (n, 2)
    triangles: np.ndarray  # (m, 3)
    triangle_tags: np.ndarray
    edges: np.ndarray  # (k, 2)
    edge_tags: np.ndarray
    names: dict  # (dim, tag) -> name

    def triangle_areas(self):
        a, b, c = (self.points[self.triangles[:, corner]] for corner in range(3))
        (ux, uy), (vx, vy) = (b - a).T, (c - a).T
        return (ux * vy - uy * vx) / 2

    def edge_lengths(self):
        a, b = (self.points[self.edges[:, end]] for end in range(2))
        return np.hypot(*(b - a).T)


def read(path):
    """Reads a file; the sections and element types that we do not write are an error."""
    lines = iter(path.read_text(encoding="utf-8").splitlines())
    sections = {}
    for line in lines:
        name = line.removeprefix("$")
        sections[name] = []
        for line in lines:
            if line == f"$End{name}":
                break
            sections[name].append(line)
    assert list(sections) == ["MeshFormat", "PhysicalNames", "Nodes", "Elements"]
    assert sections["MeshFormat"] == ["2.2 0 8"]
    counted = {name: lines[1:] for name, lines in sections.items() if name != "MeshFormat"}
    for name, rows in counted.items():
        assert int(sections[name][0]) == len(rows), name

    names = {}
    for row in counted["PhysicalNames"]:
        dim, tag, name = row.split(" ", 2)
        names[int(dim), int(tag)] = name.strip('"')

    nodes = [row.split() for row in counted["Nodes"]]
    assert [int(node[0]) for node in nodes] == list(range(1, len(nodes) + 1))
    assert all(float(node[3]) == 0 for node in nodes)
    points = np.array([[float(x) for x in node[1:3]] for node in nodes])

    elements = [[int(word) for word in row.split()] for row in counted["Elements"]]
    assert all(element[2] == 2 for element in elements), "exactly two tags"
    of = {kind: [e for e in elements if e[1] == kind] for kind in (LINE, TRIANGLE, POINT)}
    assert sum(map(len, of.values())) == len(elements)
    corners = {kind: np.array([e[5:] for e in of[kind]]) - 1 for kind in (LINE, TRIANGLE)}
    tags = {kind: np.array([e[3] for e in of[kind]]) for kind in corners}
    return Mesh(
        points, corners[TRIANGLE], tags[TRIANGLE], corners[LINE], tags[LINE], names
    )


def write(path, mesh):
    """Writes a mesh."""
    with open(path, "w", encoding="utf-8") as file:
        print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames", file=file)
        print(len(mesh.names), file=file)
        for (dim, tag), name in mesh.names.items():
            print(dim, tag, f'"{name}"', file=file)
        print("$EndPhysicalNames\n$Nodes", file=file)
        print(len(mesh.points), file=file)
        for number, (x, y) in enumerate(mesh.points, 1):
            print(number, repr(float(x)), repr(float(y)), 0, file=file)
        print("$EndNodes\n$Elements", file=file)
        print(len(mesh.edges) + len(mesh.triangles), file=file)
        number = 0
        for kind, cells, tags in (
            (LINE, mesh.edges, mesh.edge_tags),
            (TRIANGLE, mesh.triangles, mesh.triangle_tags),
        ):
            for cell, tag in zip(cells, tags):
                number += 1
                print(number, kind, 2, tag, tag, *(cell + 1), file=file)
        print("$EndElements", file=file)
