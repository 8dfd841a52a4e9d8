#!/usr/bin/python3
"""From a scan to a painted surface: points -> learned mesh -> smooth surface -> picture on it.

Reads a scan (.ply .obj .stl .vtp .vtk .pts .xyz; only its points are learned from), or makes one,
and writes surface.vtp, surface.glb, surface.obj and quickstart.png.
"""
import argparse
import os
import sys

from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from conformalsom import (
    vtkConformalDistortion, vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap,
    vtkSurfaceMismatch, vtkTexturedSurfaceWriter)

import builtin_figure
import pictures
import scan_files
import textures
from steps import StepFailed, Steps

BUILD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "build")


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", nargs="?", help="default: a toy bear made by code")
    parser.add_argument("texture", nargs="?", help="PNG or JPEG; default: a painted rosette")
    parser.add_argument("--output", metavar="DIR", default=os.path.join(BUILD, "quickstart"),
                        help="folder for the results, default build/quickstart")
    parser.add_argument("--view", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 0, 1),
                        help="from the model to the viewer, default 0 0 1")
    parser.add_argument("--up", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 1, 0),
                        help="what is up in the pictures, default 0 1 0")
    parser.add_argument("--frequency", type=int, default=36,
                        help="of the learned mesh, which has 20 f^2 triangles; default 36")
    parser.add_argument("--surface-frequency", type=int, default=80,
                        help="of the smooth surface; default 80")
    return parser.parse_args()


def sources(args, steps):
    """The scan and the texture, from files or made by code."""
    if args.scan:
        scan = scan_files.reader_for(args.scan, scan_files.SCAN_READERS)
        steps.run("Read the scan", scan)
    else:
        scan = vtkTrivialProducer()
        steps.run("Make a scan", scan, lambda: scan.SetOutput(builtin_figure.figure_cloud()))
    if args.texture:
        texture = scan_files.reader_for(args.texture, scan_files.TEXTURE_READERS)
        steps.run("Read the texture", texture)
    else:
        texture = vtkTrivialProducer()
        steps.run("Paint a texture", texture, lambda: texture.SetOutput(textures.rosette()))
    return scan, texture


def write(steps, writer, folder, name, *inputs):
    """Write the inputs, one to each port, into a file."""
    for port, source in enumerate(inputs):
        writer.SetInputConnection(port, source.GetOutputPort())
    writer.SetFileName(os.path.join(folder, name))
    steps.run(f"Write {name}", writer, writer.Write)


def measure(steps, name, surface, scan):
    """Field data of the surface's distance to the scan and of its map's distortion."""
    mismatch = vtkSurfaceMismatch()
    mismatch.SetInputConnection(0, surface.GetOutputPort())
    mismatch.SetInputConnection(1, scan.GetOutputPort())
    distortion = vtkConformalDistortion()
    distortion.SetInputConnection(mismatch.GetOutputPort())
    steps.run(f"Measure the {name}", mismatch)
    steps.run(f"Distortion of the {name}", distortion)
    return distortion.GetOutput().GetFieldData()


def draw(path, stages, args):
    """The cloud, the mesh, the surface and the painted surface, side by side."""
    scan, mesh, surface, image = stages
    camera = pictures.camera_on(scan, args.view, args.up, aspect=0.8)
    scenes = [
        pictures.scene(pictures.cloud_actor(scan, args.view),
                       f"Scan: {scan.GetNumberOfPoints():,} points"),
        pictures.scene(pictures.mesh_actor(mesh),
                       f"Learned mesh: {mesh.GetNumberOfPolys():,} triangles"),
        pictures.scene(pictures.actor_of(surface),
                       f"Smooth surface: {surface.GetNumberOfPolys():,} triangles"),
        pictures.scene(pictures.textured_actor(surface, image), "Painted surface"),
    ]
    pictures.write_side_by_side(path, scenes, camera, 1600, 500)


def print_table(scan, models, seconds):
    """Sizes, seconds, errors and distortion. models: name -> (surface, its figures)."""
    print(f"\n{'':<16}{'points':>10}{'triangles':>11}{'p2s':>10}{'nv':>10}{'s2p':>10}{'angle':>9}")
    print(f"{'scan':<16}{scan.GetNumberOfPoints():>10,}{scan.GetNumberOfPolys():>11,}")
    for name, (surface, figures) in models.items():
        p2s, nv, s2p, angle = (figures.GetArray(array).GetValue(0) for array in (
            "MeanSquarePointToSurface", "MeanSquarePointToVertex", "MeanSquareSurfaceToPoint",
            "MeanAngleDistortion"))
        print(f"{name:<16}{surface.GetNumberOfPoints():>10,}{surface.GetNumberOfPolys():>11,}"
              f"{p2s:>10.2e}{nv:>10.2e}{s2p:>10.2e}{angle:>8.2f}d")
    print("p2s, nv, s2p: mean square distance from the scan's points to the model, from them to its\n"
          "nearest vertex, and from the model to the scan; the scan's largest radius is 1.\n"
          "angle: mean change of a triangle's angles on the way to the sphere, in degrees.\n"
          f"{sum(seconds.values()):.1f} s in all.")


def main():
    args = arguments()
    os.makedirs(args.output, exist_ok=True)
    steps = Steps()
    scan, texture = sources(args, steps)

    network = vtkConformalSOM()
    network.SetInputConnection(scan.GetOutputPort())
    network.SetFrequency(args.frequency)
    steps.run("Learn the mesh", network)

    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(network.GetOutputPort())
    surface.SetFrequency(args.surface_frequency)
    steps.run("Build the smooth surface", surface)

    painted = vtkSphericalTextureMap()
    painted.SetInputConnection(surface.GetOutputPort())
    painted.SetViewDirection(args.view)
    painted.SetViewUp(args.up)
    steps.run("Lay the texture", painted)

    figures = {name: (model.GetOutput(), measure(steps, name, model, scan))
               for name, model in (("mesh", network), ("surface", painted))}

    write(steps, vtkXMLPolyDataWriter(), args.output, "surface.vtp", painted)
    for name in ("surface.glb", "surface.obj"):
        write(steps, vtkTexturedSurfaceWriter(), args.output, name, painted, texture)
    stages = [stage.GetOutputDataObject(0) for stage in (scan, network, painted, texture)]
    path = os.path.join(args.output, "quickstart.png")
    draw(path, stages, args)
    print_table(stages[0], figures, steps.seconds)


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, ValueError, OSError) as error:
        sys.exit(f"quickstart: {error}")
