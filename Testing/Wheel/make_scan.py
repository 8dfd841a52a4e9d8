"""make_scan.py: write scan.ply, 10,000 colored points of a bumpy ball, with NumPy and the package alone."""
import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from conformalsom import vtkConformalPLYWriter

generator = numpy.random.default_rng(1)
directions = generator.normal(size=(10000, 3))
directions /= numpy.linalg.norm(directions, axis=1)[:, None]
radii = 1.0 + 0.2 * numpy.sin(4.0 * directions[:, 0]) * numpy.cos(3.0 * directions[:, 1])
cloud, points = vtkPolyData(), vtkPoints()
points.SetData(numpy_to_vtk(radii[:, None] * directions, deep=True))
cloud.SetPoints(points)
colors = numpy_to_vtk((127.5 * (1.0 + directions)).astype(numpy.uint8), deep=True)
colors.SetName("RGB")
cloud.GetPointData().SetScalars(colors)
writer = vtkConformalPLYWriter()
writer.SetInputData(cloud)
writer.SetFileName("scan.ply")
if writer.Write() != 1:
    raise SystemExit("scan.ply was not written")
