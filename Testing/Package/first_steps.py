"""The first steps in Python with the installed package: points -> mesh -> smooth surface."""
from vtkmodules.vtkFiltersSources import vtkSphereSource

import conformalsom
from conformalsom import vtkConformalSOM, vtkCurvedSeamlessSurface

points = vtkSphereSource()
points.SetThetaResolution(60)
points.SetPhiResolution(30)
mesh, surface = vtkConformalSOM(), vtkCurvedSeamlessSurface()
mesh.SetNumberOfNeurons(362)
mesh.SetInputConnection(points.GetOutputPort())
surface.SetFrequency(20)
surface.SetInputConnection(mesh.GetOutputPort())
surface.Update()
result = surface.GetOutput()
print(conformalsom.__file__, result.GetNumberOfPoints(), "points")
assert conformalsom.__file__.startswith("/usr/lib/python3/dist-packages/")
assert result.GetNumberOfPoints() > 1000
assert result.GetPointData().HasArray("SpherePosition")
farthest = max(abs(sum(x * x for x in result.GetPoint(i)) ** 0.5 - 0.5)
               for i in range(result.GetNumberOfPoints()))
print("farthest from the sphere of radius 0.5:", farthest)
assert farthest < 0.02
