"""Pictures of the bear and of a dancer, as baselines."""
import os
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkLookupTable, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkClipPolyData, vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkArrowSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import baselines
import how_it_works
import webs
import zebra
from baselines import expect_picture, require_display
from helpers import textures
from helpers.builtin_figure import bear, dancer, figure_cloud, figure_surface, zero_set
from conformalsom import (
    vtkAdaptiveSphere, vtkConformalDistortion, vtkConformalPLYReader, vtkConformalSOM, vtkCurvedSeamlessMap,
    vtkCurvedSeamlessSurface, vtkGenusZeroHull, vtkGenusZeroRepair, vtkGeodesicSphereSource, vtkGlobalConformalMap,
    vtkSphericalAlignment, vtkSphericalResample, vtkSphericalTextureBlend, vtkSphericalTextureImage,
    vtkSphericalTextureMap, vtkSurfaceHarmonics, vtkSurfaceMismatch)
from conformalsom.command import pictures
from obtuse import obtuse_surface

VIEW, UP, SIZE = (0, 0, 1), (0, 1, 0), 400
PANEL = (260, 300)  # pixels of one of several


def conformal_map(surface, method="Robust", balance=0.0):
    """The surface mapped to the sphere."""
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    getattr(conformal, "SetMethodTo" + method)()
    conformal.SetAreaBalance(balance)
    conformal.Update()
    return conformal.GetOutput()


def painted_actor(surface):
    """A checkerboard on a mapped surface, its middle in front."""
    painted = vtkSphericalTextureMap()
    painted.SetInputData(surface)
    painted.SetViewDirection(VIEW)
    painted.SetViewUp(UP)
    painted.Update()
    return pictures.textured_actor(painted.GetOutput(), textures.checkerboard())


def flips_actor(surface):
    """The triangles, red where the map turns them or their neighbors over."""
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    sphere = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))
    flipped = np.linalg.det(sphere[triangles]) <= 0
    folded = np.isin(triangles, triangles[flipped]).any(axis=1)
    colors = np.where(folded[:, None], (200, 30, 30), (242, 235, 222)).astype(np.uint8)
    surface.GetCellData().SetScalars(numpy_to_vtk(colors, deep=True))
    actor = pictures.mesh_actor(surface)
    actor.GetMapper().ScalarVisibilityOn()
    actor.GetMapper().SetScalarModeToUseCellData()
    return actor


def colored_actor(surface, name, low, high, of_cells=False):
    """By an array, from light at low to dark red at high."""
    colors = vtkLookupTable()
    colors.SetHueRange(0.10, 0.0)
    colors.SetSaturationRange(0.1, 0.85)
    colors.SetValueRange(0.95, 0.6)
    colors.Build()
    actor = pictures.actor_of(surface)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    mapper.SetLookupTable(colors)
    mapper.SetScalarRange(low, high)
    if of_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray(name)
    return actor


def turned_map(surface):
    """A copy whose map is turned by 50 degrees."""
    turned = vtkPolyData()
    turned.DeepCopy(surface)
    sphere = vtk_to_numpy(turned.GetPointData().GetArray("SpherePosition"))
    cosine, sine = np.cos(np.radians(50)), np.sin(np.radians(50))
    sphere[:] = sphere @ np.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1]])
    return turned


def scan_from_front(scan, cell=0.05, depth=0.15):
    """The points that are seen against the axis z: those near the frontmost one of each square cell."""
    points = vtk_to_numpy(scan.GetPoints().GetData())
    _, cells = np.unique(np.floor(points[:, :2] / cell), axis=0, return_inverse=True)
    front = np.full(cells.max() + 1, -np.inf)
    np.maximum.at(front, cells.ravel(), points[:, 2])
    seen = vtkPolyData()
    seen.SetPoints(vtkPoints())
    seen.GetPoints().SetData(numpy_to_vtk(points[points[:, 2] > front[cells.ravel()] - depth], deep=True))
    return seen


