#!/usr/bin/python3
"""A surface with a handle: learned from points, mapped to a flat torus, and textured without a seam.

The points are on a body that is made by code: a mug, a torus or a body like a vertebra. The surface that is learned
keeps the handle. Its conformal map to a flat torus gives texture coordinates, by which a checkered image is repeated
around the handle and through it. --output writes the surface with its texture coordinates as a .vtp file. --picture
draws the points, the surface with its triangles, and the textured surface side by side.
"""
import argparse
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
from vtkmodules.vtkRenderingCore import vtkTexture

from conformalsom import vtkConformalSOM, vtkGlobalConformalMap, vtkTorusTextureMap
from conformalsom.command import pictures
from conformalsom.command.steps import StepFailed, Steps

from helpers import handle_bodies

PANEL = 480, 420
VIEW, UP = (0.35, -1.0, 0.75), (0.0, 0.0, 1.0)
BODIES = [name for name, (_, handles) in handle_bodies.BODIES.items() if handles == 1]


def arguments():
    """Return the arguments of the program."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--body", choices=BODIES, default="mug", help="default mug")
    parser.add_argument("--points", type=int, default=40000, help="number of points, default 40000")
    parser.add_argument("--noise", type=float, default=0.003, help="of the points, default 0.003")
    parser.add_argument("--neurons", type=int, default=8000, help="points of the surface, default 8000")
    parser.add_argument("--repeats", type=int, default=8, help="copies of the image along the first period, default 8")
    parser.add_argument("--output", metavar="FILE", help="surface with texture coordinates, .vtp")
    parser.add_argument("--picture", metavar="FILE", help="PNG or JPEG")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    if args.points < 1000 or args.neurons < 100 or args.repeats < 1:
        parser.error("--points must be at least 1000, --neurons at least 100, and --repeats at least 1")
    return args


def checkered(size=64):
    """Return an image of four squares, with a dark and a light frame."""
    row, column = np.mgrid[:size, :size]
    dark = (row < size // 2) ^ (column < size // 2)
    colors = np.where(dark[..., None], (45, 95, 140), (245, 225, 180)).astype(np.uint8)
    colors[(row % (size // 2) < 2) | (column % (size // 2) < 2)] = (120, 60, 50)
    image = vtkImageData()
    image.SetDimensions(size, size, 1)
    image.GetPointData().SetScalars(numpy_to_vtk(colors.reshape(-1, 3), deep=True))
    return image


def textured(surface, image):
    """Return an actor that repeats an image on a surface."""
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    texture.RepeatOn()
    actor = pictures.actor_of(surface)
    actor.SetTexture(texture)
    return actor


def main():
    """Learn, map, texture and draw the surface."""
    args = arguments()
    steps = Steps()
    body, _ = handle_bodies.BODIES[args.body]
    cloud = handle_bodies.cloud_of(handle_bodies.surface_of(body), args.points, args.noise)
    learner, conformal, texture, normals = (
        vtkConformalSOM(), vtkGlobalConformalMap(), vtkTorusTextureMap(), vtkPolyDataNormals())
    learner.SetInputData(cloud)
    learner.SetGenusToAsFound()
    learner.SetNumberOfNeurons(args.neurons)
    steps.run("Learn a surface with its handles", learner)
    normals.SetInputConnection(learner.GetOutputPort())
    normals.SplittingOff()
    conformal.SetInputConnection(normals.GetOutputPort())
    steps.run("Map it to a flat torus", conformal)
    figures = conformal.GetOutput().GetFieldData()
    real, imaginary = figures.GetArray("TorusModulus").GetTuple(0)
    texture.SetInputConnection(conformal.GetOutputPort())
    texture.SetRepeats(args.repeats, max(1, round(args.repeats * imaginary)))
    steps.run("Compute texture coordinates", texture)
    print(f"modulus {real:.3f} + {imaginary:.3f} i, mean quasi-conformal error "
          f"{figures.GetArray('MeanQuasiConformalError').GetValue(0):.3f}")
    if args.output:
        writer = vtkXMLPolyDataWriter()
        writer.SetInputConnection(texture.GetOutputPort())
        writer.SetFileName(args.output)
        steps.run(f"Write {args.output}", writer, writer.Write)
    if args.picture:
        camera = pictures.camera_on(cloud, VIEW, UP, PANEL[0] / PANEL[1])
        pictures.write_side_by_side(args.picture, [
            pictures.scene(pictures.cloud_actor(cloud, VIEW), f"{args.points:,} points", camera),
            pictures.scene(pictures.mesh_actor(learner.GetOutput()), "learned with Genus AS_FOUND", camera),
            pictures.scene(textured(texture.GetOutput(), checkered()), "an image repeated on it", camera),
        ], 3 * PANEL[0], PANEL[1])
        print(f"wrote {args.picture}")


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, OSError, ValueError) as error:
        sys.exit(f"handles: {error}")
