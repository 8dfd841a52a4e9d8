#!/usr/bin/python3
"""Draws reflections of a striped room on surfaces learned from noisy points: hardly smoothed, and by default."""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from conformalsom import vtkConformalSOM, vtkCurvedSeamlessSurface
from conformalsom.command import pictures

from helpers.builtin_figure import figure_cloud
from helpers.clouds import cloud_of, points_of

VIEW, UP = (0.3, -0.2, 1.0), (0, 1, 0)
NOISE = 0.001  # standard deviation along each axis, if the largest radius is 1
STRIPES = 8.0  # of the room, from its floor to its ceiling


def noisy_scan(count):
    """The built-in figure with Gaussian noise."""
    points = points_of(figure_cloud(count))
    radius = np.linalg.norm(points - points.mean(axis=0), axis=1).max()
    return cloud_of(points + np.random.default_rng(1).normal(size=points.shape) * NOISE * radius)


def smooth_surface(scan, smoothness):
    network = vtkConformalSOM()
    network.SetInputData(scan)
    network.SetSmoothness(smoothness)
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(network.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def striped(surface):
    """The surface with the stripes that a mirror would show: 0 or 1 at each point."""
    normals = vtk_to_numpy(surface.GetPointData().GetNormals()).astype(float)
    view = np.array(VIEW) / np.linalg.norm(VIEW)
    mirrored = 2.0 * (normals @ view)[:, None] * normals - view
    height = np.arcsin(np.clip(mirrored @ np.array(UP), -1.0, 1.0)) / np.pi + 0.5
    bright = np.clip(0.5 + 4.0 * np.sin(2.0 * np.pi * STRIPES * height), 0.0, 1.0)
    colors = numpy_to_vtk(np.repeat((40 + 200 * bright).astype(np.uint8)[:, None], 3, axis=1), deep=True)
    colors.SetName("Zebra")
    result = surface.NewInstance()
    result.ShallowCopy(surface)
    result.GetPointData().SetScalars(colors)
    return result


def write(path):
    scan = noisy_scan(40000)
    camera = pictures.camera_on(scan, VIEW, UP, 0.9)
    scenes = []
    for label, smoothness in (("Hardly smoothed", 1e-3), ("Fair, the default", 1.0)):
        actor = pictures.actor_of(striped(smooth_surface(scan, smoothness)))
        actor.GetMapper().ScalarVisibilityOn()
        actor.GetProperty().LightingOff()
        scenes.append(pictures.scene(actor, label, camera))
    pictures.write_side_by_side(path, scenes, 1200, 700)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="zebra.png", help="to write, default zebra.png")
    picture = parser.parse_args().picture
    if os.path.lexists(picture):
        parser.error(f"{picture} already exists")
    write(picture)


if __name__ == "__main__":
    main()
