"""Two folded surfaces made by code, as cortical hemispheres: equal folds at other places.

A hemisphere is an ellipsoid in millimeters, moved in and out by waves. The waves are functions of a place that
both have in common, a direction: so which points correspond is known. The places themselves lie elsewhere on
each of them, by a smooth deformation, and each has ripples of its own. One piece, no holes, no handles.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from conformalsom import vtkGeodesicSphereSource

from .clouds import vtk_points

RADII = np.array([38.0, 85.0, 55.0])  # across, along and up
DEPTH = 0.10                          # of the folds, as a share of the radius
WAVES, LENGTH = 60, 16.0              # how many, and radians of phase for one of the sphere
PLACE = "CommonPlace"                 # 3 components: the place that both have in common


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1)[:, None]


def waves(directions, seed, length):
    """A function of directions of variance 1 without any symmetry."""
    random = np.random.RandomState(seed)
    phases = directions @ (length * unit(random.standard_normal((WAVES, 3)))).T + 2 * np.pi * random.random(WAVES)
    return np.sqrt(2.0 / WAVES) * np.cos(phases).sum(axis=1)


def common_places(directions, deformation):
    """Where the points in these directions lie on what both have in common; one to one for up to 0.3."""
    x, y, z = directions.T
    field = np.stack([np.sin(2.0 * y + 1.0), np.cos(1.7 * z), np.sin(1.5 * x + 0.5)], axis=1)
    return unit(directions + deformation * field)


def hemisphere(frequency, deformation, seed):
    """A hemisphere of 10 frequency^2 + 2 points as a vtkPolyData, with the point array CommonPlace."""
    sphere = vtkGeodesicSphereSource()
    sphere.SetFrequency(frequency)
    sphere.Update()
    surface = sphere.GetOutput()
    directions = unit(vtk_to_numpy(surface.GetPoints().GetData()).astype(float))
    places = common_places(directions, deformation)
    folds = DEPTH * np.tanh(1.5 * waves(places, 1, LENGTH)) + 0.1 * DEPTH * waves(directions, seed, 2.0 * LENGTH)
    surface.SetPoints(vtk_points(((1.0 + folds)[:, None] * directions * RADII).astype(np.float32)))
    surface.GetPointData().Initialize()
    array = numpy_to_vtk(places, deep=True)
    array.SetName(PLACE)
    surface.GetPointData().AddArray(array)
    return surface
