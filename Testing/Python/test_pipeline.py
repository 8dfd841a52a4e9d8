"""The chain of five: its results have the same bits on any number of threads, and they lie where the
scan is. The arrays of all filters and readers are those that Documentation/Pipeline.md lists."""
import os
import re
import tempfile
import unittest

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkSMPTools
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkClipPolyData, vtkFeatureEdges, vtkPolyDataConnectivityFilter
import numpy as np

import conformalsom
import output_cases
from helpers.builtin_figure import bear, figure_cloud
from helpers.textures import checkerboard
from samples import GU_MESH, OFF_FILES, PCD, PLY_FILES, SCAN, TEXT_FILES, torus
from conformalsom import (
    vtkAdaptiveSphere, vtkBodyMap, vtkBodyMapImage, vtkConformalDistortion, vtkConformalSOM, vtkConsistentRemesh, vtkCurvedSeamlessSurface, vtkGenusZeroCheck,
    vtkFreeSurferWriter, vtkGenusZeroHull, vtkGenusZeroRepair, vtkGeodesicSphereSource, vtkGIFTIWriter,
    vtkGlobalConformalMap, vtkSphericalAlignment, vtkSurfaceHarmonics, vtkSurfaceHarmonicsSource, vtkSphericalMorph, vtkSphericalRegistration, vtkSphericalResample, vtkSphericalTemplate, vtkSphericalTextureBlend, vtkSphericalTextureImage,
    vtkSphericalTextureMap, vtkSurfaceMismatch, vtkSurfaceNormalMap, vtkSurfaceShape)

PROMISE = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "..", "..", "Documentation", "Pipeline.md")


def chain(frequency=18, surface_frequency=40):
    """The filters of the pipeline, all run, by class name."""
    scan = figure_cloud(20000)
    network = vtkConformalSOM()
    network.SetInputData(scan)
    network.SetNumberOfNeurons(10 * frequency**2 + 2)
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
    balanced = vtkSphericalTextureMap()
    balanced.SetInputConnection(surface.GetOutputPort())
    balanced.SetAreaBalance(0.5)
    balanced.Update()
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
    network_piece.SetNumberOfNeurons(362)
    network_piece.Update()
    hull_piece.SetSpacing(0.1)
    hull_piece.Update()
    conformal = vtkGlobalConformalMap()
    conformal.SetInputConnection(network.GetOutputPort())
    sheet = vtkGlobalConformalMap()
    sheet.SetInputData(half_of(network.GetOutput()))
    sheet.Update()
    ring = vtkGlobalConformalMap()
    ring.SetInputData(torus())
    ring.Update()
    alignment = vtkSphericalAlignment()
    alignment.SetInputConnection(0, conformal.GetOutputPort())
    alignment.SetInputConnection(1, network.GetOutputPort())
    alignment.Update()
    stages = (network, surface, painted, mismatch, distortion, image, sphere, hull, conformal,
              alignment)
    by_name = {stage.GetClassName(): stage for stage in stages}
    to_mesh = vtkSurfaceMismatch()
    to_mesh.SetInputConnection(0, painted.GetOutputPort())
    to_mesh.SetInputConnection(1, surface.GetOutputPort())
    to_mesh.Update()
    return {**by_name, "vtkSphericalTextureMap with SplitSeam": split,
            "vtkSphericalTextureMap with AreaBalance": balanced,
            "vtkGlobalConformalMap with a border": sheet,
            "vtkGlobalConformalMap with a handle": ring,
            "vtkSurfaceMismatch with a reference mesh": to_mesh,
            "vtkConformalSOM with DistributeOutput": network_piece,
            "vtkGenusZeroHull with DistributeOutput": hull_piece}


