"""Closed models with maps to the sphere, landmarks on them, and files of them."""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from conformalsom import vtkGlobalConformalMap

from . import scan_files


def name_of(path):
    return os.path.splitext(os.path.basename(path))[0]


def read(path, balance, steps):
    """A file's surface, mapped to the sphere with this AreaBalance unless the file has a map."""
    reader = scan_files.scan_reader(path)
    steps.run(f"Read {name_of(path)}", reader)
    surface = reader.GetOutput()
    if surface.GetPointData().GetArray("SpherePosition"):
        return surface
    if surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        raise ValueError(f"{path}: has no triangles; learn a surface from its points first")
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    conformal.SetAreaBalance(balance)
    steps.run(f"Map {name_of(path)} to the sphere", conformal)
    return conformal.GetOutput()


def read_landmarks(path, surface):
    """Point ids of the surface, one a line."""
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    size = surface.GetNumberOfPoints()
    if not words or not all(word.isdecimal() and int(word) < size for word in words):
        raise ValueError(f"{path}: expected ids of the model's {size} points, one a line")
    return [int(word) for word in words]


def mark(surface, landmarks, name="Landmark"):
    """A point array with 1, 2 and so on at the landmarks, 0 elsewhere."""
    marks = np.zeros(surface.GetNumberOfPoints(), dtype=np.int32)
    marks[landmarks] = np.arange(1, len(landmarks) + 1)
    array = numpy_to_vtk(marks, deep=True)
    array.SetName(name)
    surface.GetPointData().AddArray(array)
    return name


def figure(surface, name, component=0):
    """A number of the field data."""
    return surface.GetFieldData().GetArray(name).GetComponent(0, component)


def write(surface, path, steps):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(path)
    steps.run(f"Write {os.path.basename(path)}", writer, writer.Write)
