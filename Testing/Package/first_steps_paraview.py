"""The first steps with pvbatch: the plugin is there without being loaded by the script."""
from paraview import simple

points = simple.Sphere(ThetaResolution=60, PhiResolution=30)
mesh = simple.ConformalSOM(Input=points, NumberOfNeurons=362)
surface = simple.CurvedSeamlessSurface(Input=mesh, Frequency=20)
surface.UpdatePipeline()
information = surface.GetDataInformation()
print(information.GetNumberOfPoints(), "points, arrays", surface.PointData.keys())
assert information.GetNumberOfPoints() > 1000
assert "SpherePosition" in surface.PointData.keys()
