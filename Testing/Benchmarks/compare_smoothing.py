#!/usr/bin/python3
"""Prints how close surfaces of several methods are to an object, from the same points with noise.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/compare_smoothing.py
    ... compare_smoothing.py --objects igea,bunny --noise .001,.005,.01 --scans ../shared/data

Points are uniform on an object, with Gaussian noise of standard deviation s along each axis. Methods:
  default               vtkCurvedSeamlessSurface over the mesh of vtkConformalSOM, all properties by default
  mesh                  that mesh itself
  mesh, Loop            one step of vtkLoopSubdivisionFilter on that mesh
  mesh, Taubin          Taubin's smoothing (1995) of that mesh, 10 passes of lambda 0.5, mu -0.53
  mesh, sinc            vtkWindowedSincPolyDataFilter on that mesh, 20 iterations, pass band 0.1
  mesh, bilateral       bilateral filtering of normals (Zheng 2011) on that mesh
  rough, ...            the same filters on the mesh of vtkConformalSOM with Smoothness 0.01, which follows the noise
  Poisson, depth D      screened Poisson reconstruction (Kazhdan 2013) from the points with the object's exact normals
Poisson needs the Python package pymeshlab. Without pymeshlab, its rows are left out.

Columns: off, the root mean square distance of the surface from the object; p2s, the mean square distance of the
object's vertices from the surface; normals, the root mean square angle between the normals of surface and object, in
degrees; curvature, the root mean square difference of the mean curvatures (curvature_error.py); triangles; pieces,
the number of connected surfaces; seconds of the processor, with learning. The object's largest radius is 1.
"""
import argparse
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter, vtkWindowedSincPolyDataFilter
from vtkmodules.vtkFiltersModeling import vtkLoopSubdivisionFilter

from conformalsom import vtkConformalSOM

from curvature_error import Curvature, curvature_error
from helpers.clouds import cloud_of, points_of, vtk_points
from known_objects import (facet_normals, known_object, largest_radius, mismatch, smooth_surface, triangles_of)


def surface_of(x, triangles):
    cells, surface = vtkCellArray(), vtkPolyData()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, np.int64).ravel(), deep=True))
    surface.SetPoints(vtk_points(x))
    surface.SetPolys(cells)
    return surface


def learned(points, smoothness=None):
    network = vtkConformalSOM()
    network.SetInputData(cloud_of(points))
    if smoothness is not None:
        network.SetSmoothness(smoothness)
    network.Update()
    return network.GetOutput()


def loop(mesh):
    subdivision = vtkLoopSubdivisionFilter()
    subdivision.SetInputData(mesh)
    subdivision.SetNumberOfSubdivisions(1)
    subdivision.Update()
    return subdivision.GetOutput()


def taubin(mesh, passes=10, shrink=0.5, inflate=-0.53):
    """Taubin's lambda | mu smoothing (1995). Defaults are those of pymeshlab."""
    x, triangles = points_of(mesh), triangles_of(mesh)
    one, other = np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]).T
    degrees = np.bincount(one, minlength=len(x))[:, None]
    for factor in (shrink, inflate) * passes:
        x = x + factor * (added(one, x[other], len(x)) / degrees - x)
    return surface_of(x, triangles)


def sinc(mesh, iterations=20, band=0.1):
    smoothing = vtkWindowedSincPolyDataFilter()
    smoothing.SetInputData(mesh)
    smoothing.SetNumberOfIterations(iterations)
    smoothing.SetPassBand(band)
    smoothing.NormalizeCoordinatesOn()
    smoothing.Update()
    return smoothing.GetOutput()


def sides(triangles):
    """Pairs of triangles on the two sides of each edge of a closed mesh."""
    edges = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    order = np.lexsort((edges[:, 1], edges[:, 0])) % len(triangles)
    return order[::2], order[1::2]


def added(ids, values, count):
    """Sum of the values with each id in [0, count)."""
    return np.column_stack([np.bincount(ids, column, count) for column in values.T])


