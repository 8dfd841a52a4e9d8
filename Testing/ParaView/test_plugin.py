"""Every proxy of the plugin is made and works; files find their readers and writers."""
import os
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import numpy as np
from paraview import servermanager
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_CHAR, vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkPolyData

import scenes

def proxies():
    """Group and element of every proxy."""
    for group in ElementTree.parse(os.environ["CONFORMALSOM_PROXIES"]).getroot():
        for element in group:
            yield group.get("name"), element


def hints(tag):
    """Name of the proxy and the hint, of all that have it."""
    for _, element in proxies():
        for hint in element.iter(tag):
            yield element.get("name"), hint


def extension_of_tables(hint):
    """Whether files of a hint hold a table, not a surface."""
    return hint.get("extensions") == "coef"


class TestPlugin(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="plugin ")
        cls.scan = scenes.write_scan(cls.temporary.name, 4000)
        cls.points = simple.OpenDataFile(cls.scan)
        cls.mesh = simple.ConformalSOM(Input=cls.points, NumberOfNeurons=642)
        cls.surface = simple.CurvedSeamlessSurface(Input=cls.mesh, Frequency=16)
        cls.painted = simple.SphericalTextureMap(
            Input=cls.surface, Projection="Octahedral", SplitSeam=1)
        harmonics = simple.SurfaceHarmonics(Input=cls.surface, Degree=4)
        harmonics.UpdatePipeline()
        cls.harmonics = servermanager.OutputPort(harmonics, 1)
        cls.picture = simple.PNGSeriesReader(FileNames=[scenes.write_picture(cls.temporary.name)])

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def path(self, name):
        return os.path.join(self.temporary.name, name)

    def number(self, source, name):
        """The one value of a field array."""
        source.UpdatePipeline()
        low, high = source.FieldData[name].GetRange()
        self.assertEqual(low, high)
        return low

    def test_every_proxy_is_made(self):
        manager = servermanager.ProxyManager()
        for group, element in proxies():
            with self.subTest(element.get("name")):
                proxy = manager.NewProxy(group, element.get("name"))
                proxy.UpdateVTKObjects()
                self.assertIsNotNone(proxy.GetClientSideObject())

    def test_scan_becomes_a_surface(self):
        self.assertEqual(self.points.GetXMLName(), "ConformalPLYReader")
        self.assertEqual(self.points.GetDataInformation().GetNumberOfPoints(), 4000)
        self.mesh.UpdatePipeline()
        self.assertEqual(self.mesh.GetDataInformation().GetNumberOfPoints(), 10 * 8**2 + 2)
        self.surface.UpdatePipeline()
        self.assertEqual(self.surface.GetDataInformation().GetNumberOfCells(), 20 * 16**2)
        self.assertEqual(self.number(simple.GenusZeroCheck(Input=self.surface), "IsGenusZero"), 1)

    def painted_scan(self):
        """The surface that the compound filter makes of a scan with colors, and its source."""
        scan = simple.OpenDataFile(scenes.write_scan(self.temporary.name, 4000, colored=True))
        painted = simple.ScanToPaintedSurface(Input=scan, NumberOfNeurons=642, Frequency=40)
        painted.UpdatePipeline()
        return scan, painted

    def test_scan_becomes_a_painted_surface_in_one_step(self):
        _, painted = self.painted_scan()
        self.assertEqual(self.number(simple.GenusZeroCheck(Input=painted), "IsGenusZero"), 1)
        surface = servermanager.Fetch(painted)
        data = surface.GetPointData()
        self.assertEqual(surface.GetNumberOfPoints(), 10 * 40**2 + 2)
        colors = data.GetScalars()
        self.assertEqual((colors.GetName(), colors.GetDataType(), colors.GetNumberOfComponents()),
                         ("RGB", VTK_UNSIGNED_CHAR, 3))
        wrong = vtk_to_numpy(colors) - scenes.colors_at(vtk_to_numpy(surface.GetPoints().GetData())).astype(float)
        self.assertLess(abs(wrong).mean(), 3)
        self.assertLess(abs(wrong).max(), 25)
        self.assertEqual(data.GetNormals().GetName(), "Normals")
        self.assertEqual(data.GetTCoords().GetName(), "Texture Coordinates")
        sphere = vtk_to_numpy(data.GetArray("SpherePosition"))
        np.testing.assert_allclose(np.linalg.norm(sphere, axis=1), 1)

    def test_scan_without_colors_becomes_a_surface_in_one_step(self):
        painted = simple.ScanToPaintedSurface(Input=self.points, NumberOfNeurons=642, Frequency=16)
        painted.UpdatePipeline()
        surface = servermanager.Fetch(painted)
        self.assertEqual(surface.GetNumberOfPoints(), 10 * 16**2 + 2)
        self.assertIsNone(surface.GetPointData().GetScalars())

    def test_colors_are_shown_without_a_color_map(self):
        scan, painted = self.painted_scan()
        view = simple.CreateRenderView()
        for source in (scan, painted):
            shown = simple.Show(source, view)
            self.assertEqual((shown.ColorArrayName, shown.MapScalars), (["POINTS", "RGB"], 0))
            shown.SetScalarBarVisibility(view, True)
            self.assertFalse(shown.IsScalarBarVisible(view))
        simple.ColorBy(shown, ("POINTS", "Supported"))
        self.assertEqual(shown.MapScalars, 1)
        shown.SetScalarBarVisibility(view, True)
        self.assertTrue(shown.IsScalarBarVisible(view))
        simple.ColorBy(shown, ("POINTS", "RGB"))
        self.assertEqual(shown.MapScalars, 0)
        shown.MapScalars = 1
        self.assertEqual(shown.MapScalars, 1)  # a choice of the user
        shown.SetScalarBarVisibility(view, True)
        self.assertTrue(shown.IsScalarBarVisible(view))
        simple.ColorBy(shown, None)
        shown.MapScalars = 0
        simple.ColorBy(shown, ("POINTS", "Supported"))
        self.assertEqual(shown.MapScalars, 0)
        simple.Delete(view)

    def test_history_of_learning_is_a_table(self):
        self.mesh.UpdatePipeline()
        table = simple.OutputPort(self.mesh, 1)
        self.assertEqual(table.GetDataInformation().GetDataClassName(), "vtkTable")

    def test_measures(self):
        mismatch = simple.SurfaceMismatch(Input=self.surface, Reference=self.points)
        self.assertLess(self.number(mismatch, "MeanSquarePointToSurface"), 1e-4)
        distortion = simple.ConformalDistortion(Input=self.surface)
        self.assertEqual(self.number(distortion, "NumberOfFlippedTriangles"), 0)

    def test_other_ways_to_a_map(self):
        hull = simple.GenusZeroHull(Input=self.points, Spacing=0.05)
        mapped = simple.GlobalConformalMap(Input=hull)
        self.assertEqual(self.number(mapped, "Converged"), 1)
        aligned = simple.SphericalAlignment(Input=self.surface, Reference=self.mesh,
                                            Landmarks=[0, 0, 5, 5, 9, 9], Transform="Moebius")
        self.assertLess(self.number(aligned, "AlignmentError"), 1e-2)

    def test_optional_inputs_come_and_go(self):
        sphere = simple.GeodesicSphereSource(Frequency=4)
        surface = simple.CurvedSeamlessSurface(Input=self.mesh, Sphere=sphere, Cloud=self.points,
                                               DomeHeight="Fitted")
        surface.UpdatePipeline()
        self.assertEqual(surface.GetDataInformation().GetNumberOfPoints(), 162)
        surface.Sphere, surface.Sampling, surface.Frequency = None, "Directions", 5
        surface.UpdatePipeline()
        self.assertEqual(surface.GetDataInformation().GetNumberOfPoints(), 252)

    def test_menus_list_the_arrays_of_the_input(self):
        self.painted.UpdatePipeline()
        self.assertEqual(simple.SphericalTextureImage(Input=self.painted).ArrayName, "")
        volume = simple.Wavelet()
        volume.UpdatePipeline()
        layers = simple.SurfaceLayers(Input=self.painted, Volume=volume)
        self.assertEqual(list(layers.GetProperty("ArrayName").Available), ["", "RTData"])  # of the volume
        weighted = simple.TrivialProducer()
        cloud = vtkPolyData()
        cloud.DeepCopy(servermanager.Fetch(self.points))
        weight = vtkDoubleArray()
        weight.SetName("Weight")
        weight.SetNumberOfTuples(cloud.GetNumberOfPoints())
        weight.Fill(1.0)
        cloud.GetPointData().AddArray(weight)
        weighted.GetClientSideObject().SetOutput(cloud)
        weighted.UpdatePipeline()
        mesh = simple.ConformalSOM(Input=weighted, NumberOfNeurons=642)
        self.assertEqual((mesh.GetProperty("PriorityArrayName").Available, mesh.PriorityArrayName),
                         (["", "Weight"], ""))
        mesh.PriorityArrayName = "Weight"
        mesh.UpdatePipeline()
        self.assertEqual(mesh.GetDataInformation().GetNumberOfPoints(), 642)

    def test_images_are_baked_and_blended(self):
        baked = simple.SphericalTextureImage(Input=self.painted, ArrayName="Normals",
                                             ImageSize=[64, 32])
        blended = simple.SphericalTextureBlend(Input=self.painted, Front=self.picture,
                                               Back=self.picture, ImageSize=[64, 32])
        for image in (baked, blended):
            image.UpdatePipeline()
            self.assertEqual(image.GetDataInformation().GetExtent(), (0, 63, 0, 31, 0, 0))

    def test_what_is_written_is_read(self):
        self.surface.UpdatePipeline()
        for extension, reader in (("ply", "ConformalPLYReader"), ("off", "ConformalOFFReader"),
                                  ("m", "GuMeshReader"), ("gii", "GIFTIReader"),
                                  ("asc", "TextCloudReader"), ("white", "FreeSurferReader")):
            with self.subTest(extension):
                path = self.path("surface." + extension)
                simple.SaveData(path, self.surface)
                back = simple.OpenDataFile(path)
                self.assertEqual(back.GetXMLName(), reader)
                back.UpdatePipeline()
                self.assertEqual(back.GetDataInformation().GetNumberOfPoints(),
                                 self.surface.GetDataInformation().GetNumberOfPoints())

    def written_by(self, hint):
        """A table or an image, if the files of a writer have these; otherwise None."""
        if extension_of_tables(hint):
            return self.harmonics
        return servermanager.OutputPort(self.picture) if "tif" in hint.get("extensions").split() else None

    def test_writers_are_found_by_their_extensions(self):
        """ParaView takes the first writer that knows an extension: it must be ours."""
        self.painted.UpdatePipeline()
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetWriterFactory()
        for name, hint in hints("WriterFactory"):
            source = self.written_by(hint) or servermanager.OutputPort(self.painted)
            for extension in hint.get("extensions").split():
                with self.subTest(extension):
                    writer = factory.CreateWriter(self.path("x." + extension),
                                                  source.SMProxy, source.Port, False)
                    self.assertEqual(writer.GetXMLName(), name)

    def test_readers_are_offered_for_their_extensions(self):
        """One each of the files that they wrote, by any of its usual names."""
        self.surface.UpdatePipeline()
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = servermanager.ActiveConnection.Session
        for name, hint in hints("ReaderFactory"):
            writer = getattr(servermanager.writers, name.replace("Reader", "Writer"), None)
            if not writer:
                continue
            for extension in hint.get("extensions").split():
                with self.subTest(extension):
                    path = self.path("offered." + extension)
                    writer(Input=self.written_by(hint) or self.surface,
                           FileName=path).UpdatePipeline()
                    offered = factory.GetReaders(path, session)
                    self.assertIn(name, [offered.GetString(i)
                                         for i in range(offered.GetNumberOfStrings())])

    def test_readers_are_told_by_content(self):
        """A file that is not what its name says is left to other readers."""
        with open(self.path("water.m"), "w", encoding="ascii") as file:
            file.write("function y = f(x)\n")
        factory = servermanager.vtkSMProxyManager.GetProxyManager().GetReaderFactory()
        session = servermanager.ActiveConnection.Session
        self.assertFalse(factory.CanReadFile(self.path("water.m"), session))

    def test_painted_surface_is_written_with_its_picture(self):
        for name in ("painted.glb", "painted.obj"):
            writer = servermanager.writers.TexturedSurfaceWriter(
                Input=self.painted, Texture=self.picture, FileName=self.path(name))
            writer.UpdatePipeline()
            self.assertGreater(os.path.getsize(self.path(name)), 100000)
        self.assertTrue(os.path.exists(self.path("painted.png")))

    def test_page_is_written_with_the_array_that_is_chosen(self):
        three = self.path("three.js")
        with open(three, "w", encoding="ascii") as file:
            file.write("exports.WebGLRenderer = null;")
        writer = servermanager.writers.SurfacePageWriter(
            Input=self.painted, Texture=self.picture, ColorArrayName="OutsideImage",
            ThreeJSFileName=three, FileName=self.path("painted.html"))
        writer.UpdatePipeline()
        with open(self.path("painted.html"), encoding="utf-8") as file:
            page = file.read()
        self.assertIn('"name":"OutsideImage"', page)
        self.assertNotIn('"first":-1', page)


if __name__ == "__main__":
    unittest.main()
