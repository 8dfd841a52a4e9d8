"""Four pictures of the bear and one of a dancer, as baselines."""
import os
import sys
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import pictures
import textures
import webs
from baselines import expect_picture
from builtin_figure import figure_cloud, figure_surface
from conformalsom import (
    vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkSurfaceMismatch)

VIEW, UP, SIZE = (0, 0, 1), (0, 1, 0), 400


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

    def expect_actor(self, name, actor):
        """Draw the actor and compare with the baseline of that name."""
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
        expect_picture(self, drawn, name)

    def test_learned_mesh_as_wireframe(self):
        actor = pictures.actor_of(self.network.GetOutput())
        actor.GetProperty().SetRepresentationToWireframe()
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(pictures.INK)
        self.expect_actor("ConformalSOMWireframe", actor)

    def test_smooth_surface_shaded(self):
        self.expect_actor("CurvedSeamlessSurface", pictures.actor_of(self.surface.GetOutput()))

    def test_checkerboard_on_the_surface(self):
        painted = vtkSphericalTextureMap()
        painted.SetInputConnection(self.surface.GetOutputPort())
        painted.SetViewDirection(VIEW)
        painted.SetViewUp(UP)
        painted.Update()
        self.expect_actor("SphericalTextureMap",
                          pictures.textured_actor(painted.GetOutput(), textures.checkerboard()))

    def test_distance_to_the_figure_in_colours(self):
        mismatch = vtkSurfaceMismatch()
        mismatch.SetInputConnection(0, self.surface.GetOutputPort())
        mismatch.SetInputData(1, figure_surface())
        mismatch.Update()
        mismatch.GetOutput().GetPointData().SetActiveScalars("Distance")
        colors = vtkLookupTable()
        colors.SetHueRange(0.6, 0.0)
        colors.SetTableRange(0.0, 0.01)
        colors.Build()
        actor = pictures.actor_of(mismatch.GetOutput())
        actor.GetMapper().ScalarVisibilityOn()
        actor.GetMapper().UseLookupTableScalarRangeOn()
        actor.GetMapper().SetLookupTable(colors)
        self.expect_actor("SurfaceMismatch", actor)


class TestWebs(unittest.TestCase):
    def test_before_and_after(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "webs.png")
            webs.write(path)
            drawn = vtkPNGReader()
            drawn.SetFileName(path)
            drawn.Update()
            expect_picture(self, drawn, "Webs")


if __name__ == "__main__":
    if not os.environ.get("DISPLAY"):
        print("Pictures need a display: run ctest under xvfb-run")
        sys.exit(125)
    unittest.main()
