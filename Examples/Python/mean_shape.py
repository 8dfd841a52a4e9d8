#!/usr/bin/python3
"""The mean of closed models, and how they differ from it.

Models are of any format that quickstart.py opens, closed and without handles. Those without a map to the
sphere are mapped. All are registered with their mean, by landmarks if there are some, else by their shape
alone, put on one mesh, and compared. Writes the mean with its modes (the point arrays ShapeMode1 and so on:
displacements by one standard deviation) as .vtp, and prints the share of the variance that each mode explains,
and the scores of each model.
"""
import argparse
import os
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet

from conformalsom import vtkConsistentRemesh, vtkSphericalTemplate
from conformalsom.command.steps import StepFailed, Steps

from helpers import mapped_models


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="+", help="two closed models or more")
    parser.add_argument("--landmarks", nargs="+", metavar="FILE",
                        help="for each model a file of point ids, one a line, which correspond line by line")
    parser.add_argument("--similarity", action="store_true", help="size is no difference of shape")
    parser.add_argument("--rounds", type=int, default=4,
                        help="in which all are registered with their mean, at most; default 4")
    parser.add_argument("--points", type=int, default=20000, help="of the mean, default 20000")
    parser.add_argument("--modes", type=int, default=10, help="to write, default 10")
    parser.add_argument("--balance", type=float, default=0.5,
                        help="AreaBalance of maps that are made, default 0.5")
    parser.add_argument("--output", metavar="FILE", default="mean.vtp", help="default mean.vtp")
    args = parser.parse_args()
    if len(args.model) < 2:
        parser.error("two models or more are needed")
    if args.landmarks and len(args.landmarks) != len(args.model):
        parser.error("--landmarks needs a file for each model")
    if os.path.lexists(args.output):
        parser.error(f"{args.output} already exists")
    return args


def registered(args, steps):
    """The models on their template, as a filter."""
    blocks = vtkMultiBlockDataSet()
    template = vtkSphericalTemplate()
    for i, path in enumerate(args.model):
        model = mapped_models.read(path, args.balance, steps)
        if args.landmarks:
            landmarks = mapped_models.read_landmarks(args.landmarks[i], model)
            template.SetLandmarkArrayName(mapped_models.mark(model, landmarks))
        blocks.SetBlock(i, model)
        blocks.GetMetaData(i).Set(vtkMultiBlockDataSet.NAME(), mapped_models.name_of(path))
    template.SetInputDataObject(blocks)
    template.SetMaximumNumberOfRounds(args.rounds)
    if args.similarity:
        template.SetAlignmentToSimilarity()
    steps.run("Register with the mean", template)
    return template


def values(data, name):
    array = data.GetFieldData().GetArray(name)
    return vtk_to_numpy(array).ravel() if array else []


def main():
    args = arguments()
    steps = Steps()
    template = registered(args, steps)
    remesh = vtkConsistentRemesh()
    remesh.SetInputConnection(template.GetOutputPort())
    remesh.SetNumberOfPoints(args.points)
    remesh.SetNumberOfModes(args.modes)
    if args.similarity:
        remesh.SetAlignmentToSimilarity()
    steps.run("Find mean and modes", remesh)
    mean = remesh.GetMeanSurface()
    mapped_models.write(mean, args.output, steps)

    of_template = template.GetMeanSurface()
    start = mapped_models.name_of(args.model[int(mapped_models.figure(of_template, "TemplateStart"))])
    print(f"\nstart               {start}")
    print("change per round   ", " ".join(f"{change:.4f}" for change in values(of_template, "TemplateChange")))
    print("explained variance ", " ".join(f"{share:.3f}" for share in values(mean, "ExplainedVariance")))
    print(f"\n{'model':<20}{'stretch':>8}{'agreement':>11}{'p2s':>10}  scores of modes")
    for i, path in enumerate(args.model):
        block, on_mesh = template.GetOutput().GetBlock(i), remesh.GetOutput().GetBlock(i)
        print(f"{mapped_models.name_of(path):<20}{mapped_models.figure(block, 'RegistrationStretch'):>8.3f}"
              f"{mapped_models.figure(block, 'FeatureAgreement', 1):>11.3f}"
              f"{mapped_models.figure(on_mesh, 'MeanSquarePointToSurface'):>10.1e}  "
              + " ".join(f"{score:5.2f}" for score in values(on_mesh, "ShapeScores")))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, StepFailed) as error:
        sys.exit(f"mean_shape: {error}")
