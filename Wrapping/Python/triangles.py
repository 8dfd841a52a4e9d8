"""The triangles of a surface as an array."""
import typing

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter


def triangles_of(surface: vtkPolyData) -> typing.Any:
    """Return the ids of their corners, m x 3 integers.

    Other polygons and strips are divided into triangles. Polygons of fewer than 3 corners are left out.
    """
    if surface.GetPolys().IsHomogeneous() != 3 or surface.GetNumberOfStrips():
        triangles = vtkTriangleFilter()
        triangles.SetInputData(surface)
        triangles.Update()
        surface = triangles.GetOutput()
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
