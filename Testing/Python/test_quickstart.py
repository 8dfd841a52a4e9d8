"""quickstart.py: every file it promises is there and can be read back; its own picture is that of
the README."""
import os
import subprocess
import sys
import tempfile
import unittest

from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import builtin_figure
import textures
from baselines import expect_picture

PROGRAM = os.path.join(os.path.dirname(os.path.abspath(builtin_figure.__file__)), "quickstart.py")
TRIANGLES = 20 * 16**2


def quickstart(folder, *arguments):
    """Run the program as a user would, from the folder."""
    return subprocess.run([sys.executable, PROGRAM, *arguments], cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)


def read(reader, *path):
    reader.SetFileName(os.path.join(*path))
    reader.Update()
    return reader.GetOutput()


class TestQuickstart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory(prefix="quick start ")
        cls.folder = cls.temporary.name
        scan = vtkXMLPolyDataWriter()
        scan.SetInputData(builtin_figure.figure_cloud(4000))
        scan.SetFileName(os.path.join(cls.folder, "my scan.vtp"))
        scan.Write()
        picture = vtkPNGWriter()
        picture.SetInputData(textures.checkerboard(128))
        picture.SetFileName(os.path.join(cls.folder, "my picture.png"))
        picture.Write()
        cls.completed = quickstart(cls.folder, "my scan.vtp", "my picture.png", "--output", "out",
                             "--frequency", "8", "--surface-frequency", "16")
        cls.output = os.path.join(cls.folder, "out")

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_ends_well_and_quietly(self):
        self.assertEqual((self.completed.returncode, self.completed.stderr), (0, ""))

    def test_prints_a_line_a_step_and_the_table(self):
        for text in ("Read the scan", "Learn the mesh", "Build the smooth surface", "Lay the texture",
                     "p2s", "nv", "s2p", "angle", "4,000", "642", "2,562"):
            with self.subTest(text):
                self.assertIn(text, self.completed.stdout)

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
        self.assertGreater(surface.GetNumberOfPolys(), TRIANGLES)  # cut along the picture
        self.assertIsNotNone(surface.GetPointData().GetTCoords())
        with open(os.path.join(self.output, "surface.mtl"), encoding="ascii") as file:
            names = [line.split(None, 1)[1].strip() for line in file if line.startswith("map_Kd")]
        self.assertEqual(len(names), 1)
        picture = read(vtkPNGReader(), self.output, names[0])
        self.assertEqual(picture.GetDimensions(), (128, 128, 1))

    def test_glb_is_read_by_another_reader(self):
        scene = read(vtkGLTFReader(), self.output, "surface.glb")
        iterator = scene.NewIterator()
        iterator.InitTraversal()
        surface = iterator.GetCurrentDataObject()
        self.assertGreater(surface.GetNumberOfCells(), TRIANGLES)  # cut along the picture
        self.assertIsNotNone(surface.GetPointData().GetTCoords())

    def test_picture_shows_four_views(self):
        picture = read(vtkPNGReader(), self.output, "quickstart.png")
        self.assertEqual(picture.GetDimensions(), (1600, 500, 1))

    def test_failures_end_with_a_message_and_status_1(self):
        with open(os.path.join(self.folder, "broken.ply"), "w", encoding="ascii") as file:
            file.write("ply\nformat ascii 1.0\nelement vertex 5\n")
        for arguments, message in ((("missing.ply",), "missing.ply: no such file"),
                                   (("scan.doc",), "expected a file of type"),
                                   (("broken.ply",), "Read the scan")):
            with self.subTest(arguments):
                run = quickstart(self.folder, *arguments, "--output", "failed")
                self.assertEqual(run.returncode, 1)
                self.assertIn(message, run.stderr)
                self.assertNotIn("Traceback", run.stderr)

    def test_picture_of_the_readme_is_what_it_draws(self):
        run = quickstart(self.folder, "--output", "own scan")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        picture = vtkPNGReader()
        picture.SetFileName(os.path.join(self.folder, "own scan", "quickstart.png"))
        expect_picture(self, picture, "Quickstart")


if __name__ == "__main__":
    if not os.environ.get("DISPLAY"):
        print("The quickstart draws: run ctest under xvfb-run")
        sys.exit(125)
    unittest.main()
