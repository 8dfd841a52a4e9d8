"""Steps of a study of shapes. Each runs in a process of its own, and keeps its result in a file.

The name of such a file is a hash of what the step is made of. A step whose file exists is not done again.
"""
import hashlib
import json
import os
import typing

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import conformalsom
from conformalsom import (
    vtkConformalSOM, vtkConsistentRemesh, vtkGenusZeroCheck, vtkGlobalConformalMap, vtkSphericalRegistration)

from . import outputs, scan_files, shape_landmarks
from .plan import Paths

SPHERE = "SpherePosition"
AREA_BALANCE = 0.5  # gives limbs area on the sphere
MEAN_FREQUENCY = 45  # of means to register with, as in vtkSphericalTemplate
AMBIGUITY = "two correspondences are about equally good"  # begin of a warning, which names a port of the filter
TARGETS = ("TargetPointIds", "TargetBarycentric", "TargetCellId")  # of registrations, not of shapes


class Step(typing.NamedTuple):
    """What makes one file from others."""
    kind: str
    scan: str  # what messages call it
    sources: typing.Tuple[str, ...]
    paths: Paths
    token: str
    work: str  # name of the folder
    landmarks: typing.Tuple = ()  # of sources: coordinates of each landmark

    @property
    def file(self):
        """The file that keeps the result."""
        return self.paths.surfaces[0]


def hash_of(*parts):
    """A name for what is made of these parts."""
    return hashlib.sha256(json.dumps([conformalsom.__version__, AREA_BALANCE, MEAN_FREQUENCY, *parts]).encode()).hexdigest()[:32]


def content_of(path):
    """A hash of a scan: of all files that its reader reads."""
    total = hashlib.sha256()
    for name in scan_files.inputs_of(path):
        with open(name, "rb") as file:
            data = file.read()
        total.update(b"%d " % len(data) + data)
    return total.hexdigest()


def step_of(kind, scan, sources, work, *settings, landmarks=()):
    """The step that makes a file from others; names of files in the folder of the work are their hashes."""
    settings += (landmarks,) if landmarks else ()
    known = [content_of(source) if kind == "map" else os.path.basename(source) for source in sources]
    path = os.path.join(work, f"{kind}-{hash_of(kind, known, *settings)}.vtp")
    return Step(kind, scan, tuple(sources), Paths([path], ""), outputs.new_token(), work, landmarks)


def make(step, options, _, steps):
    """Do a step; returns an entry of a report, and no table."""
    result = {"map": mapped, "register": registered, "mean": mean}[step.kind](step, options, steps)
    writer = outputs.writer_of(step.file, painted=False)
    writer.SetInputData(result)
    outputs.write(steps, writer, step.file, step.token)
    entry = {"Scan": step.scan, "Surface": {"NumberOfPoints": result.GetNumberOfPoints()}, "Seconds": steps.seconds,
             "Warnings": steps.warnings}
    return entry, ""


def read(steps, path):
    """The surface of a file of the work."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    steps.run(f"Read {path}", reader)
    return reader.GetOutput()


def mapped(step, _, steps):
    """A scan's closed surface with a map to the sphere, and with the vector that the reader subtracted, for landmarks."""
    scan, data = scan_files.read(step.scan, steps)
    if data.GetNumberOfPoints() == 0:
        raise ValueError(f"{step.scan}: no points found")
    has_shift = hasattr(scan, "GetShiftCoordinates")  # else the array is of the file, as are the landmarks
    return scan_files.with_shift(surface_of(data, steps), scan_files.shift_of(data) if has_shift else (0.0, 0.0, 0.0))


def surface_of(data, steps):
    """A closed surface with a map to the sphere: that of a scan, or else a learned one."""
    if isinstance(data, vtkPolyData) and data.GetPointData().GetArray(SPHERE):
        return data
    if not is_closed(data, steps):
        network = vtkConformalSOM()
        network.SetInputData(data)
        network.SetBorderToClosed()
        steps.run("Learn the mesh", network)
        data = network.GetOutput()
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(data)
    conformal.SetAreaBalance(AREA_BALANCE)
    steps.run("Map to the sphere", conformal)
    return conformal.GetOutput()


