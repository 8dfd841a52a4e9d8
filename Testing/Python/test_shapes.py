"""conformalsom shapes: a family made by code has the two modes it was made with, a call continues after a stop with the
same bytes, unsuitable inputs leave no results, R reads the tables, and the page moves the surface."""
import contextlib
import csv
import errno
import glob
import io
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest
from unittest import mock

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

from browser import CHROMIUM, Browser
from conformalsom import (
    vtkConformalPLYReader, vtkConformalPLYWriter, vtkGeodesicSphereSource, vtkSphericalTemplate, vtkTextCloudWriter)
from conformalsom.command import outputs, shape_results, shape_steps, shapes
from conformalsom.command.steps import Steps
from samples import write_las
from test_command import COMMAND, command, files_in, heed_interrupts, read, write

NUMBER = 12
MARKS = ("scan,x,y,z\n", "scan,name,x,y,z\nshape 00,nose,1,2,3\n", "scan,name,x,y,z\nshape 00,nose,1,n,3\n",
         "scan,name,x,y,z\nshape 00,nose,1,2,3\nshape 00.ply,nose,1,2,3\n", "scan,name,x,y,z\nother,nose,1,2,3\n",
         "scan,name,x,y,z\n", "scan,name,x,y,z\nshape 00,nose,1,2\n")  # tables of landmarks, all unsuitable
RSCRIPT = shutil.which("Rscript")
GUIDE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "Correspondence.md")
SMALL = ("--points", "500", "--rounds", "1", "--modes", "2", "--permutations", "99")


def sphere(frequency):
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    return source.GetOutput()


def parameters():
    """Two numbers of each shape, without correlation."""
    angles = 2 * np.pi * np.arange(NUMBER) / NUMBER
    return np.sqrt(2) * np.stack([np.cos(angles), np.sin(2 * angles)], axis=1)


def ellipsoids(frequency):
    """#shapes x #V x 3 points of ellipsoids, two axes of which vary."""
    directions = vtk_to_numpy(sphere(frequency).GetPoints().GetData()).astype(float)
    axes = np.array([(2 + 0.2 * first, 1 + 0.046 * second, 0.7) for first, second in parameters()])
    return axes[:, None] * directions


def shares_of(shapes, triangles):
    """Fractions of the variance of centered shapes that are oriented alike, weighted by area: the known answer."""
    weights = np.zeros(shapes.shape[1])
    for shape in shapes:
        a, b, c = (shape[triangles[:, k]] for k in range(3))
        areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        for k in range(3):
            np.add.at(weights, triangles[:, k], areas / areas.sum())
    weights /= weights.sum()
    differences = shapes - shapes.mean(axis=0)
    values = np.linalg.eigvalsh(np.einsum("nvc,mvc,v->nm", differences, differences, weights))[::-1]
    return values / values.sum()


def write_family(folder, frequency, number=NUMBER):
    """Ellipsoids as files, each moved and turned; their names."""
    random, names = np.random.RandomState(1), []
    for i, shape in enumerate(ellipsoids(frequency)[:number]):
        turn, _ = np.linalg.qr(random.standard_normal((3, 3)))
        turn *= np.sign(np.linalg.det(turn))
        points, mesh = vtkPoints(), vtkPolyData()
        points.SetData(numpy_to_vtk(shape @ turn.T + 3 * random.standard_normal(3), deep=True))
        mesh.SetPoints(points)
        mesh.SetPolys(sphere(frequency).GetPolys())
        names.append(f"shape {i:02}.ply")
        write(vtkConformalPLYWriter(), mesh, folder, names[-1])
    return names


