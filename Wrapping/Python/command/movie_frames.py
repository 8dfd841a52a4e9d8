"""Frames of a movie of a body: which there are, and a closed surface with a map to the sphere for each."""
import contextlib
import os
import re
import typing

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter

from conformalsom import (
    vtkBodyMap, vtkConformalSOM, vtkGlobalConformalMap, vtkSurfaceLayers, vtkVolumeSurfacePoints)
from conformalsom.messages import errors_outside, heard
from conformalsom.triangles import triangles_of

from . import cleaning, mapped_files, scan_files, shape_steps, volumes
from .steps import StepFailed

SPHERE = shape_steps.SPHERE
BRIGHTNESS = "LayerMean"


class Frame(typing.NamedTuple):
    """A frame: its file, the time in the file if that has several, and what to call it."""
    path: str
    time: float
    name: str


class Skipped(Exception):
    """A frame cannot be used; the text is the reason."""


def frames_of(paths):
    """All frames of files in their order, and pairs of path and interval of files with several frames."""
    frames, intervals = [], []
    for path in paths:
        if not volumes.is_volume(path):
            frames.append(Frame(path, 0.0, mapped_files.name_of(path)))
            continue
        times, name = [0.0], volumes.name_of(path)
        if os.path.isfile(path):
            reader = volumes.volume_reader(path)
            with heard(reader):  # errors are reported when the frame is read
                reader.UpdateInformation()
            times = volumes.times_of(reader)
        if len(times) == 1:
            frames.append(Frame(path, 0.0, name))
            continue
        intervals.append((path, times[1] - times[0]))
        digits = len(str(len(times) - 1))
        frames += [Frame(path, time, f"{name}_{k:0{digits}}") for k, time in enumerate(times)]
    return frames, intervals


def disorder_of(paths):
    """Two neighboring files whose numbers do not ascend, or None; also None unless paths differ in one number only."""
    rows = [re.split(r"([0-9]+)", path) for path in paths]  # texts between numbers, which have odd indices
    if len({len(row) for row in rows}) > 1:
        return None
    differing = [k for k, texts in enumerate(zip(*rows)) if len(set(texts)) > 1]
    if len(differing) != 1 or differing[0] % 2 == 0:
        return None
    numbers = [int(row[differing[0]]) for row in rows]
    return next(((paths[i], paths[i + 1]) for i in range(len(paths) - 1) if numbers[i] > numbers[i + 1]), None)


