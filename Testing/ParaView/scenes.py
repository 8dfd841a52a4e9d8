"""What the tests here have in common: a scan in a file, and the chain that paints it."""
import os
import subprocess
import sys

import numpy as np
from paraview import servermanager
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

from helpers import textures
from helpers.builtin_figure import figure_cloud

SIZE = [400, 400]


def colors_at(points):
    """Red, green and blue that increase to the right, upward and to the front of the bear, n x 3 bytes."""
    low, high = np.array([-1, -1, -1]), np.array([1, 1, 1])
    return np.rint(255 * np.clip((points - low) / (high - low), 0, 1)).astype(np.uint8)


def write_scan(folder, number_of_points=20000, colored=False):
    """The bear as a PLY file, by our own writer."""
    bear = figure_cloud(number_of_points)
    if colored:
        colors = numpy_to_vtk(colors_at(vtk_to_numpy(bear.GetPoints().GetData())), deep=True)
        colors.SetName("RGB")
        bear.GetPointData().SetScalars(colors)
    cloud = simple.TrivialProducer()
    cloud.GetClientSideObject().SetOutput(bear)
    path = os.path.join(folder, "colored.ply" if colored else "bear.ply")
    servermanager.writers.ConformalPLYWriter(Input=cloud, FileName=path).UpdatePipeline()
    simple.Delete(cloud)
    return path


def write_picture(folder):
    """The picture to paint with, as a PNG file."""
    path = os.path.join(folder, "rosette.png")
    writer = vtkPNGWriter()
    writer.SetInputData(textures.rosette(512))
    writer.SetFileName(path)
    writer.Write()
    return path


def open_and_paint(scan, picture):
    """Open a scan, learn, smooth and paint it, and look at it."""
    points = simple.OpenDataFile(scan)
    mesh = simple.ConformalSOM(Input=points, NumberOfNeurons=2562)
    surface = simple.CurvedSeamlessSurface(Input=mesh, Frequency=48)
    painted = simple.SphericalTextureMap(Input=surface)
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.Show(painted, view).Texture = simple.CreateTexture(picture)
    simple.ResetCamera(view)
    return painted


def draw(path):
    """Save the active view as a picture, on one background, without the axes and their letters."""
    view = simple.GetActiveView()
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0  # ParaView 6 has another one
    view.Background = [0.32, 0.34, 0.43]
    simple.SaveScreenshot(path, view, ImageResolution=SIZE)


def picture_of(path):
    """A saved picture as a source of images."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return reader


def replay(file, path):
    """Draw what a saved state or a recorded script shows, in a pvbatch that knows nothing else."""
    subprocess.run(["pvbatch", os.path.abspath(__file__), file, path], check=True)


if __name__ == "__main__":
    if sys.argv[1].endswith(".py"):
        with open(sys.argv[1], encoding="utf-8") as script:
            exec(script.read())
    else:
        simple.LoadState(sys.argv[1])
    for texture in servermanager.ProxyManager().GetProxiesInGroup("textures").values():
        texture.FileName = texture.FileName  # without it, pvbatch of ParaView 5.13 has not read it
    draw(sys.argv[2])
