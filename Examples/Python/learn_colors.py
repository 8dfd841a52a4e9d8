#!/usr/bin/python3
"""Learn colors with the shape, and compare with colors that are baked onto the mesh afterwards.

The cloud is a toy bear, made by code, with a checkerboard in space as colors and labels. Four fifths of the points are
learned. At the other points, the colors of the closest points of three meshes are compared with the true colors:

    nearest   the mesh of the coordinates; each vertex has the color of the nearest point
    mean      likewise; each vertex has the mean color of the points that are nearest to it
    learned   AddPatternArray: the mesh follows the edges between colors

"error" is the mean error of the color, between 0 and 1, "wrong" is the fraction of the points with an error above 0.2,
"distance" is the root mean square distance of the points from the mesh, in units of the largest radius. "label" is the
fraction of the points whose label is not the most frequent one of the corners of the closest triangle.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator, vtkStaticPointLocator

from conformalsom import vtkConformalSOM
from conformalsom.command import pictures
from conformalsom.command.steps import StepFailed, Steps

from helpers import builtin_figure, clouds

PANEL = 420, 520
PALETTE = np.array([[225, 80, 50], [50, 90, 200]], dtype=np.uint8)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=40000, help="number of points, default 40000")
    parser.add_argument("--neurons", type=int, nargs="+", default=[2562, 6002], help="default 2562 6002")
    parser.add_argument("--weight", type=float, default=0.1, help="weight of the arrays, default 0.1")
    parser.add_argument("--size", type=float, default=0.5, help="edge length of the checkerboard, default 0.5")
    parser.add_argument("--picture", metavar="FILE", help="of the meshes with the first number of neurons, PNG or JPEG")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    if args.picture and os.path.lexists(args.picture):
        parser.error(f"{args.picture} already exists")
    return args


def fields_of(points, size):
    """The field of each point, 0 or 1."""
    return np.floor(points / size + 0.31).astype(int).sum(axis=1) % 2


def learn(points, fields, neurons, weight, steps):
    cloud = clouds.cloud_of(points)
    for name, values in (("RGB", PALETTE[fields]), ("Field", fields.astype(np.int32))):
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        cloud.GetPointData().AddArray(array)
    som = vtkConformalSOM()
    som.SetInputData(cloud)
    som.SetNumberOfNeurons(neurons)
    if weight:
        som.AddPatternArray("RGB", weight)
        som.AddPatternArray("Field", weight)
    steps.run("Learn with colors" if weight else "Learn", som)
    return som.GetOutput()


def nearest_ids(points, others):
    """For each point, the nearest of the other points."""
    locator = vtkStaticPointLocator()
    locator.SetDataSet(clouds.cloud_of(others))
    locator.BuildLocator()
    return np.array([locator.FindClosestPoint(point) for point in points])


def closest_points(mesh, points):
    """For each point, the corners of the closest triangle, the weights of the corners, and the distance."""
    locator, cell = vtkStaticCellLocator(), vtkGenericCell()
    locator.SetDataSet(mesh)
    locator.BuildLocator()
    triangles, vertices = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3), clouds.points_of(mesh)
    corners, weights, distances = [], [], []
    for point in points:
        foot, triangle, part, square = [0.0] * 3, reference(0), reference(0), reference(0.0)
        locator.FindClosestPoint(point, foot, cell, triangle, part, square)
        ids = triangles[int(triangle)]
        system = np.vstack([vertices[ids].T, np.ones(3)])
        corners.append(ids)
        weights.append(np.linalg.lstsq(system, np.append(foot, 1.0), rcond=None)[0])
        distances.append(np.sqrt(float(square)))
    return np.array(corners), np.array(weights), np.array(distances)


def baked(mesh, points, colors, fields):
    """Colors and labels of the vertices: of the nearest point, and means of the points that are nearest."""
    vertices = clouds.points_of(mesh)
    nearest, owners = nearest_ids(vertices, points), nearest_ids(points, vertices)
    sums, counts = np.zeros((len(vertices), 3)), np.bincount(owners, minlength=len(vertices))
    np.add.at(sums, owners, colors)
    means = np.where(counts[:, None] > 0, sums / np.maximum(counts, 1)[:, None], colors[nearest])
    ones = np.bincount(owners, weights=fields, minlength=len(vertices))
    majority = np.where(counts > 0, ones > 0.5 * counts, fields[nearest])
    return {"nearest": (colors[nearest], fields[nearest]), "mean": (means, majority.astype(int))}


def measure(mesh, colors, labels, points, fields):
    corners, weights, distances = closest_points(mesh, points)
    predicted = (colors[corners] * weights[:, :, None]).sum(axis=1)
    errors = np.abs(predicted - PALETTE[fields]).mean(axis=1) / np.abs(np.diff(PALETTE.astype(float), axis=0)).mean()
    likely = labels[corners].sum(axis=1) > 1
    radius = np.linalg.norm(points - points.mean(axis=0), axis=1).max()
    return errors.mean(), np.mean(errors > 0.2), np.mean(likely != fields), np.sqrt((distances**2).mean()) / radius


def scene_of(mesh, colors, label):
    colored = mesh.NewInstance()
    colored.ShallowCopy(mesh)
    array = numpy_to_vtk(np.clip(colors, 0, 255).round().astype(np.uint8), deep=True)
    array.SetName("Colors")
    colored.GetPointData().SetScalars(array)
    actor = pictures.mesh_actor(colored)
    actor.GetMapper().ScalarVisibilityOn()
    camera = pictures.camera_on(colored, (0.0, 0.0, 1.0), (0.0, 1.0, 0.0), PANEL[0] / PANEL[1])
    return pictures.scene(actor, label, camera)


def main():
    args = arguments()
    points = clouds.points_of(builtin_figure.figure_cloud(args.points))
    fields = fields_of(points, args.size)
    held_out = np.arange(len(points)) % 5 == 4
    known, known_fields = points[~held_out], fields[~held_out]
    steps, scenes = Steps(), []
    rows = ["| neurons | colors | error | wrong | label | distance |", "| --- | --- | --- | --- | --- | --- |"]
    for neurons in args.neurons:
        plain = learn(known, known_fields, neurons, 0.0, steps)
        joint = learn(known, known_fields, neurons, args.weight, steps)
        results = {name: (plain, *values) for name, values in
                   baked(plain, known, PALETTE[known_fields].astype(float), known_fields).items()}
        results["learned"] = (joint, *(vtk_to_numpy(joint.GetPointData().GetArray(name)).astype(kind)
                                       for name, kind in (("RGB", float), ("Field", int))))
        for name, (mesh, colors, labels) in results.items():
            error, wrong, label, distance = measure(mesh, colors, labels, points[held_out], fields[held_out])
            rows.append(f"| {neurons:,} | {name} | {error:.3f} | {100 * wrong:.1f} % | {100 * label:.1f} % "
                        f"| {distance:.5f} |")
            if neurons == args.neurons[0]:
                scenes.append(scene_of(mesh, colors, name))
    print(*rows, sep="\n")
    if args.picture:
        pictures.write_side_by_side(args.picture, scenes, 3 * PANEL[0], PANEL[1])


if __name__ == "__main__":
    try:
        main()
    except StepFailed as failure:
        sys.exit(str(failure))
