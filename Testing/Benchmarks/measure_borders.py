#!/usr/bin/python3
"""Measure the borders of surfaces that are learned from parts of objects.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_borders.py [FILE ...]

Cuts each object by planes and by a ball, and learns a surface with Border OPEN from 40,000 random points on the largest
remaining part. The border of this part is known. The unit of length is the spacing of the points, the square root of
the area of the part divided by the number of points. Prints a row for each cut, of the learned surface (CSM) and of the
smooth surface of at least 64,000 points (CSS):

    borders  of the part, and of the surface
    mean     distance from the border of the surface to the known border
    largest  the largest of these distances
    missed   largest distance from the known border to the border of the surface
    beyond   percent of the area of the surface that is farther than two spacings from the part
    p2s      mean square distance from other random points on the part to the surface; the largest radius is 1
    closed   p2s of the closed surface that is learned from the same points
    K        mean ratio of the largest to the smallest stretch of triangles, between the surface and the disk
    flipped  triangles of the disk that are flipped or have no area
"""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints, reference
from vtkmodules.vtkCommonDataModel import (
    vtkGenericCell, vtkPlane, vtkPolyData, vtkSphere, vtkStaticCellLocator)
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData, vtkClipPolyData, vtkFeatureEdges, vtkPolyDataConnectivityFilter, vtkTriangleFilter)

import conformalsom
from helpers import builtin_figure
from planar_distortion import planar_distortion

COUNT = 40000


def plane(normal, offset):
    """The half space behind a plane, at a distance from the origin."""
    function = vtkPlane()
    function.SetNormal(normal)
    function.SetOrigin(offset * np.asarray(normal, float))
    return function, False


def ball(center, radius):
    """The outside of a ball."""
    function = vtkSphere()
    function.SetCenter(center)
    function.SetRadius(radius)
    return function, True


CUTS = {
    "x": plane((1, 0, 0), 0.0),
    "y": plane((0, 1, 0), 0.1),
    "xz": plane((0.6, 0, 0.8), -0.1),
    "ball": ball((0.5, 0.2, 0.6), 0.7),
}


def triangles_of(surface):
    """The triangles of a surface, as ids of points."""
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def points_of(surface):
    """The points of a surface."""
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def part_of(surface, cut):
    """The largest connected part of a surface where the cut is negative."""
    function, keeps_outside = cut
    clip = vtkClipPolyData()
    clip.SetInputData(surface)
    clip.SetClipFunction(function)
    clip.SetInsideOut(not keeps_outside)
    largest = vtkPolyDataConnectivityFilter()
    largest.SetExtractionModeToLargestRegion()
    last = clip
    for step in (vtkTriangleFilter(), largest, vtkCleanPolyData(), vtkTriangleFilter()):
        step.SetInputConnection(last.GetOutputPort())
        last = step
    last.Update()
    return last.GetOutput()


