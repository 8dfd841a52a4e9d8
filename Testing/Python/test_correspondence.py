"""What surfaces with corresponding maps to the sphere are good for.

Weights of resampling are held against those of Connectome Workbench (wb_command, where it is
installed), on GIFTI files that vtkGIFTIWriter writes.
"""
import base64
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from types import SimpleNamespace
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from conformalsom import (
    vtkGeodesicSphereSource, vtkGIFTIReader, vtkGIFTIWriter, vtkSphericalResample, vtkSurfaceShape)
from helpers import hemispheres

BENCHMARKS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Benchmarks")
sys.path.insert(0, BENCHMARKS)
import compare_registrations  # pylint: disable=wrong-import-position

WORKBENCH = shutil.which("wb_command")
METHODS = {"BARYCENTRIC": vtkSphericalResample.BARYCENTRIC,
           "ADAP_BARY_AREA": vtkSphericalResample.AREA_ADAPTIVE}

LABELS = """<?xml version="1.0" encoding="UTF-8"?>
<GIFTI Version="1.0" NumberOfDataArrays="1">
<MetaData><MD><Name>AnatomicalStructurePrimary</Name><Value>CortexLeft</Value></MD></MetaData>
<LabelTable>{table}</LabelTable>
<DataArray Intent="NIFTI_INTENT_LABEL" DataType="NIFTI_TYPE_INT32" ArrayIndexingOrder="RowMajorOrder"
 Dimensionality="1" Dim0="{size}" Encoding="ASCII" Endian="LittleEndian" ExternalFileName=""
 ExternalFileOffset=""><MetaData/><Data>{data}</Data></DataArray>
</GIFTI>
"""


def turn(angle):
    c, s, d, t = np.cos(angle), np.sin(angle), np.cos(0.7 * angle), np.sin(0.7 * angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, d, -t], [0, t, d]])


def uneven_sphere(frequency, angle):
    """A geodesic sphere that is turned and denser on one side: polygons, and unit vectors."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    places = vtk_to_numpy(source.GetOutput().GetPoints().GetData()) @ turn(angle).T
    places = places + np.outer(0.25 * (1.0 + places[:, 2]) * places[:, 0], [0, 0, 1])
    return source.GetOutput().GetPolys(), places / np.linalg.norm(places, axis=1)[:, None]


def shape_at(places):
    """A bent ellipsoid in units of 1."""
    x, y, z = places.T
    return np.stack([x + 0.1 * z**2, 0.7 * y + 0.2 * np.sin(3.0 * x), 0.4 * z * (1.0 + 0.4 * y)], axis=1)


def labels_at(places):
    """Parcels along waves that no mesh follows."""
    return (np.floor(3.0 * np.sin(4.0 * places[:, 0]) + 2.0 * places[:, 1]) + 6.0).astype(np.int32)


def surface_of(polygons, positions, **arrays):
    """A surface of floats, as files have them."""
    points = vtkPoints()
    points.SetData(numpy_to_vtk(positions.astype(np.float32), deep=1))
    surface = vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(polygons)
    for name, values in arrays.items():
        array = numpy_to_vtk(values, deep=1)
        array.SetName(name)
        surface.GetPointData().AddArray(array)
    return surface


def data_of(path):
    """The integers of the only data array of a GIFTI file."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    content = re.search(r"<Data>(.*?)</Data>", text, re.DOTALL).group(1)
    if 'Encoding="ASCII"' in text:
        return np.array(content.split(), dtype=np.int32)
    packed = base64.b64decode(content)
    return np.frombuffer(zlib.decompress(packed) if "GZip" in text else packed, dtype="<i4")


