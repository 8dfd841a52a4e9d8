"""Runs of every class of the package whose outputs record_outputs.py records.

CASES has one entry for each class; add_derived_cases() makes those that are not listed. The run `default`
sets no property but those that the class does not work without; it gets its input from the chain of
defaults that learns the built-in bear, or from a surface made by code. The run `small` sets sizes too, so
that it is fast, on inputs made by code. All other runs differ from `small` in what their names state: one
for each value of each enumeration, one for each switch, and those of CASES.
"""
import functools
import os
import re
import subprocess
import sys
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkObject, vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData, vtkTable
from vtkmodules.vtkParallelCore import vtkMultiProcessController

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "Examples", "Python"))
import conformalsom  # pylint: disable=wrong-import-position
from helpers.builtin_figure import figure_cloud  # pylint: disable=wrong-import-position
from helpers.clouds import cloud_of, points_of, vtk_points  # pylint: disable=wrong-import-position
from helpers.textures import numbered_grid  # pylint: disable=wrong-import-position
from samples import (  # pylint: disable=wrong-import-position
    GU_MESH, OFF_FILES, PCD, PLY_FILES, SCAN, TEXT_FILES, torus)
from conformalsom.messages import heard  # pylint: disable=wrong-import-position

# In place of three.js, whose version would change the bytes of pages.
THREE = os.path.join(HERE, "..", "Data", "ThreeStandIn.js")

SMALL_BEAR, BEAR = 3000, 20000  # numbers of points


def concrete_classes():
    """Classes of the package that can be instantiated, by name."""
    classes = {}
    for name, class_ in sorted(vars(conformalsom).items()):
        if isinstance(class_, type) and issubclass(class_, vtkObject):
            try:
                class_()
            except (TypeError, NotImplementedError):
                continue  # an abstract base class
            classes[name] = class_
    return classes


def methods_of(class_):
    """Names of the methods that a class has besides those of its base, also where Python derives from it."""
    return set(vars(getattr(sys.modules[class_.__module__], class_.__name__)))


def enumeration_values(class_):
    """Pairs of a property and a name of a value that is not its default."""
    for method in sorted(methods_of(class_)):
        match = re.fullmatch(r"Set([A-Z]\w*)To([A-Z]\w*)", method)
        if match:
            object_ = class_()
            default = getattr(object_, "Get" + match[1])()
            getattr(object_, method)()
            if getattr(object_, "Get" + match[1])() != default:
                yield match[1], match[2]


def switches(class_):
    """Properties that are on or off, with the value that is not the default: 0 or 1."""
    methods = methods_of(class_)
    for method in sorted(methods):
        match = re.fullmatch(r"([A-Z]\w*)On", method)
        if match and {match[1] + "Off", "Get" + match[1]} <= methods:
            yield match[1], 0 if getattr(class_(), "Get" + match[1])() else 1


# Processes of an MPI job. Without MPI there is one.

def ranks():
    """Number of this process, and how many there are."""
    controller = vtkMultiProcessController.GetGlobalController()
    return (controller.GetLocalProcessId(), controller.GetNumberOfProcesses()) if controller else (0, 1)


def of_first_rank(surface):
    return surface if ranks()[0] == 0 else vtkPolyData()


# Inputs.

@functools.lru_cache(maxsize=None)
def bear(count):
    """Points of the bear; of several processes each has its part of them, of unequal sizes."""
    begin, end = part_of_rank(count)
    return cloud_of(points_of(figure_cloud(count))[begin:end])


def part_of_rank(count):
    rank, number = ranks()
    cuts = [count * i * (i + 1) // (number * (number + 1)) for i in range(number + 1)]
    return cuts[rank], cuts[rank + 1]


def with_weights():
    """The small bear with the point array `Weight`."""
    cloud = vtkPolyData()
    cloud.DeepCopy(bear(SMALL_BEAR))
    add(cloud.GetPointData(), "Weight", 1.0 + np.arange(*part_of_rank(SMALL_BEAR)) % 3)
    return cloud


def add(data, name, values):
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(name)
    data.AddArray(array)
    return array


@functools.lru_cache(maxsize=None)
def octahedral_sphere(level):
    """Directions and triangles of an octahedron whose edges are halved `level` times."""
    points = [np.array(p, dtype=float) for p in (
        (1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))]
    triangles = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(level):
        middles = {}

        def middle(a, b):
            key = min(a, b), max(a, b)
            if key not in middles:
                middles[key] = len(points)
                points.append((points[a] + points[b]) / np.linalg.norm(points[a] + points[b]))
            return middles[key]
        triangles = [part for a, b, c in triangles for part in (
            (a, middle(a, b), middle(c, a)), (b, middle(b, c), middle(a, b)), (c, middle(c, a), middle(b, c)),
            (middle(a, b), middle(b, c), middle(c, a)))]
    return np.array(points), np.array(triangles)


def polygons(triangles):
    cells = vtkCellArray()
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(
        np.column_stack([np.full(len(triangles), 3), triangles]).ravel().astype(np.int64), deep=True))
    return cells


