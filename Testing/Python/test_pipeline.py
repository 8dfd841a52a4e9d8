"""The chain of five: its arrays are those Documentation/Pipeline.md promises, its results have
the same bits on any number of threads, and they lie where the scan is."""
import os
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkFiltersCore import vtkFeatureEdges
import numpy as np

from helpers.builtin_figure import bear, figure_cloud
from conformalsom import (
    vtkConformalDistortion, vtkConformalSOM, vtkCurvedSeamlessSurface, vtkGenusZeroCheck,
    vtkGenusZeroHull, vtkGeodesicSphereSource, vtkGlobalConformalMap, vtkSphericalAlignment,
    vtkSphericalTextureImage, vtkSphericalTextureMap, vtkSurfaceMismatch)

PROMISE = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "Pipeline.md")


def chain(frequency=18, surface_frequency=40):
    """The filters of the pipeline, all run, by class name."""
    scan = figure_cloud(20000)
    network = vtkConformalSOM()
    network.SetInputData(scan)
    network.SetFrequency(frequency)
    network.GenerateErrorScalarsOn()
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(network.GetOutputPort())
    surface.SetFrequency(surface_frequency)
    painted = vtkSphericalTextureMap()
    painted.SetInputConnection(surface.GetOutputPort())
    painted.SetViewDirection(0, 0, 1)
    painted.SetViewUp(0, 1, 0)
    mismatch = vtkSurfaceMismatch()
    mismatch.SetInputConnection(0, painted.GetOutputPort())
    mismatch.SetInputData(1, scan)
    distortion = vtkConformalDistortion()
    distortion.SetInputConnection(mismatch.GetOutputPort())
    distortion.Update()
    split = vtkSphericalTextureMap()
    split.SetInputConnection(surface.GetOutputPort())
    split.SetProjectionToOctahedral()
    split.SplitSeamOn()
    image = vtkSphericalTextureImage()
    image.SetInputConnection(split.GetOutputPort())
    image.SetArrayName("Normals")
    image.SetImageSize(40, 30)
    image.Update()
    sphere = vtkGeodesicSphereSource()
    sphere.Update()
    hull = vtkGenusZeroHull()
    hull.SetInputData(scan)
    hull.SetSpacing(0.04)
    hull.Update()
    network_piece, hull_piece = vtkConformalSOM(), vtkGenusZeroHull()
    for piece in (network_piece, hull_piece):
        piece.SetInputData(scan)
        piece.DistributeOutputOn()
    network_piece.SetFrequency(6)
    network_piece.Update()
    hull_piece.SetSpacing(0.1)
    hull_piece.Update()
    conformal = vtkGlobalConformalMap()
    conformal.SetInputConnection(network.GetOutputPort())
    alignment = vtkSphericalAlignment()
    alignment.SetInputConnection(0, conformal.GetOutputPort())
    alignment.SetInputConnection(1, network.GetOutputPort())
    alignment.Update()
    stages = (network, surface, painted, mismatch, distortion, image, sphere, hull, conformal,
              alignment)
    by_name = {stage.GetClassName(): stage for stage in stages}
    return {**by_name, "vtkSphericalTextureMap with SplitSeam": split,
            "vtkConformalSOM with DistributeOutput": network_piece,
            "vtkGenusZeroHull with DistributeOutput": hull_piece}


def promised_arrays():
    """Rows of the tables of arrays in Pipeline.md, which have five columns: name, where,
    components and type, writers, readers."""
    with open(PROMISE, encoding="ascii") as file:
        rows = [line.strip("| \n").split(" | ") for line in file if line.startswith("| `")]
    for name, where, kind, writers, _ in (row for row in rows if len(row) == 5):
        components, type_name = kind.split(" ", 1)
        yield name.strip("`"), where, int(components), type_name, writers.split(", ")