class Pair:
    """A source and a target as files for Workbench and as data for the filter."""

    def __init__(self, folder, source_frequency, target_frequency):
        self.folder = folder
        self.polygons, self.source = uneven_sphere(source_frequency, 0.0)
        self.others, self.target = uneven_sphere(target_frequency, 0.9)
        for name, polygons, places in (("source", self.polygons, self.source),
                                       ("target", self.others, self.target)):
            self.write(name + ".surf.gii", surface_of(polygons, shape_at(places)))
            self.write(name + ".sphere.gii", surface_of(polygons, 100.0 * places))
        keys = np.unique(labels_at(self.source))
        table = "".join(f'<Label Key="{key}" Red="0" Green="1" Blue="0" Alpha="1">{key}</Label>'
                        for key in [0, *keys])
        with open(self.path("source.label.gii"), "w", encoding="ascii") as file:
            file.write(LABELS.format(table=table, size=len(self.source),
                                     data=" ".join(map(str, labels_at(self.source)))))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, surface):
        writer = vtkGIFTIWriter()
        writer.SetInputData(surface)
        writer.SetFileName(self.path(name))
        assert writer.Write() == 1

    def by_workbench(self, command, what, method):
        """The file that it makes of the source's."""
        areas = ["-area-surfs", "source.surf.gii", "target.surf.gii"] if "AREA" in method else []
        run = subprocess.run(
            [WORKBENCH, command, "source." + what, "source.sphere.gii", "target.sphere.gii", method,
             "resampled." + what, *areas], cwd=self.folder, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stdout + run.stderr
        return self.path("resampled." + what)

    def by_filter(self, method):
        positions = shape_at(self.source).astype(np.float32)
        resample = vtkSphericalResample()
        resample.SetMethod(METHODS[method])
        resample.SetSourceData(surface_of(
            self.polygons, positions, SpherePosition=(100.0 * self.source).astype(np.float32),
            Positions=positions, Labels=labels_at(self.source)))
        resample.SetInputData(surface_of(
            self.others, shape_at(self.target), SpherePosition=(100.0 * self.target).astype(np.float32)))
        resample.Update()
        return resample.GetOutput().GetPointData()


@unittest.skipUnless(WORKBENCH, "wb_command is not installed (Debian: connectome-workbench)")
class TestWorkbench(unittest.TestCase):
    """A mapped surface, in double precision and with arrays of all sorts, is handed to wb_command."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        polygons, places = uneven_sphere(10, 0.0)
        self.size, self.triangles = len(places), polygons.GetNumberOfCells()
        self.surface = surface_of(polygons, shape_at(places), SpherePosition=places,
                                  Depth=places[:, 2].copy(), Parcel=labels_at(places))
        points = vtkPoints()
        points.SetData(numpy_to_vtk(shape_at(places), deep=1))
        self.surface.SetPoints(points)

    def written(self, content, name):
        writer = vtkGIFTIWriter()
        writer.SetInputData(self.surface)
        writer.SetAnatomicalStructure("CortexRight")
        getattr(writer, "SetContentTo" + content)()
        writer.SetFileName(os.path.join(self.folder, name))
        assert writer.Write() == 1
        return writer.GetFileName()

    def run_workbench(self, *arguments):
        run = subprocess.run([WORKBENCH, *arguments], cwd=self.folder, capture_output=True, text=True,
                             check=False)
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run.stdout

    def information(self, name):
        lines = self.run_workbench("-file-information", name).splitlines()
        return {key.strip(): value.strip() for key, value in (line.split(":", 1) for line in lines
                                                              if ":" in line)}

    def test_it_knows_the_geometry(self):
        found = self.information(self.written("Geometry", "rh.white.surf.gii"))
        self.assertEqual(found["Structure"], "CortexRight")
        self.assertEqual(found["Surface Type (Primary)"], "Anatomical")
        self.assertEqual(int(found["Number of Vertices"]), self.size)
        self.assertEqual(int(found["Number of Triangles"]), self.triangles)
        bounds = self.surface.GetBounds()
        for i, axis in enumerate("XYZ"):
            self.assertAlmostEqual(float(found[axis + "-minimum"]), bounds[2 * i], delta=1e-3)
            self.assertAlmostEqual(float(found[axis + "-maximum"]), bounds[2 * i + 1], delta=1e-3)

    def test_it_knows_the_sphere(self):
        found = self.information(self.written("Sphere", "rh.sphere.surf.gii"))
        self.assertEqual(found["Structure"], "CortexRight")
        self.assertEqual(found["Surface Type (Primary)"], "Spherical")
        self.assertEqual(int(found["Number of Vertices"]), self.size)
        places = vtk_to_numpy(self.surface.GetPointData().GetArray("SpherePosition"))
        for i, axis in enumerate("XYZ"):
            self.assertAlmostEqual(float(found[axis + "-minimum"]), 100.0 * places[:, i].min(), delta=1e-3)
            self.assertAlmostEqual(float(found[axis + "-maximum"]), 100.0 * places[:, i].max(), delta=1e-3)
        self.assertAlmostEqual(float(found["Spherical Radius"]), 100.0, delta=0.5)  # of some points

    def test_it_knows_the_shapes(self):
        path = self.written("Shape", "rh.shape.gii")
        found = self.information(path)
        self.assertEqual((found["Type"], found["Structure"]), ("Metric", "CortexRight"))
        self.assertEqual(int(found["Number of Maps"]), 2)
        for column, name in enumerate(("Depth", "Parcel"), 1):
            values = vtk_to_numpy(self.surface.GetPointData().GetArray(name))
            largest = self.run_workbench("-metric-stats", path, "-reduce", "MAX", "-column", str(column))
            self.assertAlmostEqual(float(largest), values.max(), delta=1e-5)


    def test_curvatures_are_those_of_workbench(self):
        hemisphere = hemispheres.hemisphere(40, 0.0, 2)
        self.surface = hemisphere
        self.written("Geometry", "lh.surf.gii")
        self.run_workbench("-surface-curvature", "lh.surf.gii", "-mean", "mean.shape.gii", "-gauss", "gauss.shape.gii")
        shape = vtkSurfaceShape()
        shape.SetInputData(hemisphere)
        shape.SetCurvatureScale(0.0)
        shape.Update()
        reader = vtkGIFTIReader()
        reader.SetFileName(os.path.join(self.folder, "lh.surf.gii"))
        for file, name in (("mean", "MeanCurvature"), ("gauss", "GaussianCurvature")):
            reader.SetShapeFileName(os.path.join(self.folder, file + ".shape.gii"))
            reader.Update()
            theirs = vtk_to_numpy(reader.GetOutput().GetPointData().GetArray(0))
            ours = vtk_to_numpy(shape.GetOutput().GetPointData().GetArray(name))
            self.assertGreater(np.corrcoef(ours, theirs)[0, 1], 0.95)


class TestResample(unittest.TestCase):
    @unittest.skipUnless(WORKBENCH, "wb_command is not installed (Debian: connectome-workbench)")
    def test_weights_are_those_of_workbench(self):
        for frequencies in ((12, 20), (20, 12), (16, 15), (30, 8)):
            with tempfile.TemporaryDirectory() as folder:
                pair = Pair(folder, *frequencies)
                for method in METHODS:
                    with self.subTest(method, frequencies=frequencies):
                        carried = pair.by_filter(method)
                        reader = vtkGIFTIReader()
                        reader.SetFileName(pair.by_workbench("-surface-resample", "surf.gii", method))
                        reader.Update()
                        expected = vtk_to_numpy(reader.GetOutput().GetPoints().GetData())
                        positions = vtk_to_numpy(carried.GetArray("Positions"))
                        self.assertEqual(positions.shape, expected.shape)
                        self.assertLess(np.abs(positions - expected).max(), 1e-5)
                        path = pair.by_workbench("-label-resample", "label.gii", method)
                        np.testing.assert_array_equal(
                            vtk_to_numpy(carried.GetArray("Labels")), data_of(path))

    def test_methods_differ_and_both_carry_smooth_values(self):
        with tempfile.TemporaryDirectory() as folder:
            pair = Pair(folder, 30, 20)
            carried = [vtk_to_numpy(pair.by_filter(method).GetArray("Positions")) for method in METHODS]
        for positions in carried:
            self.assertLess(np.abs(positions - shape_at(pair.target)).max(), 0.01)
        self.assertGreater(np.abs(carried[0] - carried[1]).max(), 1e-4)


class TestCompareRegistrations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        polygons, places = uneven_sphere(8, 0.0)
        self.triangles = vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3)
        self.landmarks = [0, 3, 7, 100, 200, 641]
        for name, angle in (("straight", 0.0), ("turned", 1.1)):
            self.write(name, shape_at(places) @ turn(angle).T, self.landmarks)

    def write(self, name, positions, landmarks):
        with open(os.path.join(self.folder, name + ".off"), "w", encoding="ascii") as file:
            file.write(f"OFF\n{len(positions)} {len(self.triangles)} 0\n")
            np.savetxt(file, positions)
            np.savetxt(file, np.insert(self.triangles, 0, 3, axis=1), fmt="%d")
        with open(os.path.join(self.folder, name + ".landmarks"), "w", encoding="ascii") as file:
            file.writelines(f"{point}\n" for point in landmarks)

    def run_script(self, *arguments, script="compare_registrations.py"):
        return subprocess.run(
            [sys.executable, os.path.join(BENCHMARKS, script), *arguments],
            capture_output=True, text=True, check=False)

    def test_errors_are_lengths_along_edges(self):
        model = compare_registrations.Model(os.path.join(self.folder, "turned.off"), 0.5)
        sphere = compare_registrations.sphere_of(model.mapped)
        self.assertLess(model.landmark_errors(sphere[self.landmarks], model.distances).max(), 1e-7)
        corners = model.points[self.triangles]
        area = np.linalg.norm(
            np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2.0
        # Of places on an edge that starts at the landmark, the part of the edge.
        ends = [next(row[(list(row).index(point) + 1) % 3] for row in self.triangles if point in row)
                for point in self.landmarks]
        edges = np.linalg.norm(model.points[self.landmarks] - model.points[ends], axis=1) / np.sqrt(area)
        for part in (1.0, 0.25):
            places = (1.0 - part) * sphere[self.landmarks] + part * sphere[ends]
            np.testing.assert_allclose(model.landmark_errors(places, model.distances), part * edges, rtol=1e-6)

    def test_a_turned_copy_has_no_error(self):
        run = self.run_script(self.folder, "--landmarks", "2", "6", "--both", "--each", "--set", "Frequency=8")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        lines = run.stdout.splitlines()
        rows = [line.strip("| ").split(" | ") for line in lines if line.startswith("| ")][2:]
        self.assertEqual([row[2] for row in rows], ["2 of 6", "all 6"])
        for row in rows:
            self.assertLess(max(float(number) for number in row[3:6]), 5e-3)
            self.assertEqual(row[6:10], ["0", "100 %", "0", "0 of 0"])
        self.assertTrue(any("0*: " in line for line in lines))
        self.assertTrue(any(" 1: " in line for line in lines))

    def test_a_row_counts_reported_pairs_among_wrong_and_right_ones(self):
        outcomes = [SimpleNamespace(mean=mean, judged=np.array([mean]), is_ambiguous=reported, flips=1, seconds=2.0)
                    for mean, reported in ((0.05, False), (0.2, True), (0.05, False), (0.3, True), (0.4, False))]
        row = compare_registrations.row_of([0, 1], 5, outcomes, SimpleNamespace(folder="heads/", space="Rotation", template=False))
        self.assertEqual(row, ("heads", "Rotation", "2 of 5", "0.200", "0.200", "0.400", "2", "40 %", "5", "1 of 2",
                               "1 of 3", "2.0"))

    def test_curvature_alone_finds_most_of_a_warp(self):
        run = self.run_script(os.path.join(self.folder, "straight.off"), "--frequency", "8", "--copy", "10",
                              script="register_warped_copy.py")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        words = run.stdout.splitlines()[-1].replace(",", "").split()
        before, after = (float(words[words.index(name) + 1]) for name in ("before", "after"))
        self.assertLess(after, 0.5 * before)
        self.assertIn("0 folds", run.stdout)

    def test_bad_input_ends_with_a_message(self):
        self.write("straight", shape_at(uneven_sphere(8, 0.0)[1]), [0, 642, 3, 4, 5, 6])
        run = self.run_script(self.folder)
        self.assertEqual(run.returncode, 1)
        self.assertIn("straight.landmarks: expected ids of the 642 points", run.stderr)
        run = self.run_script(self.folder, "--models", "straight")
        self.assertEqual(run.returncode, 2)
        self.assertIn("two files", run.stderr)
        run = self.run_script(self.folder, "--set", "Frequenzy=8")
        self.assertEqual(run.returncode, 2)
        self.assertIn("no property Frequenzy", run.stderr)


if __name__ == "__main__":
    unittest.main()
