#!/usr/bin/python3
"""Makes two closed models correspond: which point of the second belongs to each point of the first?

Models are of any format that quickstart.py opens, closed and without handles. Those without a map to the
sphere are mapped; the first one's map is then deformed until it corresponds to the second one's, by
landmarks if there are some, else by their shape alone. Writes the first model with its new map, and with the
corresponding triangle and weights for each point, as .vtp.
"""
import argparse
import os
import sys

from conformalsom import vtkSphericalRegistration
from conformalsom.command.steps import StepFailed, Steps

from helpers import mapped_models


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("moving", help="the model whose map is deformed")
    parser.add_argument("fixed", help="the model that it is to correspond to")
    parser.add_argument("--landmarks", nargs=2, metavar=("MOVING", "FIXED"),
                        help="files of point ids, one a line, which correspond line by line")
    parser.add_argument("--space", choices=("Rotation", "Moebius", "Diffeomorphic"), default="Diffeomorphic",
                        help="what may be done to the map, default Diffeomorphic")
    parser.add_argument("--balance", type=float, default=0.5,
                        help="AreaBalance of maps that are made, default 0.5")
    parser.add_argument("--output", metavar="FILE", default="registered.vtp",
                        help="default registered.vtp")
    args = parser.parse_args()
    if os.path.lexists(args.output):
        parser.error(f"{args.output} already exists")
    return args


def main():
    args = arguments()
    steps = Steps()
    moving, fixed = (mapped_models.read(path, args.balance, steps) for path in (args.moving, args.fixed))
    registration = vtkSphericalRegistration()
    registration.SetInputData(moving)
    registration.SetFixedData(fixed)
    getattr(registration, "SetSpaceOfTransformsTo" + args.space)()
    if args.landmarks:
        pairs = [mapped_models.read_landmarks(path, model)
                 for path, model in zip(args.landmarks, (moving, fixed))]
        if len(pairs[0]) != len(pairs[1]):
            raise ValueError(f"{args.landmarks[0]} has {len(pairs[0])} landmarks, "
                             f"{args.landmarks[1]} has {len(pairs[1])}")
        for point, fixed_point in zip(*pairs):
            registration.AddLandmark(point, fixed_point)
    steps.run("Register", registration)
    registered = registration.GetOutput()
    mapped_models.write(registered, args.output, steps)
    print(f"\nstretch      {mapped_models.figure(registered, 'RegistrationStretch'):.3f}"
          "   1 if the models are isometric"
          f"\nagreement    {mapped_models.figure(registered, 'FeatureAgreement', 1):.3f}"
          f"   correlation of features; {mapped_models.figure(registered, 'FeatureAgreement'):.3f} before"
          f"\nfolds        {mapped_models.figure(registered, 'NumberOfFolds'):.0f}")
    if args.landmarks:
        print(f"landmarks    {mapped_models.figure(registered, 'LandmarkError'):.1e}"
              "   largest distance left, on the unit sphere")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, StepFailed) as error:
        sys.exit(f"register_surfaces: {error}")
