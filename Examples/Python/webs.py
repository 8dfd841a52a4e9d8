#!/usr/bin/python3
"""Draws a figure with limbs as learned from a sphere, with webs, and as learned by default."""
import argparse
import os

from conformalsom import vtkConformalSOM

from helpers import pictures
from helpers.builtin_figure import dancer, figure_cloud

VIEW, UP = (0, 0, 1), (0, 1, 0)


def learned(scan, starting_shape):
    """The filter that has learned the scan from that shape."""
    network = vtkConformalSOM()
    network.SetInputData(scan)
    network.SetFrequency(24)
    network.SetStartingShape(starting_shape)
    network.Update()
    return network


def write(path):
    scan = figure_cloud(30000, figure=dancer)
    camera = pictures.camera_on(scan, VIEW, UP, 0.9)
    scenes = [pictures.scene(pictures.cloud_actor(scan, VIEW), "30,000 points", camera)]
    for shape, label in ((vtkConformalSOM.SPHERE, "Learned from a sphere"),
                         (vtkConformalSOM.AUTOMATIC, "Learned by default")):
        mesh = learned(scan, shape).GetOutput()
        bare = mesh.GetFieldData().GetArray("UnsupportedFraction").GetValue(0)
        scenes.append(pictures.scene(pictures.mesh_actor(mesh),
                                     f"{label}: {100 * bare:.1f} % without points", camera))
    pictures.write_side_by_side(path, scenes, 1350, 500)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("picture", nargs="?", default="webs.png", help="to write, default webs.png")
    picture = parser.parse_args().picture
    if os.path.lexists(picture):
        parser.error(f"{picture} already exists")
    write(picture)


if __name__ == "__main__":
    main()
