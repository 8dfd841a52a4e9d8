"""The measures against others of the same things: VTK's own locators and plain NumPy."""
import os
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import (
    vtkGenericCell, vtkStaticCellLocator, vtkStaticPointLocator)
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkIOImage import vtkTIFFReader, vtkTIFFWriter

from conformalsom import (
    vtkBodyMap, vtkBodyMapImage, vtkConformalDistortion, vtkGeodesicSphereSource, vtkSurfaceMismatch)
from helpers.world_file import write_world_file


def ellipsoid(frequency, scale, shift=(0, 0, 0)):
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    transform = vtkTransform()
    transform.Translate(shift)
    transform.Scale(scale)
    moved = vtkTransformPolyDataFilter()
    moved.SetInputConnection(source.GetOutputPort())
    moved.SetTransform(transform)
    moved.Update()
    return moved.GetOutput()


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def triangles_of(surface):
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def figure(output, name):
    return output.GetFieldData().GetArray(name).GetValue(0)


def facet_normals(surface):
    points, triangles = points_of(surface), triangles_of(surface)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def distances(queries, surface):
    return closest(queries, surface)[0]


def closest(queries, surface):
    """Distances to the surface, and the triangles that are closest."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    cell, cell_id, part, square, foot = (
        vtkGenericCell(), reference(0), reference(0), reference(0.0), [0.0] * 3)
    result, triangles = [], []
    for query in queries:
        locator.FindClosestPoint(query, foot, cell, cell_id, part, square)
        result.append(float(square) ** 0.5)
        triangles.append(int(cell_id))
    return np.array(result), np.array(triangles)


def nearest_vertices(queries, surface):
    locator = vtkStaticPointLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    ids = [locator.FindClosestPoint(query) for query in queries]
    return np.linalg.norm(queries - points_of(surface)[ids], axis=1)


def area_samples(surface, count):
    """Random positions, and their triangles."""
    points, triangles = points_of(surface), triangles_of(surface)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    random = np.random.default_rng(0)
    chosen = random.choice(len(triangles), count, p=area / area.sum())
    u, v = random.random((2, count, 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    return a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen], chosen


class TestSurfaceMismatch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = ellipsoid(5, (2.05, 2.4, 1.8), (0.06, 0.0, 0.1))
        cls.reference = ellipsoid(14, (2.0, 2.3, 1.9))
        mismatch = vtkSurfaceMismatch()
        mismatch.SetInputData(cls.model)
        mismatch.SetReferenceData(cls.reference)
        mismatch.Update()
        cls.output, cls.reference_output = mismatch.GetOutput(0), mismatch.GetOutput(1)
        cls.unit = figure(cls.output, "LengthUnit")
        cls.forward = distances(points_of(cls.reference), cls.model)
        samples, cls.triangles = area_samples(cls.model, 60000)
        cls.back, cls.feet = closest(samples, cls.reference)

    def test_unit_is_the_largest_radius(self):
        points = points_of(self.reference)
        radius = np.linalg.norm(points - points.mean(0), axis=1).max()
        self.assertAlmostEqual(self.unit, radius, places=12)

    def test_from_points_to_surface(self):
        expected = ((self.forward / self.unit) ** 2).mean()
        self.assertAlmostEqual(
            figure(self.output, "MeanSquarePointToSurface") / expected, 1.0, places=10)
        found = vtk_to_numpy(self.reference_output.GetPointData().GetArray("Distance"))
        np.testing.assert_allclose(found, self.forward, atol=1e-12)

    def test_from_points_to_vertices(self):
        squares = (nearest_vertices(points_of(self.reference), self.model) / self.unit) ** 2
        self.assertAlmostEqual(
            figure(self.output, "MeanSquarePointToVertex") / squares.mean(), 1.0, places=6)

    def test_from_surface_to_points(self):
        squares = (self.back / self.unit) ** 2
        noise = squares.std() / len(squares) ** 0.5
        self.assertLess(
            abs(figure(self.output, "MeanSquareSurfaceToPoint") - squares.mean()), 5 * noise)
        self.assertLess(
            abs(figure(self.output, "WebFraction") - (squares > 4e-4).mean()), 0.01)

    def test_normal_angle(self):
        """Planes of both surfaces at other samples, with VTK's locator."""
        cosines = np.abs(
            (facet_normals(self.model)[self.triangles] * facet_normals(self.reference)[self.feet]).sum(axis=1))
        angles = np.degrees(np.arccos(np.clip(cosines, 0.0, 1.0)))
        expected = np.sqrt((angles ** 2).mean())
        self.assertAlmostEqual(figure(self.output, "RootMeanSquareNormalAngle") / expected, 1.0, delta=0.02)

    def test_hausdorff(self):
        vertices = distances(points_of(self.model), self.reference)
        expected = max(self.forward.max(), self.back.max(), vertices.max()) / self.unit
        self.assertAlmostEqual(figure(self.output, "HausdorffDistance") / expected, 1.0, places=3)


