"""Scans from files."""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import conformalsom
from conformalsom.messages import errors_outside

from . import cleaning, outputs
from .obj_files import OBJReader
from .stl_files import STLReader

OUR_READERS = [reader for reader in vars(conformalsom).values()
               if hasattr(reader, "CanReadFile") and issubclass(reader, conformalsom.vtkSurfaceFileReader)]
SHIFT = "CoordinateShift"  # field array
READERS_BY_EXTENSION = {
    ".obj": OBJReader,
    ".stl": STLReader,
    ".vtp": vtkXMLPolyDataReader,
    ".vtk": vtkPolyDataReader,
}


def reader_class(path):
    """The reader of ours that knows the file by its content, or the one that READERS_BY_EXTENSION has.

    Otherwise ours of the extension, which says what is wrong with the file, or None.
    """
    extension = os.path.splitext(path)[1].lower()
    for reader in OUR_READERS:
        if reader.CanReadFile(path):
            return reader
    if extension in READERS_BY_EXTENSION:
        return READERS_BY_EXTENSION[extension]
    for reader in OUR_READERS:
        if extension in reader().GetFileExtensions().split():
            return reader
    return None


def scan_reader(path):
    """The reader for a scan, with the file name set."""
    extensions = [extension for ours in OUR_READERS for extension in ours().GetFileExtensions().split()]
    known = " ".join(sorted({*extensions, *READERS_BY_EXTENSION}))
    return opened(path, reader_class, known + outputs.lacking("Reader"))


def read(path, steps, label="Read the scan"):
    """The reader of a scan, after it has run, and its points or surface, without what other filters do not expect.

    Raises ValueError also for a .vtk file that ends early, which is no failure for VTK.
    """
    reader = scan_reader(path)
    with errors_outside() as broken:
        steps.run(label, reader)
    if broken:
        raise ValueError(f"{path}: {broken[0]}")
    return reader, cleaning.kept(reader.GetOutputDataObject(0), steps, label)


def shift_of(points):
    """The vector that a reader subtracted from coordinates of maps, or 0."""
    shift = points.GetFieldData().GetArray(SHIFT)
    return np.array(shift.GetTuple3(0) if shift else (0.0, 0.0, 0.0))


def with_shift(points, shift):
    """A copy of points whose field data has this shift."""
    result = points.NewInstance()
    result.ShallowCopy(points)
    result.GetFieldData().RemoveArray(SHIFT)
    if any(shift):
        array = numpy_to_vtk(np.array([shift]), deep=True)
        array.SetName(SHIFT)
        result.GetFieldData().AddArray(array)
    return result


def shifted_to(points, shift):
    """A copy of points, in double precision, from whose coordinates in the file this vector is subtracted."""
    offset = shift_of(points) - shift
    result, moved = with_shift(points, shift), vtkPoints()
    moved.SetData(moved_by(points.GetPoints().GetData(), offset))
    result.SetPoints(moved)
    for data in (result.GetPointData(), result.GetFieldData()):
        scanner = data.GetArray("ScannerPosition")
        if scanner:
            data.AddArray(moved_by(scanner, offset))
    return result


def moved_by(vectors, offset):
    """A copy of an array of vectors, plus an offset."""
    array = numpy_to_vtk(vtk_to_numpy(vectors).astype(float) + offset, deep=True)
    array.SetName(vectors.GetName())
    return array


def note_shift(points, steps):
    """Show which vector a reader subtracted from coordinates of maps, if it did."""
    shift = shift_of(points)
    if any(shift):
        numbers = " ".join(f"{number:.15g}" for number in shift)
        steps.note("Read the scan", f"coordinates are large; {numbers} is subtracted from those of all written files")


def inputs_of(path):
    """The files that reading a scan reads, as its reader names them: a list of scans names others."""
    reader_type = reader_class(path) if os.path.isfile(path) else None
    if reader_type not in OUR_READERS:  # the others read no other file
        return [path]
    reader = reader_type()
    reader.SetFileName(path)
    names = reader.GetReadFileNames()
    return [os.fsdecode(names.GetValue(i)) for i in range(names.GetNumberOfValues())]


def read_models(paths):
    """What is in the files, by their names without folders and extensions."""
    models = {}
    for path in paths:
        reader = scan_reader(path)
        reader.Update()
        models[os.path.splitext(os.path.basename(path))[0]] = reader.GetOutput()
    return models


def opened(path, choose, known):
    """A reader of the class that is chosen for a file; else an error that tells the known types."""
    if not os.path.isfile(path):
        raise ValueError(f"{path}: not a file" if os.path.exists(path) else f"{path}: no such file")
    reader_type = choose(path)
    if reader_type is None:
        raise ValueError(f"{path}: expected a file of type {known}")
    reader = reader_type()
    reader.SetFileName(path)
    return reader
