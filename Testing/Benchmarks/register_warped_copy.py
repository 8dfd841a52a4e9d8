#!/usr/bin/python3
"""How well vtkSphericalRegistration finds a known warp by curvature alone.

    register_warped_copy.py cortex.ply [--frequency 32] [--warp 0.15]

A closed mesh of genus zero is mapped to the sphere. Its copy has other vertices, the directions of a geodesic sphere,
is bent a little in space, and its map is warped smoothly. Both get their mean curvature, smoothed over the same area.
The copy is registered with the mesh by it (ShapeWeight 0): what is left of the warp, in degrees on the sphere, is
printed. PYTHONPATH is that of the build.
"""
import argparse
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkFiltersGeneral import vtkCurvatures

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from conformalsom import (  # pylint: disable=wrong-import-position
    vtkGeodesicSphereSource, vtkGlobalConformalMap, vtkSphericalRegistration, vtkSphericalResample)
from conformalsom.command import scan_files  # pylint: disable=wrong-import-position

SMOOTHED = 0.024  # about how far curvature is smoothed, of the area's square root


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name)).astype(float)


def add(data, name, values):
    added = numpy_to_vtk(np.ascontiguousarray(values, dtype=float), deep=True)
    added.SetName(name)
    data.GetPointData().AddArray(added)


def mapped(path, balance):
    conformal, reader = vtkGlobalConformalMap(), scan_files.scan_reader(path)
    conformal.SetInputConnection(reader.GetOutputPort())
    conformal.SetAreaBalance(balance)
    conformal.Update()
    return conformal.GetOutput()


def warped(directions, amount):
    x, y, z = directions.T
    moved = directions + amount * np.stack([np.sin(2.0 * y + 1.0), np.cos(1.7 * z), np.sin(1.5 * x + 0.5)], axis=1)
    return moved / np.linalg.norm(moved, axis=1)[:, None]


def copy_of(surface, frequency):
    """The surface in the directions of a geodesic sphere, bent, and those directions."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    for k in range(3):
        add(surface, "xyz"[k], points[:, k])
    sphere = vtkGeodesicSphereSource()
    sphere.SetFrequency(frequency)
    resample = vtkSphericalResample()
    resample.SetInputConnection(sphere.GetOutputPort())
    resample.SetSourceData(surface)
    resample.Update()
    copy = resample.GetOutput()
    directions = vtk_to_numpy(sphere.GetOutput().GetPoints().GetData()).astype(float)
    places = np.stack([array(copy, name) for name in "xyz"], axis=1)
    center = places.mean(axis=0)
    size = np.abs(places - center).max()
    places = (places - center) / size
    points = vtkPoints()
    points.SetData(numpy_to_vtk(center + size * (places + 0.05 * np.sin(2.0 * places[:, [1, 2, 0]] + 0.3)), deep=True))
    copy.SetPoints(points)
    return copy, directions / np.linalg.norm(directions, axis=1)[:, None]


def with_curvature(surface):
    """Mean curvature, averaged among neighbors by area until it is smoothed as far on any mesh."""
    curvatures = vtkCurvatures()
    curvatures.SetCurvatureTypeToMean()
    curvatures.SetInputData(surface)
    curvatures.Update()
    result = curvatures.GetOutput()
    points = vtk_to_numpy(result.GetPoints().GetData()).astype(float)
    corners = vtk_to_numpy(result.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = points[corners.T]
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    shares = np.bincount(corners.ravel(), np.repeat(areas, 3), len(points))
    start, end = np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]).T
    spacing = np.linalg.norm(points[start] - points[end], axis=1).mean() / np.sqrt(areas.sum())
    values = array(result, "Mean_Curvature")
    values = np.clip(values, *np.percentile(values, [1, 99]))
    for _ in range(max(1, int((SMOOTHED / spacing)**2))):
        sums, weights = (np.bincount(start, own[end], len(points)) + own for own in (shares * values, shares))
        values = sums / np.maximum(weights, np.finfo(float).tiny)
    add(result, "Curvature", np.arctan(values / values.std()))
    return result


def degrees(a, b):
    return np.degrees(np.arccos(np.clip((a * b).sum(axis=1), -1.0, 1.0)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", help="a closed mesh of genus zero")
    parser.add_argument("--frequency", type=int, default=32, help="of the sphere that is deformed, default 32")
    parser.add_argument("--copy", type=int, default=40, help="frequency of the copy, default 40")
    parser.add_argument("--warp", type=float, default=0.15, help="of the map, default 0.15")
    parser.add_argument("--balance", type=float, default=0.5, help="AreaBalance of the map, default 0.5")
    args = parser.parse_args()
    surface = mapped(args.model, args.balance)
    copy, true = copy_of(surface, args.copy)
    before = warped(true, args.warp)
    add(copy, "SpherePosition", before)
    registration = vtkSphericalRegistration()
    registration.SetInputData(with_curvature(copy))
    registration.SetFixedData(with_curvature(surface))
    registration.SetShapeWeight(0.0)
    registration.AddFeature("Curvature", 1.0)
    registration.SetFrequency(args.frequency)
    start = time.process_time()
    registration.Update()
    seconds = time.process_time() - start
    result = registration.GetOutput()
    left = degrees(array(result, "SpherePosition"), true)
    folds = result.GetFieldData().GetArray("NumberOfFolds").GetValue(0)
    print(f"{surface.GetNumberOfPoints()} points, their copy {copy.GetNumberOfPoints()}")
    print(f"degrees on the sphere: before {degrees(before, true).mean():.2f}, after {left.mean():.2f} in the mean, "
          f"{np.median(left):.2f} in the median; {folds} folds, {seconds:.1f} CPU seconds")


if __name__ == "__main__":
    main()
