#!/usr/bin/python3
"""Common meshes of mapped surfaces in figures: the tables of Documentation/Correspondence.md.

    measure_common_meshes.py [--balance B] [--points N] [--means] MESH ...

For each closed mesh, a morph with itself on N points. With landmark files (MESH with the ending .landmarks) beside all
meshes, also their common mesh, their linear mean and their rigid mean; all areas are scaled to 1. Columns: folded,
percentage of edges with an angle of more than 90 degrees between the normals; crossing, pairs of triangles that cross
each other; area; angle, below which the smallest angle of 5 percent of the triangles is, in degrees. PYTHONPATH is that
of the build.
"""
import argparse
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkPolyData, vtkStaticCellLocator

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from conformalsom import (  # pylint: disable=wrong-import-position
    conformal_map, vtkConsistentRemesh, vtkSphericalMorph, vtkSphericalTemplate)
from conformalsom.command import scan_files  # pylint: disable=wrong-import-position

from known_objects import facet_normals, points_of, triangles_of  # pylint: disable=wrong-import-position


def parts_through(x, sides, triangles):
    """For pairs of a triangle and a triangle, whether a side of the first crosses the second."""
    a, b, c = (x[triangles[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    found = np.zeros(len(triangles), bool)
    for k in range(3):
        p, q = x[sides[:, k]], x[sides[:, (k + 1) % 3]]
        before, after = ((p - a) * normal).sum(axis=1), ((q - a) * normal).sum(axis=1)
        with np.errstate(all="ignore"):
            at = p + (before / (before - after))[:, None] * (q - p)
        inside = before * after < 0.0
        for first, second in ((a, b), (b, c), (c, a)):
            inside &= (np.cross(second - first, at - first) * normal).sum(axis=1) > 0.0
        found |= inside
    return found


def crossing_pairs(surface):
    """The number of pairs of triangles without a common vertex that cross each other."""
    x, triangles = points_of(surface).astype(float), triangles_of(surface)
    locator, near, pairs = vtkStaticCellLocator(), vtkIdList(), []
    locator.SetDataSet(surface)
    locator.BuildLocator()
    low, high = x[triangles].min(axis=1), x[triangles].max(axis=1)
    for i in range(len(triangles)):
        locator.FindCellsWithinBounds(np.column_stack([low[i], high[i]]).ravel(), near)
        pairs.extend((i, near.GetId(j)) for j in range(near.GetNumberOfIds()) if near.GetId(j) > i)
    one, other = triangles[np.array(pairs)].transpose(1, 0, 2)
    apart = ~(one[:, :, None] == other[:, None, :]).any(axis=(1, 2))
    one, other = one[apart], other[apart]
    return int((parts_through(x, one, other) | parts_through(x, other, one)).sum())


def measures(surface):
    x, triangles = points_of(surface).astype(float), triangles_of(surface)
    normals, doubled = facet_normals(x, triangles)
    sides = np.vstack([triangles[:, (k, (k + 1) % 3)] for k in range(3)])
    order = np.lexsort(np.sort(sides, axis=1).T)
    both = np.tile(np.arange(len(triangles)), 3)[order].reshape(-1, 2)
    folded = ((normals[both[:, 0]] * normals[both[:, 1]]).sum(axis=1) < 0.0).mean()
    angles = []
    for k in range(3):
        u, v = (x[triangles[:, (k + i) % 3]] - x[triangles[:, k]] for i in (1, 2))
        angles.append(np.degrees(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(axis=1))))
    return 100.0 * folded, crossing_pairs(surface), 0.5 * doubled.sum(), np.percentile(np.min(angles, axis=0), 5)


def print_row(name, surface, seconds=0.0):
    folded, crossing, area, angle = measures(surface)
    print(f"| {name} | {surface.GetNumberOfPoints():,} | {folded:.2f} | {crossing} | {area:.3f} | {angle:.1f} | "
          f"{seconds:.1f} |", flush=True)


def mapped(path, balance):
    """A mesh of area 1 with its map, and with its landmarks as a point array if it has any."""
    reader = scan_files.scan_reader(path)
    reader.Update()
    read, surface = reader.GetOutput(), vtkPolyData()
    x = points_of(read).astype(float)
    area = 0.5 * facet_normals(x, triangles_of(read))[1].sum()
    surface.DeepCopy(read)
    surface.GetPoints().SetData(numpy_to_vtk(x / np.sqrt(area), deep=True))
    landmarks = os.path.splitext(path)[0] + ".landmarks"
    if os.path.exists(landmarks):
        numbers = np.zeros(len(x))
        numbers[np.loadtxt(landmarks, dtype=int)] = np.arange(1, len(np.loadtxt(landmarks)) + 1)
        array = numpy_to_vtk(numbers, deep=True)
        array.SetName("Landmarks")
        surface.GetPointData().AddArray(array)
    return conformal_map(surface, area_balance=balance).polydata


def run(algorithm):
    begin = time.process_time()
    algorithm.Update()
    return time.process_time() - begin


def print_itself(name, surface, points):
    print_row(name, surface)
    morph = vtkSphericalMorph()
    morph.SetInputData(surface)
    morph.SetTargetData(surface)
    morph.SetNumberOfPoints(points)
    seconds = run(morph)
    print_row(name + ", with itself", morph.GetOutput(), seconds)


def print_mean(surfaces, points, means_only):
    template, remesh = vtkSphericalTemplate(), vtkConsistentRemesh()
    for surface in surfaces:
        template.AddInputDataObject(surface)
    template.SetLandmarkArrayName("Landmarks")
    seconds = run(template)
    if not means_only:
        print_row("template", template.GetMeanSurface(), seconds)
    remesh.SetInputConnection(template.GetOutputPort())
    remesh.SetNumberOfPoints(points)
    seconds = run(remesh)
    for i in range(0 if means_only else remesh.GetOutput().GetNumberOfBlocks()):
        print_row(f"block {i}", remesh.GetOutput().GetBlock(i))
    print_row("linear mean", remesh.GetMeanSurface(), seconds)
    remesh.SetMeanTypeToRigid()
    seconds = run(remesh)
    print_row("rigid mean", remesh.GetMeanSurface(), seconds)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--balance", type=float, default=0.5, help="AreaBalance of the maps, default 0.5")
    parser.add_argument("--points", type=int, default=20000, help="points of the common meshes, default 20,000")
    parser.add_argument("--means", action="store_true", help="print only rows of linear and rigid mean")
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    args = parser.parse_args()
    print("| surface | points | folded | crossing | area | angle | seconds |\n|---|---|---|---|---|---|---|")
    surfaces = [mapped(path, args.balance) for path in args.meshes]
    for path, surface in () if args.means else zip(args.meshes, surfaces):
        print_itself(os.path.splitext(os.path.basename(path))[0], surface, args.points)
    if len(surfaces) > 1 and all(surface.GetPointData().HasArray("Landmarks") for surface in surfaces):
        print_mean(surfaces, args.points, args.means)


if __name__ == "__main__":
    main()
