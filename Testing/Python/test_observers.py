"""Readers and writers run with the inputs, properties and names they began with, whatever observers do.

Observers of their progress may set every property to another value, empty the inputs and empty the outputs:
the result has the same bits, and so have the files of writers. Testing/Cxx/TestObservers.cxx tries filters.
"""
import os
import tempfile
import unittest

from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
import numpy as np

import conformalsom
import output_cases
from conformalsom import (
    vtkConformalSOM, vtkGeodesicSphereSource, vtkSphericalTextureImage, vtkSphericalTextureMap, vtkSurfaceHarmonics)

FORMATS = {"ply": "ConformalPLY", "off": "ConformalOFF", "m": "GuMesh", "xyz": "TextCloud",
           "gii": "GIFTI", "white": "FreeSurfer", "vtk": "SPHARMSurface"}
WRITERS = {"glb": "TexturedSurface", "obj": "TexturedSurface", "html": "SurfacePage"}
PCD = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nPOINTS 4\nDATA ascii\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
PLATES = "4 4\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 3 2\n1 2 4\n2 3 4\n3 1 4\n"
SCANS = "bmesh one.ply 0 0 0 0 0 0 1\nbmesh two.ply 1 0 0 0 0 0 1\n"
THREE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "Data", "ThreeStandIn.js")


def surface(frequency=24):
    """An ellipsoid with its map, and with what makes it a texture's."""
    sphere = vtkGeodesicSphereSource()
    sphere.SetFrequency(frequency)
    sphere.Update()
    made = vtkPolyData()
    made.DeepCopy(sphere.GetOutput())
    points = vtk_to_numpy(made.GetPoints().GetData())
    points *= [1.0, 0.8, 0.6]
    weights = numpy_to_vtk(2.0 + points[:, 2], deep=1)
    weights.SetName("Weights")
    made.GetPointData().SetScalars(weights)
    texture = vtkSphericalTextureMap()
    texture.SetInputData(made)
    texture.SplitSeamOn()
    texture.SetProjectionToLongitudeLatitude()
    texture.Update()
    made.GetFieldData().ShallowCopy(texture.GetOutput().GetFieldData())
    return made


def cloud():
    """Without field data, which the executive passes to outputs before a run."""
    made = surface(12)
    made.GetFieldData().Initialize()
    return made


def picture():
    made = vtkImageData()
    made.SetDimensions(30, 20, 1)
    made.AllocateScalars(3, 3)  # unsigned char
    vtk_to_numpy(made.GetPointData().GetScalars())[:] = np.arange(1800).reshape(600, 3) % 251
    return made


def textured():
    texture = with_inputs(vtkSphericalTextureMap, surface(6), SplitSeam=True)
    texture.Update()
    return texture.GetOutput()


