"""Files of the command conformalsom: whatever an input is called, it is not replaced; what is replaced keeps its
rights; what cannot be written is noticed before any work; and checks cost in proportion to the number of files."""
import contextlib
import errno
import io
import json
import os
import resource
import stat
import subprocess
import tempfile
import unittest
from unittest import mock

import conformalsom
import numpy as np
from conformalsom.command import outputs, plan, scan_files
from conformalsom.command.steps import Steps, message_of
from conformalsom.messages import heard
from samples import write_las
from test_command import COARSE, COMMAND, command, egg, files_in, points_of, read, textures, write
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

LINE = "0 0 0 0 0 0 1\n"
NO_BREAK = "\u00a0"


def put(text, *path):
    with open(os.path.join(*path), "w", encoding="utf-8") as file:
        file.write(text)


def far(surface):
    """The surface where floats are too coarse for it."""
    points, moved = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(points_of(surface) + (4e6, -5e6, 3e6), deep=True))
    moved.SetPoints(points)
    moved.SetPolys(surface.GetPolys())
    return moved


class Folder(unittest.TestCase):
    """A folder for each test, with a scan in it."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="files of ")
        self.addCleanup(temporary.cleanup)
        self.folder = os.path.realpath(temporary.name)
        write(conformalsom.vtkConformalPLYWriter(), egg(), self.folder, "a.ply")

    def file(self, *names):
        return os.path.join(self.folder, *names)

    def refuses(self, message, *arguments):
        """Nothing is done, with status 2."""
        before = self.states()
        run = command(self.folder, *arguments)
        self.assertEqual(run.returncode, 2, run.stderr)
        self.assertIn(message, run.stderr)
        self.assertNotIn("Traceback", run.stderr)
        self.assertEqual(self.states(), before)

    def states(self):
        """Names, places on the disk and times of all files, pipes among them."""
        found = {}
        for path, _, names in os.walk(self.folder):
            for name in names:
                status = os.lstat(os.path.join(path, name))
                found[os.path.join(path, name)] = status.st_ino, status.st_mtime_ns, status.st_size, status.st_mode
        return found

    def makes(self, *arguments):
        run = command(self.folder, *arguments)
        self.assertEqual((run.returncode, run.stderr), (0, ""))


class TestInputs(Folder):
    """Every file that is read, by all of its names."""

    def expect_kept(self, name, *scans):
        """The file cannot be written, by its own name, other spellings of it, and links to it."""
        folder, base = os.path.split(name)
        os.makedirs(self.file("links"), exist_ok=True)
        os.symlink(self.file(name), self.file("links", base))
        os.link(self.file(name), self.file("links", "hard" + base))
        os.symlink("links", self.file("linked folder"))
        for other in (name, os.path.join(folder, ".", "links", "..", base) if not folder else name,
                      os.path.join(".", folder, ".", base), self.file(name), os.path.join("links", base),
                      os.path.join("links", "hard" + base), os.path.join("linked folder", base)):
            with self.subTest(other):
                self.refuses(f"{other} is an input and would be replaced", *scans, "-o", other, "--overwrite")
        other = os.path.join(folder, base.upper())
        if os.path.exists(self.file(other)):  # names do not differ by case here
            self.refuses("is an input", *scans, "-o", other, "--overwrite")

    def test_sphere_of_a_surface(self):
        for name in "shape_surf.vtk", "shape_para.vtk":
            write(vtkPolyDataWriter(), egg(), self.folder, name)
        self.expect_kept("shape_para.vtk", "shape_surf.vtk")

    def test_scans_of_a_list_whatever_its_name(self):
        put("camera " + LINE + "mesh a.ply " + LINE + "\tbmesh \v b.ply " + LINE, self.folder, "list.conf")
        write(conformalsom.vtkConformalPLYWriter(), egg(), self.folder, "b.ply")
        os.rename(self.file("list.conf"), self.file("list.txt"))
        self.expect_kept("a.ply", "list.txt")
        self.refuses("b.ply is an input", "list.txt", "-o", "b.ply", "--overwrite")
        os.rename(self.file("list.txt"), self.file("list.conf"))
        self.refuses("b.ply is an input", "list.conf", "-o", "b.ply", "--overwrite")
        self.refuses("b.ply is an input", "list.conf", "--report", "b.ply", "--overwrite")

    def test_name_with_a_no_break_space(self):
        name = f"a{NO_BREAK}scan.ply"
        os.rename(self.file("a.ply"), self.file(name))
        put(f"bmesh {name} " + LINE, self.folder, "list.conf")
        self.expect_kept(name, "list.conf")

    def test_scan_that_is_not_there_is_not_made(self):
        put("mesh a.ply " + LINE + "mesh missing.ply " + LINE, self.folder, "list.conf")
        self.refuses("missing.ply is an input", "list.conf", "-o", "missing.ply")

    def test_texture_and_the_files_beside_a_surface(self):
        write(vtkPNGWriter(), textures.checkerboard(8), self.folder, "t.png")
        for output in "t.obj", "t.ply":
            self.refuses("t.png is an input", "a.ply", "--texture", "t.png", "-o", output, "--overwrite")
        self.refuses("t.png is an input", "a.ply", "--texture", "t.png", "--picture", "t.png", "--overwrite")

    def test_readers_of_vtk_read_no_other_file(self):
        """So an .mtl file that an .obj file names may be replaced."""
        for name, writer in (("b.obj", vtkOBJWriter()), ("b.stl", vtkSTLWriter()), ("b.vtp", vtkXMLPolyDataWriter()),
                             ("b.vtk", vtkPolyDataWriter())):
            write(writer, egg(), self.folder, name)
            self.assertEqual(scan_files.inputs_of(self.file(name)), [self.file(name)])
        with open(self.file("b.obj"), encoding="ascii") as file:
            text = file.read()
        put("mtllib b.mtl\n" + text, self.folder, "b.obj")
        os.mkfifo(self.file("b.mtl"))  # at which a reader would hang
        reader = scan_files.scan_reader(self.file("b.obj"))
        reader.Update()
        self.assertGreater(reader.GetOutput().GetNumberOfPoints(), 0)

    def test_every_writer_makes_no_other_file_than_those_checked(self):
        write(vtkPNGWriter(), textures.checkerboard(8), self.folder, "t.png")
        names = ["new " + extension[1:] + extension for extension in outputs.SURFACES]
        for texture in ((), ("--texture", "t.png")):
            with self.subTest(texture=texture):
                before = set(os.listdir(self.folder))
                self.makes("a.ply", *(word for name in names for word in ("-o", name)), *texture, *COARSE)
                new = set(os.listdir(self.folder)) - before
                self.assertLessEqual(set(names), new)
                for name in new:
                    made = next(made for made in names if made.split(".")[0] == name.split(".")[0])
                    self.assertIn(name, outputs.files_of(made))
                    os.remove(self.file(name))


class TestPlaces(Folder):
    """What cannot be written is noticed before any work."""

    def test_names_with_control_characters(self):
        for name in "x\n.glb", "x\t.vtp", "x\x7f.stl":
            self.refuses("control characters", "a.ply", "-o", name)
        self.refuses(r"x\x1b[2J.glb", "a.ply", "-o", "x\x1b[2J.glb")

    def test_links(self):
        os.mkdir(self.file("real"))
        os.symlink("real/new.vtp", self.file("dangling.vtp"))
        os.symlink("real/old.glb", self.file("link.glb"))
        os.symlink("nowhere/new.vtp", self.file("lost.vtp"))
        os.symlink("circle.vtp", self.file("circle.vtp"))
        put("old", self.file("real", "old.glb"))
        self.refuses("lost.vtp is a link to", "a.ply", "-o", "lost.vtp")
        self.refuses("circle.vtp", "a.ply", "-o", "circle.vtp", "--overwrite")
        self.refuses("link.glb already exists", "a.ply", "-o", "link.glb")
        self.makes("a.ply", "-o", "dangling.vtp", *COARSE)
        self.makes("a.ply", "-o", "link.glb", "--overwrite", *COARSE)
        for link in "dangling.vtp", "link.glb":
            self.assertTrue(os.path.islink(self.file(link)))
        self.assertEqual(sorted(os.listdir(self.file("real"))), ["new.vtp", "old.glb"])
        self.assertGreater(os.path.getsize(self.file("real", "old.glb")), 3)
        self.refuses("would be written twice", "a.ply", "-o", "link.glb", "-o", "real/old.glb", "--overwrite")

    def test_files_of_one_surface_behind_links(self):
        write(vtkPNGWriter(), textures.checkerboard(8), self.folder, "t.png")
        os.mkdir(self.file("elsewhere"))
        os.symlink("elsewhere/p.png", self.file("s.png"))
        self.makes("a.ply", "-o", "s.obj", "--texture", "t.png", *COARSE)
        self.assertEqual(os.listdir(self.file("elsewhere")), ["p.png"])
        self.assertTrue(os.path.islink(self.file("s.png")))

    def test_places_that_are_none(self):
        os.mkfifo(self.file("pipe.glb"))
        os.mkdir(self.file("folder.vtp"))
        for output, message in (("pipe.glb", "not a regular file"), ("a.ply/x.glb", "a.ply cannot be written to"),
                                ("x" * 300 + ".glb", "name too long")):
            self.refuses(message, "a.ply", "-o", output, "--overwrite")
        self.refuses("folder.vtp is not a regular file", "a.ply", "--report", "folder.vtp", "--overwrite")
        self.refuses("x.glb is to be a file and a folder", "a.ply", "-o", "x.glb", "-o", "x.glb/y.vtp")

    def test_files_and_folders_that_are_read_only(self):
        os.mkdir(self.file("locked"))
        put("old", self.file("locked", "x.vtp"))
        put("old", self.file("x.vtp"))
        os.symlink("locked/y.vtp", self.file("link.vtp"))
        os.chmod(self.file("x.vtp"), 0o444)
        os.chmod(self.file("locked"), 0o555)
        self.addCleanup(os.chmod, self.file("locked"), 0o755)
        with unwritable(self.file("x.vtp"), self.file("locked")):
            for path, message in (("x.vtp", "x.vtp cannot be replaced"), ("locked/x.vtp", "locked cannot be written to"),
                                  ("locked/y.vtp", "locked cannot be written to"),
                                  ("link.vtp", "locked cannot be written to")):
                checks = plan.Checks([], overwrite=True)
                with self.subTest(path), self.assertRaisesRegex(plan.WrongUsage, message):
                    checks.expect_free(self.file(path))

    def test_checks_cost_in_proportion_to_the_number_of_files(self):
        """Eight times as many scans look at eight times as many files, or at 64 times as many."""
        def looks(count):
            scans = [self.file(f"{i}.xyz") for i in range(count)]
            for scan in scans:
                put("1 2 3\n", scan)
            options, _ = None, None
            calls = [0]
            real = {name: getattr(os, name) for name in ("stat", "lstat")}

            def counted(name):
                def call(*arguments, **keywords):
                    calls[0] += 1
                    return real[name](*arguments, **keywords)
                return call
            options = mock.Mock(scans=scans, output=[self.file("out", "{}" + e) for e in (".glb", ".vtp", ".stl")],
                                picture=None, report=None, texture=None, overwrite=False)
            with mock.patch.object(os, "stat", counted("stat")), mock.patch.object(os, "lstat", counted("lstat")):
                self.assertEqual(len(plan.paths_of(options)), count)
            return calls[0]
        self.assertLess(looks(320), 12 * looks(40))


@contextlib.contextmanager
def unwritable(*paths):
    """Let paths be unwritable for root, too."""
    real = outputs.may
    with mock.patch.object(outputs, "may", lambda path, mode: os.path.realpath(path) not in paths and real(path, mode)):
        yield


class TestReplacing(Folder):
    """One mechanism for all files."""

    def test_files_of_a_surface_are_replaced_together(self):
        for name in "x.obj", "x.mtl", "x.png":
            put("old " + name, self.file(name))
        before, real = files_in(self.folder), os.replace

        def fail_for_png(source, target):
            if target.endswith("x.png") and source.endswith(".new"):
                raise OSError(errno.EIO, "the disk is gone", target)
            real(source, target)
        with mock.patch.object(os, "replace", fail_for_png), self.assertRaisesRegex(OSError, "the disk is gone"):
            with outputs.whole(self.file("x.obj")) as part:
                for extension in ".obj", ".mtl", ".png":
                    put("new", os.path.splitext(part)[0] + extension)
        self.assertEqual(files_in(self.folder), before)
        for name in "x.obj", "x.mtl":  # and new ones are gone
            os.remove(self.file(name))
        with mock.patch.object(os, "replace", fail_for_png), self.assertRaisesRegex(OSError, "the disk is gone"):
            with outputs.whole(self.file("x.obj")) as part:
                for extension in ".obj", ".mtl", ".png":
                    put("new", os.path.splitext(part)[0] + extension)
        self.assertEqual(files_in(self.folder), {name: before[name] for name in ("a.ply", "x.png")})

    def test_a_file_that_was_not_checked_is_not_written(self):
        with self.assertRaisesRegex(RuntimeError, "x.png"):
            with outputs.whole(self.file("x.vtp")) as part:
                put("new", part)
                put("new", os.path.splitext(part)[0] + ".png")
        self.assertEqual(os.listdir(self.folder), ["a.ply"])

    def test_what_came_into_being_meanwhile_is_kept(self):
        put("theirs", self.file("x.vtp"))
        with self.assertRaisesRegex(OSError, "in the meantime"):
            with outputs.whole(self.file("x.vtp"), overwrite=False):
                self.fail("nothing is written")
        self.assertEqual(files_in(self.folder)["x.vtp"], b"theirs")

    def replaced(self, mode, **functions):
        """The mode of a file of that mode that is replaced, where functions of the system are others."""
        path = self.file("x.vtp")
        put("old", path)
        os.chmod(path, mode)
        with contextlib.ExitStack() as stack:
            for name, function in functions.items():
                stack.enter_context(mock.patch.object(os, name, function))
            with outputs.whole(path) as part:
                self.assertEqual(stat.S_IMODE(os.stat(os.path.dirname(part)).st_mode) & 0o077, 0)  # nobody looks in
                put("new", part)
        self.assertEqual(files_in(self.folder)["x.vtp"], b"new")
        return stat.S_IMODE(os.stat(path).st_mode)

    def test_rights_owner_and_group_are_kept(self):
        for mode in 0o600, 0o640, 0o666, 0o751:
            self.assertEqual(self.replaced(mode), mode)
        self.assertEqual(self.replaced(0o6755), 0o755)
        called = []
        self.replaced(0o640, chown=lambda path, user, group: called.append((user, group)))
        owner = os.stat(self.folder)
        self.assertEqual(called, [(-1, os.stat(self.file("x.vtp")).st_gid), (owner.st_uid, -1)])

    def test_group_that_cannot_be_kept_gets_no_more_than_all_others(self):
        def refuse(path, user, group):
            raise PermissionError(errno.EPERM, "no", path)
        for mode, expected in ((0o664, 0o644), (0o660, 0o600), (0o604, 0o604), (0o667, 0o667)):
            self.assertEqual(self.replaced(mode, chown=refuse), expected)

    def test_access_list_is_kept(self):
        lists = {}
        entries = b"\x02\0\0\0"

        def get(path, name):
            if os.path.basename(path) == "x.vtp":
                return entries
            raise OSError(errno.ENODATA, "none")

        def put_list(path, name, value):
            lists[name] = value
        self.replaced(0o640, getxattr=get, setxattr=put_list)
        self.assertEqual(lists, {"system.posix_acl_access": entries})

    def test_rights_of_every_kind_of_file_by_the_command(self):
        names = [extension[1:] + extension for extension in outputs.SURFACES] + ["x.json"]
        for name in names:
            put("old", self.file(name))
            os.chmod(self.file(name), 0o604)
        self.makes("a.ply", *COARSE, *(word for name in names[:-1] for word in ("-o", name)),
                   "--report", "x.json", "--overwrite")
        for name in names:
            with self.subTest(name):
                self.assertEqual(stat.S_IMODE(os.stat(self.file(name)).st_mode), 0o604)
                self.assertGreater(os.path.getsize(self.file(name)), 3)


@contextlib.contextmanager
def limited_files(size):
    """Let no file of this process become larger during the block."""
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        yield
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)


class TestWords(Folder):
    """Errors in plain words."""

    def test_standard_output_that_is_closed(self):
        for arguments in (("--report", "-"), ("--measure",)):
            run = subprocess.run(["bash", "-c", 'exec "$@" >&-', "bash", COMMAND, "a.ply", *COARSE, *arguments],
                                 cwd=self.folder, text=True, stderr=subprocess.PIPE, check=False)
            self.assertEqual(run.returncode, 1)
            self.assertRegex(run.stderr, "^conformalsom: the standard output is closed.*\n$")
        run = subprocess.run(["bash", "-c", 'exec "$@" <&- >&- 2>&-', "bash", COMMAND, "a.ply", *COARSE, "-o", "x.glb"],
                             cwd=self.folder, check=False)
        self.assertEqual((run.returncode, sorted(os.listdir(self.folder))), (0, ["a.ply", "x.glb"]))

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no device that is full")
    def test_standard_output_that_is_full(self):
        for arguments in (("--report", "-"), ("--measure",)):
            with open("/dev/full", "wb") as full:
                run = subprocess.run([COMMAND, "a.ply", *COARSE, *arguments], cwd=self.folder, text=True, stdout=full,
                                     stderr=subprocess.PIPE, check=False)
            self.assertEqual((run.returncode, run.stderr),
                             (1, "conformalsom: the standard output: No space left on device\n"))

    @unittest.skipUnless(os.path.exists("/dev/full"), "there is no device that is full")
    def test_help_that_cannot_be_printed(self):
        script = 'set -o pipefail; "$1" --help | true; echo $?; "$1" --version > /dev/full; echo $?; "$1" map --help > /dev/full'
        run = subprocess.run(["bash", "-c", script, "bash", COMMAND], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, check=False)
        self.assertEqual((run.stdout, run.returncode), ("1\n1\n", 1))
        self.assertEqual(run.stderr, 2 * "conformalsom: the standard output: No space left on device\n")

    def test_system_errors_have_no_numbers(self):
        for error, text in ((OSError(errno.ENOSPC, "No space left on device"), "No space left on device"),
                            (OSError(errno.ENOSPC, "No space left on device", "x"), "x: No space left on device"),
                            (ValueError("x: bad"), "x: bad")):
            self.assertEqual(message_of(error, ""), text)

    def test_coordinates_of_maps(self):
        """A LAS file far from the origin: the subtracted vector is shown."""
        points = [egg().GetPoint(i % egg().GetNumberOfPoints()) for i in range(2000)]
        write_las(self.file("map.las"), points, (500000.0, 5400000.0, 300.0))
        run = command(self.folder, "map.las", *COARSE, "-o", "map.ply")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertRegex(run.stderr, "Read the scan: coordinates are large; [0-9]+ [0-9]+ [0-9]+ is subtracted")

    def test_a_file_that_cannot_be_written_ends_no_other(self):
        write(conformalsom.vtkConformalPLYWriter(), far(egg()), self.folder, "far.ply")
        run = command(self.folder, "far.ply", *COARSE, "-o", "x.stl", "-o", "x.vtp", "--measure", "--report", "x.json")
        self.assertEqual(run.returncode, 1)
        self.assertIn("conformalsom: x.stl: the surface is too far from the origin", run.stderr)
        self.assertIn("smooth surface", run.stdout)
        with open(self.file("x.json"), encoding="utf-8") as file:
            [entry] = json.load(file)["Surfaces"]
        self.assertEqual(entry["Files"], ["x.vtp"])
        self.assertIn("x.stl: the surface is too far", entry["Error"])
        self.assertEqual({name for name in files_in(self.folder) if name.startswith("x")}, {"x.json", "x.vtp"})

    def test_files_for_printers_are_moved_to_the_origin_if_floats_need_it(self):
        write(conformalsom.vtkConformalPLYWriter(), far(egg()), self.folder, "far.ply")
        for scan in ("a", "far"):
            run = command(self.folder, scan + ".ply", *COARSE, "--preset", "print", "--unit", "m", "-o", scan + ".stl")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual("is added to its coordinates" in run.stderr, scan == "far")
        near, moved = (read(vtkSTLReader(), self.folder, scan + ".stl").GetBounds() for scan in ("a", "far"))
        np.testing.assert_allclose(moved, near, atol=20.0)  # of the 2,000 millimeters that the egg has

    def test_full_disk(self):
        """A limit of size acts as a full disk: the error names the file and the reason, and old files stay."""
        for extension in (".3mf", ".obj", ".ply", ".stl", ".vtk", ".vtp"):
            with self.subTest(extension):
                put("old", self.file("x" + extension))
                before = files_in(self.folder)
                writer = outputs.writer_of("x" + extension, painted=False)
                writer.SetInputData(egg())
                with limited_files(2000), contextlib.redirect_stdout(io.StringIO()):
                    with self.assertRaises((OSError, RuntimeError)) as raised:
                        outputs.write(Steps(), writer, self.file("x" + extension))
                self.assertRegex(message_of(raised.exception, ""),
                                 fr"^(Write x{extension}: )?{self.file('x' + extension)}"
                                 r"(: | cannot be written: )(File too large|.*; is the disk full\?)$")
                self.assertEqual(files_in(self.folder), before)

    def test_filter_that_fails_without_a_reason(self):
        class Fails(VTKPythonAlgorithmBase):
            def __init__(self):
                super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkPolyData")

            def RequestData(self, request, inputs, outputs):
                return 0
        algorithm = Fails()
        with heard(algorithm) as messages:
            algorithm.Update()
        self.assertEqual(messages.errors, [algorithm.GetClassName() + " failed without a message; its input may be broken"])

    def test_silent_failure_of_a_filter(self):
        put('<?xml version="1.0"?>\n<VTKFile type="PolyData"><Poly', self.folder, "b.vtp")
        run = command(self.folder, "b.vtp", "-o", "x.glb")
        self.assertEqual(run.returncode, 1)
        self.assertNotIn("returned failure for request", run.stderr)
        self.assertRegex(run.stderr, "^conformalsom: b.vtp: Read the scan: .*\n$")


if __name__ == "__main__":
    unittest.main()
