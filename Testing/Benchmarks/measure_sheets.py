#!/usr/bin/python3
"""Measure conformal maps of sheets to the disk.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_sheets.py [FILE ...]

Learns a surface from each scan, makes it smooth with about 100,000 points, and cuts it by a plane through its middle.
The largest part is a sheet. Prints a row for each plane:

    points   of the sheet
    borders  of the sheet; all but the longest are holes
    K        mean ratio of the largest to the smallest stretch of triangles, between the sheet and the disk
    flipped  triangles of the disk that are flipped or have no area
    circle   largest difference from 1 of the distance of a point on the border from the disk's center
    CPU      seconds of the processor for the map
    double   the same for the sheet glued to its mirror image, as a closed surface
"""
import argparse
import os
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData, vtkClipPolyData, vtkPolyDataConnectivityFilter, vtkTriangleFilter)

import conformalsom
from helpers import builtin_figure
from planar_distortion import planar_distortion

PLANES = {"x": (1, 0, 0), "y": (0, 1, 0), "z": (0, 0, 1)}


def half_of(surface, normal):
    """The largest part of a surface on one side of a plane through its middle."""
    plane, clip = vtkPlane(), vtkClipPolyData()
    plane.SetOrigin(np.array(surface.GetBounds()).reshape(3, 2).mean(axis=1))
    plane.SetNormal(normal)
    clip.SetInputData(surface)
    clip.SetClipFunction(plane)
    last = clip
    largest = vtkPolyDataConnectivityFilter()
    largest.SetExtractionModeToLargestRegion()
    for step in (vtkTriangleFilter(), largest, vtkCleanPolyData()):
        step.SetInputConnection(last.GetOutputPort())
        last = step
    last.Update()
    return last.GetOutput()


def timed(filter_):
    """Seconds of the processor that a filter takes."""
    start = time.process_time()
    filter_.Update()
    return time.process_time() - start


def doubled(x, triangles, on_border):
    """The sheet glued to its mirror image."""
    mirror = np.arange(len(x))
    mirror[~on_border] = len(x) + np.arange((~on_border).sum())
    both = np.vstack([triangles, mirror[triangles][:, ::-1]])
    return np.vstack([x, x[~on_border]]), both


def measure(name, surface):
    """Print the rows of a surface."""
    for axis, normal in PLANES.items():
        sheet = half_of(surface, normal)
        check = conformalsom.vtkGenusZeroCheck()
        check.SetInputData(sheet)
        check.Update()
        borders = int(check.GetOutput().GetFieldData().GetArray("NumberOfBoundaryLoops").GetValue(0))
        mapped = conformalsom.vtkGlobalConformalMap()
        mapped.SetInputData(sheet)
        seconds = timed(mapped)
        output = mapped.GetOutput()
        x = vtk_to_numpy(output.GetPoints().GetData())
        triangles = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        disk = vtk_to_numpy(output.GetPointData().GetArray("DiskPosition"))
        on_border = vtk_to_numpy(output.GetPointData().GetArray("SpherePosition"))[:, 2] == 0.0
        k, _, _, flipped = planar_distortion(x, triangles, disk)
        circle = np.abs(np.linalg.norm(disk[on_border], axis=1) - 1.0).max()
        whole = "-"
        if borders == 1:
            start = time.process_time()
            conformalsom.conformal_map(doubled(x, triangles, on_border))
            whole = f"{time.process_time() - start:.2f}"
        print(f"| {name} | {axis} | {len(x):,} | {borders} | {k:.4f} | {flipped} | {circle:.0e} | {seconds:.2f} | {whole} |",
              flush=True)


def main():
    """Measure all scans."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scans", nargs="*", help="files of scans, besides the built-in objects")
    options = parser.parse_args()
    print("| scan | plane | points | borders | K | flipped | circle | CPU | double, CPU |\n|" + " --- |" * 9)
    for name in ("bear", "dancer"):
        scan = builtin_figure.figure_cloud(figure=getattr(builtin_figure, name))
        measure(name, conformalsom.learn(scan).smooth(100000).polydata)
    for path in options.scans:
        measure(os.path.basename(path).partition(".")[0], conformalsom.learn(path).smooth(100000).polydata)


if __name__ == "__main__":
    main()