def half_of(surface):
    """The part of a surface above the middle."""
    plane = vtkPlane()
    plane.SetOrigin(surface.GetCenter())
    plane.SetNormal(0, 0, 1)
    clip = vtkClipPolyData()
    clip.SetInputData(surface)
    clip.SetClipFunction(plane)
    largest = vtkPolyDataConnectivityFilter()
    largest.SetInputConnection(clip.GetOutputPort())
    largest.SetExtractionModeToLargestRegion()
    used = vtkCleanPolyData()
    used.SetInputConnection(largest.GetOutputPort())
    used.Update()
    return used.GetOutput()


def beside_the_chain(stages):
    """The classes that the chain does not need, run on its results, by class name."""
    check = vtkGenusZeroCheck()
    check.SetInputConnection(stages["vtkConformalDistortion"].GetOutputPort())
    check.Update()
    shape = vtkSurfaceShape()
    shape.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    shape.Update()
    blend = vtkSphericalTextureBlend()
    blend.SetInputConnection(stages["vtkSphericalTextureMap"].GetOutputPort())
    blend.SetFrontData(checkerboard())
    blend.SetBackData(checkerboard())
    blend.SetBackViewDirection(0, 0, -1)
    blend.SetImageSize(30, 20)
    blend.Update()
    normal_map = vtkSurfaceNormalMap()
    normal_map.SetInputConnection(stages["vtkSphericalTextureMap"].GetOutputPort())
    normal_map.SetDetailConnection(stages["vtkCurvedSeamlessSurface"].GetOutputPort())
    normal_map.SetImageSize(30, 20)
    normal_map.Update()
    adaptive = vtkAdaptiveSphere()
    adaptive.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    adaptive.SetNumberOfPoints(2000)
    adaptive.Update()
    resample = vtkSphericalResample()
    resample.SetInputConnection(adaptive.GetOutputPort())
    resample.SetSourceConnection(stages["vtkSurfaceMismatch"].GetOutputPort())
    resample.SetMaskArrayName("Distance")
    resample.Update()
    harmonics = vtkSurfaceHarmonics()
    harmonics.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    harmonics.SetDegree(8)
    harmonics.Update()
    rebuilt = vtkSurfaceHarmonicsSource()
    rebuilt.SetInputConnection(harmonics.GetOutputPort(1))
    rebuilt.SetFrequency(5)
    rebuilt.Update()
    morph = vtkSphericalMorph()
    morph.SetInputConnection(stages["vtkSphericalAlignment"].GetOutputPort())
    morph.SetTargetConnection(stages["vtkConformalSOM"].GetOutputPort())
    morph.SetNumberOfPoints(1000)
    morph.Update()
    registration = vtkSphericalRegistration()
    registration.SetInputConnection(stages["vtkSphericalAlignment"].GetOutputPort())
    registration.SetFixedConnection(stages["vtkConformalSOM"].GetOutputPort())
    registration.SetFrequency(8)
    registration.Update()
    remesh = vtkConsistentRemesh()
    remesh.AddInputConnection(stages["vtkCurvedSeamlessSurface"].GetOutputPort())
    remesh.AddInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    remesh.SetNumberOfPoints(1000)
    remesh.Update()
    template = vtkSphericalTemplate()
    template.AddInputConnection(stages["vtkSphericalAlignment"].GetOutputPort())
    template.AddInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    template.SetFrequency(8)
    template.SetMeanFrequency(8)
    template.SetMaximumNumberOfRounds(1)
    template.Update()
    series = conformalsom.vtkSphericalTimeSeries()
    series.AddInputConnection(stages["vtkSphericalAlignment"].GetOutputPort())
    series.AddInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    series.SetFrequency(8)
    series.SetNumberOfSweeps(0)
    series.Update()
    transfer = conformalsom.vtkDeformationTransfer()
    transfer.SetInputConnection(stages["vtkSphericalAlignment"].GetOutputPort())
    transfer.SetSourceConnection(stages["vtkConformalSOM"].GetOutputPort())
    transfer.SetPoseConnection(stages["vtkConformalSOM"].GetOutputPort())
    transfer.Update()
    body = vtkBodyMap()
    body.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    body.SetPlacesData(torus())
    body.Update()
    chart = vtkBodyMapImage()
    chart.SetInputConnection(body.GetOutputPort())
    chart.SetArrayName("Height")
    chart.SetImageSize(40, 20)
    chart.GeneratePositionsOn()
    chart.GenerateAreaScaleOn()
    chart.SetProjectionToCapsule()
    chart.Update()
    repair = vtkGenusZeroRepair()
    repair.SetInputData(torus())
    repair.Update()
    outside = conformalsom.vtkVolumeSurfacePoints()
    outside.SetInputData(output_cases.ball_volume())
    outside.Update()
    layers = conformalsom.vtkSurfaceLayers()
    layers.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    layers.SetVolumeData(output_cases.ball_volume())
    layers.SetNumberOfLayers(1)
    layers.SetProjectionToCapsule()
    layers.SetImageSize(40, 20)
    layers.Update()
    labels = conformalsom.vtkMapLabels()
    labels.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    labels.SetLabelsData(output_cases.label_map())
    labels.Update()
    drawn = conformalsom.vtkMapOutlines()
    drawn.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    drawn.SetOutlinesData(output_cases.outlines())
    drawn.Update()
    geodesics = conformalsom.vtkSurfaceGeodesics()
    geodesics.SetInputConnection(stages["vtkConformalSOM"].GetOutputPort())
    geodesics.AddSourceId(0)
    geodesics.SetTargetsConnection(stages["vtkConformalSOM"].GetOutputPort())
    geodesics.Update()
    som = conformalsom.vtkSphericalSOM()
    som.SetInputData(output_cases.measurements())
    som.SetLabelColumn("Kind")
    som.Update()
    filters = (som, check, shape, blend, normal_map, adaptive, harmonics, rebuilt, morph, registration, remesh, template,
               series, transfer, resample, repair, body, chart, outside, layers, labels, drawn,
               geodesics)
    return {filter_.GetClassName(): filter_ for filter_ in filters}


