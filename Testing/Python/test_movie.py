"""The command conformalsom movie: cells of a moving body keep their places in the maps, files are read back, frames
that cannot be used are skipped, and the page shows all times."""
import contextlib
import csv
import io
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkMassProperties
from vtkmodules.vtkIOImage import vtkMetaImageWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import conformalsom as cs
from browser import CHROMIUM, Browser
from conformalsom.command import movie, movie_frames, shape_page, volumes
from conformalsom.command.steps import StepFailed, Steps
from helpers.moving_cells import (
    GROWTH, SIZE, SPACING, angles, cells, frame_of, image_of, positions_of_cells, rotation, sphere_positions)
from samples import write_las
from test_command import heed_interrupts

try:
    import tifffile
except ImportError:
    tifffile = None

STEPS = 2
COMMAND = os.environ["CONFORMALSOM_COMMAND"]
LARGEST_SLIP = 0.6  # angle between the places of a cell in two frames by the angle by which cells move, means; 0.8 by shape


def write_stack(path, values, frames=1, interval=1.0, unit="micron"):
    writer = cs.vtkTIFFStackWriter()
    writer.SetInputData(image_of(values))
    writer.SetNumberOfFrames(frames)
    writer.SetFrameInterval(interval)
    writer.SetUnit(unit)
    writer.SetFileName(path)
    writer.Write()


def head(step, frequency):
    """A closed surface that grows by a tenth of its area in each step, with colors."""
    source = cs.vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    n = vtk_to_numpy(source.GetOutput().GetPoints().GetData()).astype(float)
    reach = 1.0 + 0.4 * np.exp((n @ [0.6, 0.0, 0.8] - 1.0) / 0.1)
    surface, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(1.1**(0.5 * step) * reach[:, None] * n * [1.6, 1.0, 0.9], deep=True))
    surface.SetPoints(points)
    surface.SetPolys(source.GetOutput().GetPolys())
    colors = numpy_to_vtk((127.5 * (n + 1.0)).astype(np.uint8), deep=True)
    colors.SetName("RGB")
    surface.GetPointData().SetScalars(colors)
    return surface


def write_head(path, step, frequency=12):
    writer = cs.vtkConformalPLYWriter()
    writer.SetInputData(head(step, frequency))
    writer.SetFileName(path)
    writer.Write()


def map_of(path, frame=0, interval=1.0):
    """A frame of a stack of maps: slices x rows x columns x channels, first row in the south."""
    reader = cs.vtkTIFFStackReader()
    reader.SetFileName(path)
    reader.SetYAxisToUp()
    reader.UpdateTimeStep(frame * interval)
    image = reader.GetOutput()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(*image.GetDimensions()[::-1], -1)


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def usage_error(*arguments):
    """The error of a call that makes no sense."""
    text = io.StringIO()
    try:
        with contextlib.redirect_stderr(text):
            movie.arguments(list(arguments))
    except SystemExit as error:
        return text.getvalue() if error.code == 2 else f"status {error.code}"
    return "no error"


