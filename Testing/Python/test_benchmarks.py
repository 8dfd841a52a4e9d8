"""The clouds with errors of scanners, and the measures, that the benchmarks use."""
import os
import sys
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

from conformalsom import vtkGeodesicSphereSource
from helpers import depth_camera
from helpers.clouds import points_of, vtk_points

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Benchmarks"))
import compare_smoothing  # pylint: disable=wrong-import-position
import scanner_noise  # pylint: disable=wrong-import-position
from curvature_error import Curvature  # pylint: disable=wrong-import-position
from known_objects import facet_normals, mismatch, rms, triangles_of  # pylint: disable=wrong-import-position


def sphere(frequency):
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    return source.GetOutput()


def scanned(noise):
    surface = sphere(20)
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    normals, _ = facet_normals(points_of(surface), triangles_of(surface))
    return depth_camera.scanned(locator, normals, 1000, noise, np.random.default_rng(1))


class TestBenchmarks(unittest.TestCase):
    def test_a_depth_camera_without_noise_returns_positions_on_the_object(self):
        points, exact, normals = scanned(0.0)
        self.assertEqual(len(points), 1000)
        self.assertLess(np.abs(points - exact).max(), 1e-12)
        self.assertLess(np.abs(np.linalg.norm(points, axis=1) - 1.0).max(), 5e-3)  # facets are inside of the sphere
        self.assertGreater((points * normals).sum(axis=1).min(), 0.9)

    def test_the_depths_of_a_camera_are_quantized(self):
        noise = 0.02
        points, exact, _ = scanned(noise)
        self.assertGreater(rms(np.linalg.norm(points - exact, axis=1)), 0.5 * noise)
        misses = [np.abs(steps - np.round(steps)) for steps in (
            depth_camera.DISTANCE**2 / (2.0 * noise * (depth_camera.DISTANCE - points @ view))
            for view in depth_camera.directions())]
        self.assertLess(np.min(misses, axis=0).max(), 1e-6)

    def test_errors_have_the_size_that_they_are_given(self):
        random = np.random.default_rng(2)
        x = random.standard_normal((20000, 3))
        x /= np.linalg.norm(x, axis=1)[:, None]
        for name, expected in (("gaussian", 1.0), ("view", 0.715), ("outliers", 0.715), ("passes", 0.82)):
            with self.subTest(name):
                points, inside = scanner_noise.NOISES[name](x, x, 0.01, random)
                error = rms(((points - x) * x).sum(axis=1)[inside])
                self.assertLess(abs(error - 0.01 * expected), 0.0015)
                self.assertEqual((~inside).sum(), 200 if name == "outliers" else 0)

    def test_the_curvature_of_a_sphere_is_exact(self):
        surface = sphere(20)
        surface.SetPoints(vtk_points(2.0 * points_of(surface)))
        curvature = Curvature(surface, 0.3).closest(points_of(surface)[::40])
        self.assertLess(np.abs(curvature - 0.5).max(), 5e-3)

    def test_rivals_remove_noise_from_a_mesh(self):
        truth, noisy = sphere(60), sphere(20)
        noisy.SetPoints(vtk_points(points_of(noisy) * (
            1.0 + 0.01 * np.random.default_rng(3).standard_normal((noisy.GetNumberOfPoints(), 1)))))
        before = mismatch(noisy, truth)[2]
        for method in (compare_smoothing.loop, compare_smoothing.taubin, compare_smoothing.bilateral):
            with self.subTest(method.__name__):
                self.assertLess(mismatch(method(noisy), truth)[2], 0.8 * before)


if __name__ == "__main__":
    unittest.main()
