"""Four pictures, compared pixel by pixel with those in Testing/Data/Baseline.

Where one differs, the new picture and a .diff.png are left in the folder that the variable
CONFORMALSOM_PICTURES names. With RENEW_BASELINES set, the pictures become the baselines: look at
them before you commit them.
"""
import os
import sys
import unittest

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkImagingCore import vtkImageDifference
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import pictures
import textures
from builtin_figure import figure_cloud
from conformalsom import (
    vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkSurfaceMismatch)

HERE = os.path.dirname(os.path.abspath(__file__))
BASELINES = os.path.join(HERE, "..", "Data", "Baseline")
LEFT_OVERS = os.environ.get("CONFORMALSOM_PICTURES", ".")
VIEW, UP, SIZE = (0, 0, 1), (0, 1, 0), 400
# Another processor may round the last bit otherwise and so move a line by a hair: a pixel may be
# off by GREY_LEVELS, and what goes beyond may add up to so many pixels turned from black to white.
GREY_LEVELS, PIXELS = 8, 30.0


def write_png(image, path):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


class TestPictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scan = figure_cloud(20000)
        cls.network = vtkConformalSOM()
        cls.network.SetInputData(cls.scan)
        cls.network.SetFrequency(16)
        cls.surface = vtkCurvedSeamlessSurface()
        cls.surface.SetInputConnection(cls.network.GetOutputPort())
        cls.surface.SetFrequency(48)
        cls.surface.Update()

    def expect_picture(self, name, actor):
        """Draw the actor and compare with the baseline of that name, or renew it."""
        renderer = vtkRenderer()
        renderer.SetBackground(1.0, 1.0, 1.0)
        renderer.AddActor(actor)
        renderer.SetActiveCamera(pictures.camera_on(self.scan, VIEW, UP, 1.0))
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(SIZE, SIZE)
        window.AddRenderer(renderer)
        window.Render()
        drawn = vtkWindowToImageFilter()
        drawn.SetInput(window)
        drawn.ReadFrontBufferOff()
        path = os.path.join(BASELINES, name + ".png")
        if os.environ.get("RENEW_BASELINES"):
            write_png(drawn, path)
        if not os.path.exists(path):
            write_png(drawn, os.path.join(LEFT_OVERS, name + ".png"))
            self.fail(f"there is no baseline {path}")
        baseline = vtkPNGReader()
        baseline.SetFileName(path)
        difference = vtkImageDifference()
        difference.SetInputConnection(drawn.GetOutputPort())
        difference.SetImageConnection(baseline.GetOutputPort())
        difference.AllowShiftOff()
        difference.AveragingOff()
        difference.SetThreshold(GREY_LEVELS)
        difference.Update()
        error = difference.GetThresholdedError()
        if error > PIXELS:
            write_png(drawn, os.path.join(LEFT_OVERS, name + ".png"))
            write_png(difference, os.path.join(LEFT_OVERS, name + ".diff.png"))
        self.assertLessEqual(error, PIXELS, f"see {LEFT_OVERS}/{name}.diff.png")

    def test_learned_mesh_as_wireframe(self):
        actor = pictures.actor_of(self.network.GetOutput())
        actor.GetProperty().SetRepresentationToWireframe()
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(pictures.INK)
        self.expect_picture("ConformalSOMWireframe", actor)

    def test_smooth_surface_shaded(self):
        self.expect_picture("CurvedSeamlessSurface", pictures.actor_of(self.surface.GetOutput()))

    def test_checkerboard_on_the_surface(self):
        painted = vtkSphericalTextureMap()
        painted.SetInputConnection(self.surface.GetOutputPort())
        painted.SetViewDirection(VIEW)
        painted.SetViewUp(UP)
        painted.Update()
        self.expect_picture("SphericalTextureMap",
                            pictures.textured_actor(painted.GetOutput(), textures.checkerboard()))

    def test_distance_to_the_scan_in_colours(self):
        mismatch = vtkSurfaceMismatch()
        mismatch.SetInputConnection(0, self.surface.GetOutputPort())
        mismatch.SetInputData(1, self.scan)
        mismatch.Update()
        mismatch.GetOutput().GetPointData().SetActiveScalars("Distance")
        colors = vtkLookupTable()
        colors.SetHueRange(0.6, 0.0)
        colors.SetTableRange(0.0, 0.02)
        colors.Build()
        actor = pictures.actor_of(mismatch.GetOutput())
        actor.GetMapper().ScalarVisibilityOn()
        actor.GetMapper().UseLookupTableScalarRangeOn()
        actor.GetMapper().SetLookupTable(colors)
        self.expect_picture("SurfaceMismatch", actor)


if __name__ == "__main__":
    if not os.environ.get("DISPLAY"):
        print("Pictures need a display: run ctest under xvfb-run")
        sys.exit(125)
    unittest.main()
