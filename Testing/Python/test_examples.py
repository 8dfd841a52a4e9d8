"""The examples run as programs, and Examples/README.md shows each with a picture and its command."""
import glob
import math
import os
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import body_map
import compare_surfaces
from conformalsom import (
    vtkFreeSurferReader, vtkGeodesicSphereSource, vtkGIFTIReader, vtkSPHARMCoefficientReader, vtkTIFFStackReader,
    vtkTIFFStackWriter)
from conformalsom.command import scan_files
import morph
from helpers import bodies, builtin_figure, handle_bodies, mapped_models, moving_cells

PYTHON = os.path.dirname(os.path.abspath(compare_surfaces.__file__))
EXAMPLES = os.path.dirname(PYTHON)
LANDMARKS = os.path.join(EXAMPLES, "..", "Documentation", "Correspondence")
SCRIPTS = sorted(os.path.basename(path) for path in glob.glob(os.path.join(PYTHON, "*.py")))


def run(script, *arguments):
    """Run a program from a folder of its own, as a user would."""
    with tempfile.TemporaryDirectory() as folder:
        return subprocess.run([sys.executable, os.path.join(PYTHON, script), *arguments], cwd=folder,
                              text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)


def write_model(folder, name, frequency, longer):
    """A head, longer by a number, as name.off, and as name.txt its landmarks; the path without extension."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    n = vtk_to_numpy(source.GetOutput().GetPoints().GetData())
    bumps = sum(height * np.exp((n @ np.array(at) / np.linalg.norm(at) - 1.0) / width**2) for height, at, width in (
        (0.7, (1, 0.1, 0.2), 0.3), (0.4, (-0.2, 1, 0.6), 0.35), (0.9, (-0.8, -0.3, -0.6), 0.25)))
    points = (1.0 + bumps)[:, None] * n * (1.0 + longer, 0.8, 1.0)
    triangles = vtk_to_numpy(source.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
    path = os.path.join(folder, name)
    with open(path + ".off", "w", encoding="ascii") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        np.savetxt(file, points)
        np.savetxt(file, np.insert(triangles, 0, 3, axis=1), fmt="%d")
    with open(path + ".txt", "w", encoding="ascii") as file:
        file.write("0\n3\n7\n10\n")  # vertices of the icosahedron, the first ones at any frequency
    return path


class TestExamples(unittest.TestCase):
    def test_every_program_explains_itself(self):
        self.assertIn("quickstart.py", SCRIPTS)
        for script in SCRIPTS:
            with self.subTest(script):
                completed = run(script, "--help")
                self.assertEqual((completed.returncode, completed.stderr), (0, ""))
                self.assertIn("usage: " + script, completed.stdout)

    def test_surfaces_are_compared_on_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            scan = os.path.join(folder, "ball.xyz")
            with open(scan, "w", encoding="ascii") as file:
                for i in range(2000):  # along a spiral from pole to pole
                    z, turn = (2 * i + 1) / 2000 - 1, 2.399963 * i
                    r = (1 - z * z) ** 0.5
                    file.write(f"{r * math.cos(turn)} {r * math.sin(turn)} {z}\n")
            completed = run(
                "compare_surfaces.py", scan, "--frequency", "4", "--surface-frequency", "12")
        self.assertEqual((completed.returncode, completed.stderr), (0, ""))
        rows = {line[:16].rstrip(): line[16:].split() for line in completed.stdout.splitlines()}
        for row in ("learned mesh", "butterfly", "Loop", "PN triangles",
                    *("CSS " + height for height in compare_surfaces.DOME_HEIGHTS)):
            self.assertIn(row, rows)
        self.assertEqual(rows["learned mesh"][0], "162")
        self.assertEqual(rows["CSS Fitted"][0], "1,442")
        self.assertLess(float(rows["CSS Curvature"][1]), float(rows["learned mesh"][1]))

    def test_surfaces_are_judged_by_points_held_out(self):
        completed = run("compare_surfaces.py", "--held-out", "--frequency", "8", "--surface-frequency", "20")
        self.assertEqual(completed.returncode, 0, completed.stderr)  # few neurons: it warns
        lines = completed.stdout.splitlines()
        for lattice in ("Geodesic", "Adaptive"):
            begin = next(i for i, line in enumerate(lines) if line.startswith(lattice))
            self.assertEqual(lines[begin].count("/"), 3)
            rows = {line[:16].rstrip(): line[16:].split() for line in lines[begin + 1:begin + 11]}
            best = [min(float(rows[name][k]) for name in compare_surfaces.RIVALS) for k in range(3)]
            for k, ratio in enumerate(rows["default / best"]):
                self.assertAlmostEqual(float(ratio), float(rows["CSS Curvature"][k]) / best[k], delta=0.02)

    def test_files_of_the_user_are_kept(self):
        with tempfile.TemporaryDirectory() as folder:
            scan, picture, beside, drawing = (
                os.path.join(folder, name) for name in ("scan.ply", "rosette.png", "model.mtl", "drawing.svg"))
            for path in (scan, picture, beside, drawing):
                with open(path, "w", encoding="ascii") as file:
                    file.write("mine")
            for kept, command in (
                    (scan, ("quickstart.py", scan, picture, scan)),
                    (picture, ("quickstart.py", scan, picture, picture)),
                    (beside, ("quickstart.py", scan, picture, os.path.join(folder, "model.obj"))),
                    (drawing, ("paper_schematics.py", "--output", drawing)),
                    (picture, ("toy_bear.py", folder))):
                with self.subTest(command):
                    completed = run(*command)
                    self.assertEqual(completed.returncode, 2)
                    self.assertIn(f"{os.path.basename(kept)} already exists", completed.stderr)
                    with open(kept, encoding="ascii") as file:
                        self.assertEqual(file.read(), "mine")
            completed = run("toy_bear.py", folder, "--overwrite")  # as quickstart.sh, which may run again
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            self.assertGreater(os.path.getsize(picture), 1000)

    def test_missing_scan_ends_with_a_message(self):
        completed = run("compare_surfaces.py", "missing.ply")
        self.assertEqual(completed.returncode, 1)
        self.assertEqual(completed.stderr, "compare_surfaces: missing.ply: no such file\n")

    def test_surfaces_are_registered(self):
        with tempfile.TemporaryDirectory() as folder:
            models = [write_model(folder, f"model{i}", 8 + i, 0.2 * i) for i in range(3)]
            files = [path + ".off" for path in models]
            marks = [path + ".txt" for path in models]
            output = os.path.join(folder, "registered.vtp")
            completed = run("register_surfaces.py", *files[:2], "--landmarks", *marks[:2], "--output", output)
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            rows = {line.split()[0]: line.split()[1] for line in completed.stdout.splitlines()[-4:]}
            self.assertEqual(rows["folds"], "0")
            self.assertLess(float(rows["landmarks"]), 1e-6)
            self.assertLess(float(rows["stretch"]), 1.2)
            self.assertGreater(float(rows["agreement"]), 0.9)
            registered = scan_files.read_models([output])["registered"]
            self.assertEqual(registered.GetNumberOfPoints(), 642)
            for name in ("SpherePosition", "TargetPointIds", "TargetBarycentric"):
                self.assertTrue(registered.GetPointData().HasArray(name), name)
            again = run("register_surfaces.py", output, files[1], "--landmarks", *marks[:2], "--space", "Rotation",
                        "--output", os.path.join(folder, "again.vtp"))
            self.assertEqual((again.returncode, again.stderr), (0, ""))
            self.assertNotIn("Map registered", again.stdout)  # it has a map
            self.assertIn("Map model1", again.stdout)
            completed = run("register_surfaces.py", *files[:2], "--output", output)
            self.assertEqual(completed.returncode, 2)
            self.assertIn("registered.vtp already exists", completed.stderr)

            mean = os.path.join(folder, "mean.vtp")
            completed = run("mean_shape.py", *files, "--landmarks", *marks, "--points", "1000", "--rounds", "1",
                            "--output", mean)
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            lines = completed.stdout.splitlines()
            self.assertIn("start               model1", lines)
            explained = next(line for line in lines if line.startswith("explained variance")).split()[2:]
            self.assertEqual(len(explained), 2)
            self.assertGreater(float(explained[0]), 0.9)  # the length, by which they differ
            scores = [float(line.split()[4]) for line in lines[-3:]]
            self.assertIn(scores, (sorted(scores), sorted(scores, reverse=True)))
            self.assertTrue(scan_files.read_models([mean])["mean"].GetPointData().HasArray("ShapeMode2"))

    def test_bodies_made_by_code_face_outward(self):
        for body in (builtin_figure.zero_set(body_map.comet), bodies.head(np.random.default_rng(1), 0.0).mesh(40),
                     handle_bodies.surface_of(handle_bodies.torus, 40)):
            points, triangles = handle_bodies.arrays_of(body)
            self.assertGreater(np.linalg.det(points[triangles]).sum(), 0.0)  # 6 times the volume

    def test_a_body_gets_a_map_with_its_place(self):
        with tempfile.TemporaryDirectory() as folder:
            path = write_model(folder, "body", 12, 0.4) + ".off"
            for projection, size in (("Mollweide", (200, 100)), ("PeirceQuincuncial", (200, 200))):
                with self.subTest(projection):
                    image = os.path.join(folder, projection + ".png")
                    completed = run("body_map.py", path, "--projection", projection, "--width", "200", "--output", image)
                    self.assertEqual((completed.returncode, completed.stderr), (0, ""))
                    reader = vtkPNGReader()
                    reader.SetFileName(image)
                    reader.Update()
                    self.assertEqual(reader.GetOutput().GetDimensions()[:2], size)
                    colors = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
                    self.assertGreater(len(np.unique(colors, axis=0)), 100)
                    with open(image[:-4] + ".pgw", encoding="ascii") as file:
                        place = [float(line) for line in file]
                    self.assertEqual(len(place), 6)
                    self.assertAlmostEqual(place[0], -place[3])
                    self.assertAlmostEqual(place[4], -place[0] * (size[0] - 1) / 2)  # the map's middle is 0, 0
            completed = run("body_map.py", "missing.off")
            self.assertEqual((completed.returncode, completed.stderr), (1, "body_map: missing.off: no such file\n"))
            self.assertEqual(run("body_map.py", path, "--output", path).returncode, 2)

    def test_a_picture_of_a_body_does_not_replace_its_map(self):
        for names in (("--picture", "body_map.png"), ("--output", "a.png", "--picture", "./a.png"),
                      ("--output", "a.pgw")):
            with self.subTest(names):
                completed = run("body_map.py", *names)
                self.assertEqual(completed.returncode, 2)
                self.assertIn("must be different files", completed.stderr)

    def test_a_torus_keeps_its_handle_and_gets_a_texture(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "torus.vtp")
            completed = run("handles.py", "--body", "torus", "--points", "6000", "--neurons", "1500", "--output", path)
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            line = next(line for line in completed.stdout.splitlines() if line.startswith("modulus"))
            self.assertAlmostEqual(float(line.split()[3]), (1.0 - 0.16) ** 0.5 / 0.4, delta=0.02)
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(path)
            reader.Update()
            self.assertGreater(np.ptp(vtk_to_numpy(reader.GetOutput().GetPointData().GetTCoords()), axis=0).min(), 7.9)
            self.assertEqual(run("handles.py", "--repeats", "0").returncode, 2)

    def test_harmonics_come_closer_with_their_degree(self):
        with tempfile.TemporaryDirectory() as folder:
            path = write_model(folder, "body", 12, 0.4) + ".off"
            output, picture = (os.path.join(folder, name) for name in ("body.coef", "body.png"))
            completed = run("surface_harmonics.py", path, "--degrees", "12", "2", "5", "--align", "--output", output,
                            "--picture", picture)
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            rows = [line.split() for line in completed.stdout.splitlines() if line[:6].strip().isdigit()]
            self.assertEqual([row[0] for row in rows], ["2", "5", "12"])
            distances = [float(row[1]) for row in rows]
            self.assertEqual(distances, sorted(distances, reverse=True))
            self.assertLess(distances[-1], 0.01)
            reader = vtkSPHARMCoefficientReader()
            reader.SetFileName(output)
            reader.Update()
            self.assertEqual(reader.GetOutput().GetNumberOfRows(), 13 * 13)
            self.assertGreater(os.path.getsize(picture), 1000)
            completed = run("surface_harmonics.py", path, "--output", output)
            self.assertEqual(completed.returncode, 2)
            self.assertIn("body.coef already exists", completed.stderr)

    def test_cortical_surfaces_are_registered(self):
        def table(completed):
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            return {line[:30].strip(): [float(word) for word in line[30:].split()]
                    for line in completed.stdout.splitlines() if re.fullmatch(r"[\d. -]+", line[30:])}

        def read(folder, reader, sphere, **files):
            reader.SetFileName(os.path.join(folder, files.pop("surface")))
            reader.SetSphereFileName(os.path.join(folder, sphere))
            for name, file in files.items():
                getattr(reader, f"Set{name}FileName")(os.path.join(folder, file))
            reader.Update()
            return reader.GetOutput()

        with tempfile.TemporaryDirectory() as folder:
            made, again = os.path.join(folder, "made"), os.path.join(folder, "again")
            rows = table(run("cortex.py", "--size", "20", "--frequency", "16", "--output", made))
            self.assertEqual(rows["folds"], [0.0])
            for name in ("correlation of sulcal depth", "correlation of curvature"):
                self.assertGreater(rows[name][1], rows[name][0] + 0.1)
            self.assertGreater(rows["correlation of sulcal depth"][1], 0.9)
            before, after = rows["mean error, degrees"]
            self.assertGreater(before, 5.0)
            self.assertLess(after, 0.4 * before)
            surface = read(made, vtkGIFTIReader(), "first.sphere.reg.surf.gii", surface="first.surf.gii",
                           Shape="first.shape.gii")
            self.assertEqual(surface.GetNumberOfPoints(), 4002)
            depth, carried = (vtk_to_numpy(surface.GetPointData().GetArray(name)) for name in ("SulcalDepth", "Carried"))
            self.assertAlmostEqual(np.corrcoef(depth, carried)[0, 1], rows["correlation of sulcal depth"][1], delta=1e-3)
            # What was written is read as a user's own.
            files = [os.path.join(made, label + ".surf.gii") for label in ("first", "second")]
            theirs = table(run("cortex.py", *files, "--values", os.path.join(made, "second.shape.gii"), "--array",
                               "MeanCurvature", "--frequency", "16", "--format", "freesurfer", "--output", again))
            self.assertNotIn("mean error, degrees", theirs)
            self.assertAlmostEqual(theirs["correlation of sulcal depth"][0], rows["correlation of sulcal depth"][0], delta=1e-3)
            surface = read(again, vtkFreeSurferReader(), "first.sphere.reg", surface="first.white", Curvature="first.sulc")
            np.testing.assert_allclose(vtk_to_numpy(surface.GetPointData().GetArray("Curvature")), depth, atol=1e-3)
            curv, carried = (
                vtk_to_numpy(read(again, vtkFreeSurferReader(), "first.sphere", surface="first.white", Curvature=file)
                             .GetPointData().GetArray("Curvature")) for file in ("first.curv", "first.carried"))
            self.assertGreater(np.corrcoef(curv, depth)[0, 1], 0.3)  # its sign is FreeSurfer's, the carried one's ours
            self.assertAlmostEqual(np.corrcoef(-curv, carried)[0, 1], theirs["correlation of curvature"][1], delta=1e-3)

            self.assertEqual(run("cortex.py", "--output", made).returncode, 2)
            self.assertEqual(run("cortex.py", files[0]).returncode, 2)
            self.assertEqual(run("cortex.py", "--values", files[0]).returncode, 2)
            completed = run("cortex.py", *files, "--array", "Thickness")
            self.assertEqual((completed.returncode, completed.stderr),
                             (1, "cortex: the second surface has no array Thickness of 1 component\n"))

    def test_shown_landmarks_are_met(self):
        """Those beside the pictures of Correspondence.md lie on their models, and ask for no fold."""
        igea = os.path.join(os.environ.get("CONFORMALSOM_SCAN_DIR", ""), "igea-closed.ply")
        for names, files in ((("dancer", "bear"), ("dancer.txt", "bear.txt")),
                             ((igea, "bear"), ("igea.txt", "bear_of_igea.txt"))):
            with self.subTest(names[0]):
                if names[0] == igea and not os.path.isfile(igea):
                    self.skipTest("igea-closed.ply is not in CONFORMALSOM_SCAN_DIR")
                models = [morph.model_of(name) for name in names]
                paths = [os.path.join(LANDMARKS, file) for file in files]
                for model, path, points in zip(models, paths, morph.landmarks_of(paths, models)):
                    taken = vtk_to_numpy(model.GetPoints().GetData())[points]
                    self.assertLess(np.abs(taken - np.loadtxt(path)).max() / model.GetLength(), 1e-3)
                landmarks = morph.landmarks_of(paths, models)
                moving, fixed = (morph.mapped(morph.placed(model), 0.5) for model in models)
                field = morph.registered(moving, landmarks[0], fixed, landmarks[1]).GetFieldData()
                self.assertLess(field.GetArray("LandmarkError").GetValue(0), 1e-6)
                self.assertEqual(field.GetArray("NumberOfFolds").GetValue(0), 0)

    def test_landmark_files_may_hold_ids_and_positions(self):
        model = morph.model_of("bear")
        position = vtk_to_numpy(model.GetPoints().GetData())[40] + 1e-4
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "landmarks.txt")
            with open(path, "w", encoding="utf-8") as file:
                file.write("# two of them\n7\n\n" + " ".join(map(str, position)) + "  # near point 40\n")
            self.assertEqual(mapped_models.read_landmarks(path, model), [7, 40])
            for line in ("3 4", "-1", "1.5", "9999999", "a", "1 2 b", "1 2 3 4"):
                with open(path, "w", encoding="utf-8") as file:
                    file.write("5\n" + line)
                with self.assertRaisesRegex(ValueError, "line 2: expected the id of one"):
                    mapped_models.read_landmarks(path, model)

    def test_what_cannot_be_registered_ends_with_a_message(self):
        with tempfile.TemporaryDirectory() as folder:
            models = [write_model(folder, name, 8, 0.0) for name in "ab"]
            files = [path + ".off" for path in models]
            with open(models[1] + ".txt", "w", encoding="ascii") as file:
                file.write("642\n")
            marks = [path + ".txt" for path in models]
            for script in ("register_surfaces.py", "mean_shape.py"):
                with self.subTest(script):
                    name = script[:-3]
                    completed = run(script, files[0], "missing.ply")
                    self.assertEqual(completed.returncode, 1)
                    self.assertEqual(completed.stderr, f"{name}: missing.ply: no such file\n")
                    completed = run(script, *files, "--landmarks", *marks)
                    self.assertEqual(completed.returncode, 1)
                    self.assertIn("line 1: expected the id of one of the model's 642 points, or three coordinates", completed.stderr)
            completed = run("mean_shape.py", files[0])
            self.assertEqual(completed.returncode, 2)
            self.assertIn("two models or more are needed", completed.stderr)

    def test_tissue_is_unrolled(self):
        with tempfile.TemporaryDirectory() as folder:
            writer = vtkTIFFStackWriter()
            writer.SetInputData(moving_cells.image_of(moving_cells.frame_of(0)))
            writer.SetUnit("micron")
            writer.SetFileName(os.path.join(folder, "tissue.tif"))
            writer.Write()
            maps = os.path.join(folder, "maps.tif")
            completed = run("tissue_map.py", os.path.join(folder, "tissue.tif"), "--neurons", "700", "--width", "64",
                            "--depths", "-2", "1", "--projection", "Mercator", "--output", maps)
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            reader = vtkTIFFStackReader()
            reader.SetFileName(maps)
            reader.Update()
        image = reader.GetOutput()
        self.assertEqual(image.GetDimensions(), (64, 64, 17))
        self.assertEqual(image.GetFieldData().GetAbstractArray("Unit").GetValue(0), "micron")
        brightness = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(17, -1).mean(axis=1)
        self.assertTrue((np.diff(brightness[8:]) < 0).all(), brightness)  # from cells to the dark outside
        self.assertGreater(brightness[6], 120.0)  # that of the darkest cell
        self.assertLess(brightness[16], 60.0)

    def test_a_body_is_followed_over_time(self):
        completed = run("time_series.py", "--steps", "2")
        self.assertEqual((completed.returncode, completed.stderr), (0, ""))
        rows = [line.split() for line in completed.stdout.splitlines()]
        states = [row[1] for row in rows if len(row) > 1 and row[1] in ("reference", "registered")]
        self.assertEqual(states, ["reference", "registered"])

    def test_poses_are_transferred(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "poses.png")
            completed = run("transfer_poses.py", "--size", "60", "--feet", "--output", path)
            self.assertEqual((completed.returncode, completed.stderr), (0, ""))
            residuals = [float(value) for value in re.findall(r"TransferResidual (\S+)", completed.stdout)]
            self.assertEqual(len(residuals), 4)
            self.assertLess(max(residuals), 0.4)
            self.assertTrue(os.path.isfile(path))

    def test_gallery_shows_each_with_picture_and_command(self):
        with open(os.path.join(EXAMPLES, "README.md"), encoding="utf-8") as file:
            sections = re.split(r"^## ", file.read(), flags=re.MULTILINE)[1:]
        commands = ""
        for section in sections:
            with self.subTest(section.partition("\n")[0]):
                pictures = re.findall(r"^!\[.+\]\((.+)\)$", section, flags=re.MULTILINE)
                self.assertEqual(len(pictures), 1)
                self.assertTrue(os.path.isfile(os.path.join(EXAMPLES, pictures[0])))
                commands += re.search(r"```sh\n(.+?)```", section, flags=re.DOTALL).group(1)
        for script in glob.glob(os.path.join(EXAMPLES, "*.sh")):
            self.assertIn("bash Examples/" + os.path.basename(script), commands)
        for project in os.listdir(os.path.join(EXAMPLES, "Cxx")):
            self.assertIn("-S Examples/Cxx/" + project, commands)
        for script in SCRIPTS:
            self.assertIn("python3 Examples/Python/" + script, commands)


if __name__ == "__main__":
    unittest.main()
