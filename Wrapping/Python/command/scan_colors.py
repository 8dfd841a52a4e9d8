"""A scan's own colors: found, and baked into a picture for its surface."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData

from conformalsom import vtkSphericalTextureImage

NAME = "Color"


def color_scalars(data):
    """The active scalars of points or cells if they are colors, else None."""
    scalars = data.GetScalars()
    is_color = isinstance(scalars, vtkUnsignedCharArray) and scalars.GetNumberOfComponents() in (3, 4)
    return scalars if is_color else None


def colors_of(scan):
    """Red, green and blue of every point, or of the triangles around it; None if there are none."""
    colors, of_cells = color_scalars(scan.GetPointData()), color_scalars(scan.GetCellData())
    if colors is None and of_cells is not None:
        averaged = vtkCellDataToPointData()
        averaged.SetInputData(scan)
        averaged.Update()
        colors = averaged.GetOutput().GetPointData().GetArray(of_cells.GetName())
    return None if colors is None else np.rint(vtk_to_numpy(colors)[:, :3]).astype(np.uint8)


def baked(painted, scan, colors):
    """The filter that bakes colors of a scan into a picture, for a surface with texture coordinates."""
    array = numpy_to_vtk(colors, deep=True)
    array.SetName(NAME)
    colored = scan.NewInstance()
    colored.ShallowCopy(scan)
    colored.GetPointData().AddArray(array)
    source = vtkTrivialProducer()
    source.SetOutput(colored)
    image = vtkSphericalTextureImage()
    image.SetInputConnection(painted.GetOutputPort())
    image.SetSourceConnection(source.GetOutputPort())
    image.SetArrayName(NAME)
    return image
