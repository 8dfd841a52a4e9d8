#!/usr/bin/python3
"""Which smooth surface over one learned mesh comes closest to the scan?

Learns a mesh from a scan (in any format that quickstart.py opens; default: a toy bear made by
code) and prints, side by side: one step of VTK's subdivision filters, PN triangles, and the curved
seamless surface with every DomeHeight.

--held-out judges them by points that were not learned: half of the scan's points by the other half, the
vertices that a decimation makes of it by all its points, and as many random points by the rest.
"""
import argparse
import sys

import numpy as np
from vtkmodules.vtkFiltersModeling import vtkButterflySubdivisionFilter, vtkLoopSubdivisionFilter

from conformalsom import vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSurfaceMismatch
from conformalsom.command import scan_files

from compare_lattices import LATTICES, triangulated
from helpers import builtin_figure, paper_models
from helpers.clouds import cloud_of, only_points_of, points_of

DOME_HEIGHTS = ("None", "Published", "Scaled", "Curvature", "Fitted")
RIVALS = ("CSS None", "Loop", "butterfly", "PN triangles")


def subdivided(mesh, filter_class):
    """One step of a subdivision filter."""
    subdivision = filter_class()
    subdivision.SetInputData(mesh)
    subdivision.SetNumberOfSubdivisions(1)
    subdivision.Update()
    return subdivision.GetOutput()


def curved(mesh, frequency, dome_height, cloud, vertex_shift=None):
    """The curved seamless surface, and the mean angle between normals across the mesh's edges."""
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputData(mesh)
    surface.SetCloudData(cloud)
    surface.SetFrequency(frequency)
    getattr(surface, "SetDomeHeightTo" + dome_height)()
    if vertex_shift is not None:
        surface.SetVertexShift(vertex_shift)
    surface.Update()
    jumps = [0.0, 0.0]
    surface.GetMap().GetNormalJumps(jumps)
    return surface.GetOutput(), jumps[0]


def mean_square_distance(cloud, surface):
    """p2s: from the cloud's points to the surface; the cloud's largest radius is 1."""
    mismatch = vtkSurfaceMismatch()
    mismatch.SetInputData(0, surface)
    mismatch.SetInputData(1, cloud)
    mismatch.Update()
    return mismatch.GetOutput().GetFieldData().GetArray("MeanSquarePointToSurface").GetValue(0)


def compared(cloud, frequency=36, surface_frequency=80, mesh_type="Geodesic", judges=None):
    """For each surface by name: its number of points, p2s, and mean jump of normals or None. p2s is of
    other points than those learned where there are judges."""
    judges = judges or cloud
    network = vtkConformalSOM()
    network.SetInputData(only_points_of(cloud))
    getattr(network, "SetMeshTypeTo" + mesh_type)()
    network.SetNumberOfNeurons(10 * frequency**2 + 2)
    network.Update()
    mesh = network.GetOutput()
    surfaces = {"learned mesh": (mesh, None),
                "butterfly": (subdivided(mesh, vtkButterflySubdivisionFilter), None),
                "Loop": (subdivided(mesh, vtkLoopSubdivisionFilter), None),
                "PN triangles": curved(mesh, surface_frequency, "Curvature", cloud, 0.0)}
    for dome_height in DOME_HEIGHTS:
        surfaces["CSS " + dome_height] = curved(mesh, surface_frequency, dome_height, cloud)
    return {name: (surface.GetNumberOfPoints(), mean_square_distance(judges, surface), jump)
            for name, (surface, jump) in surfaces.items()}


def held_out(scan):
    """By name: the points to learn, and those to judge by."""
    scan = triangulated(scan)
    points = np.random.RandomState(1).permutation(points_of(scan))
    middle, count, splits = len(points) // 2, len(points) // 4, {}
    splits["half / half"] = points[:middle], points[middle:]
    if scan.GetNumberOfPolys() > 0:
        few = points_of(paper_models.decimated(scan, min(paper_models.FEW, scan.GetNumberOfPolys() // 2)))
        count = len(few)
        splits["decimated / all"] = few, points
    splits[f"{count:,} / rest"] = points[:count], points[count:]
    return {name: tuple(map(cloud_of, split)) for name, split in splits.items()}


def print_held_out(scan, frequency, surface_frequency):
    splits = held_out(scan)
    for lattice in LATTICES:
        columns = [{name: p2s for name, (_, p2s, _) in
                    compared(cloud, frequency, surface_frequency, lattice, judges).items()}
                   for cloud, judges in splits.values()]
        print(f"{lattice:<16}" + "".join(f"{split:>18}" for split in splits))
        for name in columns[0]:
            print(f"{name:<16}" + "".join(f"{column[name]:>18.2e}" for column in columns))
        print(f"{'default / best':<16}" + "".join(
            f"{column['CSS Curvature'] / min(column[name] for name in RIVALS):>18.2f}"
            for column in columns) + "\n", flush=True)
    print("Columns: points learned / points judged by. p2s: mean square distance from the latter to the\n"
          "surface; their largest radius is 1. default / best: CSS Curvature over the least of\n"
          + ", ".join(RIVALS) + ".")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", nargs="?", help="default: a toy bear made by code")
    parser.add_argument("--frequency", type=int, default=36, help="of the learned mesh, default 36")
    parser.add_argument("--surface-frequency", type=int, default=80,
                        help="of the curved surfaces, default 80")
    parser.add_argument("--held-out", action="store_true",
                        help="judge by points that were not learned, on both lattices")
    args = parser.parse_args()
    if args.scan:
        reader = scan_files.scan_reader(args.scan)
        reader.Update()
        cloud = reader.GetOutput()
    else:
        cloud = builtin_figure.figure_surface() if args.held_out else builtin_figure.figure_cloud()
    if args.held_out:
        print_held_out(cloud, args.frequency, args.surface_frequency)
        return
    rows = compared(cloud, args.frequency, args.surface_frequency)
    butterfly = rows["butterfly"][1]
    print(f"{'':<16}{'points':>10}{'p2s':>11}{'/ butterfly':>13}{'normals jump':>14}")
    for name, (points, p2s, jump) in rows.items():
        angle = f"{jump:.2f} deg" if jump else ""
        print(f"{name:<16}{points:>10,}{p2s:>11.2e}{p2s / butterfly:>13.2f}{angle:>14}")
    print("p2s: mean square distance from the scan's points to the surface; their largest radius is 1.\n"
          "normals jump: mean angle between the surface's normals on both sides of the mesh's edges.")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError) as error:
        sys.exit(f"compare_surfaces: {error}")
