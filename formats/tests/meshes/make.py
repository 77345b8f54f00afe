"""Makes the meshes of this folder by Gmsh 4.15, meshio 5.3 and VTK 9.7: one domain, two regions with
an interface between them, a hole, named groups. Run it here; it overwrites them."""

import gmsh
import meshio
import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk


def by_gmsh():
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    model, geo, option = gmsh.model, gmsh.model.geo, gmsh.option.setNumber
    corners = [(0, 0), (1, 0), (2, 0), (2, 1), (1, 1), (0, 1), (0.4, 0.4), (0.6, 0.4), (0.5, 0.6)]
    points = [geo.addPoint(x, y, 0, 0.6) for x, y in corners]
    ends = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4), (6, 7), (7, 8), (8, 6)]
    lines = [geo.addLine(points[a], points[b]) for a, b in ends]
    left = geo.addCurveLoop([lines[0], lines[6], lines[4], lines[5]])
    hole = geo.addCurveLoop(lines[7:])
    right = geo.addCurveLoop([lines[1], lines[2], lines[3], -lines[6]])
    surfaces = [geo.addPlaneSurface([left, hole]), geo.addPlaneSurface([right])]
    geo.synchronize()
    groups = [
        (0, [points[3]], 4, "corner"),
        (1, [lines[i] for i in (0, 1, 3, 4)], 1, "wall"),
        (1, [lines[5]], 2, "in flow"),
        (1, [lines[2]], 3, "outlet"),
        (1, [lines[6]], 7, "interface wall"),
        (1, lines[7:], 9, "pillar"),
        (2, [surfaces[0]], 11, "water"),
        (2, [surfaces[1]], 12, "Stein ß"),
    ]
    for group in groups:
        model.addPhysicalGroup(*group)
    option("Mesh.MeshSizeMax", 1.0)
    model.mesh.generate(2)
    write_msh("gmsh")
    option("Mesh.Binary", 0)
    for end in ("vtk", "mesh", "su2", "inp"):
        gmsh.write("gmsh." + end)
    option("Mesh.Binary", 1)
    gmsh.write("gmsh_binary.vtk")
    triangles = np.concatenate(model.mesh.getElements(2)[1])
    nodes = model.mesh.getNodes()[0]
    load, speed = gmsh.view.add("load"), gmsh.view.add("speed")
    values = [i + 0.5 for i in range(len(triangles))]
    add = gmsh.view.addHomogeneousModelData
    add(load, 0, model.getCurrent(), "ElementData", triangles, values)
    values = [x for i in range(len(nodes)) for x in (float(i), 0.25, 0)]
    add(speed, 0, model.getCurrent(), "NodeData", nodes, values, numComponents=3)
    for name in versions("data"):
        option("PostProcessing.SaveMesh", 1)
        gmsh.view.write(load, name)
        option("PostProcessing.SaveMesh", 0)
        gmsh.view.write(speed, name, True)
    model.mesh.setOrder(2)
    write_msh("order2")
    option("Mesh.Binary", 0)
    for end in ("vtk", "inp"):
        gmsh.write("order2." + end)
    gmsh.finalize()


def versions(stem):
    for version in (2.2, 4.1):
        for binary, kind in enumerate(("ascii", "binary")):
            gmsh.option.setNumber("Mesh.MshFileVersion", version)
            gmsh.option.setNumber("Mesh.Binary", binary)
            yield f"{stem}_{round(10 * version)}_{kind}.msh"


def write_msh(stem):
    for name in versions(stem):
        gmsh.write(name)


def by_meshio():
    mesh = meshio.read("gmsh_22_ascii.msh")
    mesh.cell_data.pop("gmsh:geometrical")
    meshio.write("meshio_ascii.vtu", mesh, binary=False)
    meshio.write("meshio_zlib.vtu", mesh)
    meshio.write("meshio_plain.vtu", mesh, compression=None)
    meshio.write("meshio_42.vtk", mesh, file_format="vtk42", binary=False)
    meshio.write("meshio_51.vtk", mesh, file_format="vtk51", binary=True)
    mesh.cell_data["medit:ref"] = mesh.cell_data.pop("gmsh:physical")
    meshio.write("meshio.mesh", mesh)


def by_vtk():
    mesh = meshio.read("gmsh_22_ascii.msh")
    grid = vtk.vtkUnstructuredGrid()
    points = vtk.vtkPoints()
    points.SetDataType(vtk.VTK_DOUBLE)
    for point in mesh.points:
        points.InsertNextPoint(*point)
    grid.SetPoints(points)
    physical = []
    for block, numbers in zip(mesh.cells, mesh.cell_data["gmsh:physical"]):
        kind = {"vertex": 1, "line": 3, "triangle": 5}[block.type]
        for cell, number in zip(block.data, numbers):
            grid.InsertNextCell(kind, len(cell), [int(node) for node in cell])
            physical.append(number)
    array(grid.GetCellData(), "gmsh:physical", np.array(physical, dtype=np.int32))
    array(grid.GetCellData(), "load", np.arange(len(physical)) + 0.5)
    array(grid.GetPointData(), "depth of water", mesh.points[:, 0].astype(np.float32))
    xml = vtk.vtkXMLUnstructuredGridWriter
    kinds = {
        "ascii": ("ascii", False, 32, "little"),
        "inline_zlib": ("binary", True, 32, "little"),
        "inline_plain_big": ("binary", False, 64, "big"),
        "raw_plain_big": ("raw", False, 64, "big"),
        "raw_zlib": ("raw", True, 64, "little"),
        "base64_plain": ("base64", False, 32, "little"),
        "base64_zlib": ("base64", True, 64, "little"),
    }
    for name, (mode, zlib, header, order) in kinds.items():
        writer = xml()
        writer.SetFileName(f"vtk_{name}.vtu")
        writer.SetInputData(grid)
        if mode == "ascii":
            writer.SetDataModeToAscii()
        elif mode == "binary":
            writer.SetDataModeToBinary()
        else:
            writer.SetDataModeToAppended()
            writer.SetEncodeAppendedData(mode == "base64")
        if zlib:
            writer.SetCompressorTypeToZLib()
        else:
            writer.SetCompressorTypeToNone()
        writer.SetHeaderType(header)
        if order == "big":
            writer.SetByteOrderToBigEndian()
        writer.Write()
    for version in (42, 51):
        for kind in ("ascii", "binary"):
            writer = vtk.vtkUnstructuredGridWriter()
            writer.SetFileName(f"vtk_{version}_{kind}.vtk")
            writer.SetFileVersion(version)
            legacy(writer, grid, kind)
    surface = vtk.vtkGeometryFilter()
    surface.SetInputData(grid)
    surface.Update()
    writer = vtk.vtkPolyDataWriter()
    writer.SetFileName("vtk_polydata.vtk")
    legacy(writer, surface.GetOutput(), "binary")


def array(data, name, values):
    values = numpy_to_vtk(values, deep=True)
    values.SetName(name)
    data.AddArray(values)


def legacy(writer, data, kind):
    writer.SetInputData(data)
    if kind == "binary":
        writer.SetFileTypeToBinary()
    writer.Write()


if __name__ == "__main__":
    by_gmsh()
    by_meshio()
    by_vtk()