def bilateral(mesh, width=0.35, normal_passes=20, vertex_passes=10):
    """Bilateral filtering of facet normals, then of vertices (Zheng et al. 2011, local scheme).

    A neighbor shares an edge. Its weight is area exp(-|c - c'|^2 / (2 a^2)) exp(-|n - n'|^2 / (2 width^2)), for
    centroids c, normals n, and the mean distance a of centroids. width 0.35 is recommended there for moderate noise.
    """
    x, triangles = points_of(mesh), triangles_of(mesh)
    normals, areas = facet_normals(x, triangles)
    left, right = sides(triangles)
    one, other = np.concatenate([left, right]), np.concatenate([right, left])
    centroids = x[triangles].mean(axis=1)
    gaps = np.linalg.norm(centroids[one] - centroids[other], axis=1)
    near = areas[other] * np.exp(-0.5 * (gaps / gaps.mean())**2)
    for _ in range(normal_passes):
        squares = ((normals[one] - normals[other])**2).sum(axis=1)
        weights = near * np.exp(-0.5 * squares / width**2)
        normals = areas[:, None] * normals + added(one, weights[:, None] * normals[other], len(triangles))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
    corners = triangles.ravel()
    degrees = np.bincount(corners, minlength=len(x))[:, None]
    for _ in range(vertex_passes):
        heights = ((x[triangles].mean(axis=1)[:, None] - x[triangles]) * normals[:, None]).sum(axis=2)
        x = x + added(corners, (heights[:, :, None] * normals[:, None]).reshape(-1, 3), len(x)) / degrees
    return surface_of(x, triangles)


def poisson(points, normals, depth):
    """Screened Poisson reconstruction by pymeshlab, or None without this package."""
    try:
        import pymeshlab  # pylint: disable=import-outside-toplevel
    except ImportError:
        return None
    meshes = pymeshlab.MeshSet()
    meshes.add_mesh(pymeshlab.Mesh(vertex_matrix=points, v_normals_matrix=normals))
    meshes.generate_surface_reconstruction_screened_poisson(depth=depth, preclean=False)
    result = meshes.current_mesh()
    return surface_of(result.vertex_matrix(), result.face_matrix())


def timed(function, *arguments):
    begin = time.process_time()
    result = function(*arguments)
    return result, time.process_time() - begin


def surfaces(points, normals, depths):
    """Name, surface and seconds of each method."""
    mesh, learning = timed(learned, points)
    smooth, seconds = timed(smooth_surface, mesh)
    yield "default", smooth, learning + seconds
    yield "mesh", mesh, learning
    rough, rough_learning = timed(learned, points, 0.01)
    yield "rough", rough, rough_learning
    for prefix, base, before in (("mesh", mesh, learning), ("rough", rough, rough_learning)):
        for name, method in (("Loop", loop), ("Taubin", taubin), ("sinc", sinc), ("bilateral", bilateral)):
            surface, seconds = timed(method, base)
            yield f"{prefix}, {name}", surface, before + seconds
    for depth in depths:
        surface, seconds = timed(poisson, points, normals, depth)
        if surface is not None:
            yield f"Poisson, depth {depth}", surface, seconds


def pieces(surface):
    regions = vtkPolyDataConnectivityFilter()
    regions.SetInputData(surface)
    regions.SetExtractionModeToAllRegions()
    regions.Update()
    return regions.GetNumberOfExtractedRegions()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--objects", default="superquadric")
    parser.add_argument("--noise", default=".001,.005,.01")
    parser.add_argument("--points", type=int, default=0, help="default 40,000 of an equation, 60,000 of a scan")
    parser.add_argument("--depths", default="8,9", help="of Poisson's octree")
    parser.add_argument("--scans", default="../shared/data", help="folder of the scans")
    arguments = parser.parse_args()
    print(f"{'object':13}{'s':>7}  {'method':20}{'normals':>9}{'off':>10}{'p2s':>10}{'curvature':>11}{'triangles':>11}"
          f"{'pieces':>8}{'seconds':>9}")
    for name in arguments.objects.split(","):
        truth = known_object(name, arguments.scans, arguments.points)
        mesh, normals = truth.mesh(), truth.normals(truth.points)
        radius = largest_radius(points_of(mesh))
        mesh.SetPoints(vtk_points(points_of(mesh) / radius))
        curvature = Curvature(mesh)
        for s in map(float, arguments.noise.split(",")):
            points = truth.points / radius + s * np.random.default_rng(101).normal(size=truth.points.shape)
            for method, surface, seconds in surfaces(points, normals, map(int, arguments.depths.split(","))):
                off, p2s, angle = mismatch(surface, mesh)
                print(f"{name:13}{s:7.4f}  {method:20}{angle:9.2f}{off:10.2e}{p2s:10.2e}"
                      f"{curvature_error(surface, curvature):11.2f}{surface.GetNumberOfPolys():11,}{pieces(surface):8}"
                      f"{seconds:9.1f}", flush=True)


if __name__ == "__main__":
    main()