class TestConformalDistortion(unittest.TestCase):
    def test_agrees_with_jacobians(self):
        """K by singular values, areas by cross products, angles by arc cosines."""
        surface = ellipsoid(6, (1.0, 1.6, 0.7))
        distortion = vtkConformalDistortion()
        distortion.SetInputData(surface)
        distortion.Update()
        output = distortion.GetOutput()
        triangles = triangles_of(surface)
        mesh = points_of(surface)[triangles]
        sphere = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))[triangles]

        errors, logs, angles = [], [], []
        for a, b in zip(mesh, sphere):
            sides, images = (np.stack([x[1] - x[0], x[2] - x[0]], 1) for x in (a, b))
            plane = np.linalg.qr(sides)[0]
            image_plane = np.linalg.qr(images)[0]
            jacobian = (image_plane.T @ images) @ np.linalg.inv(plane.T @ sides)
            values = np.linalg.svd(jacobian, compute_uv=False)
            errors.append(values[0] / values[1])
            logs.append(np.log(values.prod()))
            angles.append(np.abs(corner_angles(a) - corner_angles(b)).mean())
        cells = output.GetCellData()
        for name, expected in (("QuasiConformalError", errors), ("AngleDistortion", angles)):
            np.testing.assert_allclose(vtk_to_numpy(cells.GetArray(name)), expected, rtol=1e-7)
        logs = np.array(logs)
        found = vtk_to_numpy(cells.GetArray("AreaDistortion"))
        np.testing.assert_allclose(found - found.mean(), logs - logs.mean(), atol=1e-12)
        self.assertAlmostEqual(figure(output, "MeanQuasiConformalError"), np.mean(errors), places=9)
        self.assertAlmostEqual(figure(output, "MeanAngleDistortion"), np.mean(angles), places=9)
        self.assertAlmostEqual(figure(output, "AreaDistortionDeviation"), logs.std(), places=9)
        self.assertAlmostEqual(figure(output, "SphereDegree"), 1.0, places=12)


def corner_angles(triangle):
    result = []
    for k in range(3):
        u = triangle[(k + 1) % 3] - triangle[k]
        v = triangle[(k + 2) % 3] - triangle[k]
        result.append(np.degrees(np.arccos(u @ v / np.linalg.norm(u) / np.linalg.norm(v))))
    return np.array(result)


class TestBodyMapFiles(unittest.TestCase):
    """A map of latitudes as a picture and its world file, read by what others would do with them."""

    def test_world_file_says_where_pixels_are(self):
        body = vtkBodyMap()
        body.SetInputData(ellipsoid(40, (3.0, 2.0, 1.0)))
        chart = vtkBodyMapImage()
        chart.SetInputConnection(body.GetOutputPort())
        chart.SetArrayName("Latitude")
        chart.SetImageSize(90, 60)
        chart.Update()
        image = chart.GetOutput()
        for name in [image.GetPointData().GetArrayName(i)
                     for i in range(image.GetPointData().GetNumberOfArrays())]:
            if name != "Latitude":
                image.GetPointData().RemoveArray(name)
        numbers = vtk_to_numpy(image.GetPointData().GetScalars()).astype(np.float32)
        single = numpy_to_vtk(numbers, deep=1)
        image.GetPointData().SetScalars(single)
        with tempfile.TemporaryDirectory() as folder:
            picture, world = os.path.join(folder, "map.tif"), os.path.join(folder, "map.tfw")
            writer = vtkTIFFWriter()
            writer.SetFileName(picture)
            writer.SetInputData(image)
            writer.Write()
            write_world_file(image, world)
            reader = vtkTIFFReader()
            reader.SetFileName(picture)
            reader.SetOrientationType(4)  # the top row last, as in images of VTK
            reader.Update()
            with open(world, encoding="ascii") as file:
                across, *skew, down, left, top = map(float, file.read().split())
        self.assertEqual(skew, [0.0, 0.0])
        self.assertAlmostEqual(left, -178.0)
        self.assertAlmostEqual(top, 88.5)
        self.assertAlmostEqual(left + 89 * across, 178.0)
        found = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).reshape(60, 90)[::-1]
        for row in range(60):  # from the top
            np.testing.assert_allclose(found[row], top + row * down, atol=1.5)

if __name__ == "__main__":
    unittest.main()
