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
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from conformalsom import vtkConformalSOM

from helpers.clouds import cloud_of, points_of
from known_objects import (angles, facet_normals, field_value, known_object, largest_radius, rms, smooth_surface,
                           triangles_of)


def row(truth, s, arguments):
    radius = largest_radius(truth.points)
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
    output = smooth_surface(network.GetOutput())
    x, triangles = points_of(output), triangles_of(output)
    normals, _ = facet_normals(x, triangles)
    facets = angles(truth, x[triangles].mean(axis=1)[::truth.stride], normals[::truth.stride])
    own = angles(truth, x[::truth.stride],
                 vtk_to_numpy(output.GetPointData().GetNormals()).astype(float)[::truth.stride])
    level, freedom = (field_value(network.GetOutput(), name) for name in ("NoiseLevel", "EffectiveDegreesOfFreedom"))
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
    print(f"{'object':13}{'s':>7}{'distance':>10}{'normals':>9}{'mean':>8}{'own':>8}{'noise':>7}{'freedom':>9}"
          f"{'neurons':>9}{'seconds':>9}")
    for name in arguments.objects.split(","):
        truth = known_object(name, arguments.scans, arguments.points)
        for s in map(float, arguments.noise.split(",")):
            distance, facets, mean, own, level, freedom, neurons, seconds = row(truth, s, arguments)
            print(f"{name:13}{s:7.4f}{distance:10.2e}{facets:9.3f}{mean:8.3f}{own:8.3f}{level:7.3f}{freedom:9.0f}"
                  f"{neurons:9}{seconds:9.2f}", flush=True)


if __name__ == "__main__":
    main()