@functools.lru_cache(maxsize=None)
def mesh(level=4, bend=0.25):
    """A closed mesh of 4^(level + 1) + 2 points that bulges, without arrays."""
    n, triangles = octahedral_sphere(level)
    surface = vtkPolyData()
    x, y, z = n.T
    # Sums and products alone: the last bit of NumPy's powers and cosines differs from run to run.
    radius = 1.0 + bend * x * y + 0.2 * z * z * z + 0.2 * x * x * (1.0 - x * x) * (y - 0.5 * z)
    surface.SetPoints(vtk_points(n * radius[:, None] * (1.0, 0.8, 0.7) + (0.1, 0.0, -0.2)))
    surface.SetPolys(polygons(triangles))
    return surface


@functools.lru_cache(maxsize=None)
def mapped(level=4, bend=0.25, turn=0.0):
    """A mesh with its map to the sphere, rotated by `turn`, and with arrays of several types."""
    surface = vtkPolyData()
    surface.DeepCopy(mesh(level, bend))
    n, triangles = octahedral_sphere(level)
    c, s = np.cos(turn), np.sin(turn)
    data = surface.GetPointData()
    add(data, "SpherePosition", np.stack([c * n[:, 0] - s * n[:, 1], s * n[:, 0] + c * n[:, 1], n[:, 2]], axis=1))
    add(data, "Height", 1.5 + n[:, 1] + 0.3 * n[:, 2] * n[:, 2])
    add(data, "Label", (3.0 * n[:, 0] + 4.0).astype(np.int32))
    add(data, "Flow", np.stack([n[:, 1], -n[:, 0]], axis=1).astype(np.float32))
    add(data, "Seen", (n[:, 2] > -0.8).astype(np.uint8))
    data.SetScalars(add(data, "RGB", (127.5 * (n + 1.0)).astype(np.uint8)))
    add(surface.GetCellData(), "Part", (np.arange(len(triangles)) % 5).astype(np.int32))
    add(surface.GetFieldData(), "Density", np.array([2.5]))
    return surface


def with_holes():
    """A mesh with a hole, a second part, a polygon that faces the other way, and a point of no triangle."""
    n, triangles = octahedral_sphere(3)
    small, small_triangles = octahedral_sphere(1)
    triangles = np.array(triangles)
    triangles[100] = triangles[100][::-1]
    surface = vtkPolyData()
    surface.SetPoints(vtk_points(np.concatenate([n * (1.0, 0.8, 0.7), 3.0 + 0.1 * small, [[5.0, 5.0, 5.0]]])))
    surface.SetPolys(polygons(np.concatenate([triangles[7:], len(n) + small_triangles])))
    return surface


def fitted_mesh():
    """A mapped mesh with the arrays of a fitted mesh of vtkConformalSOM."""
    surface = vtkPolyData()
    surface.DeepCopy(mapped())
    add(surface.GetPointData(), "Supported", np.linspace(0.0, 1.0, surface.GetNumberOfPoints()))
    add(surface.GetFieldData(), "VertexShift", np.array([0.7]))
    return surface


def painted(split=False):
    """A mapped surface with texture coordinates, by vtkSphericalTextureMap."""
    texture = conformalsom.vtkSphericalTextureMap()
    texture.SetInputDataObject(0, mapped())
    texture.SetViewDirection(0, 0, 1)
    texture.SetViewUp(0, 1, 0)
    texture.SetProjectionToOctahedral()
    texture.SetSplitSeam(split)
    texture.Update()
    return texture.GetOutput()


@functools.lru_cache(maxsize=None)
def picture():
    return numbered_grid(48, 4)


def ball_volume(size=20):
    """A volume of a ball of 0.8 of its width, in [-1.2, 1.2]^3."""
    image, steps = vtkImageData(), np.linspace(-1.2, 1.2, size)
    image.SetDimensions(size, size, size)
    image.SetOrigin(-1.2, -1.2, -1.2)
    image.SetSpacing(*[2.4 / (size - 1)] * 3)
    radius = np.sqrt(steps[:, None, None]**2 + steps[None, :, None]**2 + steps**2)
    image.GetPointData().SetScalars(add(image.GetPointData(), "Brightness", 100.0 / (1.0 + np.exp(9.0 * (radius - 0.96)).ravel())))
    return image


