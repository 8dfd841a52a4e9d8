#!/usr/bin/python3
"""What the paper leaves open, tried out: the figures of Documentation/Errata.md and Filters.md.

    paper_variants.py [--data DIR] reference | rates | priority

DIR has igea.ply, stanford-bunny.obj and, for rates, spot.ply. reference: batch learning from the sphere by
each ReferencePoint. rates: online learning by other learning rates alpha_0. priority: online learning with
points of the bunny's ears that weigh more, always, more and more, less and less, or in the second half, which
is what PriorityArrayName does. PYTHONPATH is that of the build.
"""
import argparse
import math
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from helpers import paper_models  # pylint: disable=wrong-import-position
from helpers.clouds import cloud_of, only_points_of  # pylint: disable=wrong-import-position
from conformalsom import (  # pylint: disable=wrong-import-position
    vtkConformalDistortion, vtkConformalSOM, vtkSurfaceMismatch)

MISMATCHES = {"p2s": "MeanSquarePointToSurface", "nv": "MeanSquarePointToVertex",
              "s2p": "MeanSquareSurfaceToPoint", "web": "WebFraction"}


def measured(mesh, reference):
    """The columns that are printed, by name. Largest radius 1."""
    mismatch = vtkSurfaceMismatch()
    mismatch.SetInputData(0, mesh)
    mismatch.SetInputData(1, reference)
    distortion = vtkConformalDistortion()
    distortion.SetInputData(mesh)
    errors = paper_models.run(mismatch).GetFieldData()
    angles = paper_models.run(distortion).GetFieldData()
    columns = {name: errors.GetArray(array).GetValue(0) for name, array in MISMATCHES.items()}
    columns["K"] = angles.GetArray("MeanQuasiConformalError").GetValue(0)
    columns["angle"] = angles.GetArray("MeanAngleDistortion").GetValue(0)
    return columns


def print_row(name, columns):
    print(f"{name:<36}" + "".join(f"{column:>8} {value:<9.3g}" for column, value in columns.items()),
          flush=True)


def reference_points(folder):
    for model in paper_models.models(folder):
        seconds = {}
        for reference in ("Affine", "Conformal", "Winner"):
            network = vtkConformalSOM()
            network.SetInputData(only_points_of(model.more))
            network.SetMeshTypeToGeodesic()
            network.SetStartingShapeToSphere()
            getattr(network, "SetReferencePointTo" + reference)()
            begin = time.process_time()
            mesh = paper_models.run(network)
            seconds[reference] = time.process_time() - begin
            columns = measured(mesh, model.more)
            columns["time"] = seconds[reference] / seconds["Affine"]
            print_row(f"{model.name}, {reference}", columns)


def learning_rates(folder):
    models = [(model.name, model.few, model.more) for model in paper_models.models(folder)]
    spot = os.path.join(folder, "spot.ply")
    if os.path.isfile(spot):
        models.append(("spot", paper_models.read(spot), paper_models.read(spot)))
    for name, few, more in models:
        for rate in (0.01, 0.03, 0.1, 0.3, 0.6):
            network = vtkConformalSOM()
            network.SetInputData(few)
            network.SetTrainingModeToOnline()
            network.SetOnlineConstants(0.4, 20, rate, 60)
            print_row(f"{name}, alpha_0 = {rate}", measured(paper_models.run(network), more))


def online(cloud, epochs=80, begin=0, start=None):
    """Some of the epochs of online learning, from the start or from a mesh; schedules run through."""
    network = vtkConformalSOM()
    network.SetInputData(cloud)
    network.SetTrainingModeToOnline()
    network.SetRandomSeed(1 + begin)
    network.SetNumberOfEpochs(epochs)
    network.SetOnlineConstants(0.4 * math.exp(-begin / 20.0), 20, 0.01 * math.exp(-begin / 60.0), 60)
    if cloud.GetPointData().HasArray("Weight"):
        network.SetPriorityArrayName("Weight")
    if start:
        network.SetInputData(1, start)
    mesh = vtkPolyData()
    mesh.DeepCopy(paper_models.run(network))
    return mesh


def by_weights(points, heavy, weight):
    cloud = cloud_of(points)
    weights = numpy_to_vtk(np.where(heavy, weight, 1.0), deep=True)
    weights.SetName("Weight")
    cloud.GetPointData().AddArray(weights)
    return online(cloud)


def by_repetition(points, heavy, weights):
    """In as many parts as there are weights, in each of which heavy points are there so many times."""
    mesh, epochs = None, 80 // len(weights)
    for part, weight in enumerate(weights):
        repeated = np.repeat(points, np.where(heavy, round(weight), 1), axis=0)
        mesh = online(cloud_of(repeated), epochs, part * epochs, mesh)
    return mesh


def priorities(folder):
    bunny = paper_models.models(folder)[-1].more
    points = vtk_to_numpy(bunny.GetPoints().GetData()).astype(float)
    heavy = (points[:, 1] > 0.14) & (points[:, 0] < -0.02)
    print(f"{heavy.sum():,} points above 0.14 and left of -0.02 weigh more")
    radius = np.linalg.norm(points - points.mean(axis=0), axis=1).max()
    ears = points[heavy]
    ears_radius = np.linalg.norm(ears - ears.mean(axis=0), axis=1).max()

    def print_mesh(name, mesh):
        columns = measured(mesh, bunny)
        columns["p2s of ears"] = measured(mesh, cloud_of(ears))["p2s"] * (ears_radius / radius)**2
        print_row(name, columns)

    growing = np.linspace(0.0, 1.0, 8)
    courses = {"always": np.ones(8), "growing": growing, "falling": growing[::-1],
               "in the second half": np.repeat([0.0, 1.0], 4)}
    print_mesh("no weights", online(cloud_of(points)))
    for weight in (4.0, 16.0, 64.0):
        print_mesh(f"PriorityArrayName, weight {weight:g}", by_weights(points, heavy, weight))
        for name, course in courses.items():
            print_mesh(f"repeated {weight:g} times, {name}", by_repetition(points, heavy, weight**course))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    variants = {"reference": reference_points, "rates": learning_rates, "priority": priorities}
    parser.add_argument("--data", metavar="DIR", default=paper_models.DATA)
    parser.add_argument("variant", choices=variants)
    arguments = parser.parse_args()
    variants[arguments.variant](arguments.data)


if __name__ == "__main__":
    main()
