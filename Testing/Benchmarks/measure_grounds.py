#!/usr/bin/python3
"""Measure surfaces that are learned from scans of objects that stand on a ground.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_grounds.py [FILE ...]

Samples each object by 40,000 random points, and puts it on a square plane of the same density, in front of a wall, or
beside a smaller copy. Prints a row for each scene:

    ground   percent of the ground's points that are left out
    lost     percent of the object's points that are left out, without those within two spacings of the plane
    web      percent of the surface's area that is farther than 0.02 from the object, above the lowest 0.05
    p2s      mean square distance from other random points on the object to the surface, above the lowest 0.05
    alone    p2s of the surface that is learned from the object's points alone, above the lowest 0.05

The largest radius of the object is 1. Scenes named "none" have no ground; there, nothing must be left out.
"""
import numpy as np

import conformalsom
from measure_borders import (
    cloud_of, distances, objects_of, parser_of_objects, points_of, sampled, scaled_to_one, triangles_of)

COUNT = 40000
LOWEST = 0.05


def plane_under(x, width, spacing, noise, rng):
    """Points of a square plane under the object, as wide as a multiple of the object's width."""
    center = 0.5 * (x.min(axis=0) + x.max(axis=0))
    side = width * max(np.ptp(x[:, 0]), np.ptp(x[:, 2]))
    count = int((side / spacing) ** 2)
    plane = np.zeros((count, 3))
    plane[:, [0, 2]] = center[[0, 2]] + side * (rng.random((count, 2)) - 0.5)
    plane[:, 1] = x[:, 1].min() + noise * rng.standard_normal(count)
    return plane


def scenes(x, spacing):
    """(name, ground) of each scene; points of the object come first."""
    rng = np.random.default_rng(7)
    table = plane_under(x, 3, spacing, 0.0, rng)
    yield "none", np.empty((0, 3))
    yield "table, 3 x as wide", table
    yield "table, 6 x as wide", plane_under(x, 6, spacing, 0.0, rng)
    yield "table, noise .003", plane_under(x, 3, spacing, 0.003, rng)
    second = 0.4 * x[::5] + np.array([1.2 * np.ptp(x[:, 0]), 0, 0])
    second[:, 1] += x[:, 1].min() - second[:, 1].min()
    yield "table and a second object", np.vstack([table, second])
    stray = table[rng.integers(len(table), size=len(table) // 100)]
    stray[:, 1] += 0.1 * rng.random(len(stray)) * np.ptp(x[:, 1])
    yield "table and 1 % stray points", np.vstack([table, stray])
    yield "wall behind", table[:, [0, 2, 1]] - np.array([0, 0, table[0, 1] - x[:, 2].min()])


def learned(points):
    """The surface that is learned, the number of points left out, and whether each point is near it."""
    som = conformalsom.vtkConformalSOM()
    som.SetInputData(cloud_of(points))
    som.SetBorderToClosed()
    som.Update()
    surface = som.GetOutput()
    return surface, int(surface.GetFieldData().GetArray("NumberOfGroundPoints").GetValue(0))


def measure(name, surface):
    """Print the rows of an object."""
    whole = scaled_to_one(surface)
    x, triangles = points_of(whole), triangles_of(whole)
    cloud, test = sampled(x, triangles, COUNT, 3), sampled(x, triangles, 20000, 8)
    area = 0.5 * np.linalg.norm(np.cross(x[triangles[:, 1]] - x[triangles[:, 0]], x[triangles[:, 2]] - x[triangles[:, 0]]),
                                axis=1).sum()
    spacing = (area / COUNT) ** 0.5
    alone = None
    for scene, ground in scenes(cloud, spacing):
        model, removed = learned(np.vstack([cloud, ground]))
        behind = scene.startswith("wall")
        axis = 2 if behind else 1
        above = test[test[:, axis] > x[:, axis].min() + LOWEST]
        if alone is None:
            reference = model
        alone = (distances(above, reference) ** 2).mean()
        p2s = (distances(above, model) ** 2).mean()
        y = sampled(points_of(model), triangles_of(model), 20000, 9)
        y = y[y[:, axis] > x[:, axis].min() + LOWEST]
        web = (distances(y, whole) > 0.02).mean()
        print(f"| {name} | {scene} | {len(ground):,} | {removed:,} | {100 * web:.2f} | {p2s:.1e} | {alone:.1e} |", flush=True)


def main():
    """Measure all objects."""
    options = parser_of_objects(__doc__).parse_args()
    print("| object | scene | points of the ground | left out | web | p2s | alone |\n|" + " --- |" * 7)
    for name, surface in objects_of(options):
        measure(name, surface)


if __name__ == "__main__":
    main()
