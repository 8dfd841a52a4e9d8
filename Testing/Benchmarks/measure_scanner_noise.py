#!/usr/bin/python3
"""Prints how close smooth surfaces are that are learned from clouds with errors as scanners make them.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_scanner_noise.py
    ... measure_scanner_noise.py --objects bunny --kinds view,camera --noise .005,.01 --scans ../shared/data

Lengths are divided by the object's largest radius. Column "kind" is the error of the points (scanner_noise.py):
  gaussian  equal noise along each axis
  view      noise along the direction to the scanner
  outliers  like view, with 1 % outliers
  passes    two passes, each shifted, rotated, and with an error that changes slowly over the surface
  camera    a depth camera with quantized depth, and noise that grows with distance and angle
All clouds have a fixed seed. The number of points is --ratios times 12,962 (for camera, --images).

Columns: s, the standard deviation of the error; points; neurons; true, the root mean square error along the normal
without outliers; found, NoiseLevel / true (NoiseLevel for s = 0); off, the root mean square distance of the smooth
surface from the object; p2s, the mean square distance of the object's vertices from the surface; normals, the root
mean square angle between the normals of surface and object, in degrees; area, divided by the object's; seconds of
the processor for learning; warnings, their number (their texts with --verbose).
"""
import argparse
import itertools
import time

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkMassProperties

from conformalsom import vtkConformalSOM

import scanner_noise
from helpers import depth_camera
from helpers.clouds import cloud_of, points_of, vtk_points
from known_objects import (facet_normals, field_value, known_object, mismatch, rms, smooth_surface, spread,
                           triangles_of)

NEURONS = 12962  # to which ratios refer
COLUMNS = f"{'object':14}{'kind':9}{'s':>7}{'points':>8}{'neurons':>9}{'true':>9}{'NoiseLevel / true':>19}{'off':>10}" \
          f"{'p2s':>10}{'normals':>9}{'area':>7}{'seconds':>9}  warnings"


def area(surface):
    measure = vtkMassProperties()
    measure.SetInputData(surface)
    return measure.GetSurfaceArea()


class Target:
    """A known object as triangles, with centroid 0 and largest radius 1."""

    def __init__(self, name, scans):
        self.mesh = known_object(name, scans, 4).mesh()
        x, self.triangles = points_of(self.mesh), triangles_of(self.mesh)
        x -= x.mean(axis=0)
        self.x = x / np.linalg.norm(x, axis=1).max()
        self.mesh.SetPoints(vtk_points(self.x))
        self.normals = facet_normals(self.x, self.triangles)[0]
        if np.einsum("ij,ij->", self.x[self.triangles[:, 0]],
                     np.cross(self.x[self.triangles[:, 1]], self.x[self.triangles[:, 2]])) < 0.0:
            self.normals = -self.normals
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.mesh)
        self.locator.BuildLocator()
        self.area = area(self.mesh)

    def scanned(self, kind, count, s):
        """Points, the exact positions and normals that they were measured at, and a mask without outliers."""
        random = np.random.default_rng(101)
        if kind == "camera":
            points, exact, normals = depth_camera.scanned(self.locator, self.normals, count, s, random)
            return points, exact, normals, np.ones(len(points), bool)
        exact, ids = spread(self.x, self.triangles, count, random)
        points, inside = scanner_noise.NOISES[kind](exact, self.normals[ids], s, random)
        return points, exact, self.normals[ids], inside

    def cloud(self, kind, count, s):
        """Points, their errors along the normal without outliers."""
        points, exact, normals, inside = self.scanned(kind, count, s)
        return points, ((points - exact) * normals).sum(axis=1)[inside]


def row(target, points, true, arguments):
    network, warnings = vtkConformalSOM(), []
    network.SetInputData(cloud_of(points))
    if arguments.neurons:
        network.SetNumberOfNeurons(arguments.neurons)
    network.AddObserver("WarningEvent", observer(warnings))
    begin = time.process_time()
    network.Update()
    seconds = time.process_time() - begin
    surface = smooth_surface(network.GetOutput())
    off, p2s, normals = mismatch(surface, target.mesh)
    found = field_value(network.GetOutput(), "NoiseLevel") / (true or 1.0)
    return (f"{network.GetOutput().GetNumberOfPoints():9}{true:9.5f}{found:19.2f}{off:10.2e}{p2s:10.2e}{normals:9.2f}"
            f"{area(surface) / target.area:7.3f}{seconds:9.1f}  {len(warnings)}"), warnings


def observer(texts):
    def observe(_caller, _event, text):
        texts.append(text)
    observe.CallDataType = "string0"
    return observe


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--objects", default="superquadric,bean")
    parser.add_argument("--kinds", default=",".join([*scanner_noise.NOISES, "camera"]))
    parser.add_argument("--noise", default="0,.002,.005,.01,.02")
    parser.add_argument("--ratios", default="1,3,10", help="points for each of 12,962 neurons")
    parser.add_argument("--images", default="18000,9000", help="points of all images of the depth camera")
    parser.add_argument("--neurons", type=int, default=0, help="default: that of vtkConformalSOM")
    parser.add_argument("--scans", default="../shared/data", help="folder of the scans")
    parser.add_argument("--verbose", action="store_true", help="print the texts of warnings")
    arguments = parser.parse_args()
    print(COLUMNS)
    for name, kind in itertools.product(arguments.objects.split(","), arguments.kinds.split(",")):
        target = Target(name, arguments.scans)
        counts = [int(n) for n in arguments.images.split(",")] if kind == "camera" else \
            [round(NEURONS * float(ratio)) for ratio in arguments.ratios.split(",")]
        for s, count in itertools.product(map(float, arguments.noise.split(",")), counts):
            points, errors = target.cloud(kind, count, s)
            text, warnings = row(target, points, rms(errors), arguments)
            print(f"{name:14}{kind:9}{s:7.4f}{count:8}{text}", flush=True)
            if arguments.verbose:
                print(*(f"    {warning}" for warning in warnings), sep="\n")


if __name__ == "__main__":
    main()