def table(*path):
    with open(os.path.join(*path), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def triangles_of(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def temporaries_of(folder):
    """Folders of unfinished files that are left."""
    return glob.glob(folder + "/**/.conformalsom-*", recursive=True)


def results_of(folder):
    """Contents of all files but those of the work."""
    return {name: data for name, data in files_in(folder).items() if not name.startswith("work" + os.sep)}


class TestStudy(unittest.TestCase):
    """A study of a family, with groups that differ by the first parameter."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="shapes of ")
        cls.folder = cls.temporary.name
        cls.names = write_family(cls.folder, 8)
        cls.groups = ["long" if first > 0 else "short & <b>" for first, _ in parameters()]
        with open(os.path.join(cls.folder, "groups.csv"), "w", encoding="utf-8") as file:
            file.write("scan,group\n" + "".join(f"{name},{group}\n" for name, group in zip(cls.names, cls.groups)))
        cls.run_ = command(cls.folder, "shapes", *cls.names, "-o", "study/", "--points", "1500", "--modes", "4",
                           "--groups", "groups.csv", "--jobs", "2")
        cls.study = os.path.join(cls.folder, "study")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_files_have_equal_connectivity(self):
        self.assertEqual((self.run_.returncode, without_ambiguity(self.run_.stderr)), (0, ""))
        self.assertIn("variance of modes", self.run_.stdout)
        with open(os.path.join(self.study, "study.json"), encoding="utf-8") as file:
            files = json.load(file)["Files"]
        self.assertEqual(sorted([*files, "study.json"]), sorted(results_of(self.study)))
        surfaces = [os.path.join("surfaces", name) for name in self.names]
        modes = [os.path.join("modes", f"mode{k}_{sigmas:+}.ply") for k in range(1, 5) for sigmas in (-2, -1, 1, 2)]
        self.assertLessEqual({*surfaces, *modes, "mean.vtp", "scores.csv", "variance.csv", "index.html"}, set(files))
        mean = read(vtkXMLPolyDataReader(), self.study, "mean.vtp")
        self.assertLess(abs(mean.GetNumberOfPoints() - 1500), 30)
        for name in (*surfaces, *modes):
            surface = read(vtkConformalPLYReader(), self.study, name)
            np.testing.assert_array_equal(triangles_of(surface), triangles_of(mean))
        mode = vtk_to_numpy(mean.GetPointData().GetArray("ShapeMode2"))
        moved = read(vtkConformalPLYReader(), self.study, "modes", "mode2_-2.ply")
        np.testing.assert_allclose(points_of(moved), points_of(mean) - 2 * mode, atol=1e-6)

    def test_two_known_modes(self):
        known = shares_of(ellipsoids(8), triangles_of(sphere(8)))
        np.testing.assert_allclose(known[:3], (0.94, 0.06, 0.0), atol=0.001)  # the family is as it is to be
        found = table(self.study, "variance.csv")
        self.assertEqual([row["mode"] for row in found], [str(k + 1) for k in range(len(found))])
        for row, share in zip(found[:2], known):
            self.assertLess(abs(float(row["fraction"]) - share), 0.01)
        self.assertAlmostEqual(float(found[-1]["cumulative"]), 1.0, places=6)
        scores = table(self.study, "scores.csv")
        self.assertEqual([row["scan"] for row in scores], [os.path.splitext(name)[0] for name in self.names])
        for k in range(2):
            values = [float(row[f"mode{k + 1}"]) for row in scores]
            self.assertGreater(abs(np.corrcoef(values, parameters()[:, k])[0, 1]), 0.999)
            self.assertAlmostEqual(np.std(values, ddof=1), 1.0, places=6)

    def test_surfaces_are_aligned(self):
        """Their plain principal components are those of shape, too."""
        surfaces = [points_of(read(vtkConformalPLYReader(), self.study, "surfaces", name)) for name in self.names]
        flat = np.array(surfaces).reshape(NUMBER, -1)
        values = np.linalg.svd(flat - flat.mean(axis=0), compute_uv=False)**2
        np.testing.assert_allclose(values[:2] / values.sum(), (0.94, 0.06), atol=0.015)

    def test_planted_difference_of_groups(self):
        mean = read(vtkXMLPolyDataReader(), self.study, "mean.vtp")
        corrected = vtk_to_numpy(mean.GetPointData().GetArray("GroupPCorrected"))
        alone = vtk_to_numpy(mean.GetPointData().GetArray("GroupP"))
        self.assertTrue((alone <= corrected).all())
        centered = points_of(mean) - points_of(mean).mean(axis=0)
        length = np.abs(centered @ np.linalg.svd(centered, full_matrices=False)[2][0])
        self.assertLess(corrected[length > 0.8 * length.max()].max(), 0.01)  # both ends of the long axis
        self.assertGreater(corrected.max(), 0.05)
        self.assertEqual([row["group"] for row in table(self.study, "scores.csv")], self.groups)

    def test_registration_is_that_of_the_template(self):
        names, study = self.names[:3], os.path.join(self.folder, "three")
        run = command(self.folder, "shapes", *names, "-o", study, *SMALL, "--rounds", "2", "--jobs", "2")
        self.assertEqual(run.returncode, 0, run.stderr)
        template, blocks = vtkSphericalTemplate(), vtkMultiBlockDataSet()
        for i, path in enumerate(maps_of(study, names)):
            blocks.SetBlock(i, read(vtkXMLPolyDataReader(), path))
        template.SetInputDataObject(blocks)
        template.SetMaximumNumberOfRounds(2)
        template.SetTolerance(0.0)
        template.Update()
        files = [read(vtkXMLPolyDataReader(), path) for path in glob.glob(os.path.join(study, "work", "register-*"))]
        written = [vtk_to_numpy(file.GetPointData().GetArray("SpherePosition")) for file in files]
        for i in range(len(names)):
            own = vtk_to_numpy(template.GetOutput().GetBlock(i).GetPointData().GetArray("SpherePosition"))
            self.assertLess(min(np.abs(own - other).max() for other in written), 1e-6, self.names[i])

    @unittest.skipUnless(RSCRIPT, "R is not installed (package r-base-core)")
    def test_r_reads_the_tables_as_the_guide_shows(self):
        with open(GUIDE, encoding="utf-8") as file:
            lines = re.search(r"```r\n(.*?)```", file.read(), re.DOTALL).group(1)
        self.assertEqual(lines.count("\n"), 3)
        run = subprocess.run([RSCRIPT, "-e", lines + "cat(nrow(scores), cor(scores$mode1, scores$mode2))\n"],
                             cwd=self.folder, text=True, capture_output=True, check=False)
        self.assertEqual(run.returncode, 0, run.stderr)
        rows, correlation = run.stdout.split("\n")[-1].split()
        self.assertEqual(rows, str(NUMBER))
        self.assertLess(abs(float(correlation)), 1e-6)
        self.assertIn("Pr(>F)", run.stdout)

    @unittest.skipUnless(CHROMIUM, "chromium is not installed")
    def test_page_moves_the_surface(self):
        with Browser() as browser:
            browser.open(os.path.join(self.study, "index.html"))
            self.assertEqual(browser.evaluate("document.title"), "study")
            self.assertEqual(browser.evaluate("document.querySelectorAll('input[type=range]').length"), 4)
            self.assertIn("94", browser.evaluate("document.querySelector('.share').textContent"))
            groups = "[...document.querySelectorAll('#groups li')].map((item) => item.textContent)"
            self.assertEqual(browser.evaluate(groups), ["long", "short & <b>"])
            pictures = [screen_of(browser)]
            browser.evaluate("(() => { const s = document.getElementById('mode1'); s.value = 3;"
                             " s.dispatchEvent(new Event('input')); })()")
            pictures.append(screen_of(browser))
            browser.evaluate("(() => { const s = document.getElementById('color'); s.value = 'moved';"
                             " s.dispatchEvent(new Event('change')); })()")
            pictures.append(screen_of(browser))
            browser.evaluate("document.querySelectorAll('#plot circle')[3].dispatchEvent(new Event('click'))")
            self.assertIn("shape 03", browser.evaluate("document.getElementById('shown').textContent"))
            own = float(table(self.study, "scores.csv")[3]["mode1"])
            self.assertLess(abs(browser.evaluate("Number(document.getElementById('mode1').value)") - own), 0.051)
            pictures.append(screen_of(browser))
            browser.drag((300, 300), (380, 340))
            pictures.append(screen_of(browser))
            self.assertEqual(len(set(pictures)), len(pictures))
            browser.resize(390, 844, is_phone=True)
            browser.drawn()
            self.assertLessEqual(browser.evaluate("document.documentElement.scrollWidth"), 390)
            browser.evaluate("window.scrollTo(0, 500)")
            self.assertLess(abs(browser.evaluate("document.getElementById('view').getBoundingClientRect().top")), 1)
            self.assertEqual(browser.messages, [])
            self.assertEqual([url for url in browser.requests if not url.startswith("file:")], [])


def screen_of(browser):
    """What the browser shows, as a file of a picture."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "screen.png")
        browser.screenshot(path)
        with open(path, "rb") as file:
            return file.read()


def without_ambiguity(text):
    """The lines but those of shapes whose two ends are alike, as the ends of these are."""
    return "".join(line for line in text.splitlines(True) if "two correspondences are about equally good" not in line)


def maps_of(study, names):
    """Files of the maps of scans, in their order: each has the number of points and the place of its scan."""
    maps = {path: points_of(read(vtkXMLPolyDataReader(), path)) for path in glob.glob(os.path.join(study, "work", "map-*"))}
    scans = [points_of(read(vtkConformalPLYReader(), os.path.dirname(study), name)) for name in names]
    return [next(path for path, points in maps.items() if np.allclose(points, scan)) for scan in scans]


class TestClouds(unittest.TestCase):
    def test_an_incomplete_cloud_becomes_a_closed_surface(self):
        """A third of an ellipsoid, of which vtkConformalSOM would learn an open surface."""
        directions, points, cloud = points_of(sphere(12)), vtkPoints(), vtkPolyData()
        points.SetData(numpy_to_vtk(directions[directions[:, 2] < -0.3] * [2.0, 1.0, 0.7], deep=True))
        cloud.SetPoints(points)
        steps = Steps()
        with contextlib.redirect_stdout(io.StringIO()):
            surface = shape_steps.surface_of(cloud, steps)
        edges = np.sort(triangles_of(surface)[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
        self.assertTrue((np.unique(edges, axis=0, return_counts=True)[1] == 2).all())
        self.assertRegex("".join(steps.warnings), "^Learn the mesh: [0-9.]+ % of the mesh area has no points nearby")


class TestStops(unittest.TestCase):
    """Compared with a study of one job that was not stopped."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="stops of ")
        cls.folder = cls.temporary.name
        cls.names = write_family(cls.folder, 6, number=3)
        cloud = vtkPolyData()  # without triangles: its surface is learned
        cloud.SetPoints(read(vtkConformalPLYReader(), cls.folder, cls.names.pop()).GetPoints())
        write(vtkTextCloudWriter(), cloud, cls.folder, "cloud.xyz")
        cls.names.append("cloud.xyz")
        cls.run_ = command(cls.folder, "shapes", *cls.names, "-o", "whole", *SMALL, "--jobs", "1")
        cls.whole = os.path.join(cls.folder, "whole")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def study(self, folder, *arguments):
        run = command(self.folder, "shapes", *self.names, "-o", folder, *SMALL, *arguments)
        return self.checked(run, folder)

    def checked(self, run, folder):
        """The results of a study that was made without an error."""
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual([line for line in run.stderr.splitlines() if " note: " not in line], [])
        self.assertEqual(temporaries_of(os.path.join(self.folder, folder)), [])
        return results_of(os.path.join(self.folder, folder))

    def assertWhole(self, results, folder):
        """They are those of the whole study, but for the titles, which name the folder."""
        whole = self.checked(self.run_, "whole")
        self.assertEqual(sorted(results), sorted(whole))
        for name, data in whole.items():
            self.assertEqual(results[name] == data.replace(b">whole<", f">{folder}<".encode()), True, name)

    def test_a_call_continues_after_a_stop_with_the_same_bytes(self):
        total = len(os.listdir(os.path.join(self.whole, "work")))
        folder = os.path.join(self.folder, "stopped")
        work, kept = os.path.join(folder, "work"), {}
        for number, files in ((signal.SIGTERM, 1), (signal.SIGKILL, 4), (signal.SIGINT, 7)):
            process = subprocess.Popen([COMMAND, "shapes", *self.names, "-o", folder, *SMALL], cwd=self.folder,
                                       preexec_fn=heed_interrupts)
            deadline = time.monotonic() + 120
            while process.poll() is None and time.monotonic() < deadline and len(glob.glob(work + "/*.vtp")) < files:
                time.sleep(0.002)
            process.send_signal(number)
            self.assertEqual(process.wait(), -number)
            self.wait_for_children(work)
            for name in glob.glob(work + "/*.vtp"):
                status = os.stat(name)
                self.assertEqual(kept.setdefault(name, (status.st_mtime_ns, status.st_ino)),
                                 (status.st_mtime_ns, status.st_ino))
            self.assertGreaterEqual(len(kept), files)
            self.assertLess(len(kept), total)
            self.assertEqual(results_of(folder), {})
        resumed = self.study("stopped")
        for name, times in kept.items():
            self.assertEqual((os.stat(name).st_mtime_ns, os.stat(name).st_ino), times, "it was made again")
        self.assertWhole(resumed, "stopped")

    def wait_for_children(self, work):
        """Wait for processes whose parent was killed, and which notice it."""
        for _ in range(500):
            if not glob.glob(work + "/.conformalsom-*"):
                return
            time.sleep(0.02)

    def test_jobs_change_no_byte(self):
        self.assertWhole(self.study("jobs", "--jobs", "2"), "jobs")

    def test_an_error_leaves_no_files(self):
        """A folder that comes into being meanwhile, at the place of a file, is noticed at the end."""
        folder = os.path.join(self.folder, "error")
        process = subprocess.Popen([COMMAND, "shapes", *self.names, "-o", folder, *SMALL], cwd=self.folder, text=True,
                                   stderr=subprocess.PIPE)
        while process.poll() is None and not glob.glob(os.path.join(folder, "work", "*.vtp")):
            time.sleep(0.002)
        os.mkdir(os.path.join(folder, "mean.vtp"))
        stderr = process.communicate()[1]
        self.assertEqual(process.returncode, 1)
        self.assertIn("mean.vtp is not a regular file", stderr)
        self.assertIn("inspect the surface, or add landmarks by --landmarks", stderr)
        self.assertNotIn("output port", stderr)
        self.assertEqual(sorted(os.listdir(folder)), ["mean.vtp", "work"])

    def test_scans_are_added_and_results_replaced(self):
        shutil.copytree(self.whole, os.path.join(self.folder, "study"))
        work = os.path.join(self.folder, "study", "work")
        maps = {path: os.stat(path).st_mtime_ns for path in glob.glob(work + "/map-*")}
        with open(os.path.join(self.folder, "study", "surfaces", "mine.txt"), "w", encoding="ascii") as file:
            file.write("mine")
        run = command(self.folder, "shapes", *self.names[:2], "-o", "study", *SMALL)
        self.assertEqual(run.returncode, 2)
        self.assertIn("study has a study already; use --overwrite or another folder", run.stderr)
        self.names = self.names[:2]
        results = self.study("study", "--overwrite", "--format", ".vtp", "--alignment", "similarity")
        self.assertEqual(sorted(name for name in results if name.startswith("surfaces")),
                         ["surfaces/mine.txt", "surfaces/shape 00.vtp", "surfaces/shape 01.vtp"])
        self.assertEqual({path: os.stat(path).st_mtime_ns for path in maps}, maps)
        self.assertEqual(len(table(self.folder, "study", "scores.csv")), 2)
        shutil.rmtree(work)  # as the guide permits
        self.assertEqual(self.study("study", "--overwrite", "--format", ".vtp", "--alignment", "similarity"), results)


class TestPlaces(unittest.TestCase):
    """Results take their places all together, and only where they replace nothing else."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="places of ")
        self.addCleanup(temporary.cleanup)
        self.folder = os.path.join(temporary.name, "study")
        self.scans = [os.path.join(temporary.name, name) for name in ("a.ply", "b.ply")]
        for path in self.scans:
            self.put("scan", path)

    def put(self, text, *path):
        path = os.path.join(self.folder, *path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def publish(self, names, overwrite=True):
        with shape_results.Results(self.folder, "token", Steps()) as results:
            for name in names:
                results.text(name, "new " + name)
            results.text("study.json", json.dumps({"Files": [*names, "study.json"]}))
            results.publish(overwrite)

    def refuses(self, message, *arguments):
        before, output = files_in(self.folder), io.StringIO()
        with contextlib.redirect_stderr(output), self.assertRaises(SystemExit) as raised:
            shapes.arguments([*self.scans, "-o", self.folder, *arguments])
        self.assertEqual(raised.exception.code, 2)
        self.assertIn(message, output.getvalue())
        self.assertEqual(files_in(self.folder), before)

    def accepts(self, *arguments):
        shapes.arguments([*self.scans, "-o", self.folder, *arguments])

    def test_all_files_take_their_places_or_none(self):
        """The error names the place, whichever file cannot be moved there: on the way, or before."""
        os.mkdir(self.folder)
        self.publish(["surfaces/a.ply", "mean.vtp"])
        os.chmod(os.path.join(self.folder, "study.json"), 0o640)
        before, real = files_in(self.folder), os.replace
        self.assertEqual(sorted(before), ["mean.vtp", "study.json", "surfaces/a.ply"])
        for failing in ("surfaces/a.ply", "modes/m.ply", "scores.csv", "study.json"):
            def fail(source, target, failing=failing):
                if target.endswith(failing) and source.endswith(".new"):
                    raise OSError(errno.EACCES, "no", source)
                real(source, target)
            with self.subTest(failing), mock.patch.object(os, "replace", fail):
                with self.assertRaises(OSError) as raised:
                    self.publish(["surfaces/a.ply", "modes/m.ply", "mean.vtp", "scores.csv"])
                self.assertEqual(raised.exception.filename, os.path.join(self.folder, failing))
                self.assertEqual(files_in(self.folder), before)
                self.assertEqual(sorted(os.listdir(self.folder)), ["mean.vtp", "study.json", "surfaces"])
        self.publish(["modes/m.ply", "mean.vtp"])
        self.assertEqual(sorted(files_in(self.folder)), ["mean.vtp", "modes/m.ply", "study.json"])
        self.assertEqual(os.stat(os.path.join(self.folder, "study.json")).st_mode & 0o777, 0o640)

    def test_what_came_into_being_meanwhile_is_kept(self):
        for name in ("study.json", "scores.csv"):
            self.put("mine", name)
            with self.assertRaisesRegex(OSError, "in the meantime"):
                self.publish(["scores.csv"], overwrite=False)
            self.assertEqual(files_in(self.folder), {name: b"mine"})
            os.remove(os.path.join(self.folder, name))

    def test_other_files_are_kept(self):
        """A stopped call leaves the folder work, and a killed one also unfinished files."""
        self.put("{}", "work", "map.vtp")
        self.put("", ".conformalsom-0", "mean.vtp")
        self.accepts()
        self.put("mine", "index.html")
        self.refuses("study has more than the folder work; use --overwrite")
        self.accepts("--overwrite")
        shutil.rmtree(os.path.join(self.folder, "work"))
        self.refuses("study has files that are not of a study", "--overwrite")
        self.put("{}", "study.json")
        self.refuses("study has a study already")
        self.accepts("--overwrite")
        self.put("a file", "work")
        self.refuses("work is not a folder", "--overwrite")

    def test_places_that_cannot_be_written_are_noticed_before_any_work(self):
        self.put("{}", "study.json")
        self.put("old", "modes", "mode1_+1.ply")
        self.put("old", "work", "map.vtp")
        real = outputs.may
        for name, message in (("modes", "modes cannot be written to"),
                              ("modes/mode1_+1.ply", "mode1_+1.ply cannot be replaced"),
                              ("work", "work: this user may not write it")):
            def may(path, mode, locked=os.path.realpath(os.path.join(self.folder, name))):
                return os.path.realpath(path) != locked and real(path, mode)
            with self.subTest(name), mock.patch.object(outputs, "may", may):
                self.refuses(message, "--overwrite")
        self.accepts("--overwrite")
        os.symlink(os.path.dirname(self.folder), os.path.join(self.folder, "surfaces"))
        self.refuses("surfaces/a.ply is an input and would be replaced", "--overwrite")


class TestLandmarks(unittest.TestCase):
    """Landmarks that the shapes do not suggest: on the second scan they are turned by 0.35 on the sphere."""
    ANGLE = 0.35

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="landmarks of ")
        self.addCleanup(temporary.cleanup)
        self.folder = temporary.name
        self.names = write_family(self.folder, 12, number=3)
        directions = points_of(sphere(12))
        cosine, sine = np.cos(self.ANGLE), np.sin(self.ANGLE)
        turn = np.array([[1, 0, 0], [0, cosine, -sine], [0, sine, cosine]])
        wanted = np.array([[0, 1, 0], [0, 0, 1], [0, -1, 0], [0, 0, -1], [1, 0, 0], [-1, 0, 0]], dtype=float)
        self.ids = [np.argmax(directions @ (wanted @ turn.T if i == 1 else wanted).T, axis=0) for i in range(3)]

    def write_landmarks(self, ids):
        with open(os.path.join(self.folder, "landmarks.csv"), "w", encoding="utf-8") as file:
            file.write("Scan,x,y,z,Name\n")
            for name, points in zip(self.names, ids):
                coordinates = points_of(read(vtkConformalPLYReader(), self.folder, name))
                for k, point in sorted(enumerate(points), key=lambda item: -item[0] if name == self.names[0] else item[0]):
                    file.write(f"{name},{','.join(map(repr, coordinates[point].tolist()))},L{k}\n")

    def study(self, *arguments):
        run = command(self.folder, "shapes", *self.names, "-o", "study", *SMALL, *arguments)
        self.assertEqual(run.returncode, 0, run.stderr)
        return results_of(os.path.join(self.folder, "study"))

    def disagreement(self):
        """The largest distance on the sphere between a landmark of two registered surfaces of the last round."""
        scans = [points_of(read(vtkConformalPLYReader(), self.folder, name)) for name in self.names]
        spheres = {}
        for path in sorted(glob.glob(os.path.join(self.folder, "study", "work", "register-*")), key=os.path.getmtime):
            surface = read(vtkXMLPolyDataReader(), path)
            number, = (i for i, scan in enumerate(scans) if np.allclose(points_of(surface), scan))
            spheres[number] = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))
        places = np.array([spheres[i][self.ids[i]] for i in range(3)])
        return np.linalg.norm(places[:, None] - places[None], axis=-1).max()

    def test_registered_maps_agree_at_landmarks(self):
        without = self.study()
        self.assertGreater(self.disagreement(), 0.8 * self.ANGLE)
        self.write_landmarks(self.ids)
        with_ = self.study("--landmarks", "landmarks.csv", "--overwrite")
        self.assertLess(self.disagreement(), 0.3 * self.ANGLE)
        self.assertNotEqual(without["scores.csv"], with_["scores.csv"])

    def test_a_changed_file_is_noticed_and_maps_are_kept(self):
        self.write_landmarks(self.ids)
        first = self.study("--landmarks", "landmarks.csv")
        work = os.path.join(self.folder, "study", "work")
        files = {path: os.stat(path).st_mtime_ns for path in glob.glob(work + "/*.vtp")}
        again = self.study("--landmarks", "landmarks.csv", "--overwrite")
        self.assertEqual({path: os.stat(path).st_mtime_ns for path in glob.glob(work + "/*.vtp")}, files)
        self.assertEqual(again["scores.csv"], first["scores.csv"])
        self.write_landmarks([self.ids[0]] * 3)
        changed = self.study("--landmarks", "landmarks.csv", "--overwrite")
        self.assertNotEqual(changed["scores.csv"], first["scores.csv"])
        maps = [path for path in glob.glob(work + "/*.vtp") if os.path.basename(path).startswith("map-")]
        self.assertEqual({path: os.stat(path).st_mtime_ns for path in maps},
                         {path: time_ for path, time_ in files.items() if path in maps})
        self.assertEqual(len(maps), 3)

    def test_landmarks_have_the_coordinates_of_the_file(self):
        """Scans far from the origin, from which their reader subtracts a vector: the landmarks do the same there as near."""
        places = [points_of(read(vtkConformalPLYReader(), self.folder, name)) for name in self.names]
        self.names, offset = [f"scan {i}.las" for i in range(3)], np.array((5e5, 5.4e6, 300.0))
        scores = []
        for far in (0.0, 1.0):
            lines = ["scan,name,x,y,z"]
            for name, points, ids in zip(self.names, places, self.ids):
                write_las(os.path.join(self.folder, name), points, far * offset)
                lines += [f"{name},L{k},{','.join(map(repr, (points[point] + far * offset).tolist()))}"
                          for k, point in enumerate(ids)]
            with open(os.path.join(self.folder, "landmarks.csv"), "w", encoding="utf-8") as file:
                file.write("\n".join(lines))
            self.study("--landmarks", "landmarks.csv", "--overwrite")
            scores.append([float(row["mode1"]) for row in table(self.folder, "study", "scores.csv")])
        np.testing.assert_allclose(np.abs(scores[1]), np.abs(scores[0]), atol=0.05)

    def test_landmarks_of_another_scan_are_refused(self):
        self.write_landmarks(self.ids)
        path = os.path.join(self.folder, "landmarks.csv")
        with open(path, encoding="utf-8") as file:
            lines = file.read().splitlines()
        scan, *_, name = lines[-1].split(",")
        lines[-1] = f"{scan},99,99,99,{name}"
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines))
        run = command(self.folder, "shapes", *self.names, "-o", "study", *SMALL, "--landmarks", "landmarks.csv")
        self.assertEqual(run.returncode, 1)
        self.assertRegex(run.stderr, f"{scan}: .*the landmark at 99, 99, 99 is .* from the surface; landmarks must have")


