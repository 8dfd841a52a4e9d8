"""Surfaces from files, with their maps to the sphere."""
import os

from conformalsom import vtkGlobalConformalMap

from . import scan_files


def name_of(path):
    """The file's name without its extension."""
    return os.path.splitext(os.path.basename(path))[0]


def read(path, balance, steps):
    """A file's surface, mapped to the sphere with this AreaBalance unless the file has a map."""
    _, surface = scan_files.read(path, steps, f"Read {name_of(path)}")
    if surface.GetPointData().GetArray("SpherePosition"):
        return surface
    if surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        raise ValueError(f"{path}: has no triangles; make a surface of its points first: conformalsom {path} -o surface.ply")
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    conformal.SetAreaBalance(balance)
    steps.run(f"Map {name_of(path)} to the sphere", conformal)
    return conformal.GetOutput()
