"""conformalsom.pyvista: PyVista's meshes and arrays go in and come out, properties are keywords, and what goes
wrong is an exception. Skipped where there is no PyVista."""
import importlib.util
import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGWriter

import conformalsom
import toy_bear

if importlib.util.find_spec("pyvista") is None:
    print("There is no PyVista")
    sys.exit(125)  # which is CTest's word for skipped here

import pyvista

from conformalsom.messages import FilterFailed
from conformalsom.pyvista import conformal_map, learn, paint, run, smooth

AXES = (1.0, 1.4, 0.8)
SMALL = {"number_of_neurons": 400}


def ellipsoid(frequency=12):
    """A closed mesh of one."""
    mesh = run(conformalsom.vtkGeodesicSphereSource(), frequency=frequency)
    mesh.points = mesh.points * AXES
    return mesh.extract_geometry()


def write_png(pixels, path):
    writer = vtkPNGWriter()
    writer.SetInputData(pyvista.Texture(pixels).to_image())
    writer.SetFileName(path)
    writer.Write()


def off_surface(mesh):
    """How far its points lie from the ellipsoid, of the radius there."""
    return np.abs(np.linalg.norm(mesh.points / AXES, axis=1) - 1.0).max()


class TestPyVista(unittest.TestCase):
    def expect_mapped(self, mesh, number_of_points):
        self.assertIs(type(mesh), pyvista.PolyData)
        self.assertEqual(mesh.n_points, number_of_points)
        self.assertTrue(mesh.is_all_triangles)
        self.assertEqual((mesh.n_open_edges, mesh.is_manifold), (0, True))
        np.testing.assert_allclose(np.linalg.norm(mesh["SpherePosition"], axis=1), 1.0, atol=1e-12)

    def test_learns_from_meshes_and_arrays(self):
        cloud = ellipsoid()
        points = np.array(cloud.points)
        of_array = learn(points, **SMALL)
        of_list = learn(points.tolist(), **SMALL)
        of_cloud = learn(pyvista.PolyData(points), **SMALL)
        of_grid = learn(pyvista.PolyData(points).cast_to_unstructured_grid(), **SMALL)
        self.expect_mapped(of_array, 400)
        self.assertLess(off_surface(of_array), 0.05)
        for mesh in of_list, of_cloud, of_grid:
            np.testing.assert_array_equal(mesh.points, of_array.points)
        np.testing.assert_array_equal(cloud.points, points)

    def test_is_what_the_filter_makes(self):
        cloud, network = ellipsoid(), conformalsom.vtkConformalSOM()
        network.SetNumberOfNeurons(300)
        network.SetStartingShapeToSphere()
        network.SetInputData(cloud)
        network.Update()
        mesh = learn(cloud, number_of_neurons=300, starting_shape="Sphere")
        np.testing.assert_array_equal(mesh.points, vtk_to_numpy(network.GetOutput().GetPoints().GetData()))

    def test_smooths_and_maps(self):
        mesh = ellipsoid()
        surface = smooth(mesh, frequency=20, sampling="Directions", vertex_shift=0)
        self.expect_mapped(surface, 10 * 20**2 + 2)
        self.assertLess(off_surface(surface), 0.01)
        mapped = conformal_map(mesh)
        self.expect_mapped(mapped, mesh.n_points)
        measured = run(conformalsom.vtkConformalDistortion(), mapped)
        self.assertEqual(measured.field_data["NumberOfFlippedTriangles"][0], 0)
        self.assertLess(measured.field_data["MeanAngleDistortion"][0], 2.0)

    def test_paints_from_arrays_textures_and_files(self):
        surface = conformal_map(ellipsoid())
        rows, columns = np.mgrid[0:256, 0:256].astype(np.uint8)
        image = np.stack([columns, rows, np.full_like(rows, 9)], axis=-1)
        painted = paint(surface, image, field_of_view=200.0)
        u, v = np.array(painted.active_texture_coordinates, dtype=float).T
        expected = np.clip(np.stack([256 * u - 0.5, 256 * (1 - v) - 0.5, np.full_like(u, 9)], axis=-1), 0, 255)
        expected[:, 2] = 9
        self.assertEqual((painted["RGB"].dtype, painted.active_scalars_name), (np.uint8, "RGB"))
        self.assertLess(np.abs(painted["RGB"] - expected).max(), 0.51)
        self.assertGreater(np.ptp(painted["RGB"], axis=0)[:2].min(), 200)
        np.testing.assert_array_equal(painted.points, surface.points)
        front = painted["RGB"][np.argmax(painted["SpherePosition"] @ (0, 0, 1))].astype(int)
        self.assertLess(np.abs(front[:2] - 127).max(), 12)  # the image's middle looks along +z
        top = painted["RGB"][np.argmax(painted["SpherePosition"] @ (0, 1, 1))].astype(int)
        self.assertLess(top[1], front[1] - 40)  # and its first row is on top
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "image.png")
            write_png(image, path)
            for other in (path, pyvista.Texture(image), pyvista.read_texture(path)):
                np.testing.assert_array_equal(paint(surface, other, field_of_view=200.0)["RGB"], painted["RGB"])
        transparent = np.concatenate([image, image[:, :, :1]], axis=-1)
        self.assertEqual(paint(surface, transparent)["RGBA"].shape, (surface.n_points, 4))

    def test_every_kind_of_filter_takes_and_gives_its_data(self):
        mapped = conformal_map(ellipsoid())
        for name, inputs in (("GenusZeroCheck", 1), ("GenusZeroHull", 1), ("BodyMap", 1), ("SurfaceMismatch", 2),
                             ("SphericalAlignment", 2), ("SurfaceHarmonics", 1), ("SphericalMorph", 2)):
            with self.subTest(name):
                result = run(getattr(conformalsom, "vtk" + name)(), *([mapped] * inputs))
                self.assertIs(type(result), pyvista.PolyData)
                self.assertGreater(result.n_points, 0)

    def test_an_error_is_an_exception_with_the_filters_message(self):
        with self.assertRaisesRegex(FilterFailed, "^vtkGlobalConformalMap: .*boundar"):
            conformal_map(pyvista.Plane().triangulate())
        with self.assertRaisesRegex(FilterFailed, "^vtkCurvedSeamlessSurface: .*SpherePosition"):
            smooth(pyvista.Sphere().clean())
        with self.assertRaisesRegex(FilterFailed, "ViewUp must not be parallel"):
            paint(conformal_map(ellipsoid()), np.zeros((2, 2, 3), np.uint8), view_direction=(0, 1, 0))

    def test_a_warning_is_one_of_pythons(self):
        flat = np.random.RandomState(1).random_sample((500, 3)) * (1, 1, 0)
        with self.assertWarnsRegex(UserWarning, "vtkConformalSOM: the points are coplanar"):
            learn(flat, number_of_neurons=162)

    def test_what_makes_no_sense_is_refused(self):
        for wrong in (np.zeros((5, 2)), np.zeros(6), [[1.0, 2.0]]):
            with self.assertRaisesRegex(ValueError, "expected points as an array of n x 3"):
                learn(wrong)
        with self.assertRaisesRegex(TypeError, "vtkConformalSOM has no property neurons"):
            learn(np.zeros((5, 3)), neurons=3)
        with self.assertRaisesRegex(ValueError, "expected an image"):
            paint(conformal_map(ellipsoid()), np.zeros((4, 4)))

        with self.assertRaisesRegex(ValueError, "lattice is geodesic, but must be one of .*Geodesic"):
            learn(ellipsoid(), mesh_type="geodesic")
        blocks = pyvista.MultiBlock([conformal_map(ellipsoid())])
        for several in (blocks, None, "scan.ply"):
            for function in (smooth, conformal_map, lambda mesh: paint(mesh, np.zeros((2, 2, 3), np.uint8))):
                with self.assertRaisesRegex(TypeError, "expected a mesh of PyVista, not "):
                    function(several)
        for nothing in (None, "scan.ply", pyvista.MultiBlock()):
            with self.assertRaisesRegex(TypeError, "expected a data set of PyVista or an array"):
                learn(nothing)
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "short.png")
            write_png(np.zeros((40, 40, 3), np.uint8), path)
            with open(path, "r+b") as file:
                file.truncate(60)
            with self.assertRaisesRegex(ValueError, "the picture is broken"):
                paint(smooth(learn(ellipsoid(), **SMALL)), path)
            rows = zlib.compress(b"\7" * 28)  # a filter that there is not, with right checksums
            with open(path, "wb") as file:
                file.write(b"\x89PNG\r\n\x1a\n" + b"".join(
                    struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
                    for kind, data in ((b"IHDR", struct.pack(">IIBBBBB", 2, 4, 8, 2, 0, 0, 0)), (b"IDAT", rows),
                                       (b"IEND", b""))))
            with self.assertRaisesRegex(ValueError, "the picture is broken: bad adaptive filter value"):
                paint(conformal_map(ellipsoid()), path)

    def test_the_example_draws(self):
        with tempfile.TemporaryDirectory() as folder:
            ellipsoid().save(os.path.join(folder, "scan.ply"))
            write_png(np.full((8, 8, 3), (250, 20, 20), np.uint8), os.path.join(folder, "red.png"))
            script = os.path.join(os.path.dirname(os.path.abspath(toy_bear.__file__)), "pyvista_quickstart.py")
            done = subprocess.run([sys.executable, script, "scan.ply", "red.png", "drawn.png"], cwd=folder, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("25,920 triangles learned", done.stdout)
            drawn = np.asarray(pyvista.read_texture(os.path.join(folder, "drawn.png")).to_array()).astype(int)
            red = (drawn[:, :, 0] > 100) & (drawn[:, :, 1] < 60)
            self.assertEqual(red[:, :800].sum(), 0)
            self.assertGreater(red[:, 800:].sum(), 10000)


if __name__ == "__main__":
    unittest.main()