class ReadFiles:
    """What each reader makes of files that have all it knows: outputs by class name."""

    def __init__(self, mapped):
        self.outputs = {}
        with tempfile.TemporaryDirectory() as self.folder:
            for bytes_ in PLY_FILES:
                self.read("vtkConformalPLYReader", bytes_)
            for bytes_ in OFF_FILES:
                self.read("vtkConformalOFFReader", bytes_)
            for bytes_ in TEXT_FILES:
                self.read("vtkTextCloudReader", bytes_, lambda reader: reader.SkipMalformedLinesOn())
            for color in ("rgb", "rgba"):
                self.read("vtkPCDReader", PCD.format(color=color))
            self.read("vtkGuMeshReader", GU_MESH)
            label = self.put("file.lbl", "TARGET_NAME = EROS\nUNIT = KILOMETER\n")
            self.read("vtkPlateModelReader", "3 1\n0 0 0\n1 0 0\n0 1 0\n1 2 3\n")
            os.remove(label)
            self.put("scan.ply", SCAN)
            self.read("vtkStanfordScansReader", "bmesh scan.ply 0 0 0 0 0 0 1\n"
                                                "bmesh missing.ply 0 0 0 0 0 0 1\n")
            writer = vtkFreeSurferWriter()
            writer.SetInputData(mapped)
            writer.SetArrayName("Distance")
            names = {}
            for content in ("Surface", "Sphere", "Curvature"):
                getattr(writer, "SetContentTo" + content)()
                names[content] = os.path.join(self.folder, "lh." + content)
                writer.SetFileName(names[content])
                assert writer.Write() == 1

            def name_others(reader):
                reader.SetSphereFileName(names["Sphere"])
                reader.SetCurvatureFileName(names["Curvature"])
            self.update("vtkFreeSurferReader", names["Surface"], name_others)
            writer = vtkGIFTIWriter()
            writer.SetInputData(mapped)
            writer.SetFileName(os.path.join(self.folder, "surface.gii"))
            assert writer.Write() == 1
            self.update("vtkGIFTIReader", writer.GetFileName())
            writer = conformalsom.vtkSPHARMSurfaceWriter()
            writer.SetInputData(mapped)
            writer.SetFileName(os.path.join(self.folder, "a_surf.vtk"))
            assert writer.Write() == 1
            self.update("vtkSPHARMSurfaceReader", writer.GetFileName())
            self.read("vtkSPHARMCoefficientReader", "{ 1,{1.5, 2, 3}}")
            writer = conformalsom.vtkTIFFStackWriter()
            writer.SetInputData(output_cases.ball_volume())
            writer.SetUnit("micron")
            writer.SetFileName(os.path.join(self.folder, "stack.tif"))
            assert writer.Write() == 1
            self.update("vtkTIFFStackReader", writer.GetFileName())
            for name in set(output_cases.DERIVED_READERS) - set(self.outputs):
                for files in output_cases.CASES[name].files.values():
                    paths = [self.put(file, bytes_) for file, bytes_ in files.items()]
                    self.update(name, paths[0])

    def put(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode("ascii"))
        return path

    def read(self, class_name, text, set_up=None):
        self.update(class_name, self.put("file", text), set_up)

    def update(self, class_name, path, set_up=None):
        reader = getattr(conformalsom, class_name)()
        reader.SetFileName(path)
        if set_up:
            set_up(reader)
        reader.Update()
        assert reader.GetErrorCode() == 0, f"{class_name}: {path}"
        self.outputs.setdefault(class_name, []).append(reader.GetOutput())


