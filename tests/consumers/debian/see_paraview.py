"""What ParaView sees of a `.vtu` file, and a picture of it.

pvpython --force-offscreen-rendering see_paraview.py FILE PICTURE COLOURS prints JSON. COLOURS are
a number and a colour for each group, as JSON."""

import json
import sys

from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

file, picture, colors = sys.argv[1], sys.argv[2], json.loads(sys.argv[3])
reader = simple.OpenDataFile(file)
reader.UpdatePipeline()
grid = servermanager.Fetch(reader)
tags = vtk_to_numpy(grid.GetCellData().GetArray("tag"))
sizes = {}
triangles = 0
for index, tag in enumerate(tags.tolist()):
    cell = grid.GetCell(index)
    dim = cell.GetCellDimension()
    triangles += dim == 2
    size = cell.ComputeArea() if dim == 2 else cell.GetLength2() ** 0.5
    sizes[dim, tag] = sizes.get((dim, tag), 0.0) + size
names = {}
fields = grid.GetFieldData()
for index in range(fields.GetNumberOfArrays()):
    values = vtk_to_numpy(fields.GetArray(index))
    if len(values) == 2:
        names[int(values[1]), int(values[0])] = fields.GetArrayName(index)

view = simple.CreateView("RenderView")
view.ViewSize = [840, 560]
view.Background = [1, 1, 1]
view.UseColorPaletteForBackground = 0
view.OrientationAxesVisibility = 0
shown = simple.Show(reader, view)
shown.SetRepresentationType("Surface")
shown.Ambient, shown.Diffuse, shown.Specular = 1, 0, 0
shown.LineWidth = 5
table = simple.GetColorTransferFunction("tag")
table.InterpretValuesAsCategories = 1
table.Annotations = [word for tag, _ in colors for word in (str(tag), str(tag))]
table.IndexedColors = [channel / 255 for _, color in colors for channel in color]
simple.ColorBy(shown, ("CELLS", "tag"))
shown.SetScalarBarVisibility(view, False)
simple.Render(view)  # the first time it places the camera itself
view.CameraParallelProjection = 1
view.CameraPosition, view.CameraFocalPoint = [1.15, 0.55, 5], [1.15, 0.55, 0]
view.CameraParallelScale = 0.8
simple.Render(view)
simple.SaveScreenshot(picture, view)
print(json.dumps({
    "version": str(simple.GetParaViewSourceVersion()),
    "points": vtk_to_numpy(grid.GetPoints().GetData())[:, :2].tolist(),
    "triangles": triangles,
    "groups": [(dim, tag, names.get((dim, tag)), size) for (dim, tag), size in sizes.items()],
}))  # fmt: skip
