#!/usr/bin/python3
"""Compares ConformalSOM with other libraries of PyPI. Prints tables in Markdown.

    pip install open3d pymeshlab xatlas pyshtools libigl potpourri3d
    compare_reconstructions.py --objects superquadric,igea,bunny --scans FOLDER
    compare_reconstructions.py --tables charts,maps,harmonics --objects bean,spot,bunny --scans FOLDER

Libraries that are not installed are named and left out. Open3D needs the system's library libusb-1.0. PYTHONPATH is
that of the build, and Examples/Python.

Tables (--tables), with their measures:
  surfaces    surfaces from points (reconstruction_methods.py). The points are random positions on an object, with
              Gaussian noise of standard deviation s (gaussian), or those of a depth camera (camera). Surfaces are
              compared with the object's triangles, which no method gets. Column "normals given" is "true" for the
              object's exact normals, "own" where the library estimates normals, and "-" for methods without normals.
  charts      texture coordinates (chart_methods.py)
  seams       colors at the two sides of the seams of texture coordinates (chart_methods.py)
  maps        maps to the sphere and to the plane (map_methods.py)
  harmonics   spherical harmonics (harmonics_methods.py)
The first table is for learned points, the others for the object's triangles. Each method runs in a process of its own.
Seconds are those of the processor, on all threads, without imports. MB is the growth of the process's memory.

Columns of surfaces: off, root mean square distance of the surface from the object; p2s, mean square distance of the
object's vertices from the surface; Hausdorff, the largest distance; normals, root mean square angle between the
normals of surface and object, in degrees; pieces, number of connected surfaces; open edges, edges of one triangle.
The object's largest radius is 1. Distances are measured by vtkSurfaceMismatch, or with --tools FOLDER by
compare(reference, model) of a module surface_error.py in FOLDER; both have pairs (points, triangles).
"""
import argparse
import datetime
import itertools
import sys

import numpy as np
from vtkmodules.vtkCommonCore import vtkVersion

from conformalsom import vtkGenusZeroCheck, vtkSurfaceMismatch

import chart_methods
import harmonics_methods
import map_methods
import reconstruction_methods
from compare_smoothing import surface_of
from known_objects import field_value
from measure_scanner_noise import Target
from separate_process import measured, missing, print_header, print_row, rounded, versions

LIBRARIES = {"open3d": "open3d", "pymeshlab": "pymeshlab", "xatlas": "xatlas", "pyshtools": "pyshtools",
             "igl": "libigl", "potpourri3d": "potpourri3d"}  # names for import and for pip


def distances(surface, target, tools):
    """off, p2s and Hausdorff distance of a surface, and the angle of normals in degrees."""
    measure = vtkSurfaceMismatch()
    measure.SetInputData(0, surface_of(*surface))
    measure.SetReferenceData(target.mesh)
    measure.Update()
    square, p2s, hausdorff, normals = (field_value(measure.GetOutput(), name) for name in (
        "MeanSquareSurfaceToPoint", "MeanSquarePointToSurface", "HausdorffDistance", "RootMeanSquareNormalAngle"))
    if tools:
        import surface_error  # pylint: disable=import-outside-toplevel,import-error
        found = surface_error.compare((target.x, target.triangles), surface)
        square, p2s, hausdorff = found["s2p"], found["p2s"], found["hausdorff"]
    return np.sqrt(square), p2s, hausdorff, normals


def pieces_and_open_edges(surface):
    check = vtkGenusZeroCheck()
    check.SetInputData(surface_of(*surface))
    check.Update()
    return [int(field_value(check.GetOutput(), name)) for name in ("NumberOfComponents", "NumberOfBoundaryEdges")]


def print_surfaces(target, cloud, name, arguments):
    kind, s = cloud
    points, _, normals, _ = target.scanned(kind, arguments.points, s)
    for method, library, function, further, has_normals in reconstruction_methods.methods(arguments.depths):
        if missing([library]) or not arguments.matches(method):
            continue
        for given in ("true", "own") if has_normals else ("-",):
            head = name, kind, f"{s:g}", method, given
            try:
                surface, seconds, memory = measured(library, function, points, normals if given == "true" else None,
                                                    *further)
                off, p2s, hausdorff, angle = distances(surface, target, arguments.tools)
            except RuntimeError as error:
                print_row(*head, error)
                continue
            pieces, open_edges = pieces_and_open_edges(surface)
            print_row(*head, rounded(angle), rounded(off), rounded(p2s), rounded(hausdorff), f"{len(surface[1]):,}",
                      f"{pieces:,}", f"{open_edges:,}", f"{seconds:.1f}", f"{memory:,.0f}")


def surfaces(arguments):
    print_header("object", "points", "s", "method", "normals given", "normals", "off", "p2s", "Hausdorff", "triangles",
                 "pieces", "open edges", "seconds", "MB")
    for name in arguments.objects:
        target = Target(name, arguments.scans)
        for kind, s in itertools.product(arguments.kinds, arguments.noise):
            print_surfaces(target, (kind, s), name, arguments)


def meshes(arguments):
    """Name, positions and triangles of each object."""
    for name in arguments.objects:
        target = Target(name, arguments.scans)
        yield name, target.x, target.triangles


TABLES = {"surfaces": surfaces,
          "charts": lambda arguments: chart_methods.print_table(meshes(arguments)),
          "seams": lambda arguments: chart_methods.print_seams(meshes(arguments)),
          "maps": lambda arguments: map_methods.print_table(meshes(arguments)),
          "harmonics": lambda arguments: harmonics_methods.print_table(meshes(arguments), arguments.degrees)}


def words(text):
    return text.split(",")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--tables", type=words, default=["surfaces"], help=f"of {', '.join(TABLES)}; default surfaces")
    parser.add_argument("--objects", type=words, default=["superquadric"], help="names of known_objects.py")
    parser.add_argument("--kinds", type=words, default=["gaussian", "camera"], help="of noise")
    parser.add_argument("--noise", type=lambda text: [float(s) for s in words(text)], default=[0.0, 0.002, 0.01],
                        help="standard deviations, default 0,.002,.01")
    parser.add_argument("--points", type=int, default=40000, help="of each cloud, default 40000")
    parser.add_argument("--depths", type=lambda text: [int(depth) for depth in words(text)], default=[8, 9, 10],
                        help="of Poisson's octree, default 8,9,10")
    parser.add_argument("--degrees", type=lambda text: [int(degree) for degree in words(text)], default=[12, 20, 32],
                        help="of harmonics, default 12,20,32")
    parser.add_argument("--methods", type=words, default=[""], help="only surfaces whose methods have these words")
    parser.add_argument("--scans", default="../shared/data", help="folder of the scans")
    parser.add_argument("--tools", help="folder of surface_error.py")
    arguments = parser.parse_args()
    if arguments.tools:
        sys.path.append(arguments.tools)
    arguments.matches = lambda method: any(word in method for word in arguments.methods)
    print(f"{datetime.date.today()}, VTK {vtkVersion.GetVTKVersion()}, Python {sys.version.split()[0]}, "
          f"{versions(LIBRARIES)}")
    for library in missing(LIBRARIES):
        print(f"{LIBRARIES[library]} is not installed: rows left out")
    for table in arguments.tables:
        TABLES[table](arguments)


if __name__ == "__main__":
    main()
