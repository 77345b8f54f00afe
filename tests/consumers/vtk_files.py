"""Files as VTK, the library of ParaView, reads them."""

from vtkmodules.vtkCommonCore import vtkCommand
from vtkmodules.vtkIOLegacy import vtkUnstructuredGridReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

READERS = {
    ".vtu": vtkXMLUnstructuredGridReader,
    ".vtk": vtkUnstructuredGridReader,
    ".vtp": vtkXMLPolyDataReader,
}


def read(path):
    """What VTK reads; a warning or an error of the reader fails the test."""
    complaints = []
    reader = READERS[path.suffix]()
    for event in (vtkCommand.ErrorEvent, vtkCommand.WarningEvent):
        reader.AddObserver(event, lambda *event: complaints.append(event[1]))
    reader.SetFileName(str(path))
    reader.Update()
    assert complaints == []
    assert reader.GetErrorCode() == 0
    return reader.GetOutput()