class Surfaces:
    """Surfaces of frames. Each frame that is learned starts from the surface of the frame before."""

    def __init__(self, options, steps):
        self.options, self.steps = options, steps
        self.last = None
        self.shift = None  # vector that is subtracted from coordinates of maps: that of the first surface
        self.unit = ""  # that of the first volume that has one
        self.channels = None  # number of channels of the first volume that can be used

    def of_all(self, frames):
        """The surface of each frame, or None for those that are skipped, of which there is a note."""
        found = []
        for frame in frames:
            try:
                found.append(self.of(frame))
                self.last = found[-1]
            except (StepFailed, Skipped, ValueError, OSError) as error:
                found.append(None)
                self.steps.note(frame.name, f"the frame is skipped: {error}")
        return found

    def of(self, frame):
        """The surface of a frame with its map to the sphere."""
        if volumes.is_volume(frame.path):
            return self.of_volume(frame)
        scan = scan_files.scan_reader(frame.path)
        with errors_outside() as broken:
            self.steps.run(f"Read {frame.name}", scan)
        data = cleaning.kept(scan.GetOutputDataObject(0), self.steps, f"Read {frame.name}")
        if broken or data.GetNumberOfPoints() == 0:
            raise Skipped(broken[0] if broken else "no points found")
        data = self.placed(data)
        if isinstance(data, vtkPolyData) and data.GetPointData().GetArray(SPHERE):
            return data
        if not shape_steps.is_closed(data, self.steps):
            return self.learned(data, frame)
        conformal = vtkGlobalConformalMap()
        conformal.SetInputData(data)
        conformal.SetAreaBalance(shape_steps.AREA_BALANCE)
        self.steps.run(f"Map {frame.name} to the sphere", conformal)
        return conformal.GetOutput()

    def placed(self, data):
        """A surface or cloud beside those of other frames: readers subtract a vector that depends on the file."""
        if self.shift is None:
            self.shift = scan_files.shift_of(data)
            scan_files.note_shift(data, self.steps)
        if (scan_files.shift_of(data) == self.shift).all():
            return data
        return scan_files.shifted_to(data, self.shift)

    def of_volume(self, frame):
        """The surface around the object in a volume."""
        volume, unit = volumes.read(frame.path, self.steps, f"Read {frame.name}", frame.time)
        channels = volume.GetNumberOfScalarComponents()
        self.expect_like_first(unit, channels)
        points = vtkVolumeSurfacePoints()
        points.SetInputData(volume)
        points.SetComponent(self.options.channel)
        self.steps.run(f"Find the outside of {frame.name}", points)
        if points.GetOutput().GetNumberOfPoints() == 0:
            raise Skipped("no object found")
        surface = self.with_brightness(self.learned(points.GetOutput(), frame), volume, frame)
        self.unit, self.channels = self.unit or unit, channels
        return surface

    def expect_like_first(self, unit, channels):
        """Raise Skipped unless unit and channels are those of the first volume; --unit replaces units of files."""
        if channels != (self.channels or channels):
            raise Skipped(f"it has {channels} channels instead of {self.channels}")
        if unit and self.unit and not self.options.unit and not volumes.is_same_unit(unit, self.unit):
            raise Skipped(f"its unit is {unit} instead of {self.unit}; convert the volume, or give --unit if the "
                          "coordinates of all volumes have that unit")

    def with_brightness(self, surface, volume, frame):
        """The surface with the mean brightness of its layers, which shows motion along the surface."""
        layers = vtkSurfaceLayers()
        layers.SetInputData(surface)
        layers.SetVolumeData(volume)
        layers.SetComponent(self.options.channel)
        if self.options.depths:
            layers.SetDepthRange(self.options.depths)
        layers.SetImageSize(1, 1)
        self.steps.run(f"Sample the brightness of {frame.name}", layers)
        return layers.GetOutput()

    def learned(self, points, frame):
        """The closed surface of points, learned from that of the frame before if that is near."""
        label = f"Learn the surface of {frame.name}"
        if self.last is not None:
            with contextlib.suppress(StepFailed):  # such as a body that has moved far
                return self.learned_from(points, label, self.last)
        return self.learned_from(points, label, None)

    def learned_from(self, points, label, start):
        """The closed surface of points, learned from a surface or from the sphere."""
        network = vtkConformalSOM()
        network.SetInputData(points)
        network.SetBorderToClosed()
        if start is not None:
            network.SetStartData(start)
        self.steps.run(label, network)
        return network.GetOutput()


def with_long_axis(surface, steps):
    """A surface, with its map to the sphere transformed so that the ends of its longest axis are the poles."""
    center, axes = principal_axes(surface)
    body = vtkBodyMap()
    body.SetInputData(surface)
    body.SetCenter(center)
    body.SetRotationAxis(axes[0])
    try:
        steps.run("Find the long axis", body)
    except StepFailed as error:  # the axis of a bent body may lie outside of it
        steps.note("Find the long axis", f"the map keeps its poles: {error}")
        return surface
    result = vtkPolyData()
    result.ShallowCopy(surface)
    result.GetPointData().AddArray(body.GetOutput().GetPointData().GetArray(SPHERE))
    return result


def principal_axes(surface):
    """The center of a surface, and rows of unit vectors along its principal axes, the longest first."""
    corners = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)[triangles_of(surface)]
    areas = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    middles = corners.mean(axis=1)
    center = areas @ middles / areas.sum()
    offsets = middles - center
    return center, np.linalg.eigh((offsets * areas[:, None]).T @ offsets)[1].T[::-1]


def area_and_volume(surface):
    """Area of a surface, and the volume inside."""
    triangles, mass = vtkTriangleFilter(), vtkMassProperties()
    triangles.SetInputData(surface)
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    return mass.GetSurfaceArea(), mass.GetVolume()
