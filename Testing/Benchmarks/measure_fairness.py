#!/usr/bin/python3
"""Prints how fair smooth surfaces are that are learned from points with noise.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_fairness.py
    ... measure_fairness.py --objects igea,bunny --noise 0,.002 --scans ../shared/data

Points are uniform on an object, with Gaussian noise of standard deviation s along each axis. Lengths are divided by
the object's largest radius. Columns: root mean square distance of the smooth surface's vertices from the object;
root mean square and mean angle between its facets and the object's normals, in degrees; root mean square angle of
the surface's own normals; NoiseLevel / s (NoiseLevel for s = 0); EffectiveDegreesOfFreedom; number of neurons;
seconds of the processor for learning. The objects are known by equations, or are scans whose triangles are taken for the truth.
"""
import argparse
import os
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator

from conformalsom import vtkConformalSOM, vtkCurvedSeamlessSurface, vtkGeodesicSphereSource
from conformalsom.command import scan_files

from helpers.clouds import cloud_of, points_of

BEND = 0.6  # radius to which the axis of the bean is bent
SCANS = {"igea": "igea-closed.ply", "bunny": "stanford-bunny-closed.ply", "armadillo": "armadillo.ply",
         "fandisk": "fandisk.obj", "spot": "spot.ply"}


def ellipsoid(axes):
    return lambda x: np.sqrt(((x / np.array(axes)) ** 2).sum(axis=1)) - 1.0


def superquadric(x):
    return ((np.abs(x) / np.array((1.0, 0.8, 0.6))) ** 4).sum(axis=1) ** 0.25 - 1.0


def bean(x):
    """An ellipsoid whose long axis is bent to a circle."""
    around, across = np.arctan2(x[:, 1], x[:, 0]), np.hypot(x[:, 0], x[:, 1])
    return ellipsoid((1.0, 0.3, 0.25))(np.column_stack([BEND * around, across - BEND, x[:, 2]]))


def bent(u):
    e = u * np.array((1.0, 0.3, 0.25))
    around, across = e[:, 0] / BEND, BEND + e[:, 1]
    return np.column_stack([across * np.cos(around), across * np.sin(around), e[:, 2]])


def radial(equation):
    return lambda u: u / (equation(u) + 1.0)[:, None]


EQUATIONS = {"sphere": ellipsoid((1, 1, 1)), "ellipsoid": ellipsoid((1, 0.7, 0.5)), "superquadric": superquadric,
             "bean": bean}


def gradient(equation, x, h=1e-5):
    steps = h * np.eye(3)
    return np.column_stack([(equation(x + step) - equation(x - step)) / (2 * h) for step in steps])


def triangles_of(surface):
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def facet_normals(x, triangles):
    normals = np.cross(x[triangles[:, 1]] - x[triangles[:, 0]], x[triangles[:, 2]] - x[triangles[:, 0]])
    lengths = np.linalg.norm(normals, axis=1)
    return normals / np.maximum(lengths, 1e-300)[:, None], lengths


def spread(x, triangles, count, random):
    """Random positions, uniform over the area."""
    areas = facet_normals(x, triangles)[1]
    chosen = triangles[random.choice(len(triangles), count, p=areas / areas.sum())]
    u, v = np.sqrt(random.random((count, 1))), random.random((count, 1))
    return (1 - u) * x[chosen[:, 0]] + u * (1 - v) * x[chosen[:, 1]] + u * v * x[chosen[:, 2]]


class Shape:
    """An object known by an equation."""
    stride = 1  # of all positions, one in so many is measured

    def __init__(self, name, count):
        self.equation = EQUATIONS[name]
        sphere = vtkGeodesicSphereSource()
        sphere.SetFrequency(60)
        sphere.Update()
        u = points_of(sphere.GetOutput())
        x = (bent if name == "bean" else radial(self.equation))(u)
        self.points = spread(x, triangles_of(sphere.GetOutput()), count, np.random.default_rng(5))
        for _ in range(4):
            g = gradient(self.equation, self.points)
            self.points -= (self.equation(self.points) / (g ** 2).sum(axis=1))[:, None] * g

    def distances(self, x):
        return self.equation(x) / np.linalg.norm(gradient(self.equation, x), axis=1)

    def normals(self, x):
        g = gradient(self.equation, x)
        return g / np.linalg.norm(g, axis=1)[:, None]


