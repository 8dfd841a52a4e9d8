"""Surfaces from files, with their maps to the sphere."""
import os

from conformalsom import vtkGlobalConformalMap
from conformalsom.messages import errors_outside

from . import cleaning, scan_files


def name_of(path):
    """The file's name without its extension."""
    return os.path.splitext(os.path.basename(path))[0]


def read(path, balance, steps):
    """A file's surface, mapped to the sphere with this AreaBalance unless the file has a map."""
    reader, label = scan_files.scan_reader(path), f"Read {name_of(path)}"
    with errors_outside() as broken:
        steps.run(label, reader)
    if broken:
        raise ValueError(f"{path}: {broken[0]}")
    surface = cleaning.kept(reader.GetOutput(), steps, label)
    if surface.GetPointData().GetArray("SpherePosition"):
        return surface
    if surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        raise ValueError(f"{path}: has no triangles; make a surface of its points first: conformalsom {path} -o surface.ply")
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    conformal.SetAreaBalance(balance)
    steps.run(f"Map {name_of(path)} to the sphere", conformal)
    return conformal.GetOutput()
