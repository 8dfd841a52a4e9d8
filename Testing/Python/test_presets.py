"""Presets of the command: files for the web, for games, and for printers."""
import os
import subprocess
import tempfile
import unittest
import zipfile
from xml.etree import ElementTree

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkSTLReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import conformalsom
import gltf_rules
from helpers import builtin_figure

COMMAND = os.environ["CONFORMALSOM_COMMAND"]
NEURONS = ("--neurons", "642")
CORE = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"


def document_of(path):
    """The JSON document and the binary buffer of a glTF file."""
    with open(path, "rb") as file:
        return gltf_rules.chunks(file.read(), [])


class TestPresets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.temporary.cleanup)
        cls.folder = cls.temporary.name
        cls.scan = builtin_figure.figure_cloud(4000)
        writer = vtkXMLPolyDataWriter()
        writer.SetInputData(cls.scan)
        writer.SetFileName(os.path.join(cls.folder, "scan.vtp"))
        writer.Write()

    def run_command(self, *arguments):
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        return subprocess.run([COMMAND, "scan.vtp", *NEURONS, "--overwrite", *arguments], cwd=self.folder,
                              env=environment, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)

    def made(self, name, *arguments):
        """The path of a file that the command makes."""
        run = self.run_command(*arguments, "-o", name)
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        return os.path.join(self.folder, name)

    def test_game_has_levels_with_one_picture(self):
        document, binary = document_of(self.made("game.glb", "--preset", "game"))
        self.assertNotIn("extensionsRequired", document)
        self.assertEqual(document["nodes"][0]["extensions"]["MSFT_lod"]["ids"], [1, 2])
        self.assertIn("normalTexture", document["materials"][0])
        levels = []
        for mesh in document["meshes"]:
            attributes = mesh["primitives"][0]["attributes"]
            levels.append([gltf_rules.accessor_values(document, binary, attributes[name], [])
                           for name in ("POSITION", "TEXCOORD_0")])
        numbers = [len(points) for points, _ in levels]
        self.assertLess(abs(numbers[0] - 8000), 160)
        self.assertLess(abs(numbers[1] - 2000), 40)
        self.assertLess(numbers[2], 1000)  # the fewest points, and those that are duplicated where the picture is cut
        points, coordinates = levels[0]
        for others, placed in levels[1:]:
            nearest = np.array([((points - other) ** 2).sum(axis=1).argmin() for other in others])
            apart = np.abs(coordinates[nearest] - placed).max(axis=1)  # at seams, another copy can be nearest
            self.assertLess(np.median(apart), 0.01)

    def test_web_is_small_and_has_its_details(self):
        path = self.made("web.glb", "--preset", "web")
        document, _ = document_of(path)
        self.assertIn("normalTexture", document["materials"][0])
        self.assertIn("KHR_mesh_quantization", document["extensionsRequired"])
        points = document["accessors"][document["meshes"][0]["primitives"][0]["attributes"]["POSITION"]]["count"]
        self.assertLess(abs(points - 10000), 200)
        self.assertLess(os.path.getsize(path), 500000 if conformalsom.vtkTexturedSurfaceWriter.GetHasMeshopt() else 700000)

    def test_given_options_count_more_than_the_preset(self):
        document, _ = document_of(self.made("few.glb", "--preset", "game", "--points", "3000", "--levels", "1"))
        self.assertEqual(len(document["meshes"]), 1)
        self.assertLess(abs(document["accessors"][0]["count"] - 3000), 60)

    def test_note_states_why_there_are_more_points(self):
        """A surface of 500 points, the smallest, becomes one of more where the picture is cut."""
        run = self.run_command("--normal-map", "--points", "500", "-o", "small.glb")
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stderr, r"^conformalsom: scan.vtp: note: --points: the surface has \d{3} points instead of "
                                     "500, since the cut of the picture adds points\n$")

    def test_print_is_closed_and_in_millimeters(self):
        path = self.made("toy.3mf", "--preset", "print", "--unit", "cm", "-o", "toy.stl")
        with zipfile.ZipFile(path) as file:
            self.assertEqual(file.testzip(), None)
            model = ElementTree.fromstring(file.read("3D/3dmodel.model"))
            self.assertIn(b'Target="/3D/3dmodel.model"', file.read("_rels/.rels"))
        self.assertEqual(model.get("unit"), "millimeter")
        points = np.array([[float(vertex.get(name)) for name in "xyz"] for vertex in model.iter(CORE + "vertex")])
        triangles = np.array([[int(triangle.get(name)) for name in ("v1", "v2", "v3")]
                              for triangle in model.iter(CORE + "triangle")])
        edges = np.concatenate([triangles[:, (0, 1)], triangles[:, (1, 2)], triangles[:, (2, 0)]])
        keys = {tuple(edge) for edge in edges.tolist()}
        self.assertEqual(len(keys), len(edges))  # each edge once in each direction
        self.assertTrue(all((b, a) in keys for a, b in keys))
        self.assertEqual(len(points) - len(edges) // 2 + len(triangles), 2)
        a, b, c = points[triangles].transpose(1, 0, 2)
        self.assertGreater((a * np.cross(b, c)).sum(), 0.0)  # outward
        scan = vtk_to_numpy(self.scan.GetPoints().GetData())
        np.testing.assert_allclose(np.ptp(points, axis=0), 10.0 * np.ptp(scan, axis=0), rtol=0.05)
        reader = vtkSTLReader()
        reader.SetFileName(os.path.join(self.folder, "toy.stl"))
        reader.Update()
        np.testing.assert_allclose(
            np.ptp(np.array(reader.GetOutput().GetBounds()).reshape(3, 2), axis=1), np.ptp(points, axis=0), rtol=1e-5)
        with open(path, "rb") as file:
            before = file.read()
        self.made("toy.3mf", "--preset", "print", "--unit", "cm")
        with open(path, "rb") as file:
            self.assertEqual(file.read(), before)

    def test_print_closes_a_scan_from_one_side(self):
        points = vtk_to_numpy(self.scan.GetPoints().GetData())
        np.savetxt(os.path.join(self.folder, "front.xyz"), points[points[:, 2] > np.median(points[:, 2])])
        for name, *arguments in (("open.3mf",), ("closed.3mf", "--preset", "print", "--unit", "m")):
            run = subprocess.run([COMMAND, "front.xyz", *NEURONS, *arguments, "-o", name], cwd=self.folder, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertEqual("cannot be printed as a solid; use --closed" in run.stderr, name == "open.3mf")
            self.assertEqual("To close the surface, use --closed" in run.stderr, name == "open.3mf")
            with zipfile.ZipFile(os.path.join(self.folder, name)) as file:
                model = ElementTree.fromstring(file.read("3D/3dmodel.model"))
            edges = {(triangle.get(a), triangle.get(b)) for triangle in model.iter(CORE + "triangle")
                     for a, b in (("v1", "v2"), ("v2", "v3"), ("v3", "v1"))}
            self.assertEqual(all((b, a) in edges for a, b in edges), name == "closed.3mf")

    def test_a_folder_gets_files_for_the_purpose(self):
        os.makedirs(os.path.join(self.folder, "toys"), exist_ok=True)
        self.made("toys", "--preset", "print", "--unit", "mm", "--points", "1000")
        self.assertEqual(os.listdir(os.path.join(self.folder, "toys")), ["scan.3mf"])

    def test_help_says_what_levels_need_and_have(self):
        text = " ".join(self.run_command("--help").stdout.split())
        levels = text.partition("--levels N number")[2].partition("--unit")[0]
        self.assertIn("with --points N", levels)
        self.assertIn("at least 500 and those that are duplicated", levels)
        self.assertIn("game (8,000, 2,000 and 500 to 1,000 points", text)

    def test_options_that_contradict_each_other_are_refused(self):
        for message, *arguments in (
                ("--unit", "--preset", "print", "-o", "toy.stl"),
                ("closed surfaces", "--preset", "print", "--unit", "mm", "--open", "-o", "toy.stl"),
                (".3mf .stl", "--preset", "print", "--unit", "mm", "-o", "toy.glb"),
                ("--points: invalid integer value: '1e3'", "--points", "1e3", "-o", "surface.glb"),
                ("--jobs: invalid integer value: 'x'", "--jobs", "x", "-o", "surface.glb"),
                ("--points", "--normal-map", "-o", "surface.glb"),
                ("--points", "--levels", "2", "-o", "surface.glb"),
                (".glb only", "--normal-map", "--points", "1000", "-o", "surface.ply"),
                ("fewer than 500", "--levels", "3", "--points", "5000", "-o", "surface.glb"),
                ("--texture", "--normal-map", "--points", "1000", "--texture", "no.png", "-o", "surface.glb")):
            with self.subTest(" ".join(arguments)):
                run = self.run_command(*arguments)
                self.assertEqual((run.returncode, run.stdout), (2, ""))
                self.assertIn(message, run.stderr.splitlines()[-1])


if __name__ == "__main__":
    unittest.main()
