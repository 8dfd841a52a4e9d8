"""conformalsom map: GeoTIFF files as GDAL reads them. Skipped without packages python3-gdal and gdal-bin."""
import contextlib
import io
import json
import os
import pty
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

import numpy as np
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy

from conformalsom import vtkConformalPLYReader, vtkGeodesicSphereSource
from conformalsom.command import geotiff, jobs, main, map_picture, mapped_files, maps
from conformalsom.command.plan import WrongUsage
from conformalsom.command.steps import Steps
from conformalsom.locales import same_locale
from test_command import heed_interrupts

try:
    from osgeo import gdal
    gdal.UseExceptions()
except ImportError:
    gdal = None

COMMAND = os.environ.get("CONFORMALSOM_COMMAND")
PROGRAM = [COMMAND] if COMMAND else [sys.executable, "-m", "conformalsom"]
RADII = np.array([3.0, 2.0, 1.5])  # km


def conformalsom(*words, **options):
    """Run the command; returns the finished process."""
    return subprocess.run([*PROGRAM, *map(str, words)], capture_output=True, text=True, **options)


def write_ellipsoid(path, frequency):
    """Write the surface of an ellipsoid."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    surface, points = source.GetOutput(), vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(surface.GetPoints().GetData()) * RADII, deep=True))
    surface.SetPoints(points)
    writer = vtkPLYWriter()
    writer.SetInputData(surface)
    writer.SetFileName(path)
    writer.Write()


@unittest.skipUnless(gdal and shutil.which("gdalinfo"), "python3-gdal or gdal-bin is not installed")
class TestMap(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="map f\u00fcr ")
        cls.body = os.path.join(cls.temporary.name, "Ellipsoid.ply")
        write_ellipsoid(cls.body, 40)
        cls.path = os.path.join(cls.temporary.name, "map.tif")
        cls.made = conformalsom("map", cls.body, "-o", cls.path, "--width", 360, "--central-longitude", 180)
        assert cls.made.returncode == 0, cls.made.stderr
        file = gdal.Open(cls.path)
        cls.bands = {file.GetRasterBand(i).GetDescription(): file.GetRasterBand(i).ReadAsArray().astype(float)
                     for i in range(1, file.RasterCount + 1)}
        left, across, _, top, _, down = file.GetGeoTransform()
        cls.longitude = np.radians(left + across * (np.arange(360) + 0.5))[None, :]
        cls.latitude = np.radians(top + down * (np.arange(180) + 0.5))[:, None]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def path_of(self, name):
        return os.path.join(self.temporary.name, name)

    def test_gdalinfo_knows_the_body_and_the_bands(self):
        text = subprocess.run(["gdalinfo", "-json", self.path], capture_output=True, text=True, check=True).stdout
        facts = json.loads(text)
        self.assertEqual([band["description"] for band in facts["bands"]],
                         ["height", "slope", "radius", "area", "x", "y", "z"])
        self.assertEqual({band["type"] for band in facts["bands"]}, {"Float32"})
        self.assertEqual({str(band["noDataValue"]) for band in facts["bands"]}, {"NaN"})
        self.assertEqual(facts["bands"][0]["unit"], "m")
        self.assertIn("Ellipsoid planetocentric", facts["coordinateSystem"]["wkt"])
        self.assertEqual(facts["geoTransform"], [0.0, 1.0, 0.0, 90.0, 0.0, -1.0])

    def test_positions_lie_at_their_pixels(self):
        """Round trip: the longitude and latitude of x, y, z are those of the pixel's middle, within 0.1 pixel."""
        x, y, z = (self.bands[name] for name in "xyz")
        longitude, latitude = np.arctan2(y, x), np.arctan2(z, np.hypot(x, y))
        across = np.angle(np.exp(1j * (longitude - self.longitude))) * np.cos(latitude)
        self.assertLess(np.degrees(np.abs(across)).max(), 0.001)
        self.assertLess(np.degrees(np.abs(latitude - self.latitude)).max(), 0.001)

    def test_radii_and_areas_are_those_of_the_ellipsoid(self):
        direction = np.stack(np.broadcast_arrays(
            np.cos(self.latitude) * np.cos(self.longitude), np.cos(self.latitude) * np.sin(self.longitude),
            np.sin(self.latitude)), axis=-1)
        exact = 1000.0 / np.linalg.norm(direction / RADII, axis=-1)
        np.testing.assert_allclose(self.bands["radius"], exact, rtol=2e-3)  # flat triangles
        p = 1.6075  # Thomsen's formula, within 1.2 %
        a, b, c = (1000.0 * RADII) ** p
        area = 4.0 * np.pi * ((a * b + a * c + b * c) / 3.0) ** (1.0 / p)
        self.assertAlmostEqual(self.bands["area"].sum() / area, 1.0, delta=0.02)
        self.assertLess(np.abs(self.bands["height"]).max(), 6.0)  # the ellipsoid is its own reference
        self.assertLess(self.bands["slope"].max(), 4.0)

    def test_picture_has_heights_in_colors_with_labels_and_a_scale(self):
        rows, columns, length = 360, 720, 40000.0
        longitude = (np.arange(columns) + 0.5)[None, :] * np.full((rows, 1), 360.0 / columns)
        bands = {"height": 500.0 * np.sin(np.radians(longitude)), "radius": np.full((rows, columns), 25000.0)}
        bands["height"][:, 600:620] = np.nan
        image = map_picture.draw(bands, 180.0, "A body")
        width, height, _ = image.GetDimensions()
        page = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1].astype(int)
        font = 13
        left, top = 5 * font, 3 * font
        plane = page[top:top + rows, left:left + columns]
        self.assertGreater(plane[90, 170, 0] - plane[90, 170, 2], 60)  # high: red
        self.assertGreater(plane[90, 530, 2] - plane[90, 530, 0], 60)  # low: blue
        np.testing.assert_array_equal(plane[90, 610], map_picture.MISSING)
        ink = page.max(axis=2) < 120
        for part in (page[:top, left:], page[top:top + rows, :left], page[top + rows:top + rows + 2 * font],
                     page[top:top + rows, left + columns + 3 * font:]):  # title, labels, legend
            self.assertGreater((part.max(axis=2) < 120).sum(), 20)
        bar = ink[top + rows + 3 * font, left:]
        pixels = int(np.argmin(bar))  # a round length, as far as it goes in a quarter of the width
        self.assertAlmostEqual(pixels / columns * 2.0 * np.pi * 25000.0, 20000.0, delta=0.02 * length)

    def test_pictures_of_narrow_maps_are_enlarged(self):
        for columns, factor in ((16, 25), (300, 2), (400, 1)):
            with self.subTest(columns):
                heights = np.tile(np.linspace(-1.0, 1.0, columns), (columns // 2, 1))
                image = map_picture.draw({"height": heights, "radius": np.full(heights.shape, 25.0)}, 180.0, "A body")
                width, height, _ = image.GetDimensions()
                page = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1]
                font = max(9, round(map_picture.FONT * factor * columns / 1000))
                self.assertEqual((width, height), (factor * columns + 14 * font, factor * columns // 2 + 8 * font))
                is_paper = page[-5 * font + 2:-3 * font - 2].min(axis=(0, 2)) > 200
                self.assertGreaterEqual((np.diff(is_paper.astype(int)) > 0).sum(), 13)  # gaps after labels

    def test_label_has_the_unit_and_the_name(self):
        """A table in meters with a label of PDS3, and one in kilometers with a label of PDS4."""
        reader = vtkConformalPLYReader()
        reader.SetFileName(self.body)
        reader.Update()
        surface = reader.GetOutput()
        points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
        triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3) + 1
        for label, text, scale in (
                ("a.lbl", 'PDS_VERSION_ID = PDS3\nTARGET_NAME = "433 EROS"\nUNIT = METER\n', 1000.0),
                ("b.xml", "<a><Target_Identification><name>433 EROS</name></Target_Identification><unit>km</unit></a>", 1.0)):
            with self.subTest(label):
                with open(self.path_of(label), "w", encoding="ascii") as file:
                    file.write(text)
                table = self.path_of(label[0] + ".tab")
                for name in (label, label[0] + ".tab", label[0] + ".tif"):
                    self.addCleanup(os.remove, self.path_of(name))
                with open(table, "w", encoding="ascii") as file:
                    file.writelines("v " + " ".join(map(repr, point)) + "\n" for point in (points * scale).tolist())
                    file.writelines("f " + " ".join(map(str, ids)) + "\n" for ids in triangles.tolist())
                path = self.path_of(label[0] + ".tif")
                made = conformalsom("map", table, "-o", path, "--width", 360, "--central-longitude", 180)
                self.assertEqual((made.returncode, made.stderr), (0, ""))
                file = gdal.Open(path)
                np.testing.assert_allclose(file.GetRasterBand(3).ReadAsArray(), self.bands["radius"], rtol=1e-4)
                self.assertIn("433 EROS planetocentric", file.GetProjection())
                other = conformalsom("map", table, "-o", path, "--width", 32, "--unit", "cm", "--overwrite")
                self.assertEqual(other.returncode, 0)
                self.assertEqual(other.stdout.count("\n"), 1)
                self.assertIn(f"conformalsom: {table}: note: --unit: cm is used, but the label has", other.stderr)

    def test_without_a_terminal_only_one_line_is_printed(self):
        self.assertEqual(self.made.stderr, "")
        self.assertRegex(self.made.stdout, r"^wrote .*map\.tif: 360 x 180 pixels, .*\n$")

    def test_standard_output_that_cannot_be_used(self):
        """The map is written if the standard output is closed, full, or read by no program."""
        script = 'set -o pipefail; exec "$@" '
        for number, (redirection, status, error) in enumerate((
                (">&-", 0, ""), ("| true", 1, ""),
                ("> /dev/full", 1, "conformalsom: the standard output: No space left on device\n"))):
            with self.subTest(redirection):
                path = self.path_of(f"closed{number}.tif")
                made = subprocess.run(["bash", "-c", script + redirection, "bash", *PROGRAM, "map", self.body, "-o", path,
                                       "--width", "32"], stderr=subprocess.PIPE, text=True, check=False)
                self.assertTrue(os.path.exists(path))
                os.unlink(path)
                self.assertEqual((made.returncode, made.stderr), (status, error))

    def test_names_that_are_not_utf8_or_have_control_characters(self):
        body = os.path.join(os.fsencode(self.temporary.name), b"b\xff.ply")
        for words in ((body, "-o", self.path_of("new.tif")),
                      (self.body, "-o", self.path_of("new.tif"), "--crs", b"b\xff")):
            made = subprocess.run([*PROGRAM, "map", *words], capture_output=True, text=True, check=False)
            self.assertEqual((made.returncode, "Traceback" in made.stderr), (2, False), made.stderr)
        body = self.path_of("b\x1b[31m.ply")
        shutil.copy(self.body, body)
        self.addCleanup(os.unlink, body)
        with io.StringIO() as shown, contextlib.redirect_stdout(shown):
            mapped_files.read(body, 0.0, Steps())
            self.assertNotIn("\x1b", shown.getvalue())
            self.assertIn(r"Map b\x1b[31m to the sphere", shown.getvalue())

    def test_picture_is_written_beside_the_map(self):
        picture, target = self.path_of("map.png"), self.path_of("with.tif")
        made = conformalsom("map", self.body, "-o", target, "--picture", picture, "--width", 100)
        self.assertEqual(made.returncode, 0, made.stderr)
        file = gdal.Open(picture)
        self.assertGreater(file.RasterXSize, 100)
        again = conformalsom("map", self.body, "-o", self.path_of("other.tif"), "--picture", picture)
        self.assertEqual(again.returncode, 2)
        self.assertIn("map.png already exists", again.stderr)
        large = self.path_of("map.JPG")
        made = conformalsom("map", self.body, "-o", target, "--picture", large, "--width", 100, "--overwrite")
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertEqual(gdal.Open(large).GetDriver().ShortName, "JPEG")
        for path in (picture, target, large):
            os.unlink(path)

    def test_signals_stop_filters_and_leave_no_file(self):
        """A signal while a filter runs ends the command by this signal, long before the filter would end."""
        large = self.path_of("large.ply")
        self.addCleanup(os.unlink, large)
        write_ellipsoid(large, 120)
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(number):
                terminal, end = pty.openpty()
                self.addCleanup(os.close, terminal)
                words = [*PROGRAM, "map", large, "-o", self.path_of("stopped.tif")]
                process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=end,
                                           env={**os.environ, "TERM": "xterm", "COLUMNS": "200"},
                                           preexec_fn=heed_interrupts)
                os.close(end)
                self.addCleanup(process.kill)
                shown = b""
                while b"Map large to the sphere" not in shown:
                    shown += os.read(terminal, 4096)
                process.send_signal(number)
                with contextlib.suppress(OSError):  # at the end of a terminal
                    while os.read(terminal, 4096):
                        pass
                self.assertEqual((process.communicate(timeout=60)[0], process.returncode), (b"", -number))
        self.assertEqual(sorted(os.listdir(self.temporary.name)), ["Ellipsoid.ply", "large.ply", "map.tif"])

    def expect_one_line(self, finished, text):
        """Expect that the command failed with a line that has a text."""
        self.assertEqual(finished.returncode, 1)
        self.assertRegex(finished.stderr, r"^conformalsom: .*\n$")
        self.assertIn(text, finished.stderr)

    def test_statistics_of_an_earlier_map_are_removed(self):
        """As GDAL does. Without --overwrite, or if one is an input, nothing is written or removed."""
        target, body = self.path_of("again.tif"), self.path_of("again.tif.ovr")
        companions = [target + extension for extension in (".aux.xml", ".msk", ".ovr")]
        shutil.copy(self.body, body)
        for path in companions[:2]:
            with open(path, "w", encoding="ascii") as file:
                file.write("of an earlier map")
        for scan, more, text in ((self.body, (), "again.tif.aux.xml already exists"),
                                 (body, ("--overwrite",), "again.tif.ovr is an input")):
            made = conformalsom("map", scan, "-o", target, "--width", 32, *more)
            self.assertEqual(made.returncode, 2)
            self.assertIn(text, made.stderr)
            self.assertEqual([os.path.exists(path) for path in (target, *companions)], [False, True, True, True])
        made = conformalsom("map", self.body, "-o", target, "--width", 32, "--overwrite")
        self.assertEqual((made.returncode, made.stderr), (0, ""))
        self.assertEqual([os.path.exists(path) for path in (target, *companions)], [True, False, False, False])
        os.remove(target)

    def test_reference_systems_are_in_degrees(self):
        """Planetary systems, planetocentric and others; none that are projected, geocentric, rotated or in gons."""
        for code in ("EPSG:4326", "IAU_2015:49900", "IAU_2015:49902", "IAU_2015:200000400", "+proj=longlat +R=1000"):
            geotiff.expect_available(code)
        for code in ("IAU_2015:49910", "EPSG:4978", "EPSG:5773", "EPSG:4807",
                     "+proj=ob_tran +o_proj=longlat +o_lat_p=30 +lon_0=10"):
            with self.subTest(code), self.assertRaisesRegex(WrongUsage, "expected a system of longitude and latitude"):
                geotiff.expect_available(code)

    def test_lack_of_memory_is_an_error_in_one_line(self):
        """Errors of NumPy, which filters do not report."""
        with mock.patch.object(maps, "bands_of", side_effect=MemoryError), mock.patch.object(
                jobs, "silence"), mock.patch.object(jobs, "handle_signals"), contextlib.redirect_stdout(
                io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as told, mock.patch.object(main, "drop_output"):
            status = main.main(["map", self.body, "-o", self.path_of("new.tif")])
        self.assertEqual((status, told.getvalue()), (1, "conformalsom: there is not enough memory\n"))

    def test_cells_of_too_few_points_are_left_out_and_cut_files_are_refused(self):
        reader, writer = vtkConformalPLYReader(), vtkPolyDataWriter()
        reader.SetFileName(self.body)
        reader.Update()
        reader.GetOutput().GetPolys().InsertNextCell(2, (3, 4))
        with tempfile.TemporaryDirectory() as folder:
            path, target = (os.path.join(folder, name) for name in ("body.vtk", "body.tif"))
            writer.SetInputData(reader.GetOutput())
            writer.SetFileName(path)
            with same_locale(writer):
                writer.Write()
            made = conformalsom("map", path, "-o", target, "--width", 64)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertIn("body.vtk: note: Read body: 1 cell has too few points, and is left out\n", made.stderr)
            os.remove(target)
            os.truncate(path, os.path.getsize(path) // 3)
            cut = conformalsom("map", path, "-o", target, "--width", 64)
            self.assertEqual((cut.returncode, os.listdir(folder)), (1, ["body.vtk"]))
            self.assertIn("body.vtk: ", cut.stderr)

    def test_what_cannot_work_is_said_and_nothing_is_written(self):
        target = self.path_of("new.tif")
        for words, text in [(("-o", self.path_of("new.png")), "expected a file of type .tif"),
                            (("-o", self.path), "already exists"),
                            (("-o", target, "--axis", 0, 0, 0), "not zero"),
                            (("-o", target, "--crs", "IAU_2015:nothing"), "--crs"),
                            (("-o", target, "--crs", "EPSG:32633"), "longitude and latitude in degrees"),
                            (("-o", target, "--width", 3), "not in [16, 40000]")]:
            with self.subTest(words):
                result = conformalsom("map", self.body, *words)
                self.assertEqual(result.returncode, 2)
                self.assertIn(text, result.stderr)
        self.expect_one_line(conformalsom("map", self.body, "-o", target, "--center", 9, 9, 9), "does not intersect")
        self.expect_one_line(conformalsom("map", self.body, "-o", target, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (20000, 20000))), "new.tif: GDAL cannot write it: ")
        self.assertEqual(sorted(os.listdir(self.temporary.name)), ["Ellipsoid.ply", "map.tif"])


if __name__ == "__main__":
    unittest.main()
