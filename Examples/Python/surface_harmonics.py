#!/usr/bin/python3
"""The spherical harmonics of a closed model, and the surfaces that few of them make.

The model is closed and without handles, of any format that quickstart.py opens. It is mapped to the sphere
unless it has a map. How close harmonics up to some degrees come to it is printed, as the root mean square
distance with a largest radius of 1, and the coefficients are written in the format of SPHARM-PDM (.coef).
--align writes them of map and surface turned along the axes of the ellipsoid of degree 1, to compare models.
"""
import argparse
import os
import sys

from conformalsom import vtkSPHARMCoefficientWriter, vtkSurfaceHarmonics
from conformalsom.command import pictures
from conformalsom.command.steps import StepFailed, Steps

from helpers import mapped_models

PANEL = 320, 420


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", help="a closed model")
    parser.add_argument("--degrees", nargs="+", type=int, default=[4, 12, 20, 60], metavar="L",
                        help="largest degrees, each from 0 to 256; default 4 12 20 60")
    parser.add_argument("--align", action="store_true", help="coefficients along the axes of the ellipsoid of degree 1")
    parser.add_argument("--balance", type=float, default=0.5,
                        help="AreaBalance of a map that is made; 0 keeps angles, default 0.5")
    parser.add_argument("--output", metavar="FILE", help="coefficients of the largest degree; default MODEL.coef")
    parser.add_argument("--picture", metavar="FILE", help="to draw the surfaces side by side, PNG or JPEG")
    parser.add_argument("--view", nargs=3, type=float, default=(0.0, 0.0, 1.0), metavar=("X", "Y", "Z"),
                        help="of the picture: the side that faces us, default 0 0 1")
    parser.add_argument("--up", nargs=3, type=float, default=(0.0, 1.0, 0.0), metavar=("X", "Y", "Z"),
                        help="default 0 1 0")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    args.output = args.output or mapped_models.name_of(args.model) + ".coef"
    for path in (args.output, args.picture):
        if path and os.path.lexists(path):
            parser.error(f"{path} already exists")
    if not all(0 <= degree <= 256 for degree in args.degrees):
        parser.error("--degrees must be from 0 to 256")
    return args


def harmonics_of(mapped, degree):
    harmonics = vtkSurfaceHarmonics()
    harmonics.SetInputData(mapped)
    harmonics.SetDegree(degree)
    return harmonics


def scene_of(surface, label, args):
    camera = pictures.camera_on(surface, args.view, args.up, PANEL[0] / PANEL[1])
    return pictures.scene(pictures.actor_of(surface), label, camera)


def main():
    args = arguments()
    steps = Steps()
    mapped = mapped_models.read(args.model, args.balance, steps)
    radius = mapped_models.largest_radius(mapped)
    made = {}
    for degree in sorted(set(args.degrees)):
        made[degree] = harmonics_of(mapped, degree)
        steps.run(f"Harmonics up to degree {degree}", made[degree])
    print("degree  distance")
    for degree, harmonics in made.items():
        distance = mapped_models.figure(harmonics.GetOutput(), "RootMeanSquareDistance")
        print(f"{degree:6}  {distance / radius:.3g}")
    largest = made[max(made)]
    if args.align:
        largest = harmonics_of(mapped, max(made))
        largest.SetAlignmentToMapAndSurface()
        steps.run("Align", largest)
    writer = vtkSPHARMCoefficientWriter()
    writer.SetInputConnection(largest.GetOutputPort(1))
    writer.SetFileName(args.output)
    steps.run(f"Write {args.output}", writer, writer.Write)
    if args.picture:
        scenes = [scene_of(harmonics.GetOutput(), f"L = {degree}", args) for degree, harmonics in made.items()]
        scenes.append(scene_of(mapped, "The model", args))
        pictures.write_side_by_side(args.picture, scenes, len(scenes) * PANEL[0], PANEL[1])
        print(f"wrote {args.picture}")


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, OSError, ValueError) as error:
        sys.exit(f"surface_harmonics: {error}")
