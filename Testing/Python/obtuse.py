"""Smooth surfaces of bad triangles."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from conformalsom import vtkCurvedSeamlessSurface, vtkGeodesicSphereSource


def obtuse_surface(network, frequency=24, amount=0.6, random_seed=1):
    """The smooth surface over a mapped mesh, its vertices shifted along it so that many angles are
    obtuse. amount is the largest shift, as a share of an edge."""
    sphere = vtkGeodesicSphereSource()
    sphere.SetFrequency(frequency)
    sphere.Update()
    directions = vtk_to_numpy(sphere.GetOutput().GetPointData().GetArray("SpherePosition"))
    random = np.random.RandomState(random_seed)
    edge = 1.1 / frequency
    directions += amount * edge * random.uniform(-1.0, 1.0, directions.shape)
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(0, network.GetOutputPort())
    surface.SetSphereData(sphere.GetOutput())
    surface.Update()
    return surface.GetOutput()
