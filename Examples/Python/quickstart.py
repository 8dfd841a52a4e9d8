#!/usr/bin/python3
"""From a scan to a painted surface in one pipeline: points -> learned mesh -> smooth surface -> picture.

The command conformalsom does the same with any format, progress, messages and figures.
"""
import argparse
import os

from vtkmodules.vtkIOImage import vtkPNGReader

from conformalsom import (
    vtkConformalPLYReader, vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap,
    vtkTexturedSurfaceWriter)
from conformalsom.command.outputs import files_of

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("scan", help="PLY file with points of an object that looks along +z, +y up")
parser.add_argument("picture", help="PNG file to paint its front with")
parser.add_argument("output", help="surface to write, .glb, .obj or .ply")
files = parser.parse_args()
for path in filter(os.path.lexists, files_of(files.output)):  # .obj and .ply have the picture beside them
    parser.error(f"{path} already exists")

scan, mesh, surface = vtkConformalPLYReader(), vtkConformalSOM(), vtkCurvedSeamlessSurface()
scan.SetFileName(files.scan)
mesh.SetInputConnection(scan.GetOutputPort())
surface.SetInputConnection(mesh.GetOutputPort())

painted, picture, writer = vtkSphericalTextureMap(), vtkPNGReader(), vtkTexturedSurfaceWriter()
painted.SetInputConnection(surface.GetOutputPort())
painted.SplitSeamOn()  # for programs that draw each triangle as it is
picture.SetFileName(files.picture)
writer.SetInputConnection(painted.GetOutputPort())
writer.SetTextureConnection(picture.GetOutputPort())
writer.SetFileName(files.output)
raise SystemExit(0 if writer.Write() else 1)