def sampled(x, triangles, count, seed):
    """Random points on triangles, evenly distributed."""
    a, b, c = (x[triangles[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    rng = np.random.default_rng(seed)
    k = rng.choice(len(triangles), count, p=area / area.sum())
    u = rng.random((count, 2))
    u[u.sum(axis=1) > 1] = 1 - u[u.sum(axis=1) > 1]
    return a[k] + u[:, :1] * (b - a)[k] + u[:, 1:] * (c - a)[k]


def border_of(surface):
    """The border of a surface, as lines, and the number of its closed curves."""
    edges = vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ColoringOff()
    curves = vtkPolyDataConnectivityFilter()
    curves.SetInputConnection(edges.GetOutputPort())
    curves.SetExtractionModeToAllRegions()
    curves.Update()
    return edges.GetOutput(), curves.GetNumberOfExtractedRegions()


def on_lines(lines, step):
    """Points on lines, at most a step apart."""
    x, ids, points = points_of(lines), vtkIdList(), []
    lines.GetLines().InitTraversal()
    while lines.GetLines().GetNextCell(ids):
        a, b = x[ids.GetId(0)], x[ids.GetId(1)]
        t = np.linspace(0, 1, 2 + int(np.linalg.norm(b - a) / step))[:, None]
        points.append(a + t * (b - a))
    return np.vstack(points)


def distances(points, data):
    """Distances of points from the cells of a data set."""
    locator, cell, hit = vtkStaticCellLocator(), vtkGenericCell(), [0.0] * 3
    locator.SetDataSet(data)
    locator.BuildLocator()
    i, sub, square = reference(0), reference(0), reference(0.0)
    found = np.empty(len(points))
    for n, x in enumerate(points):
        locator.FindClosestPoint(x, hit, cell, i, sub, square)
        found[n] = float(square) ** 0.5
    return found


def cloud_of(points):
    """A data set of points."""
    data, array = vtkPolyData(), vtkPoints()
    array.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(array)
    return data


def learned(cloud, border):
    """The surface that is learned from points."""
    som = conformalsom.vtkConformalSOM()
    som.SetInputData(cloud)
    som.SetBorder(border)
    som.Update()
    return som.GetOutput()


def row_of(surface, part, spacing, test, closed):
    """The figures of a surface."""
    known, count = border_of(part)
    border, own = border_of(surface)
    away = distances(on_lines(border, spacing / 4), known) / spacing
    missed = distances(on_lines(known, spacing / 4), border).max() / spacing
    x = points_of(surface)
    beyond = (distances(sampled(x, triangles_of(surface), 20000, 9), part) > 2 * spacing).mean()
    p2s = (distances(test, surface) ** 2).mean()
    disk = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))
    disk = disk[:, :2] / (1 + disk[:, 2:])
    k, _, _, flipped = planar_distortion(x, triangles_of(surface), disk)
    return (f"{len(x):,} | {count}, {own} | {away.mean():.2f} | {away.max():.2f} | {missed:.2f} | {100 * beyond:.2f} | "
            f"{p2s:.1e} | {closed} | {k:.3f} | {flipped}")


def measure(name, surface, cuts):
    """Print the rows of an object."""
    scaled = scaled_to_one(surface)
    for cut in cuts:
        part = part_of(scaled, CUTS[cut])
        points, triangles = points_of(part), triangles_of(part)
        cloud = cloud_of(sampled(points, triangles, COUNT, 3))
        test = sampled(points, triangles, 20000, 8)
        area = 0.5 * np.linalg.norm(np.cross(points[triangles[:, 1]] - points[triangles[:, 0]],
                                             points[triangles[:, 2]] - points[triangles[:, 0]]), axis=1).sum()
        spacing = (area / COUNT) ** 0.5
        closed = f"{(distances(test, learned(cloud, 1)) ** 2).mean():.1e}"
        sheet = learned(cloud, 2)
        if sheet.GetFieldData().GetArray("NumberOfBorders").GetValue(0) == 0:
            print(f"| {name} | {cut} | closed |" + " - |" * 10, flush=True)
            continue
        print(f"| {name} | {cut} | CSM | {row_of(sheet, part, spacing, test, closed)} |", flush=True)
        smooth = conformalsom.vtkCurvedSeamlessSurface()
        smooth.SetInputData(sheet)
        smooth.SetFrequency(80)
        smooth.Update()
        print(f"| {name} | {cut} | CSS | {row_of(smooth.GetOutput(), part, spacing, test, '')} |", flush=True)


def scaled_to_one(surface):
    """A surface with its centroid at the origin, and with a largest radius of 1."""
    x = points_of(surface)
    x = x - x.mean(axis=0)
    scaled = vtkPolyData()
    scaled.ShallowCopy(surface)
    scaled.SetPoints(cloud_of(x / np.linalg.norm(x, axis=1).max()).GetPoints())
    return scaled


def parser_of_objects(description):
    """A parser of the arguments that name the objects to measure."""
    parser = argparse.ArgumentParser(description=description.splitlines()[0])
    parser.add_argument("objects", nargs="*", help="files of closed surfaces, besides the built-in objects")
    parser.add_argument("--builtin", default="bear,dancer", help="names of built-in objects, separated by commas")
    return parser


def objects_of(options):
    """(name, surface) of each object that the arguments name."""
    for name in filter(None, options.builtin.split(",")):
        scan = builtin_figure.figure_cloud(figure=getattr(builtin_figure, name))
        yield name, conformalsom.learn(scan).smooth(200000).polydata
    for path in options.objects:
        yield os.path.basename(path).partition(".")[0], conformalsom.read(path).polydata


def main():
    """Measure all objects."""
    parser = parser_of_objects(__doc__)
    parser.add_argument("--cuts", default=",".join(CUTS), help="names of cuts, separated by commas")
    options = parser.parse_args()
    print("| object | cut | surface | points | borders | mean | largest | missed | beyond | p2s | closed | K | flipped |\n|" +
          " --- |" * 13)
    for name, surface in objects_of(options):
        measure(name, surface, options.cuts.split(","))


if __name__ == "__main__":
    main()
