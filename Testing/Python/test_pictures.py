"""Pictures of the bear and of a dancer, as baselines."""
import os
import sys
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import pictures
import textures
import webs
from baselines import expect_picture
from builtin_figure import figure_cloud, figure_surface
from conformalsom import (
    vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureBlend, vtkSphericalTextureImage,
    vtkSphericalTextureMap, vtkSurfaceMismatch)

VIEW, UP, SIZE = (0, 0, 1), (0, 1, 0), 400
PANEL = (260, 300)  # pixels of one of several


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

    def camera(self, azimuth=18):
        return pictures.camera_on(self.scan, VIEW, UP, PANEL[0] / PANEL[1], azimuth=azimuth)

    def expect_row(self, name, scenes):
        """Draw panels side by side and compare with the baseline of that name."""
        drawn = pictures.draw_side_by_side(scenes, PANEL[0] * len(scenes), PANEL[1])
        expect_picture(self, drawn, name)

    def painted(self, projection, margin=0.0):
        """The surface with all of an image laid around it."""
        filter_ = vtkSphericalTextureMap()
        filter_.SetInputConnection(self.surface.GetOutputPort())
        filter_.SetProjection(projection)
        filter_.SetFieldOfView(320)  # of the stereographic projection, most of the sphere
        filter_.SetMargin(margin)
        filter_.SplitSeamOn()
        filter_.Update()
        return filter_

    def test_all_projections_with_their_seams(self):
        image = textures.numbered_grid(512, 12)
        scenes = []
        for projection, label in enumerate(
                ("Stereographic", "Longitude, latitude", "Octahedral", "Cube map")):
            actor = pictures.textured_actor(self.painted(projection).GetOutput(), image)
            scenes.append(pictures.scene(actor, label + ", from behind", self.camera(200)))
        self.expect_row("SphericalTextureProjections", scenes)

    def test_colours_baked_and_put_back(self):
        """Bands of paint across the bear, as colours of its points."""
        surface = self.surface.GetOutput()
        points = vtk_to_numpy(surface.GetPoints().GetData())
        wave = np.sin(points @ np.array([[4.0, 14.0, 0.0], [14.0, -4.0, 6.0], [3.0, 3.0, 14.0]]).T)
        colors = numpy_to_vtk(np.rint(140 + 90 * wave).astype(np.uint8), deep=True)
        colors.SetName("Paint")
        surface.GetPointData().AddArray(colors)
        coloured = pictures.actor_of(surface)
        coloured.GetMapper().SetScalarModeToUsePointFieldData()
        coloured.GetMapper().SelectColorArray("Paint")
        coloured.GetMapper().ScalarVisibilityOn()
        scenes = [pictures.scene(coloured, "Colours of points", self.camera())]
        for projection, size, label in (
                (vtkSphericalTextureMap.OCTAHEDRAL, (512, 512), "Octahedral"),
                (vtkSphericalTextureMap.CUBE_MAP, (768, 512), "Cube map")):
            painted = self.painted(projection, margin=0.01)
            baked = vtkSphericalTextureImage()
            baked.SetInputConnection(painted.GetOutputPort())
            baked.SetArrayName("Paint")
            baked.SetImageSize(size)
            baked.Update()
            scenes.append(pictures.image_scene(
                baked.GetOutput(), label + ", baked", PANEL[0] / PANEL[1]))
        back = pictures.textured_actor(painted.GetOutput(), baked.GetOutput())
        scenes.append(pictures.scene(back, "Put back", self.camera()))
        self.expect_row("SphericalTextureImage", scenes)
        surface.GetPointData().RemoveArray("Paint")

    def test_front_and_back_picture_blended(self):
        painted = self.painted(vtkSphericalTextureMap.OCTAHEDRAL, margin=0.01)
        front, back = textures.rosette(512), textures.wood(512)
        blend = vtkSphericalTextureBlend()
        blend.SetInputConnection(painted.GetOutputPort())
        blend.SetInputDataObject(1, front)
        blend.SetInputDataObject(2, back)
        blend.Update()
        scenes = [pictures.image_scene(front, "Front", PANEL[0] / PANEL[1]),
                  pictures.image_scene(back, "Back", PANEL[0] / PANEL[1])]
        for azimuth, label in ((18, "From the front"), (95, "From the side"), (185, "From behind")):
            actor = pictures.textured_actor(painted.GetOutput(), blend.GetOutput())
            scenes.append(pictures.scene(actor, label, self.camera(azimuth)))
        self.expect_row("SphericalTextureBlend", scenes)

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
