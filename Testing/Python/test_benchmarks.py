"""The clouds with errors of scanners, and the measures, that the benchmarks use."""
import os
import subprocess
import sys
import time
import unittest

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

import conformalsom
from conformalsom import vtkGeodesicSphereSource
from helpers import bodies, depth_camera, poses
from helpers.clouds import points_of, vtk_points

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Benchmarks"))
import chart_methods  # pylint: disable=wrong-import-position
import compare_smoothing  # pylint: disable=wrong-import-position
import harmonics_methods  # pylint: disable=wrong-import-position
import map_methods  # pylint: disable=wrong-import-position
import measure_poses  # pylint: disable=wrong-import-position
import measure_time_series  # pylint: disable=wrong-import-position
import scanner_noise  # pylint: disable=wrong-import-position
from curvature_error import Curvature  # pylint: disable=wrong-import-position
from known_objects import facet_normals, mismatch, rms, triangles_of  # pylint: disable=wrong-import-position
from planar_distortion import planar_distortion, stretch  # pylint: disable=wrong-import-position
from separate_process import measured, rounded  # pylint: disable=wrong-import-position


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

    def test_poses_are_those_of_the_skeleton(self):
        body = bodies.animal(np.random.default_rng(1), 0.0)
        paw = body.cones[poses.LEGS["front left"] + 2][1]
        hip = body.cones[poses.LEGS["front left"]][0]
        points = np.array([paw, hip - [0.0, 0.0, 0.01], body.cones[poses.LOIN][0]])
        np.testing.assert_allclose(poses.posed(points, body, poses.POSES["stride"], 0.0), points, atol=1e-12)
        moved = poses.posed(points, body, poses.bent("front left", np.pi / 2))
        expected = hip + (paw - hip) @ poses.rotation(poses.Y, np.pi / 2).T
        knee = poses.posed(points, body, {poses.LEGS["front left"]: (poses.Y, np.pi / 2)})
        self.assertLess(np.linalg.norm(knee[0] - expected), 0.02)
        np.testing.assert_allclose(moved[2], points[2], atol=0.02)
        with self.assertRaises(ValueError):
            poses.posed(points, bodies.head(np.random.default_rng(1), 0.0), {})

    def test_folds_and_crossings_are_counted(self):
        surface = sphere(6)
        points, triangles = points_of(surface).astype(float), triangles_of(surface)
        self.assertEqual(measure_poses.folds_of(points, triangles), 0)
        self.assertEqual(measure_poses.crossings_of(points, triangles), 0)
        self.assertLess(measure_poses.distance(points @ poses.rotation(poses.Z, 0.4).T + 3.0, points, np.ones(len(points))),
                        1e-12)
        points[0] *= -1.5  # through the other side
        self.assertGreater(measure_poses.folds_of(points, triangles), 4)
        self.assertGreater(measure_poses.crossings_of(points, triangles), 4)

    def test_rivals_remove_noise_from_a_mesh(self):
        truth, noisy = sphere(60), sphere(20)
        noisy.SetPoints(vtk_points(points_of(noisy) * (
            1.0 + 0.01 * np.random.default_rng(3).standard_normal((noisy.GetNumberOfPoints(), 1)))))
        before = mismatch(noisy, truth)[2]
        for method in (compare_smoothing.loop, compare_smoothing.taubin, compare_smoothing.bilateral):
            with self.subTest(method.__name__):
                self.assertLess(mismatch(method(noisy), truth)[2], 0.8 * before)

    def test_a_process_has_its_own_time_and_memory(self):
        result, seconds, memory = measured("numpy", np.ones, 2**24)  # 128 MB
        self.assertEqual(result.sum(), 2**24)
        self.assertLess(abs(memory - 128.0), 32.0)
        self.assertLess(seconds, 10.0)
        with self.assertRaisesRegex(RuntimeError, "ZeroDivisionError"):
            measured("operator", divmod, 1, 0)
        with self.assertRaisesRegex(RuntimeError, "no result after 1 s"):
            measured("time", time.sleep, 60, limit=1)

    def test_the_comparison_prints_a_row_for_each_method(self):
        script = os.path.join(os.path.dirname(compare_smoothing.__file__), "compare_reconstructions.py")
        completed = subprocess.run(
            [sys.executable, script, "--objects", "sphere", "--kinds", "gaussian", "--noise", ".01", "--points", "2000",
             "--methods", "ConformalSOM"], text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        self.assertEqual(completed.returncode, 0, completed.stderr)
        rows = [[cell.strip() for cell in line.split("|")[1:-1]]
                for line in completed.stdout.splitlines() if line.startswith("| sphere")]
        self.assertEqual([row[3] for row in rows], ["ConformalSOM, learn", "ConformalSOM, learn and smooth"])
        for row in rows:
            self.assertLess(float(row[6]), 0.01)  # closer to the sphere than the points
            self.assertEqual(row[10:12], ["1", "0"])

    def test_numbers_have_three_digits(self):
        self.assertEqual([rounded(value) for value in (0.0, 0.00123456, 0.123456, 1.5, 12.3456, 123.456, 12345.6)],
                         ["0.00", "1.23e-3", "0.123", "1.50", "12.3", "123", "12,346"])

    def test_the_distortion_of_a_known_map_to_the_plane_is_exact(self):
        u, v = (grid.ravel() for grid in np.meshgrid(np.arange(4.0), np.arange(4.0)))
        corner = np.array([4 * i + j for i in range(3) for j in range(3)])
        triangles = np.concatenate([np.column_stack([corner, corner + 1, corner + 5]),
                                    np.column_stack([corner, corner + 5, corner + 4])])
        turned = np.linalg.qr(np.random.default_rng(4).standard_normal((3, 3)))[0]
        x = np.column_stack([u, v, 0.0 * u]) @ turned
        k, angles, areas, flipped = planar_distortion(x, triangles, np.column_stack([-3.0 * u, 1.5 * v]))
        self.assertAlmostEqual(k, 2.0, 9)
        self.assertAlmostEqual(areas, 0.0, 9)
        self.assertAlmostEqual(angles, (np.degrees(np.arctan(2.0)) - 45.0) * 2.0 / 3.0, 6)
        self.assertEqual(flipped, 0)
        moved = np.column_stack([u, v])
        moved[5] += 1.5
        self.assertEqual(planar_distortion(x, triangles, moved)[3], 2)

    def test_the_stretch_of_a_known_map_to_the_plane_is_exact(self):
        """Twice as long in one direction: sqrt((2 + 1 / 2) / 2) after areas are equal, at most sqrt(2)."""
        u, v = (grid.ravel() for grid in np.meshgrid(np.arange(4.0), np.arange(4.0)))
        triangles = np.array([[0, 1, 5], [0, 5, 4], [5, 6, 10], [6, 11, 10]])
        x = np.column_stack([u, v, 0.0 * u])
        for plane, expected in ((np.column_stack([7.0 * v, -7.0 * u]), (1.0, 1.0)),
                                (np.column_stack([2.0 * u, v]), (np.sqrt(1.25), np.sqrt(2.0)))):
            np.testing.assert_allclose(stretch(x, triangles, plane), expected, rtol=1e-12)

    def test_places_of_a_time_step_are_where_the_map_leads(self):
        surface = sphere(20)
        x = points_of(surface)
        step = measure_time_series.Step(surface, x)
        directions = 0.9 * x[::97] + 0.1 * x[1::97][:len(x[::97])]
        found = step.places(directions)
        cosines = (found * directions).sum(axis=1) / np.linalg.norm(found, axis=1) / np.linalg.norm(directions, axis=1)
        self.assertGreater(cosines.min(), 1.0 - 1e-12)
        normal, along = step.errors(1.01 * x[::97], x[::97])
        self.assertLess(np.abs(normal - 1.0 / step.size).max(), 2e-3)
        self.assertLess(along.max(), 0.1)

    def test_an_image_of_the_sphere_is_one_chart(self):
        surface = sphere(20)
        x, triangles = points_of(surface), triangles_of(surface)
        points, cut, texture, _ = chart_methods.sphere_charts(x, triangles, 0.0, "Octahedral")
        joined, corners, _ = chart_methods.welded(points, cut, texture)
        charts = chart_methods.charts_of(joined, corners)
        self.assertEqual(charts.max(), 0)
        self.assertEqual(planar_distortion(points, cut, texture, charts)[3], 0)
        self.assertLess(abs(chart_methods.seams(joined, corners) - 2.0 * np.pi), 0.2)  # four quarters of great circles

    def test_sums_of_harmonics_are_those_of_the_filter(self):
        mapped = conformalsom.Surface(sphere(20))
        x = mapped.points * (1.0, 0.7, 0.5) + 0.1 * np.cos(3.0 * mapped.points[:, [1, 2, 0]])
        coefficients, rebuilt = conformalsom.Surface(
            map_methods.mapped(x, mapped.faces, mapped.sphere)).harmonics(9)
        self.assertLess(np.abs(harmonics_methods.sums(coefficients, mapped.sphere) - rebuilt.points).max(), 1e-12)

    def test_a_stereographic_projection_keeps_a_conformal_map(self):
        plane = np.random.default_rng(5).standard_normal((1000, 2))
        found = map_methods.stereographic(plane)
        self.assertLess(np.abs(np.linalg.norm(found, axis=1) - 1.0).max(), 1e-12)
        self.assertEqual((found[:, 2] > 0.0).sum(), 500)


if __name__ == "__main__":
    unittest.main()
