#!/usr/bin/python3
"""Measure surfaces that are learned from shells: points on both sides of a wall around a cavity.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_shells.py [FILE ...]

Samples each object by 40,000 random points, the outer layer. The inner layer has the points at a given depth below the
surface, except where the object is thinner than twice this depth. Prints a row for each shell, without normals:

    inner     number of points on the inner layer
    left out  number of points that are left out as the inner layer
    web       percent of the surface's area that is farther than 0.02 from the object
    p2s       mean square distance from other random points on the object to the surface
    alone     p2s of the surface that is learned from the outer layer alone
    inner p2s mean square distance from the inner layer to the surface that is learned with Side INNER_SIDE

The largest radius of the object is 1. Shells of depth 0 have one layer; there, nothing must be left out.
"""
import numpy as np
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator

import conformalsom
from measure_borders import (
    cloud_of, distances, objects_of, parser_of_objects, points_of, sampled, scaled_to_one, triangles_of)

COUNT = 40000
SHELLS = ((0, 0), (0, 0.02), (0.03, 0), (0.06, 0), (0.06, 0.005), (0.12, 0), (0.12, 0.01))


def inner_layer(surface, x, triangles, depth):
    """Points at a depth below random points of a surface."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    cell, hit = vtkGenericCell(), [0.0] * 3
    number, sub, squared = reference(0), reference(0), reference(0.0)
    layer = []
    for point in sampled(x, triangles, COUNT, 4):
        locator.FindClosestPoint(point, hit, cell, number, sub, squared)
        a, b, c = x[triangles[int(number)]]
        normal = np.cross(b - a, c - a)
        below = point - depth * normal / np.linalg.norm(normal)
        locator.FindClosestPoint(below, hit, cell, number, sub, squared)
        if float(squared) >= (0.98 * depth) ** 2:
            layer.append(below)
    return np.array(layer).reshape(-1, 3)


def learned(points, side=0):
    """The surface that is learned, and the number of points left out."""
    som = conformalsom.vtkConformalSOM()
    som.SetInputData(cloud_of(points))
    som.SetBorderToClosed()
    som.SetSide(side)
    som.Update()
    surface = som.GetOutput()
    return surface, int(surface.GetFieldData().GetArray("NumberOfOtherLayerPoints").GetValue(0))


def measure(name, surface):
    """Print the rows of an object."""
    whole = scaled_to_one(surface)
    x, triangles = points_of(whole), triangles_of(whole)
    if np.einsum("ij,ij->i", x[triangles[:, 0]], np.cross(x[triangles[:, 1]], x[triangles[:, 2]])).sum() < 0:
        triangles = triangles[:, ::-1]
    outer, test = sampled(x, triangles, COUNT, 3), sampled(x, triangles, 20000, 8)
    for depth, noise in SHELLS:
        inner = inner_layer(whole, x, triangles, depth) if depth > 0 else np.empty((0, 3))
        rng = np.random.default_rng(2)
        noisy = [layer + noise * rng.standard_normal(layer.shape) for layer in (outer, inner)]
        alone = learned(noisy[0], 2)[0]
        model, removed = learned(np.vstack(noisy))
        web = (distances(sampled(points_of(model), triangles_of(model), 20000, 9), whole) > 0.02).mean()
        p2s, of_outer = ((distances(test, found) ** 2).mean() for found in (model, alone))
        of_inner = (distances(inner, learned(np.vstack(noisy), 1)[0]) ** 2).mean() if depth > 0 else 0.0
        print(f"| {name} | {depth} | {noise} | {len(inner):,} | {removed:,} | {100 * web:.2f} | {p2s:.1e} | "
              f"{of_outer:.1e} | {of_inner:.1e} |", flush=True)


def main():
    """Measure all objects."""
    options = parser_of_objects(__doc__).parse_args()
    print("| object | depth | noise | inner | left out | web | p2s | alone | inner p2s |\n|" + " --- |" * 9)
    for name, surface in objects_of(options):
        measure(name, surface)


if __name__ == "__main__":
    main()
