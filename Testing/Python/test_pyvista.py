"""conformalsom.pyvista: PyVista's meshes go in, and surfaces become PyVista's meshes and textures. Skipped where there
is no PyVista."""
import importlib.util
import os
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.vtkIOImage import vtkPNGWriter

import conformalsom as cs
import toy_bear

if importlib.util.find_spec("pyvista") is None:
    print("There is no PyVista")
    sys.exit(125)  # which is CTest's word for skipped here

import pyvista

from conformalsom.pyvista import Conformal, texture_of, to_pyvista

AXES = (1.0, 1.4, 0.8)


def ellipsoid(frequency=12):
    """A closed mesh of one, of PyVista."""
    source = cs.vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    mesh = pyvista.wrap(source.GetOutput())
    mesh.points = mesh.points * AXES
    return mesh.extract_geometry()


def picture():
    rows, columns = np.mgrid[0:64, 0:32].astype(np.uint8)
    return np.stack([columns, rows, np.full_like(rows, 9)], axis=-1)


class TestPyVista(unittest.TestCase):
    def test_takes_meshes(self):
        mesh = ellipsoid()
        points = np.array(mesh.points)
        learned = cs.learn(points, number_of_neurons=400)
        for other in (pyvista.PolyData(points), pyvista.PolyData(points).cast_to_unstructured_grid()):
            np.testing.assert_array_equal(cs.learn(other, number_of_neurons=400).points, learned.points)
        mapped = cs.conformal_map(mesh)
        np.testing.assert_array_equal(mapped.points, mesh.points)
        np.testing.assert_array_equal(mesh.points, points)

    def test_gives_meshes_that_are_copies(self):
        surface = cs.conformal_map(ellipsoid()).paint(picture())
        mesh = to_pyvista(surface)
        self.assertIs(type(mesh), pyvista.PolyData)
        self.assertEqual((mesh.n_open_edges, mesh.is_manifold), (0, True))
        np.testing.assert_array_equal(mesh.points, surface.points)
        np.testing.assert_array_equal(mesh["SpherePosition"], surface.sphere)
        self.assertEqual(mesh.active_texture_coordinates.shape, (mesh.n_points, 2))
        before = surface.points.copy()
        mesh.points += 1.0
        np.testing.assert_array_equal(surface.points, before)
        np.testing.assert_array_equal(texture_of(surface).to_array(), picture())
        with self.assertRaisesRegex(ValueError, "no picture"):
            texture_of(cs.conformal_map(ellipsoid()))

    def test_the_accessor_calls_the_functions(self):
        mesh = ellipsoid()
        accessor = mesh.conformal if hasattr(pyvista, "register_dataset_accessor") else Conformal(mesh)
        learned = accessor.learn(number_of_neurons=400)
        np.testing.assert_array_equal(learned.points, cs.learn(mesh, number_of_neurons=400).points)
        np.testing.assert_array_equal(accessor.conformal_map().points, mesh.points)
        self.assertEqual(Conformal(learned).smooth(1002, sampling="Directions").n_points, 1002)

    def test_the_example_draws(self):
        with tempfile.TemporaryDirectory() as folder:
            ellipsoid().save(os.path.join(folder, "scan.ply"))
            red = np.full((8, 8, 3), (250, 20, 20), np.uint8)
            png = vtkPNGWriter()
            png.SetInputData(pyvista.Texture(red).to_image())
            png.SetFileName(os.path.join(folder, "red.png"))
            png.Write()
            script = os.path.join(os.path.dirname(os.path.abspath(toy_bear.__file__)), "pyvista_quickstart.py")
            done = subprocess.run([sys.executable, script, "scan.ply", "red.png", "drawn.png"], cwd=folder, text=True,
                                  stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, r"[0-9,]{5,} triangles learned")
            drawn = np.asarray(pyvista.read_texture(os.path.join(folder, "drawn.png")).to_array()).astype(int)
            red = (drawn[:, :, 0] > 100) & (drawn[:, :, 1] < 60)
            self.assertEqual(red[:, :800].sum(), 0)
            self.assertGreater(red[:, 800:].sum(), 10000)


if __name__ == "__main__":
    unittest.main()