# Names that the files above give to numbers of their own.
NAMES_OF_FILES = {"confidence", "flags", "label", "Column5", "rowIndex", "columnIndex", "timeStamp"}


def arrays_of(output, port=0):
    """All arrays of an output: pairs of the place as Pipeline.md calls it, and the array."""
    if output.IsA("vtkMultiBlockDataSet"):
        return [pair for block in range(output.GetNumberOfBlocks())
                for pair in arrays_of(output.GetBlock(block), port)]
    if output.IsA("vtkTable"):
        places = {f"port {port}": output.GetRowData()}
    elif output.IsA("vtkImageData"):
        places = {"image": output.GetPointData(), "field data": output.GetFieldData()}
    else:
        places = {"points": output.GetPointData(), "cells": output.GetCellData(),
                  "field data": output.GetFieldData()}
    return [(place, data.GetAbstractArray(i)) for place, data in places.items()
            for i in range(data.GetNumberOfArrays())]


def arrays_of_outputs(filter_):
    return [pair for port in range(filter_.GetNumberOfOutputPorts())
            for pair in arrays_of(filter_.GetOutputDataObject(port), port)]


def names_of_inputs(filter_):
    return {array.GetName() for port in range(filter_.GetNumberOfInputPorts())
            for i in range(filter_.GetNumberOfInputConnections(port))
            for _, array in arrays_of(filter_.GetInputDataObject(port, i))}


def derived_filters(others):
    """The filters that neither the chain nor the rest names, run as by default on mapped surfaces, by class name."""
    filters = {}
    for name, case in output_cases.CASES.items():
        if isinstance(getattr(conformalsom, name)(), vtkAlgorithm) and name not in others \
                and not name.endswith(("Reader", "Writer")):
            filters[name] = getattr(conformalsom, name)()
            case.set_up["default"](filters[name])
            filters[name].Update()
    return filters


def documented_arrays():
    """Pairs of a class and an array that its header names, such as: - point array "Distance" (double, ..."""
    return {(name, array) for name, class_ in vars(conformalsom).items() if isinstance(class_, type)
            for array in re.findall('array\\s+"([A-Za-z ]+)"', class_.__doc__ or "")}