def bear_with_handles():
    """The bear with a ring in its hands, and a hole through it."""
    def distance(p):
        ring = np.hypot(np.hypot(p[:, 0], p[:, 2] - 0.20) - 0.48, p[:, 1] + 0.02) - 0.06
        bore = np.hypot(p[:, 0], p[:, 1] + 0.32) - 0.16
        return np.maximum(np.minimum(bear(p), ring), -bore)
    return zero_set(distance)


class TestPictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scan = figure_cloud(20000)
        cls.network = vtkConformalSOM()
        cls.network.SetInputData(cls.scan)
        cls.network.SetMeshTypeToGeodesic()  # whose map is none of the conformal ones beside it
        cls.network.SetNumberOfNeurons(2562)
        cls.surface = vtkCurvedSeamlessSurface()
        cls.surface.SetInputConnection(cls.network.GetOutputPort())
        cls.surface.SetFrequency(48)
        cls.surface.Update()

    def expect_actor(self, name, *actors, seen=None, size=SIZE):
        """Draw the actors side by side and compare with the baseline of that name."""
        window = vtkRenderWindow()
        window.SetOffScreenRendering(True)
        window.SetMultiSamples(0)
        window.SetSize(size * len(actors), size)
        for i, actor in enumerate(actors):
            renderer = vtkRenderer()
            renderer.SetBackground(1.0, 1.0, 1.0)
            renderer.SetViewport(i / len(actors), 0.0, (i + 1) / len(actors), 1.0)
            renderer.AddActor(actor)
            renderer.SetActiveCamera(pictures.camera_on(seen or self.scan, VIEW, UP, 1.0))
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

    def test_colors_baked_and_put_back(self):
        """Bands of paint across the bear, as colors of its points."""
        surface = self.surface.GetOutput()
        points = vtk_to_numpy(surface.GetPoints().GetData())
        wave = np.sin(points @ np.array([[4.0, 14.0, 0.0], [14.0, -4.0, 6.0], [3.0, 3.0, 14.0]]).T)
        colors = numpy_to_vtk(np.rint(140 + 90 * wave).astype(np.uint8), deep=True)
        colors.SetName("Paint")
        surface.GetPointData().AddArray(colors)
        colored = pictures.actor_of(surface)
        colored.GetMapper().SetScalarModeToUsePointFieldData()
        colored.GetMapper().SelectColorArray("Paint")
        colored.GetMapper().ScalarVisibilityOn()
        scenes = [pictures.scene(colored, "Colors of points", self.camera())]
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
        blend.SetFrontData(front)
        blend.SetBackData(back)
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

    def coarse_surface(self, frequency, dome_height, seam_mode="EdgeMatched", mesh_type="Geodesic"):
        """The surface over a mesh that is coarse enough to see the construction."""
        network = vtkConformalSOM()
        network.SetInputData(self.scan)
        getattr(network, "SetMeshTypeTo" + mesh_type)()
        network.SetNumberOfNeurons(10 * frequency**2 + 2)
        surface = vtkCurvedSeamlessSurface()
        surface.SetInputConnection(network.GetOutputPort())
        surface.SetCloudData(self.scan)
        surface.SetFrequency(120)
        getattr(surface, "SetDomeHeightTo" + dome_height)()
        getattr(surface, "SetSeamModeTo" + seam_mode)()
        surface.Update()
        return surface.GetOutput()

    def test_dome_heights_over_a_coarse_mesh(self):
        self.expect_actor("DomeHeights", *(
            pictures.actor_of(self.coarse_surface(8, dome_height, mesh_type="Adaptive"))
            for dome_height in ("None", "Published", "Curvature", "Fitted")))

    def test_lines_across_the_seams_of_a_coarse_mesh(self):
        """Lines of constant direction break where the published map jumps."""
        actors = []
        for seam_mode in ("PerTriangle", "EdgeMatched"):
            surface = self.coarse_surface(5, "Curvature", seam_mode)
            directions = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))
            stripes = numpy_to_vtk(np.sin(40.0 * directions[:, 0]), deep=True)
            surface.GetPointData().SetScalars(stripes)
            actor = pictures.actor_of(surface)
            actor.GetMapper().ScalarVisibilityOn()
            actor.GetMapper().InterpolateScalarsBeforeMappingOn()
            black_and_white = vtkLookupTable()
            black_and_white.SetNumberOfTableValues(2)
            black_and_white.SetTableValue(0, 0.2, 0.24, 0.3, 1.0)
            black_and_white.SetTableValue(1, 0.95, 0.92, 0.87, 1.0)
            actor.GetMapper().SetLookupTable(black_and_white)
            actors.append(actor)
        self.expect_actor("SeamModes", *actors)

    def test_checkerboard_on_the_surface(self):
        self.expect_actor("SphericalTextureMap", painted_actor(self.surface.GetOutput()))

    def test_distance_to_the_figure_in_colors(self):
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

    def test_what_nobody_saw(self):
        """The bear without a part of its back: the scan, where it supports the surface, and the rest cut off."""
        points = vtk_to_numpy(self.scan.GetPoints().GetData())
        back = points[points[:, 2].argmin()]
        seen = vtkPolyData()
        seen.SetPoints(vtkPoints())
        kept = points[np.linalg.norm(points - back, axis=1) > 0.45 * np.ptp(points[:, 0])]
        seen.GetPoints().SetData(numpy_to_vtk(kept, deep=True))
        network = vtkConformalSOM()
        network.SetInputData(seen)
        surface = vtkCurvedSeamlessSurface()
        surface.SetInputConnection(network.GetOutputPort())
        surface.SetFrequency(72)
        surface.Update()
        support = surface.GetOutput().GetPointData().GetArray("Supported").GetRange()
        self.assertEqual(support, (0.0, 1.0))
        surface.GetOutput().GetPointData().SetActiveScalars("Supported")
        colors = vtkLookupTable()
        colors.SetHueRange(0.04, 0.12)
        colors.SetSaturationRange(0.8, 0.1)
        colors.SetValueRange(0.8, 0.95)
        colors.SetTableRange(0.0, 1.0)
        colors.Build()
        colored = pictures.actor_of(surface.GetOutput())
        colored.GetMapper().ScalarVisibilityOn()
        colored.GetMapper().UseLookupTableScalarRangeOn()
        colored.GetMapper().SetLookupTable(colors)
        cut = vtkClipPolyData()
        cut.SetInputConnection(surface.GetOutputPort())
        cut.SetValue(0.5)
        cut.Update()
        camera = lambda: self.camera(215)
        behind = (np.sin(np.radians(215)), 0, np.cos(np.radians(215)))
        self.expect_row("Supported", (
            pictures.scene(pictures.cloud_actor(seen, behind), "Scan, from behind", camera()),
            pictures.scene(colored, "Supported", camera()),
            pictures.scene(pictures.actor_of(cut.GetOutput()), "At least 0.5", camera())))

    def test_seen_from_one_side(self):
        """The front of the bear: the scan, the closed surface, the one with a border, and a checkerboard on the disk."""
        seen = scan_from_front(figure_cloud(40000))
        learner = vtkConformalSOM()
        learner.SetInputData(seen)
        surfaces = []
        for border in ("Closed", "Open"):
            getattr(learner, "SetBorderTo" + border)()
            surface = vtkCurvedSeamlessSurface()
            surface.SetInputConnection(learner.GetOutputPort())
            surface.Update()
            surfaces.append(surface.GetOutput())
        painted = vtkSphericalTextureMap()
        painted.SetInputData(surfaces[1])
        painted.SetProjectionToSquare()
        painted.Update()
        self.assertEqual(vtk_to_numpy(painted.GetOutput().GetPointData().GetArray("OutsideImage")).max(), 0)
        camera = lambda: self.camera(60)
        side = (np.sin(np.radians(60)), 0, np.cos(np.radians(60)))
        self.expect_row("OneSide", (
            pictures.scene(pictures.cloud_actor(seen, side), "Scan from the front", camera()),
            pictures.scene(pictures.actor_of(surfaces[0]), "Closed", camera()),
            pictures.scene(pictures.actor_of(surfaces[1]), "Open", camera()),
            pictures.scene(pictures.textured_actor(painted.GetOutput(), textures.checkerboard()), "Square",
                           camera())))

    def test_checkerboard_by_the_conformal_map(self):
        self.expect_actor(
            "GlobalConformalMap", painted_actor(conformal_map(self.surface.GetOutput())))

    def test_gu_yau_folds_where_robust_does_not(self):
        surface = obtuse_surface(self.network)
        self.expect_actor("GuYauAndRobust", *(
            flips_actor(conformal_map(surface, method)) for method in ("GuYau", "Robust")))

    def test_balance_gives_limbs_room_on_the_sphere(self):
        spheres = [how_it_works.sphere_of(conformal_map(self.network.GetOutput(), balance=balance))
                   for balance in (0.0, 0.1, 0.5)]
        self.expect_actor("AreaBalance", *(pictures.mesh_actor(sphere) for sphere in spheres),
                          seen=spheres[0], size=280)


    def test_adaptive_sphere_keeps_the_ears(self):
        """Even directions and an adaptive sphere of as many, and the surface sampled by both."""
        mapped = conformal_map(self.surface.GetOutput())
        even = vtkGeodesicSphereSource()
        even.SetFrequency(20)
        adaptive = vtkAdaptiveSphere()
        adaptive.SetInputData(mapped)
        adaptive.SetNumberOfPoints(4002)
        scenes = []
        for label, sphere in ("Even directions", even), ("Adaptive sphere", adaptive):
            sampled = vtkCurvedSeamlessSurface()
            sampled.SetInputData(mapped)
            sampled.SetSphereConnection(sphere.GetOutputPort())
            sampled.SetVertexShift(0)
            sampled.Update()
            ball = pictures.camera_on(even.GetOutput(), VIEW, UP, PANEL[0] / PANEL[1])
            scenes.append(pictures.scene(pictures.mesh_actor(sphere.GetOutput()), label, ball))
            scenes.append(pictures.scene(
                pictures.mesh_actor(sampled.GetOutput()), "sampled by it", self.camera()))
        self.expect_row("AdaptiveSphere", scenes)

    def test_how_far_maps_are_from_conformal(self):
        scenes = []
        network = self.network.GetOutput()
        for label, mapped in ("Learned", network), ("Mapped conformally", conformal_map(network)):
            distortion = vtkConformalDistortion()
            distortion.SetInputData(mapped)
            distortion.Update()
            scenes.append(pictures.scene(
                colored_actor(distortion.GetOutput(), "QuasiConformalError", 1.0, 2.0, of_cells=True), label,
                self.camera()))
        self.expect_row("ConformalDistortion", scenes)

    def test_alignment_brings_a_turned_map_back(self):
        learned = self.surface.GetOutput()
        turned = turned_map(learned)
        alignment = vtkSphericalAlignment()
        alignment.SetInputData(turned)
        alignment.SetReferenceConnection(self.surface.GetOutputPort())
        alignment.Update()
        scenes = []
        for surface, label in (learned, "One map"), (turned, "Turned"), (alignment.GetOutput(), "Aligned"):
            shown = vtkPolyData()
            shown.ShallowCopy(surface)
            stripes = np.sin(9.0 * vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))[:, :2])
            array = numpy_to_vtk(stripes.sum(axis=1), deep=True)
            array.SetName("Stripes")
            shown.GetPointData().AddArray(array)
            scenes.append(pictures.scene(colored_actor(shown, "Stripes", -2.0, 2.0), label, self.camera()))
        self.expect_row("SphericalAlignment", scenes)

    def test_resampled_colors(self):
        fine = vtkPolyData()
        fine.ShallowCopy(self.surface.GetOutput())
        waves = np.sin(12.0 * vtk_to_numpy(fine.GetPoints().GetData())).sum(axis=1)
        array = numpy_to_vtk(waves, deep=True)
        array.SetName("Waves")
        fine.GetPointData().AddArray(array)
        resample = vtkSphericalResample()
        resample.SetInputConnection(self.network.GetOutputPort())
        resample.SetSourceData(fine)
        resample.Update()
        self.expect_row("SphericalResample", [
            pictures.scene(colored_actor(surface, "Waves", -2.0, 2.0), label, self.camera())
            for surface, label in ((fine, f"{fine.GetNumberOfPoints():,} points"), (
                resample.GetOutput(), f"{resample.GetOutput().GetNumberOfPoints():,} points"))])

    def test_hull_of_a_dancer(self):
        cloud = figure_cloud(20000, figure=dancer)
        hull = vtkGenusZeroHull()
        hull.SetInputData(cloud)
        hull.Update()
        camera = lambda: pictures.camera_on(cloud, VIEW, UP, PANEL[0] / PANEL[1])
        self.expect_row("GenusZeroHull", (
            pictures.scene(pictures.cloud_actor(cloud, VIEW), "Points", camera()),
            pictures.scene(pictures.actor_of(hull.GetOutput()), "Hull", camera())))

    def test_geodesic_spheres(self):
        scenes = []
        for frequency in (1, 3, 9, 27):
            sphere = vtkGeodesicSphereSource()
            sphere.SetFrequency(frequency)
            sphere.Update()
            camera = pictures.camera_on(sphere.GetOutput(), VIEW, UP, PANEL[0] / PANEL[1])
            scenes.append(pictures.scene(pictures.mesh_actor(sphere.GetOutput()), f"f = {frequency}", camera))
        self.expect_row("GeodesicSphereSource", scenes)

    def test_points_of_the_sphere_on_the_surface(self):
        """By the map, with normals: arrows at the vertices of a geodesic sphere."""
        sphere = vtkGeodesicSphereSource()
        sphere.SetFrequency(6)
        sphere.Update()
        positions, normals = vtkDoubleArray(), vtkDoubleArray()
        surface_map = vtkCurvedSeamlessMap()
        surface_map.Build(self.network.GetOutput())
        directions = sphere.GetOutput().GetPointData().GetArray("SpherePosition")
        surface_map.ToSurface(directions, positions, normals)
        points = vtkPoints()
        points.SetData(positions)
        scenes = []
        for surface, label, at, along in (
                (sphere.GetOutput(), "Directions", sphere.GetOutput().GetPoints(), directions),
                (self.surface.GetOutput(), "Positions and normals", points, normals)):
            arrows = vtkPolyData()
            arrows.SetPoints(at)
            arrows.GetPointData().SetNormals(along)
            arrow, glyphs = vtkArrowSource(), vtkGlyph3D()
            glyphs.SetInputData(arrows)
            glyphs.SetSourceConnection(arrow.GetOutputPort())
            glyphs.SetVectorModeToUseNormal()
            glyphs.SetScaleFactor(0.04 * surface.GetLength())
            glyphs.Update()
            camera = pictures.camera_on(surface, VIEW, UP, PANEL[0] / PANEL[1])
            scene = pictures.scene(pictures.actor_of(surface), label, camera)
            shafts = pictures.actor_of(glyphs.GetOutput())
            shafts.GetProperty().SetColor(pictures.SLATE)
            scene.AddActor(shafts)
            scenes.append(scene)
        self.expect_row("CurvedSeamlessMap", scenes)

    def test_handles_are_cut_and_tunnels_filled(self):
        """A bear with handles and the loops along which it is mended, in red; and it mended, what is new in red."""
        holed = bear_with_handles()
        repair = vtkGenusZeroRepair()
        repair.SetInputData(holed)
        repair.Update()
        mended = repair.GetOutput()
        self.assertEqual(mended.GetFieldData().GetArray("EulerNumber").GetValue(0), 2)
        loops = pictures.actor_of(repair.GetOutput(1))
        loops.GetProperty().BackfaceCullingOff()
        loops.GetProperty().SetColor(0.8, 0.1, 0.1)
        loops.GetProperty().LightingOff()
        loops.GetProperty().SetLineWidth(3 * pictures.FINER)
        actor = pictures.actor_of(holed)
        actor.GetProperty().BackfaceCullingOff()  # the contour is inside out
        before = pictures.scene(actor, "With handles", self.camera())
        before.AddActor(loops)
        colors = np.where((vtk_to_numpy(mended.GetCellData().GetArray("OriginalCellIds")) < 0)[:, None],
                          (200, 30, 30), (204, 158, 117)).astype(np.uint8)
        mended.GetCellData().SetScalars(numpy_to_vtk(colors, deep=True))
        actor = pictures.actor_of(mended)
        actor.GetMapper().ScalarVisibilityOn()
        actor.GetMapper().SetScalarModeToUseCellData()
        after = pictures.scene(actor, "Repaired", self.camera())
        self.expect_row("GenusZeroRepair", [before, after])

    def test_harmonics_of_the_bunny(self):
        path = os.path.join(os.environ.get("CONFORMALSOM_SCAN_DIR", ""), "stanford-bunny-closed.ply")
        if not os.path.exists(path):
            self.skipTest("stanford-bunny-closed.ply is not in CONFORMALSOM_SCAN_DIR")
        reader = vtkConformalPLYReader()
        reader.SetFileName(path)
        reader.Update()
        mapped = conformal_map(reader.GetOutput(), balance=0.5)
        camera = lambda: pictures.camera_on(mapped, VIEW, UP, PANEL[0] / PANEL[1], azimuth=18)
        scenes = []
        for degree in (4, 12, 20, 60):
            harmonics = vtkSurfaceHarmonics()
            harmonics.SetInputData(mapped)
            harmonics.SetDegree(degree)
            harmonics.Update()
            scenes.append(pictures.scene(
                pictures.actor_of(harmonics.GetOutput()), f"L = {degree}", camera()))
        scenes.append(pictures.scene(pictures.actor_of(mapped), "The scan", camera()))
        self.expect_row("SphericalHarmonics", scenes)


