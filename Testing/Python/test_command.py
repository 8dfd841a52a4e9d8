"""The command conformalsom: every file it promises is there, whole, and can be read back; it replaces
nothing unasked, says what went wrong, and its own picture is that of the README."""
import filecmp
import json
import os
import pty
import shutil
import signal
import stat
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import conformalsom
from conformalsom.command import outputs, scan_files
from conformalsom.command import textures as command_textures
import gltf_rules
import output_cases
import toy_bear
from baselines import expect_picture, require_display
from helpers import builtin_figure, textures

COMMAND = os.environ["CONFORMALSOM_COMMAND"]
BUILD_SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "CMake", "build.sh")
EXAMPLES = os.path.dirname(os.path.dirname(os.path.abspath(toy_bear.__file__)))
TRIANGLES = 20 * 16**2
CUT_POINTS = range(2511, 2614)  # those of --points 2562 within 2 percent
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Systems", "figures.txt"),
          encoding="ascii") as figures:
    FIGURES = figures.read().splitlines()  # which Testing/Systems/run.sh wants from every system
COARSE = ("--neurons", "162", "--points", "1000")
COARSE_POINTS = range(980, 1021)  # those of --points 1000 within 2 percent


def heed_interrupts():
    """Let SIGINT end this process, also if a script has started it in the background."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def command(folder, *arguments):
    """Run the command as a user would, from the folder, and without a path to the package."""
    environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    return subprocess.run([COMMAND, *arguments], cwd=folder, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)


def read(reader, *path):
    reader.SetFileName(os.path.join(*path))
    reader.Update()
    return reader.GetOutput()


def page_description(*path):
    """What a page says of its data."""
    with open(os.path.join(*path), encoding="utf-8") as file:
        return json.loads(file.read().partition('id="description">')[2].partition("</script>")[0])


def files_in(folder):
    """All of them, hidden ones too, with what is in them."""
    contents = {}
    for path, _, names in os.walk(folder):
        for name in names:
            with open(os.path.join(path, name), "rb") as file:
                contents[os.path.relpath(os.path.join(path, name), folder)] = file.read()
    return contents


def bounds_of_glb(folder, name):
    """The corners of the box around a .glb file's surface, as its node places it."""
    with open(os.path.join(folder, name), "rb") as file:
        document = gltf_rules.chunks(file.read(), [])[0]
    node, accessor = document["nodes"][0], document["accessors"][0]
    return np.array([accessor["min"], accessor["max"]]) * node.get("scale", [1, 1, 1]) + node.get(
        "translation", [0, 0, 0])


