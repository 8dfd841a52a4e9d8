#!/usr/bin/python3
"""A map of a table on the sphere: similar rows are near each other, and the map has no border.

The table is a text file with commas and a line of names. Columns of numbers are learned; --label is the column with the
kinds of the rows. Without a file, a table of three kinds is made by code. Errors of the map are printed, and the table
is written with the neuron of each row. --picture draws the front and the back of the sphere, colored by labels, by the
U-matrix (dark between clusters) and by the numbers of rows.
"""
import argparse
import colorsys
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOCore import vtkDelimitedTextWriter
from vtkmodules.vtkIOInfovis import vtkDelimitedTextReader

from conformalsom import vtkSphericalSOM
from conformalsom.command import pictures
from conformalsom.command.steps import StepFailed, Steps

PANEL = 360, 380
LABEL_OF_EXAMPLE = "Kind"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", nargs="?", help="a text file with commas; default: a table made by code")
    parser.add_argument("--label", metavar="COLUMN", help="column with the kinds of the rows")
    parser.add_argument("--neurons", type=int, default=0, metavar="N", help="number of neurons; default: by the rows")
    parser.add_argument("--output", metavar="FILE", help="the table with the neuron of each row; default: none")
    parser.add_argument("--picture", metavar="FILE", help="PNG or JPEG")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    for path in (args.output, args.picture):
        if path and os.path.lexists(path):
            parser.error(f"{path} already exists")
    return args


def example_table(size=1500):
    """Rows of three kinds in six columns. The rows of a kind are on a bent band."""
    random = np.random.default_rng(1)
    kind, along = np.arange(size) % 3, random.uniform(0.0, np.pi, size)
    columns = [np.cos(along) + 2.0 * kind, np.sin(along) * (kind - 1.0), along, along**2, 1.0 * (kind == 1), np.cos(3 * along)]
    table = vtkTable()
    for k, column in enumerate(columns):
        array = numpy_to_vtk(column + 0.15 * random.standard_normal(size), deep=True)
        array.SetName(f"Column{k + 1}")
        table.AddColumn(array)
    names = vtkStringArray()
    names.SetName(LABEL_OF_EXAMPLE)
    for value in kind:
        names.InsertNextValue(("first", "second", "third")[value])
    table.AddColumn(names)
    return table


def read(path):
    reader = vtkDelimitedTextReader()
    reader.SetFileName(path)
    reader.SetHaveHeaders(True)
    reader.DetectNumericColumnsOn()
    reader.Update()
    if reader.GetOutput().GetNumberOfRows() == 0:
        raise StepFailed(f"{path} has no rows")
    return reader.GetOutput()


def colors_of(sphere, name):
    """A color for each neuron: gray levels of numbers, hues of labels."""
    array = sphere.GetPointData().GetAbstractArray(name)
    if name in ("UMatrix", "HitCount"):
        values = vtk_to_numpy(array).astype(float)
        share = (values - values.min()) / max(np.ptp(values), 1e-300)
        return np.repeat(255.0 * (1.0 - 0.9 * share)[:, None], 3, axis=1)
    labels = [array.GetVariantValue(i).ToString() for i in range(array.GetNumberOfTuples())]
    kinds = {label: k for k, label in enumerate(sorted(set(labels)))}
    return np.array([colorsys.hsv_to_rgb(kinds[label] / len(kinds), 0.65, 235.0) for label in labels])


def scene_of(sphere, name, title, view):
    colored = sphere.NewInstance()
    colored.ShallowCopy(sphere)
    colors = numpy_to_vtk(colors_of(sphere, name).round().astype(np.uint8), deep=True)
    colors.SetName("Colors")
    colored.GetPointData().SetScalars(colors)
    camera = pictures.camera_on(colored, view, (0.0, 1.0, 0.0), PANEL[0] / PANEL[1], azimuth=0, elevation=0)
    actor = pictures.actor_of(colored)
    actor.GetMapper().ScalarVisibilityOn()
    actor.GetProperty().LightingOff()
    return pictures.scene(actor, title, camera)


def draw(sphere, label, path):
    kinds = [(label, "labels")] if label else []
    kinds += [("UMatrix", "U-matrix"), ("HitCount", "hit count")]
    scenes = [scene_of(sphere, name, f"{title}, {side}", view)
              for side, view in (("front", (0.0, 0.0, 1.0)), ("back", (0.0, 0.0, -1.0))) for name, title in kinds]
    pictures.write_side_by_side(path, scenes, PANEL[0] * len(kinds), 2 * PANEL[1], rows=2)


def main():
    args = arguments()
    som = vtkSphericalSOM()
    if args.table:
        som.SetInputData(read(args.table))
    else:
        som.SetInputData(example_table())
        args.label = args.label or LABEL_OF_EXAMPLE
    som.SetLabelColumn(args.label or "")
    som.SetNumberOfNeurons(args.neurons)
    Steps().run("Map of the table", som)
    sphere = som.GetOutput()
    print(f"neurons             {sphere.GetNumberOfPoints()}")
    for name in ("QuantizationError", "TopographicError"):
        print(f"{name:19} {sphere.GetFieldData().GetArray(name).GetTuple1(0):.3f}")
    if args.output:
        writer = vtkDelimitedTextWriter()
        writer.SetInputData(som.GetTable())
        writer.SetFileName(args.output)
        writer.Write()
    if args.picture:
        draw(sphere, args.label, args.picture)


if __name__ == "__main__":
    try:
        main()
    except StepFailed as failure:
        sys.exit(str(failure))
