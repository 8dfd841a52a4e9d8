"""Scans and pictures from files, by their extension."""
import os

from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkPTSReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkSimplePointsReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from conformalsom import vtkConformalPLYReader

SCAN_READERS = {
    ".ply": vtkConformalPLYReader,
    ".obj": vtkOBJReader,
    ".stl": vtkSTLReader,
    ".vtp": vtkXMLPolyDataReader,
    ".vtk": vtkPolyDataReader,
    ".pts": vtkPTSReader,
    ".xyz": vtkSimplePointsReader,
}
TEXTURE_READERS = {".png": vtkPNGReader, ".jpg": vtkJPEGReader, ".jpeg": vtkJPEGReader}


def reader_for(path, readers):
    """The reader for a file's extension, with the file name set."""
    extension = os.path.splitext(path)[1].lower()
    if extension not in readers:
        raise ValueError(f"{path}: expected a file of type {' '.join(readers)}")
    if not os.path.isfile(path):
        raise ValueError(f"{path}: no such file")
    reader = readers[extension]()
    reader.SetFileName(path)
    return reader