class Scan:
    """An object known by its triangles."""
    stride = 5

    def __init__(self, path, count):
        reader = scan_files.scan_reader(path)
        reader.Update()
        self.surface = reader.GetOutput()
        x, triangles = points_of(self.surface), triangles_of(self.surface)
        self.facets = facet_normals(x, triangles)[0]
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.surface)
        self.locator.BuildLocator()
        self.points = spread(x, triangles, count, np.random.default_rng(5))

    def closest(self, x):
        cell, foot = vtkGenericCell(), [0.0] * 3
        cell_id, part, square = reference(0), reference(0), reference(0.0)
        squares, ids = [], []
        for position in x:
            self.locator.FindClosestPoint(position, foot, cell, cell_id, part, square)
            squares.append(float(square))
            ids.append(int(cell_id))
        return np.sqrt(squares), ids

    def distances(self, x):
        return self.closest(x)[0]

    def normals(self, x):
        return self.facets[self.closest(x)[1]]


def angles(truth, x, normals):
    g = truth.normals(x)
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(normals, g), axis=1), (normals * g).sum(axis=1)))


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def row(truth, s, arguments):
    radius = np.linalg.norm(truth.points - truth.points.mean(axis=0), axis=1).max()
    noise = np.random.default_rng(101).normal(size=truth.points.shape) * s * radius
    network = vtkConformalSOM()
    network.SetInputData(cloud_of(truth.points + noise))
    if arguments.smoothness is not None:
        network.SetSmoothness(arguments.smoothness)
    if arguments.neurons:
        network.SetNumberOfNeurons(arguments.neurons)
    begin = time.process_time()
    network.Update()
    seconds = time.process_time() - begin
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(network.GetOutputPort())
    surface.Update()
    output = surface.GetOutput()
    x, triangles = points_of(output), triangles_of(output)
    normals, _ = facet_normals(x, triangles)
    facets = angles(truth, x[triangles].mean(axis=1)[::truth.stride], normals[::truth.stride])
    own = angles(truth, x[::truth.stride],
                 vtk_to_numpy(output.GetPointData().GetNormals()).astype(float)[::truth.stride])
    fields = network.GetOutput().GetFieldData()
    level, freedom = (fields.GetArray(name).GetValue(0) if fields.GetArray(name) else float("nan")
                      for name in ("NoiseLevel", "EffectiveDegreesOfFreedom"))
    return (rms(truth.distances(x[::truth.stride])) / radius, rms(facets), facets.mean(), rms(own),
            level / radius / (s or 1.0), freedom, network.GetOutput().GetNumberOfPoints(), seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--objects", default="ellipsoid,superquadric,bean")
    parser.add_argument("--noise", default="0,.0005,.001,.002")
    parser.add_argument("--points", type=int, default=0, help="default 40,000 of an equation, 60,000 of a scan")
    parser.add_argument("--neurons", type=int, default=0)
    parser.add_argument("--smoothness", type=float)
    parser.add_argument("--scans", default="../shared/data", help="folder of the scans")
    arguments = parser.parse_args()
    print(f"{'object':13}{'s':>7}{'distance':>10}{'facets':>8}{'mean':>8}{'normals':>8}{'noise':>7}{'freedom':>9}"
          f"{'neurons':>8}{'seconds':>8}")
    for name in arguments.objects.split(","):
        truth = Scan(os.path.join(arguments.scans, SCANS[name]), arguments.points or 60000) if name in SCANS \
            else Shape(name, arguments.points or 40000)
        for s in map(float, arguments.noise.split(",")):
            distance, facets, mean, own, level, freedom, neurons, seconds = row(truth, s, arguments)
            print(f"{name:13}{s:7.4f}{distance:10.2e}{facets:8.3f}{mean:8.3f}{own:8.3f}{level:7.3f}{freedom:9.0f}"
                  f"{neurons:8}{seconds:8.2f}", flush=True)


if __name__ == "__main__":
    main()
