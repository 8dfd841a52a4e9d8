"""What VTK's classes can do from VTK 9.4: properties as keywords and in snake case, pipelines by >>. Skipped with
older VTK."""
import os
import sys
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion

import conformalsom

VERSION = vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()
if VERSION < (9, 4):
    print("VTK is older than 9.4")
    sys.exit(0)


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData())


class TestPythonic(unittest.TestCase):
    def test_properties_are_keywords(self):
        sphere = conformalsom.vtkGeodesicSphereSource(frequency=5)
        self.assertEqual((sphere.GetFrequency(), sphere.frequency), (5, 5))
        sphere.frequency = 7
        self.assertEqual(sphere.GetFrequency(), 7)
        painted = conformalsom.vtkSphericalTextureMap(view_direction=(1, 0, 0), split_seam=True)
        self.assertEqual((painted.GetViewDirection(), painted.GetSplitSeam()), ((1, 0, 0), True))
        with self.assertRaises((AttributeError, TypeError)):
            conformalsom.vtkGeodesicSphereSource(frequencies=5)

    def test_pipelines_are_made_by_an_operator(self):
        piped = (conformalsom.vtkGeodesicSphereSource(frequency=5)
                 >> conformalsom.vtkCurvedSeamlessSurface(frequency=10, vertex_shift=1)
                 >> conformalsom.vtkSphericalTextureMap(split_seam=False)).update().output
        source, surface = conformalsom.vtkGeodesicSphereSource(), conformalsom.vtkCurvedSeamlessSurface()
        source.SetFrequency(5)
        surface.SetInputConnection(source.GetOutputPort())
        surface.SetFrequency(10)
        surface.SetVertexShift(1)
        surface.Update()
        np.testing.assert_array_equal(points_of(piped), points_of(surface.GetOutput()))
        self.assertIsNotNone(piped.GetPointData().GetTCoords())

    def test_a_pipeline_is_called_with_data(self):
        sphere = conformalsom.vtkGeodesicSphereSource(frequency=8)
        sphere.Update()
        network = conformalsom.vtkConformalSOM(number_of_neurons=100)
        made = (network >> conformalsom.vtkCurvedSeamlessSurface(frequency=10))(sphere.GetOutput())
        self.assertGreaterEqual(made.GetNumberOfPoints(), 10 * 10**2 + 2)
        self.assertLess(np.abs(np.linalg.norm(points_of(made), axis=1) - 1.0).max(), 0.05)

    def test_stubs_have_the_properties_with_types_and_texts(self):
        with open(os.path.join(os.path.dirname(conformalsom.__file__), "vtkFiltersConformal.pyi"), encoding="utf-8") as file:
            stub = file.read()
        network = stub[stub.index("class vtkConformalSOM("):]
        self.assertRegex(network, r'def number_of_neurons\(self\) -> int:\n +"""read-write, [^"]+ geodesic mesh [^"]+"""')
        self.assertIn("def smoothness(self, value: float, /) -> None", network)


if __name__ == "__main__":
    unittest.main()