class TestTolerance(unittest.TestCase):
    def test_a_shift_by_a_pixel_is_seen_by_any_renderer(self):
        for name in os.listdir(baselines.FOLDER):
            if name.endswith(".png"):
                with self.subTest(name):
                    picture = baselines.pixels(baselines.read_png(os.path.join(baselines.FOLDER, name)))
                    self.assertEqual(baselines.square_difference(picture, picture), 0.0)
                    self.assertGreater(baselines.square_difference(picture[:, 1:], picture[:, :-1]),
                                       baselines.SQUARE_LEVELS)


class TestExamplePictures(unittest.TestCase):
    """Examples that write one picture."""

    def expect_written(self, example, name):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "example.png")
            example.write(path)
            drawn = vtkPNGReader()
            drawn.SetFileName(path)
            drawn.Update()
            expect_picture(self, drawn, name)

    def test_webs_before_and_after(self):
        self.expect_written(webs, "Webs")

    def test_reflections_of_noisy_and_fair_surfaces(self):
        self.expect_written(zebra, "Zebra")


class TestHowItWorks(unittest.TestCase):
    def test_each_stage(self):
        for name, drawn in how_it_works.draw().items():
            expect_picture(self, drawn, "HowItWorks" + name)

    def test_flow_of_the_page(self):
        page = os.path.join(os.path.dirname(__file__), "..", "..", "Documentation", "HowItWorks", "flow.svg")
        with open(page, encoding="ascii") as file:
            self.assertEqual(file.read(), how_it_works.flow())


if __name__ == "__main__":
    require_display()
    unittest.main()
