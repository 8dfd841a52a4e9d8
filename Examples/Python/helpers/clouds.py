"""Points as VTK's filters take them."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData


def vtk_points(array):
    """A copy of n by 3 coordinates."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(array), deep=True))
    return points


def cloud_of(points, normals=None):
    """A vtkPolyData of points only, with their normals where these are known."""
    cloud = vtkPolyData()
    cloud.SetPoints(vtk_points(points))
    if normals is not None:
        array = numpy_to_vtk(np.ascontiguousarray(normals), deep=True)
        array.SetName("Normals")
        cloud.GetPointData().SetNormals(array)
    return cloud


def points_of(data):
    """The positions of its points, n by 3."""
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def only_points_of(data):
    """Its points without what joins them, from which vtkConformalSOM would start."""
    return cloud_of(points_of(data))
