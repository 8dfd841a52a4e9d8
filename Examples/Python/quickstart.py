#!/usr/bin/python3
"""From a scan to a painted surface: points -> learned mesh -> smooth surface -> picture on it.

Reads a scan (PLY, OFF, PCD, points as text, FreeSurfer, GIFTI, Gu's .m, .conf of the Stanford scans,
OBJ, STL, .vtp or .vtk; only its points are learned from), or makes one, and writes surface.vtp,
surface.glb, surface.obj and quickstart.png. A scan with colors is painted with them if no picture is
given.
"""
import argparse
import os
import sys

from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

from conformalsom import (
    vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkTexturedSurfaceWriter)

from helpers import builtin_figure, pictures, report, scan_colors, scan_files, textures
from helpers.steps import StepFailed, Steps

RESULTS = ("surface.vtp", "surface.glb", "surface.obj", "surface.mtl", "surface.png", "quickstart.png")
OUTPUT = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "quickstart")


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", nargs="?", help="default: a toy bear made by code")
    parser.add_argument("texture", nargs="?",
                        help="PNG or JPEG; default: the scan's own colors, else a painted rosette")
    parser.add_argument("--output", metavar="DIR", default=OUTPUT,
                        help="folder for the results, default build/quickstart")
    parser.add_argument("--overwrite", action="store_true",
                        help="replace existing results in DIR; in the default folder they always are")
    parser.add_argument("--view", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 0, 1),
                        help="from the model to the viewer, default 0 0 1")
    parser.add_argument("--up", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 1, 0),
                        help="what is up in the pictures, default 0 1 0")
    parser.add_argument("--frequency", type=int, default=36,
                        help="of the learned mesh, which has 20 f^2 triangles; default 36")
    parser.add_argument("--surface-frequency", type=int, default=80,
                        help="of the smooth surface; default 80")
    return parser.parse_args()


def prepare(args):
    """Make the folder for the results. Files that may not be ours are not replaced."""
    overwrite = args.overwrite or args.output == OUTPUT
    for path in (os.path.join(args.output, name) for name in RESULTS):
        if not os.path.lexists(path):
            continue
        if not overwrite:
            raise ValueError(f"{path} already exists; use --overwrite or another --output")
        for source in (args.scan, args.texture):
            if source and os.path.realpath(source) == os.path.realpath(path):
                raise ValueError(f"{path} is an input and would be replaced; use another --output")
    os.makedirs(args.output, exist_ok=True)


def scan_source(args, steps):
    """The scan, from a file or made by code."""
    if args.scan:
        scan = scan_files.scan_reader(args.scan)
        steps.run("Read the scan", scan)
        if scan.GetOutput().GetNumberOfPoints() == 0:
            raise ValueError(f"{args.scan}: no points found")
    else:
        scan = vtkTrivialProducer()
        steps.run("Make a scan", scan, lambda: scan.SetOutput(builtin_figure.figure_cloud()))
    return scan


def picture_source(args, steps):
    """The picture to paint with, from a file or made by code."""
    if args.texture:
        picture = scan_files.texture_reader(args.texture)
        steps.run("Read the texture", picture)
    else:
        picture = vtkTrivialProducer()
        steps.run("Paint a texture", picture, lambda: picture.SetOutput(textures.rosette()))
    return picture


def texture_map(surface, args, whole):
    """The filter that lays a texture on a surface, in its middle what the viewer sees first.

    One that shows the whole surface goes all around it, a picture lies on one side.
    """
    painted = vtkSphericalTextureMap()
    painted.SetInputConnection(surface.GetOutputPort())
    painted.SetViewDirection(args.view)
    painted.SetViewUp(args.up)
    if whole:
        painted.SetProjectionToOctahedral()
        painted.SetMargin(0.01)
    return painted


def write(steps, writer, folder, name, *inputs):
    """Write the inputs, one to each port, into a file."""
    for port, source in enumerate(inputs):
        writer.SetInputConnection(port, source.GetOutputPort())
    writer.SetFileName(os.path.join(folder, name))
    steps.run(f"Write {name}", writer, writer.Write)


def main():
    args = arguments()
    prepare(args)
    steps = Steps()
    scan = scan_source(args, steps)
    colors = None if args.texture else scan_colors.colors_of(scan.GetOutputDataObject(0))
    texture = picture_source(args, steps) if colors is None else None

    network = vtkConformalSOM()
    network.SetInputConnection(scan.GetOutputPort())
    network.SetFrequency(args.frequency)
    steps.run("Learn the mesh", network)

    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(network.GetOutputPort())
    surface.SetFrequency(args.surface_frequency)
    steps.run("Build the smooth surface", surface)

    painted = texture_map(surface, args, whole=colors is not None)
    steps.run("Lay the texture", painted)

    mesh = report.measured(steps, "mesh", network, scan)
    result = report.measured(steps, "surface", painted, scan)

    write(steps, vtkXMLPolyDataWriter(), args.output, "surface.vtp", result)
    cut = texture_map(result, args, whole=colors is not None)
    cut.SplitSeamOn()  # for programs that draw each triangle as it is
    steps.run("Cut along the picture", cut)
    if colors is not None:
        texture = scan_colors.baked(cut, scan.GetOutputDataObject(0), colors)
        steps.run("Bake the scan's colors", texture)
    for name in ("surface.glb", "surface.obj"):
        write(steps, vtkTexturedSurfaceWriter(), args.output, name, cut, texture)
    stages = [stage.GetOutputDataObject(0) for stage in (scan, mesh, result, cut, texture)]
    pictures.write_stages(
        os.path.join(args.output, "quickstart.png"), *stages, colors, args.view, args.up)
    report.print_table(*stages[:3], steps.seconds)
    print(f"Results: {os.path.relpath(args.output)}{os.sep}")


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, ValueError, OSError) as error:
        sys.exit(f"quickstart: {error}")
