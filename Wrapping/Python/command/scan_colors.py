"""A scan's own colors: found, and baked into a picture for its surface."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkFiltersCore import vtkCellDataToPointData

from conformalsom import vtkSphericalTextureImage

from . import cleaning

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


def finite_part(scan, colors):
    """The points of a scan with finite coordinates, with the cells between them, and their colors."""
    finite = cleaning.flags_of(scan)
    if finite.all():
        return scan, colors
    surface = scan
    if not isinstance(scan, vtkPolyData):
        surface = vtkPolyData()
        surface.SetPoints(scan.GetPoints())
    return cleaning.with_points(surface, finite), colors[finite]


def baked(painted, scan, colors, side=None):
    """The filter that bakes colors of a scan into a picture, for a surface with texture coordinates.

    The picture has side x side pixels. Without side, bake() chooses as many as the scan needs.
    """
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
    image.SetSamplingToAverage()
    if side is not None:
        image.SetImageSize(side, side)
    return image


def bake(image, side=None):
    """Run the filter of baked(), after it has chosen the number of pixels if none is given."""
    if side is None:
        image.FitImageSize()
    image.Update()
