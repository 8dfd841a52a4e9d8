"""write_scene.py FOLDER: scan.ply and checkerboard.png, of which Testing/Python/test_pictures.py draws
its pictures too."""
import os
import sys

from vtkmodules.vtkIOImage import vtkPNGWriter

from conformalsom import vtkConformalPLYWriter
from helpers.builtin_figure import figure_cloud
from helpers.textures import checkerboard

folder = sys.argv[1]
os.makedirs(folder, exist_ok=True)
for writer, data, name in ((vtkConformalPLYWriter(), figure_cloud(20000), "scan.ply"),
                           (vtkPNGWriter(), checkerboard(), "checkerboard.png")):
    writer.SetInputData(data)
    writer.SetFileName(os.path.join(folder, name))
    writer.Write()
