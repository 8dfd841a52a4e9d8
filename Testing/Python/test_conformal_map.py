"""The conformal map on real triangles, measured by plain NumPy: the bear as marching cubes leave it,
and the mesh learned from its points."""
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkReverseSense

from helpers.builtin_figure import bear, figure_cloud, figure_surface
from conformalsom import (
    vtkConformalSOM, vtkCurvedSeamlessSurface, vtkGlobalConformalMap, vtkSphericalAlignment)
from obtuse import obtuse_surface


def inside_out(surface):
    """The surface turned inside out."""
    reverse = vtkReverseSense()
    reverse.SetInputData(surface)
    reverse.Update()
    return reverse.GetOutput()


def conformal_map(surface, **properties):
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    for name, value in properties.items():
        getattr(conformal, "Set" + name)(value)
    conformal.Update()
    return conformal.GetOutput()


def figure(output, name):
    return output.GetFieldData().GetArray(name).GetValue(0)


def corners(surface):
    """Corners on the surface and on the sphere, each #F by 3 by 3."""
    triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    sphere = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))
    return points[triangles], sphere[triangles]


def orientations(sphere):
    return np.sign(np.linalg.det(sphere))


def dilatations(mesh, sphere):
    """K of each triangle from squared lengths alone: 4 area K + 4 area / K = sum of cot times sides."""
    def sides(p):
        return ((np.roll(p, -1, axis=1) - np.roll(p, 1, axis=1))**2).sum(axis=2)

    def area(p):
        return np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1) / 2

    a, b = sides(mesh), sides(sphere)
    cotangents = (a.sum(axis=1)[:, None] - 2 * a) / (4 * area(mesh)[:, None])
    sum_of_both = (cotangents * b).sum(axis=1) / (2 * area(sphere))  # K + 1/K
    return sum_of_both / 2 + np.sqrt(np.maximum(sum_of_both**2 / 4 - 1, 0))


class TestGlobalConformalMap(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.raw = figure_surface()
        cls.cloud = figure_cloud(20000)
        cls.network = vtkConformalSOM()
        cls.network.SetInputData(cls.cloud)
        cls.network.SetMeshTypeToGeodesic()
        cls.network.SetNumberOfNeurons(5762)
        cls.network.Update()

    def test_maps_raw_triangles_one_to_one(self):
        output = conformal_map(self.raw)
        mesh, sphere = corners(output)
        self.assertEqual((orientations(sphere) <= 0).sum(), 0)
        self.assertEqual(figure(output, "NumberOfFlippedTriangles"), 0)
        with np.errstate(divide="ignore", invalid="ignore"):  # some triangles have no area
            self.assertLess(np.nanmedian(dilatations(mesh, sphere)), 1.06)

    def test_gu_yau_folds_obtuse_triangles_and_robust_does_not(self):
        surface = obtuse_surface(self.network)
        output = conformal_map(surface, Method=vtkGlobalConformalMap.GUYAU)
        flipped = (orientations(corners(output)[1]) <= 0).sum()
        self.assertGreater(flipped, 20)
        self.assertEqual(figure(output, "NumberOfFlippedTriangles"), flipped)
        self.assertGreater(figure(output, "NumberOfNegativeStringConstants"), 1000)
        self.assertEqual(figure(output, "Converged"), 0)
        output = conformal_map(surface)
        self.assertEqual((orientations(corners(output)[1]) <= 0).sum(), 0)
        self.assertEqual(figure(output, "Converged"), 1)

    def test_a_surface_inside_out_has_the_same_map(self):
        expected = vtk_to_numpy(conformal_map(self.raw).GetPointData().GetArray("SpherePosition"))
        found = vtk_to_numpy(
            conformal_map(inside_out(self.raw)).GetPointData().GetArray("SpherePosition"))
        self.assertLess(np.abs(found - expected).max(), 0.05)

    def test_balance_evens_areas(self):
        deviations = []
        for balance in (0.0, 0.3, 1.0):
            mesh, sphere = corners(conformal_map(self.network.GetOutput(), AreaBalance=balance))
            self.assertEqual((orientations(sphere) <= 0).sum(), 0)
            areas = [np.linalg.norm(np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]), axis=1)
                     for p in (mesh, sphere)]
            deviations.append(np.log(areas[1] / areas[0]).std())
        self.assertGreater(deviations[0], 1.2 * deviations[1])
        self.assertGreater(deviations[1], 1.2 * deviations[2])

    def test_makes_the_learned_mesh_conformal(self):
        before = dilatations(*corners(self.network.GetOutput())).mean()
        output = conformal_map(self.network.GetOutput())
        mesh, sphere = corners(output)
        self.assertEqual((orientations(sphere) <= 0).sum(), 0)
        self.assertLess(dilatations(mesh, sphere).mean() - 1.0, 0.25 * (before - 1.0))
        surface = vtkCurvedSeamlessSurface()
        surface.SetInputData(output)
        surface.SetFrequency(48)
        surface.Update()
        points = vtk_to_numpy(surface.GetOutput().GetPoints().GetData()).astype(float)
        self.assertLess(np.median(np.abs(bear(points))), 0.002)

    def test_starts_learning(self):
        """The learned map stays near the one it started from, which no rotation could better."""
        start = conformal_map(self.raw, AreaBalance=0.3)
        network = vtkConformalSOM()
        network.SetInputData(self.cloud)
        network.SetInputData(1, start)
        network.SetNumberOfNeurons(5762)
        alignment = vtkSphericalAlignment()
        alignment.SetInputConnection(0, network.GetOutputPort())
        alignment.SetInputData(1, start)
        alignment.Update()
        points = vtk_to_numpy(network.GetOutput().GetPoints().GetData()).astype(float)
        self.assertLess(np.median(np.abs(bear(points))), 0.002)
        self.assertLess(figure(alignment.GetOutput(), "AlignmentError"), 0.3)


class TestSphericalAlignment(unittest.TestCase):
    def test_maps_of_scan_and_learned_mesh_agree(self):
        network = vtkConformalSOM()
        network.SetInputData(figure_cloud(20000))
        network.SetNumberOfNeurons(5762)
        network.Update()
        alignment = vtkSphericalAlignment()
        alignment.SetInputData(0, conformal_map(network.GetOutput()))
        alignment.SetInputData(1, conformal_map(figure_surface()))
        alignment.SetTransformToMoebius()
        alignment.Update()
        self.assertLess(figure(alignment.GetOutput(), "AlignmentError"), 0.05)
        moved = vtk_to_numpy(alignment.GetOutput().GetPointData().GetArray("SpherePosition"))
        np.testing.assert_allclose(np.linalg.norm(moved, axis=1), 1.0, atol=1e-12)


if __name__ == "__main__":
    unittest.main()