def label_map(width=48):
    """A map of columns of labels, each six pixels wide."""
    image = vtkImageData()
    image.SetDimensions(width, width // 2, 1)
    image.GetPointData().SetScalars(add(image.GetPointData(), "Cells", (np.arange(width * width // 2) % width // 6).astype(np.int32)))
    return image


def outlines(scale=1.0):
    """Two triangles and a line in a map of 1000 by 500 pixels; one triangle crosses the right side."""
    data, points, polygons, lines = vtkPolyData(), vtkPoints(), vtkCellArray(), vtkCellArray()
    for cells, corners in ((polygons, ((300, 200), (420, 230), (350, 330))), (polygons, ((950, 200), (1040, 210), (990, 300))),
                           (lines, ((100, 100), (250, 380), (600, 300)))):
        cells.InsertNextCell(3)
        for x, y in corners:
            cells.InsertCellPoint(points.InsertNextPoint(scale * x, scale * y, 0.0))
    data.SetPoints(points)
    data.SetPolys(polygons)
    data.SetLines(lines)
    return data


def coefficients():
    """A table of harmonics up to degree 5, as vtkSurfaceHarmonics makes it."""
    table, rows = vtkTable(), [(l, m) for l in range(6) for m in range(-l, l + 1)]
    degree, order = np.array(rows, dtype=np.int32).T
    add(table.GetRowData(), "Degree", degree)
    add(table.GetRowData(), "Order", order)
    for name, axis in (("X", 1), ("Y", -1), ("Z", 0)):
        add(table.GetRowData(), name, np.where(
            (degree == 1) & (order == axis), 2.0, 0.1 * ((7 * degree + 3 * order) % 5 - 2.0) / (1.0 + degree)**2))
    return table


def measurements():
    """A table of two kinds of rows, with a column of their names."""
    table, numbers = vtkTable(), np.arange(240)
    for column in range(4):
        add(table.GetRowData(), f"Column{column}", 3.0 * (numbers % 2) + ((numbers * (7 + column)) % 31) / 31.0)
    kinds = vtkStringArray()
    kinds.SetName("Kind")
    for number in numbers:
        kinds.InsertNextValue("odd" if number % 2 else "even")
    table.AddColumn(kinds)
    return table


@functools.lru_cache(maxsize=None)
def chain():
    """The filters from the bear to its painted surface, with their defaults."""
    network, surface = conformalsom.vtkConformalSOM(), conformalsom.vtkCurvedSeamlessSurface()
    texture = conformalsom.vtkSphericalTextureMap()
    network.SetInputDataObject(0, bear(BEAR))
    surface.SetInputConnection(network.GetOutputPort())
    texture.SetInputConnection(surface.GetOutputPort())
    texture.Update()
    return {filter_.GetClassName(): filter_.GetOutput() for filter_ in (network, surface, texture)}


# Cases.

def inputs(*data, **properties):
    """A set-up: data for the ports, or functions that make it, and values of properties."""
    def set_up(object_):
        for port, item in enumerate(data):
            for one in item if isinstance(item, list) else [item]:
                object_.AddInputDataObject(port, one() if callable(one) else one)
        for name, value in properties.items():
            getattr(object_, "Set" + name)(*(value if isinstance(value, tuple) else (value,)))
    return set_up


def call(method, *arguments):
    return lambda object_: getattr(object_, method)(*arguments)


def several(*set_ups):
    def set_up(object_):
        for one in set_ups:
            one(object_)
    return set_up


def properties_of(**properties):
    return inputs(**properties)


class Outputs:
    """What a run made: data objects or bytes by name, and the number of warnings."""

    def __init__(self, made, warnings=0):
        self.made, self.warnings = made, warnings


class CaseFailed(RuntimeError):
    """A run ended with an error or without outputs."""


def updated(algorithm):
    with heard(algorithm) as messages:
        algorithm.Update()
    if messages.errors:
        raise CaseFailed(messages.errors[0])
    if algorithm.GetOutputDataObject(0).GetActualMemorySize() == 0 and ranks()[0] == 0:
        raise CaseFailed("the output is empty")
    return Outputs({f"port{port}": algorithm.GetOutputDataObject(port)
                    for port in range(algorithm.GetNumberOfOutputPorts())}, len(messages.warnings))


class Filter:
    """A filter or source: how it is set up by default, and how with small inputs."""

    def __init__(self, default, small=None, needs=None, others=None, on_ranks=False):
        self.set_up = {"default": default}
        self.small = small or default
        if small:
            self.set_up["small"] = small
        self.needs = needs or {}  # what else a value of an enumeration or a switch needs
        self.others = others or {}
        self.on_ranks = on_ranks

    def runs(self, class_):
        """Names of runs, each with a function of a folder that returns its Outputs."""
        set_ups = dict(self.set_up)
        for property_, value in enumeration_values(class_):
            set_ups[f"{property_}={value}"] = self.changed(
                f"{property_}={value}", call(f"Set{property_}To{value}"))
        for property_, value in switches(class_):
            set_ups[f"{property_}={value}"] = self.changed(
                f"{property_}={value}", call("Set" + property_, value))
        set_ups.update({name: several(self.small, change) for name, change in self.others.items()})
        return {name: functools.partial(self.run, class_, set_up) for name, set_up in set_ups.items()}

    def settings_of_no_run(self, class_):
        return sorted(set(self.needs) - set(self.runs(class_)))

    def changed(self, name, change):
        return several(self.small, self.needs.get(name, lambda object_: None), change)

    def run(self, class_, set_up, folder):
        del folder
        object_ = class_()
        set_up(object_)
        return updated(object_)


class Map(Filter):
    """vtkCurvedSeamlessMap, which is no algorithm: directions to the surface, derivatives, and back.

    Its properties are those of vtkCurvedSeamlessSurface.
    """

    def runs(self, class_):
        set_ups = {"default": self.small}
        for property_, value in enumeration_values(conformalsom.vtkCurvedSeamlessSurface):
            if property_ in ("SeamMode", "DomeHeight"):
                set_ups[f"{property_}={value}"] = call(f"Set{property_}To{value}")
        return {name: functools.partial(self.run, class_, set_up) for name, set_up in set_ups.items()}

    def run(self, class_, set_up, folder):
        map_, filter_ = class_(), conformalsom.vtkCurvedSeamlessSurface()
        # Shifted off the vertices of the mesh, where all domes are flat.
        directions = numpy_to_vtk(octahedral_sphere(3)[0] + (0.01, 0.02, 0.03), deep=True)
        with heard_object(map_) as errors:
            set_up(filter_)
            filter_.BuildMap(fitted_mesh(), bear(SMALL_BEAR), map_)
            result = vtkPolyData()
            arrays = {name: vtkDoubleArray() for name in (
                "positions", "normals", "derivatives", "metrics", "areas", "directions", "closest")}
            map_.ToSurface(directions, arrays["positions"], arrays["normals"])
            if filter_.GetDomeHeight() not in (filter_.PUBLISHED, filter_.SCALED):
                map_.Differentiate(directions, arrays["derivatives"], arrays["metrics"], arrays["areas"])
                map_.ToSphere(mapped().GetPoints().GetData(), arrays["directions"], arrays["closest"])
        if errors:
            raise CaseFailed(errors[0])
        for name, array in arrays.items():
            array.SetName(name)
            result.GetFieldData().AddArray(array)
        jumps = [0.0, 0.0]
        map_.GetNormalJumps(jumps)
        add(result.GetFieldData(), "jumps", np.array(jumps))
        add(result.GetFieldData(), "degenerate", np.array([map_.GetNumberOfDegeneratePatches()]))
        return Outputs({"map": result})


@functools.lru_cache(maxsize=None)
def mapped_torus():
    """A surface of genus 1 with its map to a flat torus."""
    conformal = conformalsom.vtkGlobalConformalMap()
    conformal.SetInputData(torus())
    conformal.Update()
    return conformal.GetOutput()


class Background(Filter):
    """vtkBackgroundUpdate, which is no algorithm: it updates a filter."""

    def runs(self, class_):
        return {"default": functools.partial(self.run, class_, self.small)}

    def run(self, class_, set_up, folder):
        update, filter_ = class_(), conformalsom.vtkGlobalConformalMap()
        filter_.SetInputData(mapped())
        set_up(update)
        update.Start(filter_)
        while update.IsRunning():
            time.sleep(0.001)
        update.Wait()
        if update.GetNumberOfErrors():
            raise CaseFailed(update.GetError(0))
        return Outputs({"updated": filter_.GetOutput()})


class heard_object:  # pylint: disable=invalid-name
    """Errors of an object that is no algorithm."""

    def __init__(self, object_):
        self.object_, self.errors, self.tags = object_, [], []

    def __enter__(self):
        self.tags = [self.object_.AddObserver("ErrorEvent", lambda *_: self.errors.append("an error")),
                     self.object_.AddObserver("WarningEvent", lambda *_: None)]
        return self.errors

    def __exit__(self, *_):
        for tag in self.tags:
            self.object_.RemoveObserver(tag)


class Writer(Filter):
    """A writer: the name of its file by default, and for others. All files that it makes are outputs."""

    def __init__(self, name, default, names=None, **rest):
        super().__init__(default, **rest)
        self.name, self.names = name, names or []

    def runs(self, class_):
        runs = super().runs(class_)
        for name in self.names:
            runs[name] = functools.partial(self.run, class_, several(self.small, call("SetFileName", name)))
        return runs

    def run(self, class_, set_up, folder):
        writer = class_()
        writer.SetFileName(self.name)
        set_up(writer)
        writer.SetFileName(os.path.join(folder, writer.GetFileName()))
        with heard(writer) as messages:
            written = writer.Write()
        if messages.errors or written != 1:
            raise CaseFailed((messages.errors + ["Write() returned 0"])[0])
        return Outputs({name: read_bytes(os.path.join(folder, name)) for name in sorted(os.listdir(folder))},
                       len(messages.warnings))


class Reader(Filter):
    """A reader: files by name for each run. The first of them is read, others lie beside it."""

    def __init__(self, files, change=None, changes=None, needs=None):
        super().__init__(lambda object_: None, needs=needs)
        self.files, self.change, self.changes = files, change, changes or {}

    def runs(self, class_):
        first = next(iter(self.files.values()))
        runs = {name: functools.partial(self.read, class_, files, name) for name, files in self.files.items()}
        for property_, value in switches(class_):
            name = f"{property_}={value}"
            runs[name] = functools.partial(
                self.read, class_, self.needs.get(name, first), name, call("Set" + property_, value))
        return runs

    def read(self, class_, files, name, more=None, folder=None):
        files = files(folder) if callable(files) else files
        for file_name, text in files.items():
            if text is not None:
                with open(os.path.join(folder, file_name), "wb") as file:
                    file.write(text if isinstance(text, bytes) else text.encode())
        reader = class_()
        reader.SetFileName(os.path.join(folder, next(iter(files))))
        for property_, file_name in self.changes.get(name, {}).items():
            getattr(reader, "Set" + property_)(
                os.path.join(folder, file_name) if property_.endswith("FileName") else file_name)
        if more:
            more(reader)
        outputs = updated(reader)
        if reader.GetErrorCode() != 0:
            raise CaseFailed(f"error code {reader.GetErrorCode()}")
        return outputs


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def written_by(class_name, name, data=None, **contents):
    """Files for a reader, made by a writer: one, or one for each keyword with that Content."""
    def write(folder):
        for content, file_name in (contents or {"": name}).items():
            writer = getattr(conformalsom, class_name)()
            writer.SetInputDataObject(0, (data or mapped)())
            writer.SetFileName(os.path.join(folder, file_name))
            if content:
                getattr(writer, "SetContentTo" + content)()
            if content in ("Curvature", "Shape") and hasattr(writer, "SetArrayName"):
                writer.SetArrayName("Height")
            if writer.Write() != 1:
                raise CaseFailed(f"{class_name} wrote no {file_name}")
        return {file_name: None for file_name in ([name] + sorted(set(os.listdir(folder)) - {name}))}
    return write


def sections():
    """A plate model: vertices and plates, counted from 1."""
    n, triangles = octahedral_sphere(2)
    rows = [f"{len(n)} {len(triangles)}"] + [f"{i + 1} {x:.9f} {y:.9f} {z:.9f}" for i, (x, y, z) in enumerate(n)]
    return "\n".join(rows + [f"{i + 1} {a + 1} {b + 1} {c + 1}" for i, (a, b, c) in enumerate(triangles)]) + "\n"


TURNED = functools.partial(mapped, 4, 0.2, 0.3)
SCANS = {"scans.conf": "bmesh scan.ply 0 0 0 0 0 0 1\nbmesh other.ply 1 2 3 0 0.6 0 0.8\n",
         "scan.ply": SCAN, "other.ply": SCAN}
TWO = [mapped, TURNED]
POSED = functools.partial(mapped, 4, 0.4)

CASES = {
    # Filters and sources.
    "vtkAdaptiveSphere": Filter(
        inputs(mapped), inputs(mapped, NumberOfPoints=700),
        needs={"Density=Array": properties_of(DensityArrayName="Height"),
               "Density=Image": inputs([], picture)}),
    "vtkBodyMap": Filter(
        inputs(mapped), others={"places": inputs([], torus), "axis": properties_of(
            Center=(0.05, 0.0, -0.1), RotationAxis=(1.0, 1.0, 2.0), GraticuleSpacing=30.0)},
        needs={"UseMarkerPoint=1": properties_of(MarkerPoint=(0.0, 1.0, 0.5))}),
    "vtkBodyMapImage": Filter(
        inputs(mapped, ArrayName="Height"), inputs(mapped, ArrayName="Height", ImageSize=(64, 32)),
        others={"label": properties_of(ArrayName="Label", CentralLongitude=70.0, GraticuleSpacing=0.0)}),
    "vtkMapLabels": Filter(inputs(mapped, label_map), inputs(mapped, label_map)),
    "vtkMapOutlines": Filter(inputs(mapped, outlines), inputs(mapped, outlines)),
    "vtkSurfaceLayers": Filter(
        inputs(mapped, ball_volume), inputs(mapped, ball_volume, ImageSize=(64, 32), DepthRange=(-0.2, 0.1))),
    "vtkVolumeSurfacePoints": Filter(
        inputs(ball_volume), inputs(ball_volume), needs={"LevelMethod=Fixed": properties_of(Level=40.0)}),
    "vtkConformalDistortion": Filter(inputs(lambda: chain()["vtkConformalSOM"]), inputs(mapped)),
    "vtkConformalSOM": Filter(
        inputs(lambda: bear(BEAR)),
        inputs(lambda: bear(SMALL_BEAR), NumberOfNeurons=812, NumberOfEpochs=20, SamplesPerEpoch=1000),
        needs={"StartingShape=Mesh": inputs([], lambda: of_first_rank(mapped())),
               "HullMethod=Distance": call("SetStartingShapeToHull"),
               "HullMethod=WindingNumbers": call("SetStartingShapeToHull"),
               **{f"ReferencePoint={point}": several(call("SetMeshTypeToGeodesic"), call("SetStartingShapeToSphere"))
                  for point in ("Conformal", "Winner", "Affine")}},
        others={
            "MeshType=Geodesic,TrainingMode=Online": several(
                call("SetMeshTypeToGeodesic"), call("SetTrainingModeToOnline")),
            "TrainingMode=Online,ReferencePoint=Affine": several(
                call("SetTrainingModeToOnline"), call("SetReferencePointToAffine")),
            "NumberOfNeurons=600": properties_of(NumberOfNeurons=600),
            "FitIterations=0": properties_of(FitIterations=0),
            "RandomSeed=2": properties_of(RandomSeed=2),
            "Smoothness=10": properties_of(Smoothness=10.0),
            **{f"PriorityArrayName,TrainingMode={mode}": several(
                lambda object_: object_.SetInputDataObject(0, with_weights()),
                properties_of(PriorityArrayName="Weight"), call("SetTrainingModeTo" + mode))
               for mode in ("Batch", "Online")}},
        on_ranks=True),
    "vtkBackgroundUpdate": Background(properties_of()),
    "vtkConsistentRemesh": Filter(
        inputs([*TWO, functools.partial(mapped, 4, 0.1)]),
        inputs([*TWO, functools.partial(mapped, 4, 0.1)], NumberOfPoints=700, Frequency=8)),
    "vtkCurvedSeamlessMap": Map(properties_of()),
    "vtkCurvedSeamlessSurface": Filter(
        inputs(lambda: chain()["vtkConformalSOM"]), inputs(fitted_mesh, Frequency=12),
        needs={"DomeHeight=Fitted": inputs([], [], lambda: bear(SMALL_BEAR))},
        others={"sphere": inputs([], mesh),
                "Sampling=Network,Subdivisions=3": several(
                    call("SetSamplingToNetwork"), properties_of(Subdivisions=3)),
                "DomeHeight=Fitted,SeamMode=PerTriangle": several(
                    inputs([], [], lambda: bear(SMALL_BEAR)), call("SetDomeHeightToFitted"),
                    call("SetSeamModeToPerTriangle")),
                "VertexShift=0.3": properties_of(VertexShift=0.3)}),
    "vtkDeformationTransfer": Filter(
        inputs(TURNED, mapped, POSED), others={"contacts": properties_of(ContactArrayName="Seen")}),
    "vtkGenusZeroCheck": Filter(inputs(mapped), others={"torus": lambda object_: object_.SetInputData(torus()),
                                                        "holes": lambda object_: object_.SetInputData(with_holes())}),
    "vtkGenusZeroHull": Filter(
        inputs(lambda: bear(BEAR)), inputs(lambda: bear(SMALL_BEAR), Spacing=0.08), on_ranks=True),
    "vtkTorusTextureMap": Filter(inputs(mapped_torus)),
    "vtkGenusZeroRepair": Filter(
        inputs(torus), others={"holes": lambda object_: object_.SetInputData(with_holes())}),
    "vtkGeodesicSphereSource": Filter(inputs(), inputs(Frequency=5)),
    "vtkGlobalConformalMap": Filter(
        inputs(mesh), others={"AreaBalance=0.5": properties_of(AreaBalance=0.5),
                              "AreaBalance=1": properties_of(AreaBalance=1.0),
                              "torus": lambda object_: object_.SetInputData(torus())}),
    "vtkSphericalAlignment": Filter(
        inputs(TURNED, mapped), others={"landmarks": several(*(call("AddLandmark", i, i) for i in (1, 4, 30, 99)))}),
    "vtkSphericalMorph": Filter(
        inputs(mapped, TURNED), inputs(mapped, TURNED, NumberOfPoints=700, Frequency=8),
        others={"weights": several(call("AddWeight", 1.0), call("AddWeight", 3.0))}),
    "vtkSphericalRegistration": Filter(
        inputs(TURNED, mapped), inputs(TURNED, mapped, Frequency=8),
        others={"landmarks": several(*(call("AddLandmark", i, i) for i in (1, 4, 30, 99))),
                "feature": call("AddFeature", "Height", 1.0)}),
    "vtkSphericalResample": Filter(
        inputs(functools.partial(mapped, 3, 0.1, 0.2), mapped), others={"mask": properties_of(MaskArrayName="Seen")}),
    "vtkSphericalTemplate": Filter(
        inputs(TWO), inputs(TWO, Frequency=8, MeanFrequency=8, MaximumNumberOfRounds=1)),
    "vtkSphericalTimeSeries": Filter(
        inputs(TWO), inputs(TWO, Frequency=8, NumberOfSweeps=0)),
    "vtkSphericalTextureBlend": Filter(
        inputs(painted, picture, picture, BackViewDirection=(0, 0, -1)),
        inputs(painted, picture, picture, BackViewDirection=(0, 0, -1), ImageSize=(48, 40))),
    "vtkSphericalTextureImage": Filter(
        inputs(painted), inputs(painted, ImageSize=(48, 40)),
        others={"ArrayName=Flow": properties_of(ArrayName="Flow"),
                "split seam": lambda object_: object_.SetInputDataObject(0, painted(True)),
                "source": inputs([], functools.partial(mapped, 3, 0.1))}),
    "vtkSphericalTextureMap": Filter(
        inputs(lambda: chain()["vtkCurvedSeamlessSurface"]), inputs(mapped),
        needs={"UseViewPoint=1": properties_of(ViewPoint=(0.2, 0.1, 3.0))},
        others={f"Projection={projection},SplitSeam=1": several(
            call("SetProjectionTo" + projection), call("SplitSeamOn"), properties_of(Margin=0.05, Rotation=20.0))
            for projection in ("LongitudeLatitude", "Octahedral", "CubeMap", "Disk", "Square")}),
    "vtkSurfaceHarmonics": Filter(
        inputs(mapped), inputs(mapped, Degree=6, Frequency=6),
        others={"arrays": several(call("AddPointArray", "Height"), call("AddPointArray", "Flow")),
                "reference": several(inputs([], coefficients), call("SetAlignmentToMapAndSurface")),
                "ReconstructionDegree=3": properties_of(ReconstructionDegree=3)}),
    "vtkSphericalSOM": Filter(
        inputs(measurements, LabelColumn="Kind"),
        others={"columns": several(call("AddColumn", "Column2"), call("AddColumn", "Column0")),
                "NumberOfNeurons=162": properties_of(NumberOfNeurons=162)}),
    "vtkSurfaceHarmonicsSource": Filter(
        inputs(coefficients), inputs(coefficients, Frequency=5),
        others={"ReconstructionDegree=2": properties_of(ReconstructionDegree=2)}),
    "vtkSurfaceMismatch": Filter(
        inputs(lambda: chain()["vtkSphericalTextureMap"], lambda: bear(BEAR)),
        inputs(mapped, lambda: bear(SMALL_BEAR), NumberOfSamples=2000),
        others={"surface": lambda object_: object_.SetInputDataObject(1, mapped(3, 0.1))}),
    "vtkSurfaceNormalMap": Filter(
        inputs(lambda: chain()["vtkSphericalTextureMap"], mapped),
        inputs(lambda: chain()["vtkSphericalTextureMap"], mapped, ImageSize=(48, 40))),
    "vtkSurfaceGeodesics": Filter(
        inputs(mapped, NumberOfFarthestPoints=2), inputs(mapped, NumberOfFarthestPoints=2),
        others={"picked": inputs([], torus)}),
    "vtkSurfaceShape": Filter(inputs(mapped), others={"scales": properties_of(CurvatureScale=0.1, DepthScale=0.2)}),

    # Writers.
    "vtkConformalOFFWriter": Writer("surface.off", inputs(painted)),
    "vtkConformalPLYWriter": Writer("surface.ply", inputs(painted)),
    "vtkTIFFStackWriter": Writer("stack.tif", inputs(ball_volume)),
    "vtkFreeSurferWriter": Writer("lh.white", inputs(painted, ArrayName="Height")),
    "vtkGIFTIWriter": Writer("surface.gii", inputs(painted), others={
        "AnatomicalStructure": properties_of(AnatomicalStructure="CortexLeft")}),
    "vtkGuMeshWriter": Writer("surface.m", inputs(painted)),
    "vtkSPHARMCoefficientWriter": Writer("surface.coef", inputs(coefficients)),
    "vtkSPHARMSurfaceWriter": Writer("a_surf.vtk", inputs(painted)),
    "vtkSurfacePageWriter": Writer(
        "page.html", inputs(functools.partial(painted, True), picture, ThreeJSFileName=THREE),
        others={"without picture": lambda object_: object_.SetInputDataObject(1, None)}),
    "vtkTextCloudWriter": Writer("cloud.xyz", inputs(painted)),
    "vtkTexturedSurfaceWriter": Writer(
        "surface.glb", inputs(functools.partial(painted, True), picture), names=["surface.obj", "surface.ply"]),

    # Readers.
    "vtkConformalOFFReader": Reader({
        "default": {"surface.off": OFF_FILES[0]},
        **{f"colors {i}": {"surface.off": text} for i, text in enumerate(OFF_FILES[1:])},
        "written": written_by("vtkConformalOFFWriter", "surface.off", painted)}),
    "vtkConformalPLYReader": Reader(
        {"default": {"surface.ply": PLY_FILES[0]}, "alpha": {"surface.ply": PLY_FILES[1]},
         "written": written_by("vtkConformalPLYWriter", "surface.ply", painted)}),
    "vtkFreeSurferReader": Reader(
        {"default": written_by("vtkFreeSurferWriter", "lh.white", Surface="lh.white"),
         "files beside": written_by("vtkFreeSurferWriter", "lh.white", Surface="lh.white", Sphere="lh.sphere",
                                    Curvature="lh.curv")},
        changes={"files beside": {"SphereFileName": "lh.sphere", "CurvatureFileName": "lh.curv"}}),
    "vtkGIFTIReader": Reader(
        {"default": written_by("vtkGIFTIWriter", "surface.gii"),
         "files beside": written_by("vtkGIFTIWriter", "a.surf.gii", Geometry="a.surf.gii", Sphere="a.sphere.gii",
                                    Shape="a.shape.gii")},
        changes={"files beside": {"SphereFileName": "a.sphere.gii", "ShapeFileName": "a.shape.gii"}}),
    "vtkGuMeshReader": Reader({"default": {"surface.m": GU_MESH},
                               "written": written_by("vtkGuMeshWriter", "surface.m", painted)}),
    "vtkPCDReader": Reader({f"{'default' if color == 'rgb' else color}": {"cloud.pcd": PCD.format(color=color)}
                            for color in ("rgb", "rgba")}),
    "vtkPlateModelReader": Reader({"default": {"body.tab": sections()}}),
    "vtkSPHARMCoefficientReader": Reader({
        "default": {"surface.coef": "{ 4,{1.5, 2, 3},{0.25, 0, 1},{-2, 0.5, 0},{1, 0, 0.125}}"},
        "written": written_by("vtkSPHARMCoefficientWriter", "surface.coef", coefficients)}),
    "vtkSPHARMSurfaceReader": Reader({"default": written_by("vtkSPHARMSurfaceWriter", "a_surf.vtk")}),
    "vtkStanfordScansReader": Reader({"default": SCANS, "missing scan": {
        "scans.conf": SCANS["scans.conf"] + "bmesh missing.ply 0 0 0 0 0 0 1\n", "scan.ply": SCAN, "other.ply": SCAN}}),
    "vtkTIFFStackReader": Reader({"default": written_by("vtkTIFFStackWriter", "stack.tif", ball_volume)}),
    "vtkTextCloudReader": Reader(
        {"default": {"cloud.xyz": TEXT_FILES[0]}, "normals": {"cloud.xyz": TEXT_FILES[1]},
         "colors": {"cloud.xyz": TEXT_FILES[2]},
         "written": written_by("vtkTextCloudWriter", "cloud.xyz", painted)},
        needs={"DecimalComma=1": {"cloud.csv": "0,5;1,25;2\n1,5;0;0\n"},
               "SkipMalformedLines=1": {"cloud.xyz": TEXT_FILES[3]}}),
}


DERIVED_READERS = []  # names of readers with a derived case
UNTRIED_READERS = []  # those of an installed package, which has no program that makes their files
READER_FILES = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(conformalsom.__file__)))),
                            "Testing", "Cases", "ReaderFiles")


def files_of_case(name):
    """Valid files of the case Testing/Cases/<name>.cxx of a reader, for each run of its own."""
    runs = {}
    with tempfile.TemporaryDirectory() as folder:
        listed = subprocess.run([READER_FILES, name, folder], check=True, capture_output=True, text=True).stdout
        for i, path in enumerate(listed.splitlines()):
            beside = sorted(set(os.listdir(os.path.dirname(path))) - {os.path.basename(path)})
            runs["default" if i == 0 else f"file {i}"] = {
                file: read_bytes(os.path.join(os.path.dirname(path), file))
                for file in [os.path.basename(path)] + beside}
    return runs


def add_derived_cases():
    """Add a case for each class without one.

    A filter gets mapped surfaces on all ports, a writer one mapped surface, a reader the files of its C++ case;
    their enumerations and switches are tried too.
    """
    for name, class_ in concrete_classes().items():
        if name in CASES:
            continue
        if name.endswith("Reader") and not os.path.exists(READER_FILES):
            UNTRIED_READERS.append(name)
        elif name.endswith("Reader"):
            DERIVED_READERS.append(name)
            CASES[name] = Reader(files_of_case(name))
        elif name.endswith("Writer"):
            CASES[name] = Writer("surface", inputs(painted))
        else:
            CASES[name] = Filter(inputs(*[mapped] * class_().GetNumberOfInputPorts()))


add_derived_cases()