class TestCommand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="first steps ")
        cls.folder = cls.temporary.name
        scan = vtkXMLPolyDataWriter()
        scan.SetInputData(builtin_figure.figure_cloud(4000))
        scan.SetFileName(os.path.join(cls.folder, "my scan.vtp"))
        scan.Write()
        picture = vtkPNGWriter()
        picture.SetInputData(textures.checkerboard(128))
        picture.SetFileName(os.path.join(cls.folder, "my picture.png"))
        picture.Write()
        cls.completed = command(
            cls.folder, "my scan.vtp", "--texture", "my picture.png", "--output", "out/surface.vtp",
            "-o", "out/surface.glb", "-o", "out/surface.obj", "-o", "out/surface.stl", "-o", "out/surface.html",
            "--picture", "out/stages.png",
            "--neurons", "642", "--points", "2562", "--measure", "--report", "out/figures.json")
        cls.output = os.path.join(cls.folder, "out")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def fails(self, status, message, *arguments):
        """The command ends with the status and a line that has the message, and leaves all files alone."""
        before = files_in(self.folder)
        run = command(self.folder, *arguments)
        self.assertEqual((run.returncode, run.stdout), (status, ""))
        self.assertIn(message, run.stderr)
        self.assertNotIn("Traceback", run.stderr)
        if status == 1:
            self.assertRegex(run.stderr, r"^conformalsom: .*\n$")  # one line
        self.assertEqual(files_in(self.folder), before)

    def test_ends_well_and_quietly(self):
        self.assertEqual((self.completed.returncode, self.completed.stderr), (0, ""))

    def test_makes_what_is_asked_for_and_nothing_else(self):
        self.assertEqual(sorted(os.listdir(self.output)), [
            "figures.json", "stages.png", "surface.glb", "surface.html", "surface.mtl", "surface.obj",
            "surface.png", "surface.stl", "surface.vtp"])

    def test_prints_the_table(self):
        for text in ("Read the scan", "Learn the mesh", "Build the smooth surface", "Lay the texture",
                     "p2s", "nv", "s2p", "angle", "4,000", "642", "2,562"):
            with self.subTest(text):
                self.assertIn(text, self.completed.stdout)

    def test_reports_what_the_surface_has(self):
        with open(os.path.join(self.output, "figures.json"), encoding="utf-8") as file:
            report = json.load(file)
        self.assertEqual(report["Version"], conformalsom.__version__)
        [entry] = report["Surfaces"]
        self.assertEqual((entry["Scan"], entry["NumberOfScanPoints"]), ("my scan.vtp", 4000))
        self.assertEqual(entry["Mesh"]["NumberOfPoints"], 642)
        self.assertEqual(entry["Files"], ["out/surface.vtp", "out/surface.glb", "out/surface.obj",
                                          "out/surface.stl", "out/surface.html", "out/stages.png"])
        surface = read(vtkXMLPolyDataReader(), self.output, "surface.vtp")
        self.assertEqual(entry["Surface"]["NumberOfTriangles"], surface.GetNumberOfPolys())
        for name in ("MeanSquarePointToSurface", "HausdorffDistance", "MeanAngleDistortion", "LengthUnit"):
            self.assertEqual(entry["Surface"][name], surface.GetFieldData().GetArray(name).GetValue(0))

    def test_surface_keeps_every_array(self):
        surface = read(vtkXMLPolyDataReader(), self.output, "surface.vtp")
        self.assertEqual(surface.GetNumberOfPolys(), TRIANGLES)
        for name in ("SpherePosition", "Normals", "Texture Coordinates", "OutsideImage", "Distance"):
            with self.subTest(name):
                self.assertIsNotNone(surface.GetPointData().GetArray(name))
        self.assertIsNotNone(surface.GetPointData().GetTCoords())
        self.assertIsNotNone(surface.GetFieldData().GetArray("MeanSquarePointToSurface"))

    def test_obj_has_texture_coordinates_and_its_picture(self):
        surface = read(vtkOBJReader(), self.output, "surface.obj")
        self.assertLess(surface.GetNumberOfPolys(), TRIANGLES)  # fewer points beside those of the cut
        self.assertIsNotNone(surface.GetPointData().GetTCoords())
        with open(os.path.join(self.output, "surface.mtl"), encoding="ascii") as file:
            names = [line.split(None, 1)[1].strip() for line in file if line.startswith("map_Kd")]
        self.assertEqual(len(names), 1)
        picture = read(vtkPNGReader(), self.output, names[0])
        self.assertEqual(picture.GetDimensions(), (128, 128, 1))

    def test_page_has_the_picture_and_all_arrays(self):
        page = page_description(self.output, "surface.html")
        self.assertIn(page["points"], CUT_POINTS)
        self.assertIn("textureBounds", page)
        names = [array["name"] for array in page["arrays"]]
        self.assertTrue({"OutsideImage", "Distance"} <= set(names), names)
        self.assertEqual(page["surfaceAxes"], [1, 0, 0, 0, 1, 0, 0, 0, 1])
        self.assertEqual(page["first"], -1)

    def test_glb_is_read_by_another_reader(self):
        scene = read(vtkGLTFReader(), self.output, "surface.glb")
        iterator = scene.NewIterator()
        iterator.InitTraversal()
        surface = iterator.GetCurrentDataObject()
        self.assertIn(surface.GetNumberOfPoints(), CUT_POINTS)
        self.assertIsNotNone(surface.GetPointData().GetTCoords())

    def test_glb_is_in_meters(self):
        with tempfile.TemporaryDirectory() as folder:
            scan = os.path.join(self.folder, "my scan.vtp")
            for name, *unit in (("m.glb",), ("mm.glb", "--unit", "mm")):
                self.assertEqual(command(folder, scan, *COARSE, "-o", name, *unit).returncode, 0)
            sizes = [bounds_of_glb(folder, name) for name in ("m.glb", "mm.glb")]
            np.testing.assert_allclose(sizes[1], sizes[0] * 0.001, rtol=1e-6)
            self.assertGreater(np.ptp(sizes[0]), 0.1)

    def test_picture_shows_four_views(self):
        picture = read(vtkPNGReader(), self.output, "stages.png")
        self.assertEqual(picture.GetDimensions(), (1600, 500, 1))

    def test_stl_is_closed(self):
        surface = read(vtkSTLReader(), self.output, "surface.stl")
        self.assertEqual((surface.GetNumberOfPolys(), surface.GetNumberOfPoints()), (TRIANGLES, 2562))

    def test_failures_end_with_a_message_and_status_1(self):
        with open(os.path.join(self.output, "surface.png"), "rb") as file:
            picture = file.read()
        with open(os.path.join(self.output, "surface.stl"), "rb") as file:
            stl = file.read()
        def chunk(kind, data):
            return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        huge = picture[:8] + chunk(b"IHDR", struct.pack(">IIBBBBB", 200000, 200000, 8, 2, 0, 0, 0)) + chunk(
            b"IDAT", zlib.compress(b"0")) + chunk(b"IEND", b"")
        for name, content in (
                ("broken.ply", b"ply\nformat ascii 1.0\nelement vertex 5\n"), ("scan.doc", b"no scan\n"),
                ("empty.xyz", b""), ("equal.xyz", b"1 2 3\n" * 50), ("short.png", picture[:len(picture) // 2]),
                ("changed.png", picture[:200] + b"?" + picture[201:]), ("text.png", b"text"),
                ("text.jpg", b"text"), ("file", b""), ("jpeg.stl", b"\xff\xd8\xff" + bytes(500)),
                ("short.stl", stl[:1000]), ("huge.png", huge),
                ("short.vtk", b"# vtk DataFile Version 3.0\n\nASCII\nDATASET POLYDATA\nPOINTS 90 float\n1 2 3 4\n")):
            with open(os.path.join(self.folder, name), "wb") as file:
                file.write(content)
        good = ("my scan.vtp", *COARSE)
        for arguments, message in (
                (("missing.ply",), "missing.ply: no such file"),
                (("out",), "out: not a file"),
                (("scan.doc",), "scan.doc: expected a file of type .asc .conf"),
                (("broken.ply",), "broken.ply: Read the scan: "),
                (("empty.xyz",), "empty.xyz: Read the scan: "),
                (("equal.xyz",), "equal.xyz: the points are all equal, so that there is no surface"),
                ((*good, "--texture", "missing.png"), "missing.png: no such file"),
                ((*good, "--texture", "short.png"), "short.png: the picture is broken"),
                ((*good, "--texture", "changed.png"), "changed.png: the picture is broken"),
                ((*good, "--texture", "text.png"), "text.png: not a PNG file"),
                ((*good, "--texture", "text.jpg"), "text.jpg: not a JPEG file"),
                (("jpeg.stl",), "jpeg.stl: Read the scan: not an STL file, or an incomplete one"),
                (("short.stl",), "short.stl: Read the scan: not an STL file, or an incomplete one"),
                (("short.vtk",), "short.vtk: Error reading"),
                ((*good, "--texture", "huge.png"), "huge.png: the picture has 200000 x 200000 pixels; there can be")):
            with self.subTest(arguments):
                self.fails(1, message, *arguments, "-o", "failed.glb")

    def test_wrong_usage_is_status_2_and_does_nothing(self):
        for message, *arguments in (
                ("SCAN", "-o", "x.glb"),
                ("there is nothing to do", "my scan.vtp"),
                ("x.doc: expected a file of type .3mf .gii .glb", "my scan.vtp", "-o", "x.doc"),
                ("x.gif: expected a file of type .jpg .png", "my scan.vtp", "--picture", "x.gif"),
                ("11 is not in [12, 10000002]", "my scan.vtp", "-o", "x.glb", "--neurons", "11"),
                ("invalid choice: 'square'", "my scan.vtp", "-o", "x.glb", "--mesh-type", "square"),
                ("--lattice is now --mesh-type", "my scan.vtp", "-o", "x.glb", "--lattice", "adaptive"),
                ("--view and --up must be finite", "my scan.vtp", "-o", "x.glb", "--view", "0", "2", "0"),
                ("not parallel", "my scan.vtp", "-o", "x.glb", "--view", "0", "nan", "1"),
                ("Shape: no such file; the subcommand is shapes", "Shape", "my scan.vtp", "-o", "study"),
                ("Map: no such file; the subcommand is map", "Map", "my scan.vtp", "-o", "x.tif"),
                ("x.glb would be written twice", "my scan.vtp", "other.ply", "-o", "x.glb"),
                ("x.png would be written twice, also as a file that belongs to another one", "my scan.vtp", "-o", "x.obj", "--picture", "x.png"),
                ("new/ is the name of a folder", "my scan.vtp", "-o", "x.glb", "--report", "new/"),
                ("out is not a regular file", "my scan.vtp", "--report", "out", "--overwrite"),
                ("my scan.vtp cannot be written to", "my scan.vtp", "-o", "my scan.vtp/x.glb"),
                (r"n\xfcr.ply: names of files must be UTF-8", os.fsdecode(b"n\xfcr.ply"), "-o", "x.glb")):
            with self.subTest(message):
                self.fails(2, message, *arguments)

    def test_replaces_nothing_unasked_and_no_input_ever(self):
        os.link(os.path.join(self.folder, "my scan.vtp"), os.path.join(self.folder, "link.vtp"))
        for message, *arguments in (
                ("out/surface.stl already exists", "-o", "out/surface.stl"),
                ("out/surface.png already exists", "-o", "out/surface.ply"),
                ("out/figures.json already exists", "--report", "out/figures.json"),
                ("my scan.vtp is an input", "-o", "my scan.vtp", "--overwrite"),
                ("link.vtp is an input", "-o", "link.vtp", "--overwrite"),
                ("my picture.png is an input", "-o", "my picture.obj", "--overwrite"),
                ("my picture.png is an input", "--picture", "my picture.png", "--overwrite"),
                ("my scan.vtp is an input", "--report", "my scan.vtp", "--overwrite")):
            with self.subTest(arguments):
                self.fails(2, message, "my scan.vtp", "--texture", "my picture.png", *arguments)
        os.unlink(os.path.join(self.folder, "link.vtp"))
        with open(os.path.join(self.folder, "list.conf"), "w", encoding="ascii") as file:
            file.write("bmesh part.ply 0 0 0 0 0 0 1\n")
        with open(os.path.join(self.folder, "part.ply"), "wb"):
            pass
        self.fails(2, "part.ply is an input", "list.conf", "-o", "part.ply", "--overwrite")

    def test_several_scans_go_on_after_one_that_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in "a", "b":
                shutil.copy(os.path.join(self.folder, "my scan.vtp"), os.path.join(folder, name + ".vtp"))
            run = command(folder, "a.vtp", "missing.ply", "b.vtp", "-o", "new/", "-o", "{}/of {}.off", *COARSE,
                          "--report", "-")
            self.assertEqual((run.returncode, run.stderr), (1, "conformalsom: missing.ply: no such file\n"))
            entries = json.loads(run.stdout)["Surfaces"]
            self.assertEqual([entry["Scan"] for entry in entries], ["a.vtp", "missing.ply", "b.vtp"])
            self.assertEqual(entries[1]["Error"], "missing.ply: no such file")
            files = files_in(folder)
            self.assertEqual(sorted(files), ["a.vtp", "a/of a.off", "b.vtp", "b/of b.off", "new/a.glb", "new/b.glb"])
            self.assertEqual(files["new/a.glb"].replace(b'"name":"a"', b'"name":"b"'), files["new/b.glb"])

    def test_replaces_when_asked_to(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "surface.vtp")
            with open(path, "wb") as file:
                file.write(b"old")
            run = command(self.folder, "my scan.vtp", "-o", path, *COARSE, "--overwrite")
            self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
            self.assertIn(read(vtkXMLPolyDataReader(), path).GetNumberOfPoints(), COARSE_POINTS)

    def test_mesh_type_and_number_of_neurons(self):
        for mesh_type, asked, got in (("adaptive", "500", 500), ("geodesic", "500", 492), ("automatic", "300", 300)):
            with self.subTest(mesh_type):
                run = command(self.folder, "my scan.vtp", "--mesh-type", mesh_type, "--neurons", asked, "--report", "-")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertEqual(json.loads(run.stdout)["Surfaces"][0]["Mesh"]["NumberOfPoints"], got)

    def test_without_a_picture_surfaces_are_closed_and_glb_has_one_color(self):
        with tempfile.TemporaryDirectory() as folder:
            run = command(self.folder, "my scan.vtp", *COARSE, "-o", folder + "/x.ply", "-o", folder + "/y.obj",
                          "-o", folder + "/z.glb", "-o", folder + "/w.html", "--view", "1", "0", "0")
            self.assertEqual((run.returncode, run.stdout, run.stderr), (0, "", ""))
            self.assertEqual(sorted(os.listdir(folder)), ["w.html", "x.ply", "y.obj", "z.glb"])
            page = page_description(folder, "w.html")
            self.assertIn(page["points"], COARSE_POINTS)
            self.assertNotIn("textureBounds", page)
            self.assertEqual(page["surfaceAxes"], [0, 0, -1, 0, 1, 0, 1, 0, 0])
            self.assertIn(read(conformalsom.vtkConformalPLYReader(), folder, "x.ply").GetNumberOfPoints(), COARSE_POINTS)
            self.assertIn(read(vtkOBJReader(), folder, "y.obj").GetNumberOfPoints(), COARSE_POINTS)

    def test_files_of_one_name_share_a_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            call = (folder, os.path.join(self.folder, "my scan.vtp"), *COARSE, "--texture",
                    os.path.join(self.folder, "my picture.png"), "-o", "x.obj")
            self.assertEqual(command(*call).returncode, 0)
            pictures = [os.path.join(folder, name) for name in ("x.png", "alone.png")]
            os.rename(*pictures)
            run = command(*call, "-o", "x.ply", "--overwrite")
            self.assertEqual((run.returncode, run.stdout), (0, ""))
            self.assertEqual(sorted(os.listdir(folder)), ["alone.png", "x.mtl", "x.obj", "x.ply", "x.png"])
            self.assertTrue(filecmp.cmp(*pictures, shallow=False))
            run = command(*call[:-2], "-o", "x.ply", "-o", "x.obj")  # without --overwrite
            self.assertEqual(run.returncode, 2)
            for name in "x.mtl", "x.obj", "x.ply", "x.png":
                os.unlink(os.path.join(folder, name))
            self.assertEqual(command(*call, "-o", "x.ply").returncode, 0)

    def test_on_a_terminal_a_bar_is_shown_in_one_line(self):
        terminal, end = pty.openpty()
        with tempfile.TemporaryDirectory() as folder:
            process = subprocess.Popen([COMMAND, "my scan.vtp", "-o", folder + "/x.glb", *COARSE], cwd=self.folder,
                                       stderr=end, stdout=subprocess.PIPE, env={**os.environ, "TERM": "xterm"})
            os.close(end)
            shown = b"".join(iter(lambda: read_terminal(terminal), b"")).decode()
            self.assertEqual((process.communicate()[0], process.returncode), (b"", 0))
        os.close(terminal)
        self.assertIn("] my scan.vtp: Learn the mesh", shown)
        self.assertIn("100 % [" + 24 * "#" + "]", shown)
        self.assertEqual(shown.count("\n"), 1)  # the last thing said
        self.assertRegex(shown, r"\r\x1b\[Kmy scan.vtp: .*x.glb \((9[89].|1,0[01].) points, [0-9.]+ s\)\r\n$")

    def test_interrupted_it_leaves_no_file_and_dies_of_the_signal(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            terminal, end = pty.openpty()
            with self.subTest(number), tempfile.TemporaryDirectory() as folder:
                process = subprocess.Popen(
                    [COMMAND, "my scan.vtp", "-o", folder + "/x.glb", "-o", folder + "/x.vtp", "--neurons", "40000"],
                    cwd=self.folder, stderr=end, env={**os.environ, "TERM": "xterm"},
                    preexec_fn=heed_interrupts)
                os.close(end)
                shown = b""
                while b"Learn the mesh" not in shown:  # it runs
                    shown += os.read(terminal, 4096)
                process.send_signal(number)
                while read_terminal(terminal):
                    pass
                self.assertEqual(process.wait(), -number)
                self.assertEqual(os.listdir(folder), [])
            os.close(terminal)

    def test_what_is_not_whole_is_gone(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "x.stl")
            with open(path, "w", encoding="ascii") as file:
                file.write("old")
            with self.assertRaises(KeyboardInterrupt):
                with outputs.whole(path) as part, open(part, "w", encoding="ascii") as file:
                    file.write("new")
                    raise KeyboardInterrupt
            self.assertEqual(files_in(folder), {"x.stl": b"old"})
            with outputs.whole(path) as part, open(part, "w", encoding="ascii") as file:
                file.write("new")
            self.assertEqual(files_in(folder), {"x.stl": b"new"})

    def test_is_a_module_too(self):
        for arguments in (["--version"], ["--help"]):
            run = subprocess.run([sys.executable, "-m", "conformalsom", *arguments], text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            self.assertEqual(run.stdout, command(self.folder, *arguments).stdout)

    def test_pictures_may_be_gray_and_of_16_bits(self):
        """All of one picture, as a reader of glTF finds them in the file."""
        gray = np.add.outer(np.arange(32), np.arange(48)).astype(np.uint8)[..., None] * 3
        alpha = np.full_like(gray, 200)
        expected = {
            "gray.png": gray, "gray.jpg": gray, "gray16.png": gray.astype(np.uint16) * 257,
            "alpha.png": np.dstack([gray, alpha]), "rgb16.png": np.dstack([gray] * 3).astype(np.uint16) * 257}
        for name, pixels in expected.items():
            with self.subTest(name):
                image = vtkImageData()
                image.SetDimensions(48, 32, 1)
                image.GetPointData().SetScalars(numpy_to_vtk(pixels.reshape(48 * 32, -1), deep=True))
                writer = vtkJPEGWriter() if name.endswith(".jpg") else vtkPNGWriter()
                writer.SetInputData(image)
                writer.SetFileName(os.path.join(self.folder, name))
                writer.Write()
                read_back = command_textures.read_picture(writer.GetFileName())
                self.assertEqual((read_back.dtype, read_back.shape),
                                 (np.uint8, (32, 48, 4 if name == "alpha.png" else 3)))
                scalars = vtk_to_numpy(command_textures.image_of(read_back).GetPointData().GetScalars())
                for channel in scalars[:, :3].T:
                    self.assertLessEqual(np.abs(channel.astype(int) - gray.ravel()).max(), 3 * name.endswith(".jpg"))
        run = command(self.folder, "my scan.vtp", "--texture", "gray.png", *COARSE, "-o", "gray/x.glb")
        self.assertEqual(run.returncode, 0, run.stderr)

    def test_report_alone_is_on_the_standard_output(self):
        run = command(self.folder, "my scan.vtp", *COARSE, "--measure", "--report", "-")
        self.assertEqual(len(json.loads(run.stdout)["Surfaces"]), 1)
        self.assertIn("learned mesh", run.stderr)

    def test_what_is_replaced_keeps_its_rights(self):
        for extension in (".vtp", ".stl", ".obj", ".off"):
            with self.subTest(extension):
                path = os.path.join(self.folder, "private" + extension)
                with open(path, "wb"):
                    pass
                os.chmod(path, 0o600)
                run = command(self.folder, "my scan.vtp", *COARSE, "-o", path, "--overwrite")
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                self.assertEqual(stat.S_IMODE(os.stat(path).st_mode), 0o600)
                os.remove(path)

    def test_surface_that_is_cut_short_is_no_file(self):
        for extension in (".vtp", ".stl", ".obj", ".off"):
            with self.subTest(extension):
                run = subprocess.run(
                    ["bash", "-c", 'ulimit -f 8; exec "$@"', "bash", COMMAND, "my scan.vtp", *COARSE,
                     "-o", "cut" + extension], cwd=self.folder, text=True, check=False,
                    stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                self.assertEqual(run.returncode, 1, run.stderr)
                self.assertFalse(os.path.exists(os.path.join(self.folder, "cut" + extension)))

    def test_picture_of_the_readme_is_what_the_quickstart_draws(self):
        subprocess.run([sys.executable, toy_bear.__file__, os.path.join(self.folder, "own")], check=True)
        run = command(self.folder, "own/bear.vtp", "--texture", "own/rosette.png", "--measure", "-o", "own/surface.vtp",
                      "--picture", "own/quickstart.png")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual([line for line in run.stdout.splitlines() if line.startswith(("learned", "smooth"))],
                         FIGURES)
        picture = vtkPNGReader()
        picture.SetFileName(os.path.join(self.folder, "own", "quickstart.png"))
        expect_picture(self, picture, "Quickstart")


def read_terminal(terminal):
    """What was written to it; nothing at its end."""
    try:
        return os.read(terminal, 4096)
    except OSError:  # so Linux tells the end
        return b""


class TestScripts(unittest.TestCase):
    """Examples/quickstart.sh, in a tree whose parts only say that they were called, and quickstart.py."""

    def run_script(self, folder, *arguments):
        """What the command is called with."""
        for path, text in (
                ("CMake/install-packages.sh", ""),
                ("bin/cmake", "#!/bin/sh\n"),
                ("bin/xvfb-run", "#!/bin/sh\nshift\nexec \"$@\"\n"),
                ("Examples/Python/toy_bear.py", "import os, sys\nos.makedirs(sys.argv[1])\n"),
                ("build/release/bin/conformalsom", "#!/bin/sh\nprintf '%s\\n' \"$@\"\n")):
            os.makedirs(os.path.join(folder, os.path.dirname(path)), exist_ok=True)
            with open(os.path.join(folder, path), "w", encoding="ascii") as file:
                file.write(text)
            os.chmod(os.path.join(folder, path), 0o755)
        shutil.copy(os.path.join(EXAMPLES, "quickstart.sh"), os.path.join(folder, "Examples"))
        shutil.copy(BUILD_SCRIPT, os.path.join(folder, "CMake"))
        run = subprocess.run(["bash", os.path.join(folder, "Examples", "quickstart.sh"), *arguments], text=True,
                             env={**os.environ, "PATH": os.path.join(folder, "bin") + ":" + os.environ["PATH"]},
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        _, writing, *called = run.stdout.splitlines()
        self.assertEqual(writing, "Writing quickstart.png and surface.vtp, .glb, .obj and .html into "
                         + os.path.join(folder, "build", "quickstart"))
        return called

    def test_quickstart_gives_the_command_scan_texture_and_options(self):
        for arguments, first, bear in (
                ((), ["BUILD/bear.vtp", "--texture", "BUILD/rosette.png"], True),
                (("--view", "1", "0", "0"), ["BUILD/bear.vtp", "--texture", "BUILD/rosette.png"], True),
                (("my scan.ply",), ["my scan.ply"], False),
                (("my scan.ply", "--up", "0", "0", "1"), ["my scan.ply"], False),
                (("my scan.ply", "a b.png", "--neurons", "99"), ["my scan.ply", "--texture", "a b.png"], False)):
            with self.subTest(arguments), tempfile.TemporaryDirectory(prefix="a tree ") as folder:
                called = self.run_script(folder, *arguments)
                build = os.path.join(folder, "build", "quickstart")
                self.assertEqual(called[:len(first)], [word.replace("BUILD", build) for word in first])
                options = [word for word in arguments if word not in first]
                self.assertEqual(called[len(called) - len(options):], options)
                for name in ("surface.vtp", "surface.glb", "surface.obj", "surface.html", "quickstart.png"):
                    self.assertIn(os.path.join(build, name), called)
                self.assertEqual(os.path.isdir(build), bear)

    def test_build_shows_how_far_it_is_and_why_it_fails(self):
        for status, said in ((0, ["Building into out", "Building into out: 50 %", "Building into out: 100 %"]),
                             (1, ["Building into out", "Building into out: 50 %", "Building into out: 100 %",
                                  "[1/2] first", "no progress", "[2/2] second"])):
            with self.subTest(status), tempfile.TemporaryDirectory(prefix="a tree ") as folder:
                for name in "CMake", "bin":
                    os.makedirs(os.path.join(folder, name))
                shutil.copy(BUILD_SCRIPT, os.path.join(folder, "CMake"))
                cmake = os.path.join(folder, "bin", "cmake")
                with open(cmake, "w", encoding="ascii") as file:
                    file.write('#!/bin/sh\n[ "$1" = --build ] || exit 0\necho "[1/2] first"; echo no progress\n'
                               f'echo "[2/2] second"\nexit {status}\n')
                os.chmod(cmake, 0o755)
                run = subprocess.run(["bash", os.path.join(folder, "CMake", "build.sh"), "preset", "out"], text=True,
                                     env={**os.environ, "PATH": os.path.dirname(cmake) + ":" + os.environ["PATH"]},
                                     stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
                self.assertEqual((run.returncode, run.stdout.splitlines()), (status, said))
                self.assertEqual(run.stderr, "The build failed; all of its output is in out/build.log\n" if status else "")

    def test_short_example_makes_a_surface(self):
        with tempfile.TemporaryDirectory() as folder:
            scan, picture = egg(20), os.path.join(folder, "picture.png")
            write(conformalsom.vtkConformalPLYWriter(), scan, folder, "scan.ply")
            write(vtkPNGWriter(), textures.checkerboard(32), picture)
            script = os.path.join(EXAMPLES, "Python", "quickstart.py")
            subprocess.run([sys.executable, script, os.path.join(folder, "scan.ply"), picture,
                            os.path.join(folder, "surface.glb")], check=True)
            scene = read(vtkGLTFReader(), folder, "surface.glb")
            iterator = scene.NewIterator()
            iterator.InitTraversal()
            self.assertGreater(iterator.GetCurrentDataObject().GetNumberOfCells(), 100000)


def write(writer, data, *path):
    writer.SetInputData(data)
    writer.SetFileName(os.path.join(*path))
    writer.Write()


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def egg(frequency=8):
    """A closed mesh of an ellipsoid."""
    sphere = conformalsom.vtkGeodesicSphereSource()
    sphere.SetFrequency(frequency)
    sphere.Update()
    points, mesh = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(points_of(sphere.GetOutput()) * (1.0, 1.4, 0.8), deep=True))
    mesh.SetPoints(points)
    mesh.SetPolys(sphere.GetOutput().GetPolys())
    return mesh


def cloud_of(mesh):
    """The points of a mesh alone."""
    cloud = vtkPolyData()
    cloud.SetPoints(mesh.GetPoints())
    return cloud


class TestFormats(unittest.TestCase):
    """A scan in every format, opened and turned into a surface."""
    # Who must open it, by the name of the file. The content counts where the name says nothing.
    OURS = {"scan.ply": "ConformalPLY", "scan.off": "ConformalOFF", "scan.m": "GuMesh",
            "scan.xyz": "TextCloud", "scan.csv": "TextCloud", "scan.pts": "TextCloud",
            "scan.pcd": "PCD", "lh.white": "FreeSurfer", "scan.surf.gii": "GIFTI",
            "scan.conf": "StanfordScans", "scan.tab": "PlateModel", "ply without extension": "ConformalPLY",
            "shape_surf.vtk": "SPHARMSurface"}  # with shape_para.vtk beside it
    VTKS = {"scan.obj": scan_files.OBJReader, "scan.stl": scan_files.STLReader, "scan.vtp": vtkXMLPolyDataReader,
            "scan.vtk": vtkPolyDataReader}

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder, cls.mesh = cls.temporary.name, egg()
        for name, writer in (
                ("scan.ply", conformalsom.vtkConformalPLYWriter()),
                ("ply without extension", conformalsom.vtkConformalPLYWriter()),
                ("scan.off", conformalsom.vtkConformalOFFWriter()),
                ("scan.m", conformalsom.vtkGuMeshWriter()),
                ("lh.white", conformalsom.vtkFreeSurferWriter()),
                ("scan.surf.gii", conformalsom.vtkGIFTIWriter()),
                ("scan.obj", vtkOBJWriter()), ("scan.stl", vtkSTLWriter()),
                ("scan.vtp", vtkXMLPolyDataWriter()), ("scan.vtk", vtkPolyDataWriter()),
                ("shape_surf.vtk", vtkPolyDataWriter()), ("shape_para.vtk", vtkPolyDataWriter())):
            write(writer, cls.mesh, cls.folder, name)
        points = points_of(cls.mesh)
        lines = [" ".join(map(repr, point)) for point in points.tolist()]
        polygons = cls.mesh.GetPolys()
        plates = [[polygons.GetConnectivityArray().GetValue(3 * row + corner) + 1 for corner in range(3)]
                  for row in range(polygons.GetNumberOfCells())]
        for name, text in (
                ("scan.tab", [str(len(lines)), *(f"{row} {line}" for row, line in enumerate(lines, 1)),
                              str(len(plates)),
                              *(" ".join(map(str, [row, *ids])) for row, ids in enumerate(plates, 1))]),
                ("scan.xyz", lines),
                ("scan.csv", ["x,y,z", *(line.replace(" ", ",") for line in lines)]),
                ("scan.pts", [str(len(lines)), *lines]),
                ("scan.pcd", ["VERSION 0.7", "FIELDS x y z", "SIZE 4 4 4", "TYPE F F F", "COUNT 1 1 1",
                              f"WIDTH {len(lines)}", "HEIGHT 1", f"POINTS {len(lines)}", "DATA ascii",
                              *lines]),
                ("scan.conf", ["bmesh scan.ply 0 0 0 0 0 0 1"])):
            with open(os.path.join(cls.folder, name), "w", encoding="ascii") as file:
                file.write("\n".join(text) + "\n")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_plate_models_of_all_kinds_are_opened(self):
        """Tables with tags, and grids on a cube under the name of a text."""
        for name, text in (("tagged.tab", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"),
                           ("grids.txt", "1\n" + 24 * "0.5 -0.5 1.5\n")):
            with self.subTest(name):
                path = os.path.join(self.folder, name)
                with open(path, "w", encoding="ascii") as file:
                    file.write(text)
                self.assertIs(scan_files.reader_class(path), conformalsom.vtkPlateModelReader)

    def test_label_has_the_unit(self):
        """The same as --unit km."""
        shutil.copy(os.path.join(self.folder, "scan.tab"), os.path.join(self.folder, "body.tab"))
        with open(os.path.join(self.folder, "body.lbl"), "w", encoding="ascii") as file:
            file.write("UNIT = <KM>\n")
        written = []
        for scan, *words in (("body.tab",), ("scan.tab", "--unit", "km"), ("scan.tab",)):
            path = os.path.join(self.folder, "unit.glb")
            subprocess.run([sys.executable, "-m", "conformalsom", os.path.join(self.folder, scan), "-o", path, "--neurons",
                            "162", "--points", "642", "--overwrite", *words], check=True, stdout=subprocess.PIPE)
            with open(path, "rb") as file:
                written.append(file.read())
        self.assertEqual(written[0], written[1])
        self.assertNotEqual(written[0], written[2])

    def test_every_reader_of_the_package_opens_its_files(self):
        tried = {"vtk" + name + "Reader" for name in self.OURS.values()}
        for reader in set(scan_files.OUR_READERS):
            if reader.__name__ not in tried:  # the right class opens the files of its case
                folder = os.path.join(self.folder, reader.__name__)
                if reader.__name__ in output_cases.UNTRIED_READERS:
                    continue
                for number, files in enumerate(output_cases.CASES[reader.__name__].files.values()):
                    os.makedirs(os.path.join(folder, str(number)))
                    for name, bytes_ in files.items():
                        with open(os.path.join(folder, str(number), name), "wb") as file:
                            file.write(bytes_)
                    path = os.path.join(folder, str(number), next(iter(files)))
                    self.assertIs(type(scan_files.scan_reader(path)), reader, path)

    def test_right_reader_reads_every_point(self):
        ours = {name: getattr(conformalsom, "vtk" + word + "Reader") for name, word in self.OURS.items()}
        for name, expected in {**ours, **self.VTKS}.items():
            with self.subTest(name):
                reader = scan_files.scan_reader(os.path.join(self.folder, name))
                self.assertIs(type(reader), expected)
                reader.Update()
                read_back = points_of(reader.GetOutput())
                if name == "scan.stl":  # has its points in an order of its own
                    read_back = read_back[np.lexsort(np.round(read_back, 4).T)]
                    points = points_of(self.mesh)
                    points = points[np.lexsort(np.round(points, 4).T)]
                else:
                    points = points_of(self.mesh)
                self.assertEqual(read_back.shape, points.shape)
                self.assertLess(np.abs(read_back - points).max(), 2e-5)

    def test_surface_is_made_of_every_format_of_ours(self):
        for name in self.OURS:
            with self.subTest(name):
                run = command(self.folder, name, "-o", "of " + name + "/surface.vtp", *COARSE)
                self.assertEqual(run.returncode, 0, run.stderr)
                for line in run.stderr.splitlines():
                    self.assertIn(": note: ", line)
                surface = read(vtkXMLPolyDataReader(), self.folder, "of " + name, "surface.vtp")
                radii = np.linalg.norm(points_of(surface) / (1.0, 1.4, 0.8), axis=1)
                self.assertIn(len(radii), COARSE_POINTS)
                self.assertLess(np.abs(radii - 1.0).max(), 0.1)


def hues(points):
    """Red, green and blue, which change evenly from place to place."""
    return np.rint(128.0 + 70.0 * points @ [[1.0, 0.0, 0.4], [0.4, 0.9, 0.0], [0.0, -0.6, 1.2]])


def colored(data, colors, attributes):
    """Colors as active scalars of points or cells."""
    array = numpy_to_vtk(colors.astype(np.uint8), deep=True)
    array.SetName("RGB" if colors.shape[1] == 3 else "RGBA")
    attributes.SetScalars(array)
    return data


def sampled(image, coordinates):
    """The colors of an image at texture coordinates, mixed from the four pixels around each."""
    columns, rows, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(rows, columns, -1).astype(float)
    places = coordinates * (columns, rows) - 0.5
    low = np.clip(np.floor(places).astype(int), 0, (columns - 2, rows - 2))
    s, t = (places - low).T[:, :, None]
    (i, j) = low.T
    return ((1 - t) * ((1 - s) * pixels[j, i] + s * pixels[j, i + 1])
            + t * ((1 - s) * pixels[j + 1, i] + s * pixels[j + 1, i + 1]))


class TestColors(unittest.TestCase):
    """A scan with colors is painted with them, all around, unless a picture is given."""

    def paint(self, name, writer, scan, *options):
        """The vertices of surface.obj, and what its picture shows at each."""
        with tempfile.TemporaryDirectory() as folder:
            write(writer, scan, folder, name)
            picture = vtkPNGWriter()
            picture.SetInputData(textures.to_image(np.full((8, 8, 3), 0.2)))
            picture.SetFileName(os.path.join(folder, "gray.png"))
            picture.Write()
            run = command(folder, name, *options, "-o", "out/surface.obj", "--neurons", "642",
                          "--points", "5762")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            surface = read(vtkOBJReader(), folder, "out", "surface.obj")
            image = read(vtkPNGReader(), folder, "out", "surface.png")
            coordinates = vtk_to_numpy(surface.GetPointData().GetTCoords()).astype(float)
            return points_of(surface), sampled(image, coordinates)

    def expect_hues(self, points, seen):
        self.assertEqual(seen.shape[1], 3)
        difference = np.abs(seen - hues(points))
        self.assertLess(difference.mean(), 2.0)
        self.assertLess(difference.max(), 12.0)

    def test_colors_of_points_come_back_at_every_vertex(self):
        scan = cloud_of(egg(40))
        colored(scan, hues(points_of(scan)), scan.GetPointData())
        self.expect_hues(*self.paint("scan.ply", conformalsom.vtkConformalPLYWriter(), scan))

    def test_opacity_is_left_out(self):
        scan = cloud_of(egg(40))
        opacity = np.full((scan.GetNumberOfPoints(), 1), 7.0)
        colored(scan, np.hstack([hues(points_of(scan)), opacity]), scan.GetPointData())
        self.expect_hues(*self.paint("scan.ply", conformalsom.vtkConformalPLYWriter(), scan))

    def test_colors_of_triangles(self):
        scan = egg(40)
        corners = vtk_to_numpy(scan.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        colored(scan, hues(points_of(scan)[corners].mean(axis=1)), scan.GetCellData())
        self.expect_hues(*self.paint("scan.off", conformalsom.vtkConformalOFFWriter(), scan))

    def test_points_that_are_not_finite_are_left_out(self):
        scan = cloud_of(egg(20))
        colored(scan, hues(points_of(scan)), scan.GetPointData())
        vtk_to_numpy(scan.GetPoints().GetData())[0] = np.nan
        with tempfile.TemporaryDirectory() as folder:
            write(vtkXMLPolyDataWriter(), scan, folder, "scan.vtp")
            run = command(folder, "scan.vtp", *COARSE, "-o", "x.ply", "--report", "x.json")
            self.assertEqual((run.returncode, os.path.exists(os.path.join(folder, "x.png"))), (0, True), run.stderr)
            self.assertIn("Read the scan: 1 of 4,002 points are not finite, and are left out", run.stderr)

    def test_given_picture_wins(self):
        scan = cloud_of(egg(20))
        colored(scan, hues(points_of(scan)), scan.GetPointData())
        _, seen = self.paint("scan.ply", conformalsom.vtkConformalPLYWriter(), scan, "--texture", "gray.png")
        self.assertLess(np.abs(seen - 51.0).max(), 1e-9)

    def test_picture_of_the_gallery_is_what_it_draws(self):
        scan = builtin_figure.figure_cloud()
        x, y, z = points_of(scan).T
        muzzle = np.hypot(x / 0.25, (y - 0.44) / 0.18) < 1.0
        nose = np.hypot(x / 0.08, (y - 0.53) / 0.06) < 1.0
        eyes = np.hypot((np.abs(x) - 0.20) / 0.06, (y - 0.69) / 0.07) < 1.0
        jersey, stripe = (y > -0.62) & (y < 0.1), np.floor(y / 0.09) % 2 == 0
        colors = np.tile((148, 98, 58), (len(x), 1))
        colors[muzzle & (z > 0.0)] = (222, 190, 150)
        colors[(nose & (z > 0.0)) | (eyes & (z > 0.44))] = (40, 34, 34)
        colors[jersey] = (196, 48, 48)
        colors[jersey & stripe] = (244, 236, 220)
        colored(scan, colors, scan.GetPointData())
        with tempfile.TemporaryDirectory() as folder:
            write(conformalsom.vtkConformalPLYWriter(), scan, folder, "scan.ply")
            run = command(folder, "scan.ply", "--measure", "--picture", "out/quickstart.png")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            picture = vtkPNGReader()
            picture.SetFileName(os.path.join(folder, "out", "quickstart.png"))
            expect_picture(self, picture, "QuickstartColors")


if __name__ == "__main__":
    require_display()
    unittest.main()