class TestMovie(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.TemporaryDirectory()
        for step in range(STEPS):
            write_stack(os.path.join(cls.made.name, f"frame{step}.tif"), frame_of(step))
            write_head(os.path.join(cls.made.name, f"head{step}.ply"), step, 12 + step)

    @classmethod
    def tearDownClass(cls):
        cls.made.cleanup()

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def frame(self, name):
        return os.path.join(self.made.name, name)

    def run_movie(self, *arguments, status=0):
        completed = subprocess.run([COMMAND, "movie", *arguments], text=True, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, check=False)
        self.assertEqual(completed.returncode, status, completed.stderr)
        return completed

    def test_cells_keep_their_places(self):
        names = [self.frame(f"frame{step}.tif") for step in range(STEPS)]
        completed = self.run_movie(*names, "-o", self.path("map.tif"), "--time-step", "30", "--depths", "-2", "1",
                                   "--size", "128", "--surfaces", self.path("surfaces"), "--table", self.path("map.csv"))
        self.assertEqual(completed.stderr, "")
        self.assertEqual(completed.stdout, f"wrote {self.path('map.tif')}: 2 of 2 frames, 13 layers, 1 channel, 128 x 64 "
                                           "pixels\n")
        self.expect_places()
        self.expect_brightness()
        rows = rows_of(self.path("map.csv"))
        self.assertEqual([row["time"] for row in rows], ["0.0", "30.0"])
        self.assertEqual([row["state"] for row in rows], ["reference", "registered"])
        areas, volumes = ([float(row[name]) for row in rows] for name in ("area", "volume"))
        self.assertLess(abs(areas[1] / areas[0] / GROWTH**2 - 1.0), 0.02)
        self.assertLess(abs(volumes[1] / volumes[0] / GROWTH**3 - 1.0), 0.02)
        growth = 2.0 * np.log(GROWTH) / 30.0  # of areas per second
        self.assertLess(abs(float(rows[1]["mean_area_rate"]) / growth - 1.0), 0.45)  # noise of the maps adds stretch

    def expect_places(self):
        """Expect that each cell has the same position on the sphere in all frames."""
        places = []
        for step in range(STEPS):
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(self.path(f"surfaces/frame{step}.vtp"))
            reader.Update()
            data = reader.GetOutput()
            for name in ("Velocity", "AreaRate", "Layers", "LayerMaximum"):
                self.assertTrue(data.GetPointData().HasArray(name), name)
            places.append(sphere_positions(cs.Surface(data), positions_of_cells(step)))
        start = cells() / np.linalg.norm(cells(), axis=1)[:, None]
        for step in range(1, STEPS):
            moved = angles(start @ rotation(step).T, start).mean()
            self.assertLess(angles(places[step], places[0]).mean(), LARGEST_SLIP * moved)

    def expect_brightness(self):
        """Expect that maps of neighboring times show the same cells in the same pixels."""
        first, last = (map_of(self.path("map.tif"), frame, 30.0)[4, 16:48, :, 0].astype(float) for frame in (0, 1))
        self.assertGreater(first.std(), 15.0)
        self.assertGreater(np.corrcoef(first.ravel(), last.ravel())[0, 1], 0.7)

    def test_files_have_axes_spacing_and_interval(self):
        stack = np.concatenate([frame_of(step, 2) for step in range(2)])
        write_stack(self.path("movie.tif"), stack, 2, 12.5)
        self.run_movie(self.path("movie.tif"), "-o", self.path("map.tif"), "--projection", "mercator", "--size", "64")
        reader = cs.vtkTIFFStackReader()
        reader.SetFileName(self.path("map.tif"))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetDimensions(), (64, 64, 17))
        self.assertEqual(reader.GetOutput().GetNumberOfScalarComponents(), 2)
        self.assertEqual(reader.GetOutput().GetScalarTypeAsString(), "unsigned char")
        across, up, deep = reader.GetOutput().GetSpacing()
        self.assertEqual(across, up)
        self.assertTrue(0.4 < across < 1.5, across)
        self.assertLess(abs(deep - 0.25), 0.1)
        self.assertEqual(map_of(self.path("map.tif"), 1, 12.5)[..., 1].max(), 1)  # the second channel
        with open(self.path("map.tif"), "rb") as file:
            head_ = file.read(1000).decode("latin-1")
        self.assertIn("images=68\nchannels=2\nslices=17\nframes=2\nhyperstack=true\n", head_)
        self.assertIn("finterval=12.5\nunit=micron\n", head_)
        if tifffile is not None:
            with tifffile.TiffFile(self.path("map.tif")) as file:
                self.assertEqual((file.series[0].axes, file.series[0].shape), ("TZCYX", (2, 17, 2, 64, 64)))
                self.assertEqual(file.imagej_metadata["finterval"], 12.5)

    def test_stacks_of_different_intervals_need_a_time_step(self):
        paths = [self.path(name) for name in ("a.tif", "b.tif", "c.tif")]
        for path, interval in zip(paths, (30.0, 30.0001, 60.0)):
            write_stack(path, np.zeros((4, 3, 3, 1), np.uint8), 2, interval)
        output = ["-o", self.path("map.tif")]
        self.assertIn(f"{paths[0]} has a frame each 30 s, but {paths[2]} each 60 s; give --time-step",
                      " ".join(usage_error(*paths, *output).split()))
        self.assertEqual(movie.arguments([*paths[:2], *output]).interval, 30.0)
        self.assertEqual(movie.arguments([*paths, *output, "--time-step", "45"]).interval, 45.0)

    def test_numbers_of_files_that_do_not_ascend_are_noted(self):
        for paths, expected in (
                (["t1.ply", "t10.ply", "t2.ply"], ("t10.ply", "t2.ply")),
                (["a1/b.tif", "a0/b.tif"], ("a1/b.tif", "a0/b.tif")),
                (["t01.ply", "t02.ply", "t10.ply"], None), (["t8.ply", "t9.ply", "t10.ply"], None), (["t1.ply"], None),
                (["b1.ply", "a0.ply"], None), (["a2t1.ply", "a1t2.ply"], None), (["t2.ply", "last.ply"], None)):
            with self.subTest(paths):
                self.assertEqual(movie_frames.disorder_of(paths), expected)
        first, second = self.frame("head1.ply"), self.frame("head0.ply")
        completed = self.run_movie(first, second, "-o", self.path("map.tif"), "--array", "Nothing", status=1)
        self.assertIn(f"{first} is before {second}: the numbers of the frames do not ascend; number files as in t01, ",
                      completed.stderr)

    def test_surfaces_become_maps_of_growth_and_of_colors(self):
        names = [self.frame(f"head{step}.ply") for step in range(STEPS)]
        self.run_movie(*names, "-o", self.path("growth.tif"), "--size", "64", "--time-step", "10", "--unit", "mm")
        rate = map_of(self.path("growth.tif"), 1, 10.0)
        self.assertEqual(rate.shape, (1, 32, 64, 1))
        self.assertLess(abs(np.median(rate) / (np.log(1.1) / 10.0) - 1.0), 0.1)
        self.run_movie(*names[:2], "-o", self.path("colors.tif"), "--array", "RGB", "--size", "64")
        maps = [map_of(self.path("colors.tif"), frame) for frame in range(2)]
        self.assertEqual((maps[0].shape, maps[0].dtype), ((1, 32, 64, 3), np.uint8))
        self.assertLess(np.abs(maps[1].astype(int) - maps[0]).mean(), 5.0)  # of 255
        completed = self.run_movie(*names, "-o", self.path("none.tif"), "--array", "Nothing", status=1)
        self.assertIn("no point array Nothing; there are", completed.stderr)
        self.assertFalse(os.path.exists(self.path("none.tif")))

    def test_values_that_are_not_finite_are_0_and_noted(self):
        names = [self.path(f"head{step}.vtp") for step in range(STEPS)]
        for step, name in enumerate(names):
            surface = head(step, 12)
            values = np.linspace(1.0, 2.0, surface.GetNumberOfPoints())
            if step == 1:
                values[[7, 300, 301]] = np.nan, np.inf, 1e300
            array = numpy_to_vtk(values, deep=True)
            array.SetName("Stain")
            surface.GetPointData().AddArray(array)
            writer = vtkXMLPolyDataWriter()
            writer.SetInputData(surface)
            writer.SetFileName(name)
            writer.Write()
        completed = self.run_movie(*names, "-o", self.path("map.tif"), "--array", "Stain", "--size", "128", "--page",
                                   self.path("page.html"))
        self.assertRegex(completed.stderr, r"note: head1: \d+ values of Stain that are not finite are 0 in the map\n")
        self.assertNotIn("head0", completed.stderr)
        first, last = (map_of(self.path("map.tif"), frame) for frame in range(2))
        self.assertTrue(np.isfinite(last).all())
        self.assertGreater(first.min(), 0.99)
        self.assertTrue(0.9 < np.mean(last > 0.99) < 1.0)
        with open(self.path("page.html"), encoding="utf-8") as file:
            self.assertEqual(re.findall(r"\b(NaN|-?Infinity)[,}\]]", file.read()), [])

    def test_frames_far_from_the_origin_stay_where_they_are(self):
        """Clouds that move by 0.2 across the middle between two integers, to which their reader rounds their centers."""
        points = vtk_to_numpy(head(0, 12).GetPoints().GetData())
        middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
        for step in range(STEPS):
            write_las(self.path(f"scan{step}.las"), points - middle + [0.4 + 0.2 * step, 0.0, 0.0], (5e5, 5.4e6, 300.0))
        completed = self.run_movie(*(self.path(f"scan{step}.las") for step in range(STEPS)), "-o", self.path("map.tif"),
                                   "--size", "32", "--surfaces", self.path("s"), "--table", self.path("map.csv"))
        self.assertEqual(completed.stderr.count("500000 5400000 300 is subtracted"), 1)
        centers = []
        for step in range(STEPS):
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(self.path(f"s/scan{step}.vtp"))
            reader.Update()
            centers.append(np.mean(np.reshape(reader.GetOutput().GetBounds(), (3, 2)), axis=1))
        np.testing.assert_allclose(centers[1] - centers[0], [0.2, 0.0, 0.0], atol=0.02)
        self.assertLess(float(rows_of(self.path("map.csv"))[1]["mean_normal_speed"]), 0.2)

    def test_broken_frames_are_skipped_and_named(self):
        with open(self.frame("frame1.tif"), "rb") as whole, open(self.path("torn.tif"), "wb") as torn:
            torn.write(whole.read()[:20000])
        writer = vtkMetaImageWriter()
        writer.SetInputData(image_of(frame_of(0)))
        writer.SetFileName(self.path("cut.mha"))
        writer.Write()
        os.truncate(self.path("cut.mha"), os.path.getsize(self.path("cut.mha")) // 2)
        write_stack(self.path("dark.tif"), np.zeros((*SIZE[::-1], 1), np.uint8))
        write_stack(self.path("two.tif"), frame_of(1, 2))
        os.mkdir(self.path("s"))
        for name in ("two.vtp", "other.vtp"):  # of an earlier call that used the frame, and of another frame
            with open(self.path(os.path.join("s", name)), "w", encoding="ascii") as file:
                file.write("earlier")
        completed = self.run_movie(
            self.path("torn.tif"), self.frame("frame0.tif"), self.path("dark.tif"), self.path("two.tif"),
            self.path("cut.mha"), "-o", self.path("map.tif"), "--size", "32", "--table", self.path("map.csv"), "--surfaces", self.path("s"),
            "--page", self.path("map.html"), "--overwrite", status=1)
        for name in ("torn", "dark", "two", "cut"):
            self.assertRegex(completed.stderr, f"note: {name}: the frame is skipped: ")
        self.assertNotIn("interpolated", completed.stderr)
        self.assertIn("1 of 5 frames", completed.stdout)
        self.assertEqual([row["state"] for row in rows_of(self.path("map.csv"))],
                         ["skipped", "reference", "skipped", "skipped", "skipped"])
        self.assertEqual([map_of(self.path("map.tif"), frame).max() > 0 for frame in range(5)],
                         [False, True, False, False, False])
        self.assertEqual(sorted(os.listdir(self.path("s"))), ["frame0.vtp", "other.vtp"])

    def test_frames_of_another_unit_are_skipped_and_named(self):
        names = [self.path(f"{unit}.tif") for unit in ("micron", "mm", "um")]
        for step, name in enumerate(names):
            write_stack(name, frame_of(step), unit=os.path.basename(name)[:-4])
        completed = self.run_movie(*names, "-o", self.path("map.tif"), "--size", "32", "--table", self.path("map.csv"),
                                   status=1)
        self.assertIn("note: mm: the frame is skipped: its unit is mm instead of micron; convert the volume, or give "
                      "--unit", completed.stderr)
        self.assertEqual([row["state"] for row in rows_of(self.path("map.csv"))], ["reference", "skipped", "registered"])
        completed = self.run_movie(*names[:2], "-o", self.path("map.tif"), "--size", "32", "--unit", "mm", "--overwrite")
        self.assertEqual(completed.stderr, "")

    def test_frames_may_differ_in_size_and_type(self):
        write_stack(self.path("large.tif"), np.pad(frame_of(1), ((1, 2), (3, 0), (0, 4), (0, 0))))
        writer = vtkMetaImageWriter()
        writer.SetInputData(image_of(frame_of(2)))
        writer.SetFileName(self.path("other.mha"))
        writer.Write()
        completed = self.run_movie(self.path("large.tif"), self.path("other.mha"), "-o", self.path("map.tif"), "--size",
                                   "32", "--reference", "1")
        self.assertEqual(completed.stderr, "")
        self.assertTrue(all(map_of(self.path("map.tif"), frame).max() > 100 for frame in range(2)))

    def test_unsuitable_calls_leave_no_files(self):
        frame, mesh = self.frame("frame0.tif"), self.frame("head0.ply")
        with open(self.path("text.tif"), "w", encoding="ascii") as file:
            file.write("no picture")
        for arguments, message in (
                ([frame, mesh], "some frames are volumes"), ([frame, "--array", "RGB"], "--array is of surfaces"),
                ([mesh, "--depths", "-1", "1"], "are of volumes"), ([frame, "--depths", "1", "1"], "less than"),
                ([frame, "--reference", "1"], "there are 1 frames"), ([frame, "--time-step", "0"], "must be in"),
                ([frame, "--unit", "a=b"], "--unit must be a word"), ([frame, "--size", "15"], "not in [16, 16384]"),
                ([frame, frame, "--surfaces", self.path("s")], "two frames have the name frame0")):
            with self.subTest(arguments):
                self.assertIn(message, usage_error(*arguments, "-o", self.path("map.tif")))
        self.assertIn("expected a file of type .tif .tiff", usage_error(frame, "-o", self.path("map.png")))
        for arguments, message in (
                ([self.path("text.tif")], "no frame can be used"), ([self.path("nothing.tif")], "No such file"),
                ([self.path("text.tif"), frame, "--reference", "0"], "cannot be used as reference"),
                ([frame, "--depths", "-400", "400", "--size", "16384"], "would exceed 4 GB")):
            with self.subTest(arguments):
                completed = self.run_movie(*arguments, "-o", self.path("map.tif"), status=1)
                self.assertIn(message, completed.stderr)
        self.assertEqual(os.listdir(self.folder.name), ["text.tif"])
        shutil.copy(frame, self.path("map.tif"))
        self.assertIn("already exists", usage_error(frame, "-o", self.path("map.tif")))
        self.assertIn("is an input", usage_error(self.path("map.tif"), "-o", self.path("map.tif"), "--overwrite"))

    def test_interruption_leaves_no_files(self):
        names = [self.frame(f"frame{step}.tif") for step in range(STEPS)]
        process = subprocess.Popen([COMMAND, "movie", *names, "-o", self.path("map.tif")], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, preexec_fn=heed_interrupts)
        time.sleep(2.5)  # it learns, or makes maps correspond
        process.send_signal(signal.SIGINT)
        _, told = process.communicate(timeout=60)
        self.assertEqual((process.returncode, told), (-signal.SIGINT, b""))
        self.assertEqual(os.listdir(self.folder.name), [])

    @unittest.skipUnless(CHROMIUM, "needs chromium")
    def test_page_shows_all_times(self):
        names = [self.frame(f"head{step}.ply") for step in range(STEPS)]
        self.run_movie(*names, "-o", self.path("growth.tif"), "--size", "64", "--page", self.path("page.html"),
                       "--array", "RGB")
        with open(self.path("page.html"), encoding="utf-8") as file:
            self.assertEqual(re.findall(r"https?://", file.read()), [])
        with Browser() as browser:
            browser.open(self.path("page.html"))
            self.assertEqual(browser.evaluate("document.title"), "growth")
            self.assertEqual(browser.evaluate("document.getElementById('time').max"), "1")
            colors = "Array.from(document.getElementById('color').options, (o) => o.text)"
            self.assertEqual(browser.evaluate(colors), ["RGB", "AreaRate", "ShearRate", "NormalVelocity"])
            seen = [self.shown(browser, step, color) for step, color in ((1, 0), (0, 0), (0, 1), (1, 1))]
            self.assertIn("head1", browser.evaluate("document.getElementById('when').textContent"))
            self.assertEqual(len(set(seen)), len(seen))
            browser.drag((300, 300), (380, 340))
            self.assertNotEqual(self.shown(browser, 1, 1), seen[-1])
            self.assertEqual(browser.messages, [])
            self.assertEqual([url for url in browser.requests if not url.startswith(("file:", "data:image/png;"))], [])

    def shown(self, browser, step, color):
        """What the browser shows of a time and an array, as a file of a picture."""
        browser.evaluate(f"(() => {{ const t = document.getElementById('time'); t.value = {step};"
                         f"document.getElementById('color').value = {color};"
                         "document.body.dataset.frame = ''; t.dispatchEvent(new Event('input')); })()")
        for _ in range(100):
            browser.drawn()
            if browser.evaluate("document.body.dataset.frame") == str(step):
                break
        browser.drawn()
        browser.screenshot(self.path("shown.png"))
        with open(self.path("shown.png"), "rb") as file:
            return file.read()


class TestVolumes(unittest.TestCase):
    """Files of MetaImage beside their voxels, and files that end early."""

    def test_voxels_in_other_files_and_as_text_are_read(self):
        voxels = np.arange(2 * 3 * 4, dtype=np.uint32).reshape(2, 3, 4)
        text = " ".join(map(str, voxels.ravel())) + "\n"  # without which VTK 9.6 refuses the file
        files = {"0.raw": voxels[0].tobytes(), "1.raw": voxels[1].tobytes(), "all.raw": voxels.tobytes(), "all.txt": text.encode()}
        with tempfile.TemporaryDirectory() as folder:
            for name, data in files.items():
                with open(os.path.join(folder, name), "wb") as file:
                    file.write(data)
            path = os.path.join(folder, "volume.mhd")
            for binary, place in (("True", "all.raw"), ("True", "%d.raw 0 1 1"), ("True", "LIST\n0.raw\n1.raw"),
                                  ("True", "LIST 2D\n0.raw\n1.raw"), ("False", "all.txt"), ("False", f"LOCAL\n{text}")):
                with self.subTest(place):
                    with open(path, "w", encoding="ascii") as file:
                        file.write(f"ObjectType = Image\nNDims = 3\nBinaryData = {binary}\nDimSize = 4 3 2\n"
                                   f"ElementType = MET_UINT\nElementDataFile = {place}\n")
                    volume, _ = volumes.read(path, Steps(), "Read")
                    np.testing.assert_array_equal(vtk_to_numpy(volume.GetPointData().GetScalars()), voxels.ravel())
            os.truncate(os.path.join(folder, "all.raw"), 80)
            with open(path, "w", encoding="ascii") as file:
                file.write("ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 4 3 2\nElementType = MET_UINT\n"
                           "ElementDataFile = all.raw\n")
            # VTK 9.6 refuses the file itself.
            with self.assertRaisesRegex((ValueError, StepFailed), "80 of 96 bytes|cannot read data from file"):
                volumes.read(path, Steps(), "Read")

    def test_voxels_that_are_missing_are_noticed_in_nrrd_files(self):
        voxels = np.arange(60, dtype=np.uint8)
        head = b"NRRD0004\ntype: uint8\ndimension: 3\nsizes: 5 4 3\nencoding: raw\n"
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "volume.nrrd")
            for name, content in (("all.raw", voxels.tobytes()), ("volume.nrrd", head + b"data file: all.raw\n"),
                                  ("volume.nrrd", head + b"\n" + voxels.tobytes())):
                with open(os.path.join(folder, name), "wb") as file:
                    file.write(content)
                if name == "volume.nrrd":
                    volume, _ = volumes.read(path, Steps(), "Read")
                    np.testing.assert_array_equal(vtk_to_numpy(volume.GetPointData().GetScalars()).ravel(), voxels)
            os.truncate(path, os.path.getsize(path) - 5)
            with self.assertRaisesRegex(ValueError, "File operation failed"):
                volumes.read(path, Steps(), "Read")


