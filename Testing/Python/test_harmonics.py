"""Spherical harmonics of scans, and by the files of SPHARM-PDM."""
import os
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

from conformalsom import (
    vtkConformalPLYReader, vtkGeodesicSphereSource, vtkGlobalConformalMap, vtkSPHARMCoefficientReader,
    vtkSPHARMCoefficientWriter, vtkSPHARMSurfaceReader, vtkSPHARMSurfaceWriter, vtkSurfaceHarmonics,
    vtkSurfaceHarmonicsSource)

SCANS = os.environ.get("CONFORMALSOM_SCAN_DIR", "")


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def pear(frequency=30):
    """A mapped surface of which no two ends are alike."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    surface = vtkPolyData()
    surface.DeepCopy(source.GetOutput())
    n = points_of(surface)
    p = n * (3.0, 2.0, 1.0) + 0.5 * n[:, :1] ** 2 * (1.0, 0.0, 0.4) + 0.2 * n[:, 1:2] ** 3
    surface.GetPoints().SetData(numpy_to_vtk(p, deep=True))
    return surface


def harmonics_of(surface, degree, **properties):
    harmonics = vtkSurfaceHarmonics()
    harmonics.SetInputData(surface)
    harmonics.SetDegree(degree)
    for name, value in properties.items():
        getattr(harmonics, "Set" + name)(value)
    harmonics.Update()
    return harmonics


def distance_of(harmonics):
    return harmonics.GetOutput().GetFieldData().GetArray("RootMeanSquareDistance").GetValue(0)


class TestScans(unittest.TestCase):
    """Root mean square distances at a largest radius of 1, on maps with an area balance of 0.5."""
    FARTHEST = {"stanford-bunny-closed.ply": {12: 1.4e-2, 20: 6.8e-3, 32: 3.2e-3},
                "spot.ply": {12: 1.8e-2, 20: 6.8e-3, 32: 3.5e-3}}

    def test_few_harmonics_come_close(self):
        for name, farthest in self.FARTHEST.items():
            path = os.path.join(SCANS, name)
            with self.subTest(name):
                if not os.path.exists(path):
                    self.skipTest(f"{name} is not in CONFORMALSOM_SCAN_DIR")
                reader = vtkConformalPLYReader()
                reader.SetFileName(path)
                mapped = vtkGlobalConformalMap()
                mapped.SetInputConnection(reader.GetOutputPort())
                mapped.SetAreaBalance(0.5)
                mapped.Update()
                points = points_of(mapped.GetOutput())
                radius = np.linalg.norm(points - points.mean(0), axis=1).max()
                for degree, most in farthest.items():
                    with self.subTest(degree):
                        harmonics = harmonics_of(mapped.GetOutput(), degree)
                        self.assertLessEqual(distance_of(harmonics) / radius, most)
                        # By hand: most vertices are no farther than that.
                        moved = points_of(harmonics.GetOutput()) - points
                        self.assertLess(np.median(np.linalg.norm(moved, axis=1)) / radius, most)


class TestFiles(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def path(self, name):
        return os.path.join(self.folder, name)

    def test_surface_comes_back_through_a_file(self):
        surface = pear()
        harmonics = harmonics_of(surface, 6)
        writer = vtkSPHARMCoefficientWriter()
        writer.SetInputConnection(harmonics.GetOutputPort(1))
        writer.SetFileName(self.path("pear.coef"))
        self.assertEqual(writer.Write(), 1)
        reader = vtkSPHARMCoefficientReader()
        reader.SetFileName(writer.GetFileName())
        source = vtkSurfaceHarmonicsSource()
        source.SetInputConnection(reader.GetOutputPort())
        source.SetFrequency(30)
        source.Update()
        self.assertLess(np.abs(points_of(source.GetOutput()) - points_of(surface)).max(), 1e-12)

    def test_pair_comes_back_with_its_harmonics(self):
        surface = pear()
        writer = vtkSPHARMSurfaceWriter()
        writer.SetInputData(surface)
        writer.SetFileName(self.path("pear_surf.vtk"))
        self.assertEqual(writer.Write(), 1)
        reader = vtkSPHARMSurfaceReader()
        reader.SetFileName(writer.GetFileName())
        reader.Update()
        for name in ("X", "Y", "Z"):
            tables = [harmonics_of(data, 9).GetCoefficients() for data in (surface, reader.GetOutput())]
            one, two = (vtk_to_numpy(table.GetColumnByName(name)) for table in tables)
            np.testing.assert_array_equal(one, two)


if __name__ == "__main__":
    unittest.main()
