"""Closed models with maps to the sphere, landmarks on them, and files of them."""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from conformalsom.command.mapped_files import name_of, read

__all__ = ["figure", "largest_radius", "mark", "name_of", "read", "read_landmarks", "write"]


def read_landmarks(path, surface):
    """Point ids of the surface. Each line of the file is one, or three coordinates, to which the nearest
    point is taken; what follows a # does not count."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    landmarks = []
    with open(path, encoding="utf-8") as file:
        for number, line in enumerate(file, 1):
            words = line.partition("#")[0].split()
            try:
                if len(words) == 3:
                    position = np.array(words, dtype=float)
                    landmarks.append(int(np.nanargmin(np.linalg.norm(points - position, axis=1))))
                elif words:
                    point, = map(int, words)
                    landmarks.append(range(len(points)).index(point))
            except ValueError:
                raise ValueError(f"{path}, line {number}: expected the id of one of the model's {len(points)} "
                                 "points, or three coordinates") from None
    if len(set(landmarks)) < len(landmarks):
        twice = next(point for point in landmarks if landmarks.count(point) > 1)
        raise ValueError(f"{path}: point {twice} is a landmark twice")
    if not landmarks:
        raise ValueError(f"{path}: there are no landmarks")
    return landmarks


def mark(surface, landmarks, name="Landmark"):
    """A point array with 1, 2 and so on at the landmarks, 0 elsewhere."""
    marks = np.zeros(surface.GetNumberOfPoints(), dtype=np.int32)
    marks[landmarks] = np.arange(1, len(landmarks) + 1)
    array = numpy_to_vtk(marks, deep=True)
    array.SetName(name)
    surface.GetPointData().AddArray(array)
    return name


def largest_radius(surface):
    """Of its points from their mean, the unit of distances."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return np.linalg.norm(points - points.mean(axis=0), axis=1).max()


def figure(surface, name, component=0):
    """A number of the field data."""
    return surface.GetFieldData().GetArray(name).GetComponent(0, component)


def write(surface, path, steps):
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(path)
    steps.run(f"Write {os.path.basename(path)}", writer, writer.Write)
