"""Compares pictures pixel by pixel with those in Testing/Data/Baseline.

Where one differs, the new picture and a .diff.png are left in the folder that the variable
CONFORMALSOM_PICTURES names. With RENEW_BASELINES set, the pictures become the baselines: look at
them before you commit them.
"""
import os
import sys

from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data", "Baseline")
LEFT_OVERS = os.environ.get("CONFORMALSOM_PICTURES", ".")
# A pixel may be off by GRAY_LEVELS, and what goes beyond may add up to PIXELS turned from black to
# white. Mesa with other processors' instructions stays at 0.0; points moved by 1e-5 give 67.
GRAY_LEVELS, PIXELS = 4, 5.0


def require_display():
    """Fail, rather than leave the pictures out."""
    if not os.environ.get("DISPLAY"):
        sys.exit("No display: pictures cannot be drawn. Run ctest under xvfb-run.")


def write_png(image, path):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def expect_picture(test, drawn, name):
    """Fail the test unless the picture that drawn puts out is the baseline of that name."""
    path = os.path.join(FOLDER, name + ".png")
    if os.environ.get("RENEW_BASELINES"):
        write_png(drawn, path)
    if not os.path.exists(path):
        write_png(drawn, os.path.join(LEFT_OVERS, name + ".png"))
        test.fail(f"there is no baseline {path}")
    baseline = vtkPNGReader()
    baseline.SetFileName(path)
    difference = vtkImageDifference()
    difference.SetInputConnection(drawn.GetOutputPort())
    difference.SetImageConnection(baseline.GetOutputPort())
    difference.AllowShiftOff()
    difference.AveragingOff()
    difference.SetThreshold(GRAY_LEVELS)
    difference.Update()
    error = difference.GetThresholdedError()
    if error > PIXELS:
        write_png(drawn, os.path.join(LEFT_OVERS, name + ".png"))
        write_png(difference, os.path.join(LEFT_OVERS, name + ".diff.png"))
    test.assertLessEqual(error, PIXELS, f"see {LEFT_OVERS}/{name}.diff.png")
