"""Surfaces of functions on grids."""
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkFlyingEdges3D, vtkReverseSense


def zero_level(values, size, origin, spacing):
    """Triangles where a function is 0, as a vtkPolyData. They face away from where the function is negative.

    values: of the function at the nodes of a grid, x fastest. size: numbers of nodes along x, y and z. origin: first
    node. spacing: distance of nodes.
    """
    image = vtkImageData()
    image.SetDimensions(*size)
    image.SetOrigin(*origin)
    image.SetSpacing(spacing, spacing, spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    contour = vtkFlyingEdges3D()
    contour.SetInputData(image)
    contour.SetValue(0, 0.0)
    contour.ComputeNormalsOff()
    contour.ComputeScalarsOff()
    outward = vtkReverseSense()  # vtkFlyingEdges3D orients triangles to where the function decreases
    outward.SetInputConnection(contour.GetOutputPort())
    outward.Update()
    return outward.GetOutput()
