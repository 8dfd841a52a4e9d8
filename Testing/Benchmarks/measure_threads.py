#!/usr/bin/python3
"""Measure maps to the sphere of surfaces that are learned from points with outliers, and from thin sheets.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_threads.py [FILE ...]

Samples each object by 40,000 random points without normals, and adds random points in a box 1.2 times as large as the
object. Discs with a rounded rim are sampled by several numbers of points. Prints a row for each cloud:

    outliers   number of points that were left out before learning
    K          mean quasi-conformal error of the map to the sphere, weighted by area; 1 is conformal
    largest K  of a triangle
    crossing   number of pairs of triangles that cross each other
    web        percent of the surface's area that is farther than 0.02 from the object
    p2s        mean square distance from other random points on the object to the surface
    warnings   number of warnings

The largest radius of the object is 1.
"""
import numpy as np

import conformalsom
from measure_borders import (
    cloud_of, distances, objects_of, parser_of_objects, points_of, sampled, scaled_to_one, triangles_of)

COUNT = 40000
SHARES = (0.0, 0.02, 0.05, 0.1)  # of outliers
DISCS = ((0.04, 6000), (0.04, 15000), (0.02, 6000), (0.02, 15000), (0.02, 40000), (0.01, 40000))


def with_outliers(points, share):
    """Points and random points in a box around them."""
    box = 1.2 * np.array([points.min(axis=0), points.max(axis=0)])
    random = np.random.default_rng(2).random((int(share * len(points)), 3))
    return np.vstack([points, box[0] + (box[1] - box[0]) * random])


def disc(thickness, count, seed):
    """Random points on a disc of radius 1 with a rounded rim."""
    random, half = np.random.default_rng(seed), 0.5 * thickness
    radius, angle = np.sqrt(random.random(count)), 2.0 * np.pi * random.random(count)
    height = np.where(random.random(count) < 0.5, -half, half)
    tilt = np.pi * (random.random(count) - 0.5)
    rim = random.random(count) < np.pi * half / (1.0 + np.pi * half)
    radius[rim] = 1.0 + half * np.cos(tilt[rim])
    height[rim] = half * np.sin(tilt[rim])
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), height])


def far_from_disc(x, thickness):
    """Distances of positions from a disc with a rounded rim."""
    beyond = np.maximum(np.hypot(x[:, 0], x[:, 1]) - 1.0, 0.0)
    return np.abs(np.hypot(beyond, x[:, 2]) - 0.5 * thickness)


def learned(points):
    """The surface, and the number of warnings."""
    som = conformalsom.vtkConformalSOM()
    som.SetInputData(cloud_of(points))
    warnings = []
    som.AddObserver("WarningEvent", lambda *_: warnings.append(1))
    som.Update()
    return som.GetOutput(), len(warnings)


def report(name, cloud, points, test, far):
    """Print the row of a cloud.

    far: distances of positions from the object
    """
    surface, warnings = learned(points)
    figures = [surface.GetFieldData().GetArray(array).GetValue(0) for array in (
        "NumberOfOutliers", "MeanQuasiConformalError", "MaximumQuasiConformalError", "SelfIntersections")]
    web = (far(sampled(points_of(surface), triangles_of(surface), 20000, 9)) > 0.02).mean()
    print(f"| {name} | {cloud} | {figures[0]:,} | {figures[1]:.3f} | {figures[2]:.3g} | {figures[3]} | {100 * web:.2f} | "
          f"{(distances(test, surface) ** 2).mean():.1e} | {warnings} |", flush=True)


def measure(name, surface):
    """Print the rows of an object."""
    whole = scaled_to_one(surface)
    x, triangles = points_of(whole), triangles_of(whole)
    points, test = sampled(x, triangles, COUNT, 3), sampled(x, triangles, 20000, 8)
    for share in SHARES:
        report(name, f"{100 * share:.0f} %", with_outliers(points, share), test, lambda y: distances(y, whole))


def main():
    """Measure all objects, and discs."""
    options = parser_of_objects(__doc__).parse_args()
    print("| object | cloud | outliers | K | largest K | crossing | web % | p2s | warnings |\n|" + " --- |" * 9)
    for name, surface in objects_of(options):
        measure(name, surface)
    for thickness, count in DISCS:
        report(f"disc {thickness}", f"{count:,}", disc(thickness, count, 1), disc(thickness, 20000, 8),
               lambda y, thickness=thickness: far_from_disc(y, thickness))


if __name__ == "__main__":
    main()
