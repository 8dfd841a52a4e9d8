"""quickstart.py: every file it promises is there and can be read back; its own picture is that of
the README."""
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOGeometry import vtkGLTFReader, vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGReader, vtkPNGWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter

import conformalsom
import quickstart as program
from baselines import expect_picture, require_display
from helpers import builtin_figure, scan_files, textures

TRIANGLES = 20 * 16**2
with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Systems", "figures.txt"),
          encoding="ascii") as file:
    FIGURES = file.read().splitlines()  # which Testing/Systems/run.sh wants from every system
COARSE = ("--frequency", "4", "--surface-frequency", "8")


def quickstart(folder, *arguments):
    """Run the program as a user would, from the folder."""
    return subprocess.run([sys.executable, program.__file__, *arguments], cwd=folder, text=True,
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
        with open(os.path.join(self.folder, "scan.doc"), "w", encoding="ascii") as file:
            file.write("no scan\n")
        for arguments, message in ((("missing.ply",), "missing.ply: no such file"),
                                   (("scan.doc",), "expected a file of type .off .ply"),
                                   (("broken.ply",), "Read the scan")):
            with self.subTest(arguments):
                run = quickstart(self.folder, *arguments, "--output", "failed")
                self.assertEqual(run.returncode, 1)
                self.assertIn(message, run.stderr)
                self.assertNotIn("Traceback", run.stderr)

    def test_replaces_nothing_unasked(self):
        path = os.path.join(self.folder, "surface.obj")
        for arguments, message in (((), "surface.obj already exists"),
                                   (("surface.obj", "--overwrite"), "is an input")):
            with self.subTest(arguments):
                with open(path, "w", encoding="ascii") as file:
                    file.write("v 0 0 0\n")
                run = quickstart(self.folder, *arguments, "--output", ".")
                self.assertEqual(run.returncode, 1)
                self.assertIn(message, run.stderr)
                with open(path, encoding="ascii") as file:
                    self.assertEqual(file.read(), "v 0 0 0\n")

    def test_picture_of_the_readme_is_what_it_draws(self):
        run = quickstart(self.folder, "--output", "own scan")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual([line for line in run.stdout.splitlines() if line.startswith(("learned", "smooth"))],
                         FIGURES)
        picture = vtkPNGReader()
        picture.SetFileName(os.path.join(self.folder, "own scan", "quickstart.png"))
        expect_picture(self, picture, "Quickstart")


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
    VTKS = {"scan.obj": vtkOBJReader, "scan.stl": vtkSTLReader, "scan.vtp": vtkXMLPolyDataReader,
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

    def test_every_reader_of_the_package_is_met(self):
        names = {"vtk" + name + "Reader" for name in self.OURS.values()}
        self.assertEqual(names, {reader.__name__ for reader in scan_files.OUR_READERS})

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
                run = quickstart(self.folder, name, "--output", "of " + name, *COARSE)
                self.assertEqual((run.returncode, run.stderr), (0, ""))
                surface = read(vtkXMLPolyDataReader(), self.folder, "of " + name, "surface.vtp")
                radii = np.linalg.norm(points_of(surface) / (1.0, 1.4, 0.8), axis=1)
                self.assertEqual(len(radii), 10 * 8**2 + 2)
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
            run = quickstart(folder, name, *options, "--output", "out", "--frequency", "8",
                             "--surface-frequency", "24")
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

    def test_given_picture_wins(self):
        scan = cloud_of(egg(20))
        colored(scan, hues(points_of(scan)), scan.GetPointData())
        _, seen = self.paint("scan.ply", conformalsom.vtkConformalPLYWriter(), scan, "gray.png")
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
            run = quickstart(folder, "scan.ply", "--output", "out")
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            picture = vtkPNGReader()
            picture.SetFileName(os.path.join(folder, "out", "quickstart.png"))
            expect_picture(self, picture, "QuickstartColors")


if __name__ == "__main__":
    require_display()
    unittest.main()
