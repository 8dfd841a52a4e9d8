#!/usr/bin/python3
"""Maps of a body: its heights in a projection, with longitudes and latitudes.

The model is closed and without handles, of any format that quickstart.py opens; without one, a comet of two
lobes is made by code. It is mapped to the sphere unless it has a map, its longitudes and latitudes are found,
and its heights over a reference ellipsoid are drawn as an image, blue for low and red for high, beside which a
world file says where its pixels lie. --picture draws the body with its graticule, the map, and the map put
back on the body, side by side. The coordinates are those of the map and no others: see vtkBodyMap.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOImage import vtkPNGWriter

from conformalsom import vtkBodyMap, vtkBodyMapImage, vtkGlobalConformalMap
from conformalsom.command import map_picture, pictures
from conformalsom.command.steps import StepFailed, Steps

from helpers import builtin_figure, mapped_models
from helpers.builtin_figure import ellipsoid
from helpers.world_file import write_world_file

PROJECTIONS = ["Equirectangular", "LambertAzimuthal", "Mollweide", "PeirceQuincuncial", "Mercator"]
INK, PAPER = np.array([40, 44, 52]), 255
PANEL = 480, 360
VIEW = (1.0, -0.2, 0.8)

# Two lobes and their neck, a boulder and two pits: center, radii, width of the seam.
COMET = [
    (ellipsoid((0.0, -0.42, 0.0), (0.62, 0.46, 0.55)), 0.0),
    (ellipsoid((0.08, 0.52, 0.05), (0.42, 0.44, 0.40)), 0.0),
    (ellipsoid((0.02, 0.08, 0.0), (0.20, 0.22, 0.22)), 0.12),
    (ellipsoid((0.40, 0.70, 0.20), (0.12, 0.12, 0.10)), 0.05),
]
PITS = [ellipsoid((-0.25, -0.52, 0.52), (0.20, 0.18, 0.14)), ellipsoid((0.10, 0.62, 0.46), (0.14, 0.13, 0.10))]


def comet(p):
    """Signed distance to the comet; negative inside."""
    return np.maximum(builtin_figure.union(COMET)(p), -np.minimum(PITS[0](p), PITS[1](p)))


def world_file_of(path):
    """The file beside a PNG file that says where its pixels lie."""
    return os.path.splitext(path)[0] + ".pgw"


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="?", help="a closed model; default: a comet made by code")
    parser.add_argument("--axis", nargs=3, type=float, default=(0.0, 0.0, 1.0), metavar=("X", "Y", "Z"),
                        help="of rotation, to the north; default 0 0 1")
    parser.add_argument("--center", nargs=3, type=float, metavar=("X", "Y", "Z"),
                        help="a point of the axis; default: the middle of the model's box")
    parser.add_argument("--projection", choices=PROJECTIONS, default=PROJECTIONS[0],
                        help=f"of the sphere, default {PROJECTIONS[0]}")
    parser.add_argument("--balance", type=float, default=0.5,
                        help="AreaBalance of a map that is made; 0 keeps angles, default 0.5")
    parser.add_argument("--width", type=int, default=1600, help="of the image in pixels, default 1600")
    parser.add_argument("--output", metavar="FILE", default="body_map.png", help="default body_map.png")
    parser.add_argument("--picture", metavar="FILE", help="to draw body and map side by side, PNG or JPEG")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    written = [path for path in (args.output, world_file_of(args.output), args.picture) if path]
    if len(set(map(os.path.realpath, written))) < len(written):
        parser.error(f"{', '.join(written)}: the map, its world file and the picture must be different files")
    for path in written:
        if os.path.lexists(path):
            parser.error(f"{path} already exists")
    if args.width < 16:
        parser.error("--width must be at least 16")
    return args


def mapped(args, steps):
    if args.model:
        return mapped_models.read(args.model, args.balance, steps)
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(builtin_figure.zero_set(comet))
    conformal.SetAreaBalance(args.balance)
    steps.run("Map a comet to the sphere", conformal)
    return conformal.GetOutput()


def colored(heights, largest):
    """Bytes of 3 colors: red at the largest height, blue at its negative."""
    return map_picture.diverging(heights / largest).astype(np.uint8)


def painted(chart, largest):
    """The map in colors, its graticule on it, as a vtkImageData."""
    arrays = chart.GetPointData()
    colors = colored(vtk_to_numpy(arrays.GetArray("Height")), largest)
    lines = vtk_to_numpy(arrays.GetArray("Graticule")) > 0
    colors[lines] = (colors[lines] + INK) // 2
    colors[vtk_to_numpy(arrays.GetArray("OutsideSurface")) > 0] = PAPER
    image = vtkImageData()
    image.CopyStructure(chart)
    image.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    return image


def body_scene(surface, graticule, label, largest=None):
    """The body with its graticule; with heights in colors where largest is given."""
    size = np.array(surface.GetBounds()).reshape(3, 2)
    camera = pictures.camera_on(surface, VIEW, (0.0, 0.0, 1.0), PANEL[0] / PANEL[1])
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.Update()
    shaded = normals.GetOutput()
    actor = pictures.actor_of(shaded)
    if largest:
        shaded.GetPointData().SetScalars(
            numpy_to_vtk(colored(vtk_to_numpy(shaded.GetPointData().GetArray("Height")), largest), deep=True))
        actor.GetMapper().ScalarVisibilityOn()
    renderer = pictures.scene(actor, label, camera)
    lines = pictures.actor_of(graticule)
    lines.GetProperty().BackfaceCullingOff()
    lines.GetProperty().SetColor(INK / 255.0)
    lines.GetProperty().LightingOff()
    lines.GetProperty().SetLineWidth(1.2 * pictures.FINER)
    # Toward the viewer a little, or triangles would hide half of every line.
    toward = np.array(camera.GetDirectionOfProjection()) * -0.004 * np.ptp(size, axis=1).max()
    lines.SetPosition(toward)
    renderer.AddActor(lines)
    return renderer


def main():
    args = arguments()
    steps = Steps()
    surface = mapped(args, steps)
    body = vtkBodyMap()
    body.SetInputData(surface)
    body.SetCenter(args.center or np.array(surface.GetBounds()).reshape(3, 2).mean(axis=1))
    body.SetRotationAxis(args.axis)
    steps.run("Find longitudes and latitudes", body)
    heights = vtk_to_numpy(body.GetOutput().GetPointData().GetArray("Height"))
    largest = max(np.abs(heights).max(), np.finfo(float).tiny)
    chart = vtkBodyMapImage()
    chart.SetInputConnection(body.GetOutputPort())
    chart.SetArrayName("Height")
    getattr(chart, f"SetProjectionTo{args.projection}")()
    square = args.projection in ("PeirceQuincuncial", "Mercator")
    chart.SetImageSize(args.width, args.width if square else args.width // 2)
    chart.SetGraticuleSpacing(15.0)
    steps.run(f"Draw its map ({args.projection})", chart)
    image = painted(chart.GetOutput(), largest)
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.SetFileName(args.output)
    steps.run(f"Write {args.output}", writer, writer.Write)
    write_world_file(image, world_file_of(args.output))
    print(f"heights from {heights.min():.4g} to {heights.max():.4g}")
    if args.picture:
        aspect = PANEL[0] / PANEL[1]
        pictures.write_side_by_side(args.picture, [
            body_scene(body.GetOutput(0), body.GetOutput(1), "the body and its graticule"),
            pictures.image_scene(image, f"heights, {args.projection}", aspect),
            body_scene(body.GetOutput(0), body.GetOutput(1), "and back on the body", largest),
        ], 3 * PANEL[0], PANEL[1])
        print(f"wrote {args.picture}")


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, OSError, ValueError) as error:
        sys.exit(f"body_map: {error}")
