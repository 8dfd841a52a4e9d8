#!/usr/bin/python3
"""Prints how likely points are that were not learned, under the noise that was found.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_heldout.py scan.ply
    ... measure_heldout.py --objects igea,bean --noise 0,.002,.01 --scans ../shared/data

No reference surface is needed. Every tenth point is left out. A mesh is learned from the other points by default
properties. Let d be the distance of a left-out point from the smooth surface over this mesh. If the surface and its
uncertainties are correct, d is normally distributed with the variance sigma^2 = NoiseLevel^2 + StandardError^2. The
StandardError is that of the nearest vertex of the mesh. The unit of length is the scan's largest radius.

Columns: points that were left out; noise, NoiseLevel; error, the root mean square StandardError; rms, the root mean
square d; ratio, the root mean square d / sigma, which is 1 if the uncertainties are correct; likelihood, the mean of
-log(sigma) - d^2 / (2 sigma^2) - log(2 pi) / 2; best, the largest possible mean for a constant sigma. Each
likelihood is larger if the surface is closer to the points. The likelihood is also reduced by false uncertainties.
"clipped" is the fraction of points with d > 4 sigma; their d is replaced by 4 sigma, so that few points, such as
outliers, do not determine the likelihood.
"""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkStaticPointLocator

from conformalsom import vtkConformalSOM, vtkSurfaceMismatch
from conformalsom.command import scan_files

from helpers.clouds import cloud_of, points_of
from known_objects import field_value, known_object, largest_radius, rms, smooth_surface

STEP = 10  # of all points, one in so many is left out
FAR = 4.0  # in units of sigma


def nearest(mesh, x):
    """For each position, the nearest vertex."""
    locator = vtkStaticPointLocator()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    return np.array([locator.FindClosestPoint(position) for position in x])


def distances(surface, x):
    measure = vtkSurfaceMismatch()
    measure.SetInputData(0, surface)
    measure.SetReferenceData(cloud_of(x))
    measure.SetNumberOfSamples(1)
    measure.Update()
    return vtk_to_numpy(measure.GetOutput(1).GetPointData().GetArray("Distance"))


def row(points, smoothness=None):
    points = np.random.default_rng(3).permutation(points) / largest_radius(points)
    left_out = np.arange(len(points)) % STEP == 0
    network = vtkConformalSOM()
    network.SetInputData(cloud_of(points[~left_out]))
    if smoothness is not None:
        network.SetSmoothness(smoothness)
    network.Update()
    mesh = network.GetOutput()
    x = points[left_out]
    d = distances(smooth_surface(mesh), x)
    errors = vtk_to_numpy(mesh.GetPointData().GetArray("StandardError"))[nearest(mesh, x)]
    noise = field_value(mesh, "NoiseLevel")
    sigma = np.maximum(np.sqrt(noise**2 + errors**2), 1e-12)
    z = np.minimum(d / sigma, FAR)
    likelihood = np.mean(-np.log(sigma) - 0.5 * z**2) - 0.5 * np.log(2.0 * np.pi)
    best = -np.log(max(rms(np.minimum(d, FAR * sigma)), 1e-12)) - 0.5 - 0.5 * np.log(2.0 * np.pi)
    return (f"{len(x):8}{noise:12.2e}{rms(errors):10.2e}{rms(d):10.2e}{rms(z):8.3f}{likelihood:12.3f}{best:8.3f}"
            f"{np.mean(d > FAR * sigma):9.4f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", nargs="*", help="files of points")
    parser.add_argument("--objects", help="known objects, such as bean,igea, in place of files")
    parser.add_argument("--noise", default="0,.002,.01", help="Gaussian noise of the known objects along each axis")
    parser.add_argument("--points", type=int, default=0, help="default 40,000 of an equation, 60,000 of a scan")
    parser.add_argument("--scans", default="../shared/data", help="folder of the known objects' files")
    parser.add_argument("--smoothness", type=float, help="property Smoothness of vtkConformalSOM")
    arguments = parser.parse_args()
    print(f"{'object':18}{'s':>6}{'points':>8}{'NoiseLevel':>12}{'error':>10}{'rms':>10}{'ratio':>8}"
          f"{'likelihood':>12}{'best':>8}{'clipped':>9}")
    for path in arguments.scan:
        reader = scan_files.scan_reader(path)
        reader.Update()
        print(f"{os.path.basename(path):18}{'-':>6}{row(points_of(reader.GetOutput()), arguments.smoothness)}", flush=True)
    for name in arguments.objects.split(",") if arguments.objects else ():
        truth = known_object(name, arguments.scans, arguments.points)
        radius = largest_radius(truth.points)
        for s in map(float, arguments.noise.split(",")):
            points = truth.points + s * radius * np.random.default_rng(101).normal(size=truth.points.shape)
            print(f"{name:18}{s:6}{row(points, arguments.smoothness)}", flush=True)


if __name__ == "__main__":
    main()