class TestPage(unittest.TestCase):
    def test_arrays_are_appended_in_linear_time(self):
        """16 MB in 1,000 arrays: 0.01 s, but 3 s if all bytes are copied for each array."""
        data, array = shape_page.Data(), np.zeros(2**14, np.uint8)
        start = time.process_time()
        places = [data.add(array, np.uint8)[0] for _ in range(1000)]
        self.assertLess(time.process_time() - start, 0.5)
        self.assertEqual((places[-1], len(data.bytes)), (999 * 2**14, 1000 * 2**14))


class TestFunctions(unittest.TestCase):
    def test_volumes_become_series_and_layers(self):
        volumes = [frame_of(step)[..., 0] for step in range(2)]
        first = cs.surface_from_volume(volumes[0], spacing=SPACING)
        second = cs.surface_from_volume(volumes[1], spacing=SPACING, start=first, smoothing=1.0)
        series = cs.time_series([first, second], time_interval=30.0, frequency=8)
        self.assertEqual(len(series.surfaces), 2)
        self.assertEqual(list(series.table["State"]), ["reference", "registered"])
        np.testing.assert_array_equal(series.table["Time"], [0.0, 30.0])
        self.assertLess(abs(series.table["RelativeArea"][1] / GROWTH**2 - 1.0), 0.02)
        self.assertIn("AreaRate", series.surfaces[1].point_data)
        layers = series.surfaces[1].layers(volumes[1], spacing=SPACING, depth_range=(-1, 1), number_of_layers=3,
                                           image_size=(64, 32))
        self.assertEqual(layers.maps.shape, (3, 32, 64))
        np.testing.assert_allclose(layers.depths, [-1.0, 0.0, 1.0])
        self.assertGreater(layers.maps[0].mean(), layers.maps[2].mean() + 30.0)  # dark outside
        self.assertIn("LayerMaximum", layers.surface.point_data)
        mass = vtkMassProperties()
        mass.SetInputData(second.polydata)
        self.assertLess(abs(layers.spacing[0] * 64 / np.sqrt(np.pi * mass.GetSurfaceArea()) - 1.0), 0.01)

    def test_unsuitable_volumes_raise_errors(self):
        for volume, error in ((np.zeros((3, 4)), ValueError), ("nothing.tif", FileNotFoundError), ("a.xyz", ValueError),
                              (np.array([[["a"]]]), TypeError), (np.zeros((9, 9, 9)), cs.FilterFailed)):
            with self.subTest(str(volume)[:20]), self.assertRaises(error):
                cs.surface_from_volume(volume)
        with self.assertRaises(ValueError):
            cs.surface_from_volume(np.zeros((9, 9, 9)), spacing=(1, 0, 1))


if __name__ == "__main__":
    unittest.main()