class TestBadInputs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="bad inputs of ")
        cls.folder = cls.temporary.name
        cls.names = write_family(cls.folder, 6, number=4)
        for name, text in (("broken.ply", "ply\nformat ascii 1.0\nelement vertex 9\n"), ("notes.doc", "notes"),
                           ("few.csv", "scan,group\nshape 00,a\nshape 01,b\n"),
                           *((f"marks{i}.csv", text) for i, text in enumerate(MARKS)),
                           ("unknown.csv", "scan,group\nshape 00,a\nshape 01,a\nshape 02,b\nshape 03,b\nother,b\n")):
            with open(os.path.join(cls.folder, name), "w", encoding="ascii") as file:
                file.write(text)
        os.makedirs(os.path.join(cls.folder, "mine", "more"))
        shutil.copy(os.path.join(cls.folder, cls.names[0]), os.path.join(cls.folder, "mine", "more"))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_nothing_is_written(self):
        before = files_in(self.folder)
        for status, arguments, message in (
                (2, self.names[:1], "two scans or more are needed"),
                (2, [*self.names, "mine/more/" + self.names[0]], "two scans have the name shape 00"),
                (1, [*self.names, "missing.ply"], "missing.ply: no such file"),
                (1, [*self.names, "notes.doc"], "notes.doc: expected a file of type"),
                (1, [*self.names, "--groups", "missing.csv"], "missing.csv: No such file"),
                (1, [*self.names, "--groups", "few.csv"], "few.csv: no group for shape 02, shape 03"),
                (1, [*self.names, "--groups", "unknown.csv"], "unknown.csv: other is none of the scans"),
                (1, [*self.names, "--landmarks", "missing.csv"], "missing.csv: No such file"),
                (1, [*self.names, "--landmarks", "marks0.csv"], "marks0.csv: the first line must name the columns scan, name"),
                (1, [*self.names, "--landmarks", "marks1.csv"], "marks1.csv: shape 01 has no landmark nose"),
                (1, [*self.names, "--landmarks", "marks2.csv"], "marks2.csv: row 2: x, y and z must be finite numbers, not 1, n"),
                (1, [*self.names, "--landmarks", "marks3.csv"], "marks3.csv: shape 00.ply has two rows of the landmark nose"),
                (1, [*self.names, "--landmarks", "marks4.csv"], "marks4.csv: other is none of the scans"),
                (1, [*self.names, "--landmarks", "marks5.csv"], "marks5.csv: there are no landmarks"),
                (1, [*self.names, "--landmarks", "marks6.csv"], "marks6.csv: row 2 has 4 cells"),
                (2, [*self.names, "-o", "mine"], "mine has files that are not of a study"),
                (2, [*self.names, "-o", "notes.doc"], "notes.doc is not a folder"),
                (2, [*self.names, "-o", "."], "is an input, but lies in the folder to write"),
                (2, [*self.names, "--points", "9"], "9 is not in [500, 1000000]"),
                (2, [*self.names, "--view", "0", "1", "0"], "must be finite, not zero, and not parallel"),
                (2, [*self.names, "--format", ".doc"], "invalid choice: '.doc'")):
            with self.subTest(message):
                run = command(self.folder, "shapes", *(["-o", "study"] if "-o" not in arguments else []), *arguments)
                self.assertEqual((run.returncode, run.stdout), (status, ""), run.stderr)
                self.assertIn(message, run.stderr)
                self.assertNotIn("Traceback", run.stderr)
                self.assertEqual(files_in(self.folder), before)
                self.assertFalse(os.path.exists(os.path.join(self.folder, "study")))

    def test_a_broken_scan_is_named_and_the_others_are_kept(self):
        run = command(self.folder, "shapes", "broken.ply", *self.names, "-o", "half", *SMALL)
        self.assertEqual((run.returncode, run.stdout), (1, ""))
        self.assertRegex(run.stderr, "^conformalsom: broken.ply: Read the scan: .*\n$")
        half = os.path.join(self.folder, "half")
        self.assertEqual(results_of(half), {})
        self.assertEqual(len(glob.glob(os.path.join(half, "work", "map-*.vtp"))), 4)
        self.assertEqual(command(self.folder, "shapes", *self.names, "-o", "half", *SMALL).returncode, 0)
        shutil.rmtree(half)

    def test_equal_scans_have_no_modes(self):
        shutil.copy(os.path.join(self.folder, self.names[0]), os.path.join(self.folder, "copy.ply"))
        run = command(self.folder, "shapes", self.names[0], "copy.ply", "-o", "equal", *SMALL)
        self.assertEqual(run.returncode, 0)
        self.assertRegex(without_ambiguity(run.stderr), r"^conformalsom: shape 00.ply: note: its content is that of "
                                                        r"copy.ply; scans must be independent, [^\n]*\n$")
        self.assertIn("all shapes are equal, so that there are no modes", run.stdout)
        self.assertEqual(table(self.folder, "equal", "variance.csv"), [])
        self.assertEqual(table(self.folder, "equal", "scores.csv"), [{"scan": "shape 00"}, {"scan": "copy"}])
        shutil.rmtree(os.path.join(self.folder, "equal"))
        os.unlink(os.path.join(self.folder, "copy.ply"))


if __name__ == "__main__":
    unittest.main()