def promised_arrays():
    """Rows of the tables of arrays in Pipeline.md, which have five columns: name, where,
    components and type, writers, meaning."""
    with open(PROMISE, encoding="ascii") as file:
        rows = [line.strip("| \n").split(" | ") for line in file if line.startswith("| `")]
    for name, where, kind, writers, _ in (row for row in rows if len(row) == 5):
        components, types = kind.split(" ", 1)
        yield name.strip("`"), where, int(components), types.split(" or "), writers.split(", ")


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
        filters = {**cls.stages, **beside_the_chain(cls.stages)}
        mapped = cls.stages["vtkSurfaceMismatch"].GetOutput()
        filters.update(derived_filters(filters))
        readers = ReadFiles(mapped).outputs
        cls.written = {name: arrays_of_outputs(filter_) for name, filter_ in filters.items()}
        cls.written.update({name: [pair for output in outputs for pair in arrays_of(output)]
                            for name, outputs in readers.items()})
        cls.passed = {name: names_of_inputs(filter_) for name, filter_ in filters.items()}
        cls.passed.update({name: NAMES_OF_FILES for name in readers})
        cls.passed["vtkGIFTIReader"] = {"TCoords"} | {array.GetName() for _, array in arrays_of(mapped)}

    def test_writes_the_promised_arrays(self):
        promised = list(promised_arrays())
        self.assertGreater(len(promised), 10)
        for name, where, components, types, writers in promised:
            for writer in set(writers) - set(output_cases.UNTRIED_READERS):
                with self.subTest(f"{name} of {writer}"):
                    found = [array for place, array in self.written[writer]
                             if place == where and array.GetName() == name]
                    self.assertTrue(found)
                    self.assertLessEqual({array.GetDataTypeAsString() for array in found}, set(types))
                    for array in found:
                        self.assertEqual(array.GetNumberOfComponents(), components)
                        if array.IsNumeric() and array.GetNumberOfTuples():
                            self.assertTrue(np.isfinite(vtk_to_numpy(array)).all())

    def test_promises_the_written_arrays(self):
        """By a row of Pipeline.md, or by the header of the class."""
        documented = documented_arrays()
        promised = {(writer.split(" with ")[0], where, name)
                    for name, where, _, _, writers in promised_arrays() for writer in writers}
        counts = {name for name in (row[0] for row in promised_arrays()) if name.startswith("NumberOf")}
        for writer, arrays in self.written.items():
            class_name = writer.split(" with ")[0]
            for place, array in arrays:
                name = array.GetName()
                passed = name in self.passed[writer] or (class_name.endswith("Reader") and name in counts)
                with self.subTest(f"{name} of {writer}"):
                    self.assertTrue(passed or (class_name, place, name) in promised
                                    or (class_name, name) in documented)

    def test_every_name_has_one_meaning(self):
        """Two classes may give one name only where a row says that they mean the same."""
        rows = [(name, where) for name, where, *_ in promised_arrays()]
        readers = [row for row in promised_arrays() if row[4][0].endswith("Reader")]
        of_files = {(name, where) for name, where, *_ in readers}
        for row in set(rows):
            with self.subTest(row):
                self.assertLessEqual(rows.count(row), 2 if row in of_files else 1)

    def test_every_class_is_looked_at(self):
        concrete = {name for name, type_ in vars(conformalsom).items() if isinstance(type_, type)
                    and issubclass(type_, vtkAlgorithm) and not name.endswith("Writer")
                    and name != "vtkSurfaceFileReader"}
        self.assertEqual({writer.split(" with ")[0] for writer in self.written},
                         concrete - set(output_cases.UNTRIED_READERS))

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
                    if not vtkSMPTools.SetBackend(backend):
                        self.assertEqual(backend, "TBB")
                        self.skipTest("This VTK has no TBB, such as that of the wheel")
                    vtkSMPTools.Initialize(threads)
                    again = chain()
                    for name, bytes_ in expected.items():
                        self.assertEqual(all_bytes(again[name].GetOutput()), bytes_)
                    self.assertEqual(pixel_bytes(again), pixels)


if __name__ == "__main__":
    unittest.main()
