"""Compares pictures with those in Testing/Data/Baseline: pixel by pixel where they are drawn by a VTK
and an OpenGL that drew baselines (renderers.txt), else by their averages over small squares.

A picture that other renderers may well draw otherwise has alternatives NAME_1.png and so on for these.
Where one differs, the new picture and a .diff.png are left in the folder that the variable
CONFORMALSOM_PICTURES names. With RENEW_BASELINES set, the pictures become the baselines: look at
them before you commit them.
"""
import glob
import os
import re
import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules import vtkRenderingOpenGL2  # pylint: disable=unused-import; draws in vtkRenderWindow
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderWindow

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data", "Baseline")
RENDERERS = os.path.join(FOLDER, "renderers.txt")
LEFT_OVERS = os.environ.get("CONFORMALSOM_PICTURES", ".")
# A pixel may be off by GRAY_LEVELS, and what goes beyond may add up to PIXELS turned from black to
# white. Mesa with other processors' instructions stays at 0.0; points moved by 1e-5 give 67.
# The picture of a surface learned on another processor differed by 7.5.
GRAY_LEVELS, PIXELS = 4, 10.0
# Other versions filter textures and draw lines otherwise, which changes the average of a square of
# SQUARE x SQUARE pixels by 4.6 at most. A shift of the picture by a pixel changes it by 9 at least.
SQUARE, SQUARE_LEVELS = 15, 6.0


def require_display():
    """Fail, rather than leave the pictures out."""
    if not os.environ.get("DISPLAY"):
        sys.exit("No display: pictures cannot be drawn. Run ctest under xvfb-run.")


def renderer():
    """What draws pictures here: VTK and OpenGL with their versions."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.Render()
    opengl = re.search("OpenGL version string: *(.*)", window.ReportCapabilities()).group(1)
    return f"VTK {vtkVersion.GetVTKVersion()}, OpenGL {opengl}"


def renderers():
    """What drew baselines: VTK's own and ParaView's."""
    with open(RENDERERS, encoding="ascii") as file:
        return file.read().splitlines()


def write_png(image, path):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def read_png(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    return reader


def pixels(image):
    """Rows of pixels of the picture that an algorithm puts out."""
    image.Update()
    width, height, _ = image.GetOutput().GetDimensions()
    return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).reshape(height, width, -1)


def square_difference(one, other):
    """By how many gray levels the averages of a square of pixels differ, where they do most."""
    if one.shape != other.shape:
        return 255.0
    sums = np.pad((one.astype(float) - other).cumsum(0).cumsum(1), ((1, 0), (1, 0), (0, 0)))
    squares = sums[SQUARE:, SQUARE:] - sums[:-SQUARE, SQUARE:] - sums[SQUARE:, :-SQUARE] + sums[:-SQUARE, :-SQUARE]
    return np.abs(squares).max() / SQUARE**2


def pixel_difference(drawn, baseline):
    """The pictures' difference beyond GRAY_LEVELS, and its picture."""
    difference = vtkImageDifference()
    difference.SetInputConnection(drawn.GetOutputPort())
    difference.SetImageConnection(baseline.GetOutputPort())
    difference.AllowShiftOff()
    difference.AveragingOff()
    difference.SetThreshold(GRAY_LEVELS)
    difference.Update()
    return difference.GetThresholdedError(), difference


def expect_picture(test, drawn, name):
    """Fail the test unless the picture that drawn puts out is the baseline of that name."""
    path = os.path.join(FOLDER, name + ".png")
    if os.environ.get("RENEW_BASELINES"):
        write_png(drawn, path)
        if renderer() not in renderers():
            with open(RENDERERS, "a", encoding="ascii") as file:
                print(renderer(), file=file)
    if not os.path.exists(path):
        write_png(drawn, os.path.join(LEFT_OVERS, name + ".png"))
        test.fail(f"there is no baseline {path}")
    error, difference = pixel_difference(drawn, read_png(path))
    alternatives = sorted(glob.glob(os.path.join(FOLDER, name + "_[0-9].png")))
    # Alternatives are equally correct: balanced maps amplify differences of last digits to some pixels.
    if error <= PIXELS or any(pixel_difference(drawn, read_png(other))[0] <= PIXELS for other in alternatives):
        return
    write_png(drawn, os.path.join(LEFT_OVERS, name + ".png"))
    write_png(difference, os.path.join(LEFT_OVERS, name + ".diff.png"))
    if renderer() in renderers():
        test.fail(f"{error} is more than {PIXELS} pixels: see {LEFT_OVERS}/{name}.diff.png")
    least = min(square_difference(pixels(drawn), pixels(read_png(other))) for other in [path] + alternatives)
    test.assertLessEqual(least, SQUARE_LEVELS, f"see {LEFT_OVERS}/{name}.diff.png")
