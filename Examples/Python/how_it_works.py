#!/usr/bin/python3
"""Draw how a cloud becomes a painted surface: a picture of each stage, and the flow from class to class.

    how_it_works.py [FOLDER]

Writes HowItWorksPoints.png, ... and flow.svg, the pictures of Documentation/HowItWorks.md.
"""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from conformalsom import vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap
from conformalsom.command import pictures

from helpers import textures
from helpers.builtin_figure import dancer, figure_cloud

VIEW, UP = (0, 0, 1), (0, 1, 0)
SIZE = (400, 440)  # pixels of a picture
# Boxes of the flow: left edge, top edge, width, class, and the steps inside.
BOXES = [
    (10, 10, 110, "any reader", ["1 points"]),
    (150, 10, 250, "vtkConformalSOM", ["2 start", "3 fit", "4 map"]),
    (430, 10, 210, "vtkCurvedSeamlessSurface", ["5 smooth surface"]),
    (670, 10, 190, "vtkSphericalTextureMap", ["6 texture"]),
    (10, 110, 110, "any reader", ["closed mesh"]),
    (150, 110, 250, "vtkGlobalConformalMap", ["4 map"]),
]
HEIGHT = 80  # of a box
ARROWS = ["M 120 50 h 28", "M 400 50 h 28", "M 640 50 h 28", "M 120 150 h 28", "M 400 150 h 135 v -58"]


def stages_of(network):
    """The surfaces that learning went through, by the names of the blocks."""
    blocks = network.GetOutputDataObject(2)
    return {blocks.GetMetaData(i).Get(blocks.NAME()): blocks.GetBlock(i)
            for i in range(blocks.GetNumberOfBlocks())}


def sphere_of(surface):
    """The triangles of a mapped surface, on the sphere."""
    points, sphere = vtkPoints(), vtkPolyData()
    points.SetData(surface.GetPointData().GetArray("SpherePosition"))
    sphere.SetPoints(points)
    sphere.SetPolys(surface.GetPolys())
    return sphere


def toward_hands(surface):
    """The direction of the sphere that has both hands in sight: the sum of their positions on it."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    sphere = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))
    return sum(sphere[np.argmax(points @ np.array([side, 1.0, 0.0]))] for side in (-1.0, 1.0))


def flat_actor(surface):
    """The surface with its triangles shaded flat."""
    actor = pictures.actor_of(surface)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetColor(0.95, 0.92, 0.87)
    return actor


def draw():
    """The picture of each stage, as a filter that puts it out, by the name of the stage."""
    scan = figure_cloud(20000, figure=dancer)
    network = vtkConformalSOM()
    network.SetInputData(scan)
    network.SetNumberOfNeurons(4002)
    network.GenerateStagesOn()
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(network.GetOutputPort())
    painted = vtkSphericalTextureMap()
    painted.SetInputConnection(surface.GetOutputPort())
    painted.SetViewDirection(VIEW)
    painted.SetViewUp(UP)
    painted.Update()
    start = next(block for name, block in stages_of(network).items() if name.endswith(": start"))
    sphere = sphere_of(network.GetOutput())

    camera = pictures.camera_on(scan, VIEW, UP, SIZE[0] / SIZE[1])
    around = pictures.camera_on(sphere, toward_hands(network.GetOutput()), UP, SIZE[0] / SIZE[1], 0, 0)
    scenes = [
        ("Points", pictures.cloud_actor(scan, VIEW), f"{scan.GetNumberOfPoints():,} points", camera),
        ("Start", flat_actor(start), "Start: hull of the points", camera),
        ("Fit", pictures.mesh_actor(network.GetOutput()), "Fit: closed mesh", camera),
        ("Map", pictures.mesh_actor(sphere), "Map: the mesh on the sphere", around),
        ("Surface", pictures.actor_of(surface.GetOutput()), "Smooth surface", camera),
        ("Texture", pictures.textured_actor(painted.GetOutput(), textures.checkerboard()), "Painted surface", camera),
    ]
    return {name: pictures.draw_side_by_side([pictures.scene(*scene)], *SIZE) for name, *scene in scenes}


def flow():
    """The classes and the steps inside them, with arrows for data, as SVG."""
    shapes = []
    for left, top, width, name, steps in BOXES:
        shapes.append(
            f'<rect x="{left}" y="{top}" width="{width}" height="{HEIGHT}" rx="6" fill="#dbe7f3" stroke="#34495e"/>'
            f'<text x="{left + width / 2}" y="{top + 24}" font-weight="bold">{name}</text>')
        share = (width - 10) / len(steps)
        for i, step in enumerate(steps):
            shapes.append(
                f'<rect x="{left + 10 + i * share}" y="{top + 38}" width="{share - 10}" height="30" rx="4" '
                f'fill="white" stroke="#34495e"/><text x="{left + 5 + (i + 0.5) * share}" y="{top + 58}">{step}</text>')
    for arrow in ARROWS:
        shapes.append(f'<path d="{arrow}" fill="none" stroke="#34495e" stroke-width="1.5" marker-end="url(#head)"/>')
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="870" height="200" font-family="sans-serif" font-size="13" '
            'text-anchor="middle"><defs><marker id="head" markerWidth="8" markerHeight="8" refX="6" refY="4" '
            'orient="auto"><path d="M 0 0 L 7 4 L 0 8" fill="none" stroke="#34495e"/></marker></defs>'
            f'<rect width="100%" height="100%" fill="white"/>{"".join(shapes)}</svg>\n')


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default=".", help="to write to, default the working folder")
    folder = parser.parse_args().folder
    os.makedirs(folder, exist_ok=True)
    for name, drawn in draw().items():
        writer = pictures.picture_writer(os.path.join(folder, f"HowItWorks{name}.png"))
        writer.SetInputConnection(drawn.GetOutputPort())
        writer.Write()
    with open(os.path.join(folder, "flow.svg"), "w", encoding="ascii") as file:
        file.write(flow())


if __name__ == "__main__":
    main()
