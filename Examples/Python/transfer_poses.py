#!/usr/bin/python3
"""Draws poses that are transferred from one body to others: animals, or heads with expressions (--heads).

The first body and its poses are made by code. Its map to the sphere is made to correspond to that of each target: by
landmarks for a body made by code, by shape alone for a closed model of yours, such as a scan of an animal that stands.
The first row of the picture is the first body, at rest and in its poses; each further row is a target.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPointLocator, vtkPolyData

from compare_lattices import triangulated
from helpers import bodies, paper_models, poses
from helpers.clouds import points_of, vtk_points
from conformalsom import vtkDeformationTransfer, vtkGlobalConformalMap, vtkSphericalRegistration
from conformalsom.command import pictures, scan_files

PANEL = 300, 240
VIEW, UP = {"animals": (0.35, -1.0, 0.25), "heads": (1.0, -0.35, 0.1)}, (0, 0, 1)
COLORS = ((0.80, 0.62, 0.46), (0.36, 0.48, 0.62), (0.55, 0.62, 0.45), (0.62, 0.50, 0.58))


def mapped(mesh):
    """The mesh with its map to the sphere."""
    conformal = vtkGlobalConformalMap()
    conformal.SetAreaBalance(0.5)
    conformal.SetInputData(mesh)
    return paper_models.run(conformal)


def body_of(make, seed, size):
    """A body made by code, and its mapped mesh."""
    body = make(np.random.default_rng(seed), 0.0)
    return body, mapped(body.mesh(size))


def registered(source, body, target, other):
    """The source with its map made to correspond to that of the target, by landmarks if both are made by code."""
    registration = vtkSphericalRegistration()
    registration.SetInputData(source)
    registration.SetFixedData(target)
    if other:
        for own, its in zip(body.landmarks(source), other.landmarks(target)):
            registration.AddLandmark(own, its)
    return paper_models.run(registration)


def in_pose(surface, points):
    """The surface with other points."""
    result = vtkPolyData()
    result.ShallowCopy(surface)
    result.SetPoints(vtk_points(points))
    return result


def sphere_of(surface):
    return vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))


def turn_to(target, source):
    """Turn a model so that it stands as the source does (Kabsch), for the picture and for its feet."""
    on_sphere, nearest = in_pose(source, sphere_of(source)), vtkPointLocator()
    nearest.SetDataSet(on_sphere)
    pairs = points_of(source)[[nearest.FindClosestPoint(direction) for direction in sphere_of(target)]].astype(float)
    points = points_of(target).astype(float)
    u, _, v = np.linalg.svd((points - points.mean(axis=0)).T @ (pairs - pairs.mean(axis=0)))
    target.SetPoints(vtk_points(points @ (u @ np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ v))]) @ v)))


def mark_feet(surface):
    """Mark the lowest points as contacts."""
    feet = numpy_to_vtk(poses.feet(points_of(surface)).astype(np.uint8), deep=True)
    feet.SetName("Feet")
    surface.GetPointData().AddArray(feet)


def transferred(source, all_poses, target, feet):
    """The target in each pose."""
    transfer = vtkDeformationTransfer()
    transfer.SetInputData(target)
    transfer.SetSourceData(source)
    for pose in all_poses:
        transfer.AddPoseData(pose)
    if feet:
        mark_feet(target)
        transfer.SetContactArrayName("Feet")
    shapes = []
    for time in range(len(all_poses)):
        transfer.UpdateTimeStep(time)
        shapes.append(vtkPolyData())
        shapes[-1].ShallowCopy(transfer.GetOutput())
        residual = transfer.GetOutput().GetFieldData().GetArray("TransferResidual").GetValue(0)
        print(f"pose {time}: TransferResidual {residual:.3f}")
    return shapes


def scene_of(surface, label, view, color):
    """Seen by itself, since poses move a body."""
    actor = pictures.actor_of(surface)
    actor.GetMapper().ScalarVisibilityOff()
    actor.GetProperty().SetColor(color[0], color[1], color[2])
    return pictures.scene(actor, label, pictures.camera_on(surface, view, UP, PANEL[0] / PANEL[1], 0.0))


def made_by_code(args):
    """The first body, its mapped mesh, its poses by their names, and the function that makes bodies."""
    random_body = bodies.head if args.heads else bodies.animal
    body, source = body_of(random_body, args.seeds[0], args.size)
    points = points_of(source).astype(float)
    if args.heads:
        moved = {name: poses.expressed(points, body, motions) for name, motions in poses.EXPRESSIONS.items()}
    else:
        moved = {name: poses.posed(points, body, angles) for name, angles in poses.POSES.items()}
    return body, source, moved, random_body


def draw(args):
    body, source, moved, random_body = made_by_code(args)
    rows = [[source] + [in_pose(source, points) for points in moved.values()]]
    targets = [body_of(random_body, seed, args.size) for seed in args.seeds[1:]]
    for path in args.model:
        reader = scan_files.scan_reader(path)
        reader.Update()
        targets.append((None, mapped(triangulated(reader.GetOutput()))))
    for other, target in targets:
        own = registered(source, body, target, other)
        if not other:
            turn_to(target, own)
        rows.append([target] + transferred(own, [in_pose(own, points) for points in moved.values()], target, args.feet))
    view = args.view or VIEW["heads" if args.heads else "animals"]
    labels = ["at rest"] + list(moved)
    scenes = [scene_of(shape, label if k == 0 else "", view, COLORS[k % len(COLORS)])
              for k, row in enumerate(rows) for shape, label in zip(row, labels)]
    pictures.write_side_by_side(args.output, scenes, PANEL[0] * len(labels), PANEL[1] * len(rows), rows=len(rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="*", help="closed models of animals or heads, further targets")
    parser.add_argument("--heads", action="store_true", help="heads with expressions instead of animals with poses")
    parser.add_argument("--seeds", nargs="+", type=int, default=[1, 2], help="of the bodies made by code, first that with the poses, default 1 2")
    parser.add_argument("--size", type=int, default=90, help="cells of the grid along a body's longest side, default 90")
    parser.add_argument("--feet", action="store_true", help="move the feet of targets exactly as those of the first body")
    parser.add_argument("--view", nargs=3, type=float, help="where to look from")
    parser.add_argument("--output", default="transfer_poses.png", help="picture, .png or .jpg")
    args = parser.parse_args()
    draw(args)
    print("wrote", os.path.abspath(args.output))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, paper_models.StepFailed) as error:
        sys.exit(f"transfer_poses: {error}")