def is_closed(data, steps):
    """Whether triangles form one closed surface without handles."""
    if not isinstance(data, vtkPolyData) or data.GetNumberOfPolys() + data.GetNumberOfStrips() == 0:
        return False
    check = vtkGenusZeroCheck()
    check.SetInputData(data)
    steps.run("Check the surface", check)
    return number(check.GetOutput(), "IsGenusZero") == 1


def number(data, name):
    """A number of the field data."""
    return data.GetFieldData().GetArray(name).GetTuple(0)[0]


def registered(step, _, steps):
    """The first source, with its map registered with that of the second."""
    moving, fixed = (read(steps, path) for path in step.sources)
    registration = vtkSphericalRegistration()
    registration.SetInputData(moving)
    registration.SetInputData(1, fixed)
    if step.landmarks:
        shape_landmarks.add_to(registration, moving, fixed, step)
    steps.run("Register", registration, known=lambda text: text.startswith(AMBIGUITY))
    surface = registration.GetOutput()
    if number(surface, "Ambiguous"):
        steps.note("Register", f"{AMBIGUITY}, such as head and tail of similar shape; inspect the surface, or add landmarks "
                               "by --landmarks")
    for name in TARGETS:
        surface.GetPointData().RemoveArray(name)
    return surface


def remeshed(sources, options, steps, label):
    """The filter that puts surfaces on one mesh."""
    remesh = vtkConsistentRemesh()
    for path in sources:
        remesh.AddInputDataObject(read(steps, path))
    getattr(remesh, "SetAlignmentTo" + options.alignment.capitalize())()
    remesh.SetMeshTypeToGeodesic()
    remesh.SetFrequency(MEAN_FREQUENCY)
    remesh.SetNumberOfModes(len(sources))
    if label == "Find the modes":
        remesh.SetMeshTypeToAdaptive()
        remesh.SetNumberOfPoints(options.points)
    steps.run(label, remesh)
    return remesh


def mean(step, options, steps):
    """The mean of the sources, with the number of the source that is closest to it as field data."""
    remesh = remeshed(step.sources, options, steps, "Find the mean")
    shape = remesh.GetMeanSurface()
    closest = vtkPolyData()
    closest.CopyStructure(shape)
    closest.GetPointData().AddArray(shape.GetPointData().GetArray(SPHERE))
    array = vtk_numbers([closest_to_mean(remesh)], "ClosestSurface")
    closest.GetFieldData().AddArray(array)
    if step.landmarks:
        surfaces = (read(steps, path) for path in step.sources)
        closest.GetFieldData().AddArray(shape_landmarks.mean_positions(closest, surfaces, step, SPHERE))
    return closest


def closest_to_mean(remesh):
    """The number of the surface with the smallest scores, in the sense of vtkSphericalTemplate."""
    squares = scores_of(remesh)**2 @ shares_of(remesh)
    return int(np.flatnonzero(squares <= squares.min() * (1 + 1e-6))[0])


def closest_of(path):
    """The number of the surface that is closest to a mean, which a file keeps."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return int(number(reader.GetOutput(), "ClosestSurface"))


def shares_of(remesh):
    """Fractions of the variance that the modes explain; none if all shapes are equal."""
    array = remesh.GetMeanSurface().GetFieldData().GetArray("ExplainedVariance")
    return vtk_to_numpy(array) if array else np.empty(0)


def scores_of(remesh):
    """Scores of all blocks: #surfaces by #modes, in standard deviations."""
    blocks = remesh.GetOutput()
    arrays = [blocks.GetBlock(i).GetFieldData().GetArray("ShapeScores") for i in range(blocks.GetNumberOfBlocks())]
    return np.array([vtk_to_numpy(array).ravel() if array else [] for array in arrays])


def vtk_numbers(values, name):
    """Numbers as an array of VTK."""
    array = numpy_to_vtk(np.asarray(values, dtype=float), deep=True)
    array.SetName(name)
    return array
