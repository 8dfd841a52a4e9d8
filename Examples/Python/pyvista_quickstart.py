#!/usr/bin/python3
"""From a scan to a painted surface with PyVista: arrays and PyVista's meshes go in and come out."""
import argparse

parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("scan", help="any file that PyVista reads, with the points of one object")
parser.add_argument("picture", help="PNG or JPEG to paint its front with, which looks along +z, +y up")
parser.add_argument("output", help="picture to draw, .png")
files = parser.parse_args()

import pyvista

import conformalsom as cs
from conformalsom.pyvista import texture_of

cloud = pyvista.read(files.scan)
surface = cs.learn(cloud.points)
painted = surface.smooth().paint(files.picture)
mesh, result = surface.to_pyvista(), painted.to_pyvista()

plotter = pyvista.Plotter(off_screen=True, shape=(1, 3), window_size=[1200, 500])
plotter.add_mesh(cloud, style="points", color="slategray", point_size=1)
plotter.subplot(0, 1)
plotter.add_mesh(mesh, color="linen", show_edges=True, edge_color="gray")
plotter.subplot(0, 2)
plotter.add_mesh(result, texture=texture_of(painted))
plotter.link_views()
plotter.camera_position = "xy"
plotter.screenshot(files.output)
print(f"{cloud.n_points:,} points, {mesh.n_cells:,} triangles learned, {result.n_cells:,} drawn: {files.output}")
