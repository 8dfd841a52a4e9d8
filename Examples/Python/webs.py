#!/usr/bin/python3
"""Draws a figure with limbs: the points, learned as a geodesic mesh, and learned by default."""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkCamera

from conformalsom import vtkConformalSOM
from conformalsom.command import pictures

from helpers.builtin_figure import dancer, figure_cloud

VIEW, UP = (0, 0, 1), (0, 1, 0)


def learned(scan, **properties):
    """The mesh of the scan."""
    network = vtkConformalSOM()
    network.SetInputData(scan)
    network.SetNumberOfNeurons(5762)
    for name, value in properties.items():
        getattr(network, "Set" + name)(value)
    network.Update()
    return network.GetOutput()


def on_a_limb(camera, scan):
    """The camera, on a fourth of its view near the point farthest from the middle."""
    points = vtk_to_numpy(scan.GetPoints().GetData())
    end = points[np.argmax(np.linalg.norm(points - points.mean(axis=0), axis=1))]
    near = vtkCamera()
    near.DeepCopy(camera)
    shift = 0.85 * (end - np.array(camera.GetFocalPoint()))
    near.SetFocalPoint(camera.GetFocalPoint() + shift)
    near.SetPosition(camera.GetPosition() + shift)
    near.SetParallelScale(camera.GetParallelScale() / 4.0)
    return near


def write(path):
    scan = figure_cloud(30000, figure=dancer)
    camera = pictures.camera_on(scan, VIEW, UP, 0.9)
    meshes = {
        "Geodesic": learned(scan, MeshType=vtkConformalSOM.GEODESIC),
        "Adaptive, the default": learned(scan)}
    scenes = [pictures.scene(pictures.cloud_actor(scan, VIEW), "30,000 points", camera)]
    for label, mesh in meshes.items():
        bare = mesh.GetFieldData().GetArray("UnsupportedFraction").GetValue(0)
        scenes.append(pictures.scene(pictures.mesh_actor(mesh),
                                     f"{label}: {100 * bare:.1f} % without points", camera))
    near = on_a_limb(camera, scan)
    scenes.append(pictures.scene(pictures.cloud_actor(scan, VIEW), "The end of a limb", near))
    scenes += [pictures.scene(pictures.mesh_actor(mesh), label, near) for label, mesh in meshes.items()]
    pictures.write_side_by_side(path, scenes, 1350, 1000, rows=2)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="webs.png", help="to write, default webs.png")
    picture = parser.parse_args().picture
    if os.path.lexists(picture):
        parser.error(f"{picture} already exists")
    write(picture)


if __name__ == "__main__":
    main()