def all_bytes(data):
    """Points, triangles and every array of a vtkPolyData as bytes."""
    arrays = [data.GetPoints().GetData(), data.GetPolys().GetConnectivityArray()]
    for attributes in (data.GetPointData(), data.GetCellData(), data.GetFieldData()):
        arrays += [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {i: vtk_to_numpy(array).tobytes() for i, array in enumerate(arrays)}


def pixel_bytes(stages):
    """The baked image."""
    image = stages["vtkSphericalTextureImage"].GetOutput()
    return vtk_to_numpy(image.GetPointData().GetScalars()).tobytes()


class TestPipeline(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stages = chain()
        cls.result = cls.stages["vtkConformalDistortion"].GetOutput()

    def test_writes_the_promised_arrays(self):
        places = {
            "points": lambda stage: stage.GetOutput().GetPointData(),
            "cells": lambda stage: stage.GetOutput().GetCellData(),
            "image": lambda stage: stage.GetOutput().GetPointData(),
            "field data": lambda stage: stage.GetOutput().GetFieldData(),
            "port 1": lambda stage: stage.GetOutputDataObject(1).GetRowData()}
        promised = list(promised_arrays())
        self.assertGreater(len(promised), 10)
        for name, where, components, type_name, writers in promised:
            for writer in writers:
                with self.subTest(f"{name} of {writer}"):
                    array = places[where](self.stages[writer]).GetArray(name)
                    self.assertIsNotNone(array)
                    self.assertEqual(array.GetNumberOfComponents(), components)
                    self.assertEqual(array.GetDataTypeAsString(), type_name)
                    self.assertTrue(np.isfinite(vtk_to_numpy(array)).all())

    def test_every_stage_is_closed_and_of_genus_zero(self):
        for name in ("vtkConformalSOM", "vtkCurvedSeamlessSurface", "vtkGenusZeroHull"):
            with self.subTest(name):
                check = vtkGenusZeroCheck()
                check.SetInputData(self.stages[name].GetOutput())
                check.Update()
                field = check.GetOutput().GetFieldData()
                self.assertEqual(field.GetArray("IsGenusZero").GetValue(0), 1)
                self.assertEqual(field.GetArray("NumberOfInconsistentEdges").GetValue(0), 0)

    def test_texture_splits_nothing_open(self):
        edges = vtkFeatureEdges()
        edges.SetInputData(self.stages["vtkSphericalTextureMap"].GetOutput())
        edges.FeatureEdgesOff()
        edges.Update()
        self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)

    def test_surface_lies_on_the_bear(self):
        """Independent of every filter: the bear is known as a formula."""
        points = vtk_to_numpy(self.stages["vtkCurvedSeamlessSurface"].GetOutput().GetPoints().GetData())
        distance = np.abs(bear(points.astype(float)))
        self.assertLess(np.median(distance), 0.002)
        self.assertLess(distance.max(), 0.02)

    def test_mismatch_sees_the_scan(self):
        field = self.result.GetFieldData()
        p2s = field.GetArray("MeanSquarePointToSurface").GetValue(0)
        nv = field.GetArray("MeanSquarePointToVertex").GetValue(0)
        self.assertGreater(p2s, 0.0)
        self.assertLess(p2s, nv)
        self.assertLess(p2s, 1e-5)

    def test_same_bits_on_any_threads(self):
        expected = {name: all_bytes(self.stages[name].GetOutput())
                    for name in ("vtkConformalDistortion", "vtkSphericalAlignment")}
        pixels = pixel_bytes(self.stages)
        for backend in ("Sequential", "STDThread", "TBB"):
            for threads in (1, 2):
                with self.subTest(f"{backend}, {threads} threads"):
                    self.assertTrue(vtkSMPTools.SetBackend(backend))
                    vtkSMPTools.Initialize(threads)
                    again = chain()
                    for name, bytes_ in expected.items():
                        self.assertEqual(all_bytes(again[name].GetOutput()), bytes_)
                    self.assertEqual(pixel_bytes(again), pixels)


if __name__ == "__main__":
    unittest.main()