def with_inputs(cls, *inputs, **properties):
    algorithm = cls()
    for port, data in enumerate(inputs):
        algorithm.SetInputData(port, data)
    for name, value in properties.items():
        getattr(algorithm, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    return algorithm


def coefficients():
    harmonics = with_inputs(vtkSurfaceHarmonics, surface(), Degree=12)
    harmonics.Update()
    return harmonics.GetCoefficients()


def arrays_of(algorithm):
    """All that the outputs hold, by name."""
    found = {}
    outputs = [(port, algorithm.GetOutputDataObject(port))
               for port in range(algorithm.GetNumberOfOutputPorts())]
    outputs += [((port, block), data.GetBlock(block)) for port, data in outputs
                if isinstance(data, vtkMultiBlockDataSet) for block in range(data.GetNumberOfBlocks())]
    for port, data in outputs:
        groups = {"field": data.GetFieldData()}
        if isinstance(data, vtkDataSet):
            groups.update(points=data.GetPointData(), cells=data.GetCellData())
        if isinstance(data, vtkImageData):
            found[port, "size"] = data.GetDimensions()
        elif isinstance(data, vtkPolyData):
            found[port, "points"] = vtk_to_numpy(data.GetPoints().GetData()).tobytes()
            found[port, "polygons"] = vtk_to_numpy(
                data.GetPolys().GetConnectivityArray()).tobytes()
        for group, attributes in groups.items():
            for i in range(attributes.GetNumberOfArrays()):
                array = attributes.GetArray(i)
                found[port, group, attributes.GetAbstractArray(i).GetName()] = (
                    vtk_to_numpy(array).tobytes() if array else attributes.GetAbstractArray(i).GetSize())
        if hasattr(data, "GetRowData"):
            rows = data.GetRowData()
            for i in range(rows.GetNumberOfArrays()):
                found[port, "rows", rows.GetArrayName(i)] = vtk_to_numpy(rows.GetArray(i)).tobytes()
    return found


def other_values(value):
    """Some that differ, in the order in which to try them."""
    if isinstance(value, bool):
        return [not value]
    if isinstance(value, int):
        return [value + 1, value - 1]
    if isinstance(value, float):
        return [0.7 * value + 0.1, 0.5 * value]
    if isinstance(value, str):
        return ["other"]
    if isinstance(value, tuple):
        return [tuple(other_values(v)[0] for v in reversed(value))]
    return []


def change_properties(algorithm):
    """Set all to other values. Returns their names."""
    changed = []
    for base in type(algorithm).__mro__:
        if not base.__module__.startswith("conformalsom"):
            continue
        for method in vars(base):
            getter = getattr(algorithm, "Get" + method[len("Set"):], None)
            if not method.startswith("Set") or not getter or method.endswith(("Connection", "Data")):
                continue
            before = getter()
            for value in other_values(before):
                if getter() == before:
                    getattr(algorithm, method)(*(value if isinstance(value, tuple) else (value,)))
            if getter() != before:
                changed.append(method)
    return changed


def change_names(algorithm):
    """Clear all that are set, and let go of the controller."""
    for name in ("FileName", "SphereFileName", "CurvatureFileName", "ShapeFileName"):
        if hasattr(algorithm, "Set" + name):
            getattr(algorithm, "Set" + name)(None)
    for name in ("ArrayName", "AnatomicalStructure", "ColorArrayName", "ThreeJSFileName"):
        if hasattr(algorithm, "Set" + name):
            getattr(algorithm, "Set" + name)("")
    if hasattr(algorithm, "SetController"):
        algorithm.SetController(None)


def empty_inputs(algorithm):
    for port in range(algorithm.GetNumberOfInputPorts()):
        if algorithm.GetNumberOfInputConnections(port):
            algorithm.GetInputDataObject(port, 0).Initialize()


def empty_outputs(algorithm):
    for port in range(algorithm.GetNumberOfOutputPorts()):
        algorithm.GetOutputDataObject(port).Initialize()


def run(algorithm, disturb=None, at=0.0, number=None):
    """Disturb it at its first report of such a progress, or at the report of a number. The first report of
    all and those of 1 may be the executive's, before and after the run. Returns whether there was a report
    to disturb."""
    count = 0
    done = False

    def hear(caller, _):
        nonlocal count, done
        count += 1
        is_due = count == number if number else count > 1 and at <= caller.GetProgress() < 1.0
        if disturb and not done and is_due:
            done = True
            disturb(algorithm)

    algorithm.AddObserver("ProgressEvent", hear)
    if hasattr(algorithm, "Write"):
        algorithm.Write()
    else:
        algorithm.Update()
    return done


class TestObservers(unittest.TestCase):

    def expect_undisturbed(self, make, result, disturbances):
        reference = make()
        run(reference)
        expected = result(reference)
        self.assertTrue(expected)
        for disturb in disturbances:
            for at in (0.0, 0.4, 0.8):
                with self.subTest(disturb.__name__, at=at):
                    algorithm = make()
                    self.assertTrue(run(algorithm, disturb, at) or at > 0.0)
                    got = result(algorithm)
                    self.assertEqual({key for key in expected if got.get(key) != expected[key]}, set())
                    self.assertEqual(set(got), set(expected))

    def expect_undisturbed_at_every_report(self, make, result, disturbances):
        """From the second on: the first may be the executive's."""
        reference = make()
        count = 0

        def hear(*_):
            nonlocal count
            count += 1

        reference.AddObserver("ProgressEvent", hear)
        run(reference)
        self.assertGreater(count, 1)
        expected = result(reference)
        self.assertTrue(expected)
        for disturb in disturbances:
            for number in range(2, count + 1):
                with self.subTest(disturb.__name__, number=number):
                    algorithm = make()
                    self.assertTrue(run(algorithm, disturb, number=number))
                    self.assertEqual(result(algorithm), expected)

    def test_properties_are_found(self):
        changed = change_properties(vtkSphericalTextureImage())
        self.assertEqual(set(changed), {"SetArrayName", "SetImageSize", "SetSampling"})
        self.assertGreater(len(change_properties(vtkConformalSOM())), 12)

    @unittest.skipUnless(hasattr(vtkTrivialProducer, "SetAbortExecuteAndUpdateTime"),
                         "this VTK has no aborts that pass downstream")
    def test_a_wish_that_the_source_stops_is_heard(self):
        source = vtkTrivialProducer()
        source.SetOutput(cloud())
        network = vtkConformalSOM()
        network.SetInputConnection(source.GetOutputPort())
        network.AddObserver(
            "ProgressEvent", lambda *_: source.SetAbortExecuteAndUpdateTime())
        network.Update()
        self.assertEqual(network.GetOutput().GetNumberOfPoints(), 0)
        network.RemoveObservers("ProgressEvent")
        source.SetAbortExecute(0)
        network.Update()
        self.assertGreater(network.GetOutput().GetNumberOfPoints(), 0)

    def test_readers_and_writers_keep_what_they_began_with(self):
        with tempfile.TemporaryDirectory() as folder:
            for ending, name in FORMATS.items():
                path = os.path.join(folder, "a." + ending)

                def writer():
                    return with_inputs(
                        getattr(conformalsom, "vtk%sWriter" % name), surface(20), FileName=path)

                def reader():
                    return with_inputs(getattr(conformalsom, "vtk%sReader" % name), FileName=path)

                def content(_):
                    with open(path, "rb") as file:
                        written = file.read()
                    os.remove(path)
                    return {"file": written}

                with self.subTest(name):
                    self.expect_undisturbed(writer, content, (change_properties, empty_inputs))
                    run(writer())
                    self.expect_undisturbed(reader, arrays_of, (change_properties, empty_outputs))

    def test_every_reader_and_writer_keeps_its_names(self):
        tried = set()
        with tempfile.TemporaryDirectory() as folder:
            def path(name):
                return os.path.join(folder, name)

            def expect_kept(make, result):
                tried.add(make().GetClassName())
                with self.subTest(make().GetClassName(), file=make().GetFileName()):
                    self.expect_undisturbed_at_every_report(make, result, (change_names, change_properties))

            def expect_reader_kept(name, file, **properties):
                cls = getattr(conformalsom, "vtk%sReader" % name)
                expect_kept(lambda: with_inputs(cls, FileName=path(file), **properties), arrays_of)

            def expect_writer_kept(name, file, *inputs, **properties):
                cls = getattr(conformalsom, "vtk%sWriter" % name)

                def contents(_):
                    found = {}
                    for written in os.listdir(folder):
                        if written.startswith(file.split(".")[0]):
                            with open(path(written), "rb") as opened:
                                found[written] = opened.read()
                            os.remove(path(written))
                    return found

                expect_kept(lambda: with_inputs(cls, *inputs, FileName=path(file), **properties), contents)

            def write(name, file, *inputs, **properties):
                with_inputs(getattr(conformalsom, "vtk%sWriter" % name), *inputs,
                            FileName=path(file), **properties).Write()

            mapped = surface(6)
            for ending, name in FORMATS.items():
                write(name, "read." + ending, mapped)
                expect_reader_kept(name, "read." + ending)
                expect_writer_kept(name, "written." + ending, mapped)
            for ending, name in WRITERS.items():
                three = {"ThreeJSFileName": THREE} if ending == "html" else {}
                expect_writer_kept(name, "written." + ending, textured(), picture(), **three)
            for content in (1, 2):
                write("FreeSurfer", "read.%d" % content, mapped, Content=content, ArrayName="Weights")
            expect_reader_kept("FreeSurfer", "read.white", SphereFileName=path("read.1"),
                               CurvatureFileName=path("read.2"))
            for content in (1, 2, 3):
                write("GIFTI", "read.%d.gii" % content, mapped, Content=content)
            expect_reader_kept("GIFTI", "read.1.gii", SphereFileName=path("read.2.gii"),
                               ShapeFileName=path("read.3.gii"))
            for file, text in (("read.pcd", PCD), ("read.tab", PLATES), ("read.conf", SCANS)):
                with open(path(file), "w") as opened:
                    opened.write(text)
            for scan in ("one.ply", "two.ply"):
                write("ConformalPLY", scan, mapped)
            expect_reader_kept("PCD", "read.pcd")
            expect_reader_kept("PlateModel", "read.tab")
            expect_reader_kept("StanfordScans", "read.conf")
            for name in output_cases.DERIVED_READERS:
                files = output_cases.CASES[name].files["default"]
                for file, bytes_ in files.items():
                    with open(path(file), "wb") as opened:
                        opened.write(bytes_)
                expect_reader_kept(name[len("vtk"):-len("Reader")], next(iter(files)))
            table = coefficients()
            write("SPHARMCoefficient", "read.coef", table)
            expect_reader_kept("SPHARMCoefficient", "read.coef")
            expect_writer_kept("SPHARMCoefficient", "written.coef", table)
            write("TIFFStack", "read.tif", picture())
            expect_reader_kept("TIFFStack", "read.tif")
            expect_writer_kept("TIFFStack", "written.tif", picture())
        for name in dir(conformalsom):
            if name.startswith("vtk") and name.endswith(("Reader", "Writer")):
                cls = getattr(conformalsom, name)
                if not cls.__module__.startswith("conformalsom"):
                    continue
                self.assertTrue(name in (*tried, *output_cases.UNTRIED_READERS) or name.startswith("vtkSurfaceFile"), name)


if __name__ == "__main__":
    vtkObject.GlobalWarningDisplayOff()
    unittest.main()
