"""Functions that make surfaces: learn(), conformal_map(), surface_from_volume(), time_series(), mean_shape(), read()."""
from __future__ import annotations

import typing

from vtkmodules.vtkCommonDataModel import vtkPolyData

from conformalsom.filters import updated
from conformalsom.inputs import (
    MeshLike, Path, PointsLike, VolumeLike, expect_several, mark_landmarks, own_data, point_set, volume_of)
from conformalsom.keywords import properties_of
from conformalsom.reporting import Progress
from conformalsom.surface import Array, Surface, columns_of


@properties_of("vtkConformalSOM")
def learn(points: PointsLike, *, progress: Progress = False, **properties: typing.Any) -> Surface:
    """Learn a closed surface with a map to the sphere from the points of a scan.

    points: an array of n x 3 numbers, a file, a vtkPointSet, a data set of PyVista, a mesh or cloud of trimesh
    or Open3D, or a pair of arrays (points, triangles). Contiguous arrays of 32 or 64 bit floats are not copied.
    progress: True for a bar, or a function that gets the completed fraction in [0, 1].

    Raises FileNotFoundError for a missing file, TypeError or ValueError for unsuitable arguments, and FilterFailed
    for points from which no surface can be learned, such as no points, or an option that the filter refuses.
    Warnings are issued as FilterWarning, and are kept in the surface. Example:

        surface = conformalsom.learn(points, number_of_neurons=5000)
    """
    network, warnings = updated("vtkConformalSOM", [points], progress, properties,
                                reworded={"set Border to CLOSED": 'pass border="Closed"', "Border OPEN": 'border="Open"'})
    return Surface.of_output(network.GetOutput(), warnings)


@properties_of("vtkGlobalConformalMap")
def conformal_map(mesh: MeshLike, *, progress: Progress = False, **properties: typing.Any) -> Surface:
    """Map a closed surface of genus zero to the sphere, or of genus 1 to a flat torus. Points and triangles are kept.

    mesh: a surface, a file, a vtkPolyData, a mesh of PyVista, trimesh or Open3D, or a pair of arrays
    (points, triangles). Arrays are copied.
    progress: True for a bar, or a function that gets the completed fraction in [0, 1].

    Raises FileNotFoundError for a missing file, and FilterFailed if the surface has faults or several handles. A
    surface with a border is mapped to a hemisphere. A surface of genus 1 has the point array "TorusPosition" and no
    sphere. Maps that are registered later need area_balance=0.5 if the surface has limbs. Example:

        surface = conformalsom.conformal_map((points, triangles))
    """
    texts: typing.List[str] = []
    mapped, warnings = updated("vtkGlobalConformalMap", [own_data(mesh, texts)], progress, properties)
    return Surface.of_output(mapped.GetOutput(), [*texts, *warnings])


@properties_of("vtkVolumeSurfacePoints")
def surface_from_volume(volume: VolumeLike, *, spacing: typing.Optional[typing.Sequence[float]] = None,
                        start: typing.Optional[MeshLike] = None, progress: Progress = False,
                        **properties: typing.Any) -> Surface:
    """Learn a closed surface with a map to the sphere from the outside of an object in a volume.

    volume: a file (TIFF stack of ImageJ, NIfTI, MetaImage, NRRD, VTI), a vtkImageData, or an array of slices x rows
    x columns, or slices x rows x columns x channels.
    spacing: of an array: size of a voxel along x (columns), y (rows) and z (slices). The coordinates of the surface
    are in its unit, and the first voxel is at (0, 0, 0). Default is (1, 1, 1). Files and vtkImageData have a spacing of
    their own, and with spacing they raise ValueError.
    start: surface from which learning starts, such as that of the frame before; default is none.
    progress: True for a bar, or a function that gets the completed fraction in [0, 1], once for each of two filters.

    Raises FileNotFoundError for a missing file, TypeError or ValueError for unsuitable arguments, and FilterFailed
    for a volume without an object. Example:

        surface = conformalsom.surface_from_volume(volume, spacing=(0.3, 0.3, 1.0))
    """
    texts: typing.List[str] = []
    image = volume_of(volume, spacing, texts)
    points, warnings = updated("vtkVolumeSurfacePoints", [image], progress, properties, lambda data, _: data)
    learning = {"border": "Closed", "start": start}
    network, more = updated("vtkConformalSOM", [points.GetOutput()], progress, learning)
    return Surface.of_output(network.GetOutput(), [*texts, *warnings, *more])


class TimeSeries(typing.NamedTuple):
    """A body over time, made by time_series().

    surfaces: a surface for each time step. Points of the body have the same position on the sphere at all times. Point
    arrays "Velocity", "NormalVelocity", "TangentialVelocity", "AreaRate" and "ShearRate" are the motion.
    table: columns with a number or text for each time step, by name, such as "Time", "State", "RelativeArea" and
    "MeanAreaRate"; see conformalsom.vtkSphericalTimeSeries.
    """
    surfaces: typing.List[Surface]
    table: typing.Dict[str, Array]


@properties_of("vtkSphericalTimeSeries")
def time_series(surfaces: typing.Iterable[MeshLike], *, progress: Progress = False,
                **properties: typing.Any) -> TimeSeries:
    """Make the maps of a body that moves and deforms correspond, and compute its motion.

    surfaces: mapped surfaces in one coordinate system, in the order of time.
    progress: True for a bar, or a function that gets the completed fraction in [0, 1].

    Returns a surface for each time step, and a table. With time_interval in seconds, velocities are in units of
    length per second. A surface that cannot be used is skipped with a warning; the result is then interpolated. Raises
    ValueError if there is no surface, and FilterFailed if that of reference_step cannot be used. Example:

        series = conformalsom.time_series([first, second, third], time_interval=30.0)
    """
    texts: typing.List[str] = []
    data = [own_data(surface, texts) for surface in expect_some(surfaces)]
    algorithm, warnings = updated("vtkSphericalTimeSeries", data, progress, properties)
    table = columns_of(algorithm.GetTable())
    steps = []
    for time in table.get("Time", ()):
        algorithm.UpdateTimeStep(time)
        step = vtkPolyData()
        step.ShallowCopy(algorithm.GetOutput())
        steps.append(Surface.of_output(step, [*texts, *warnings]))
    return TimeSeries(steps, table)


@properties_of("vtkSphericalTemplate")
def mean_shape(surfaces: typing.Iterable[MeshLike], *,
               landmarks: typing.Optional[typing.Sequence[typing.Sequence[int]]] = None, progress: Progress = False,
               **properties: typing.Any) -> Surface:
    """Register several surfaces with their mean, and return the mean.

    surfaces: mapped surfaces.
    landmarks: for each surface, ids of its landmarks. Point k of each list corresponds to point k of the others.
    progress: True for a bar, or a function that gets the completed fraction in [0, 1].

    Raises ValueError if there is no surface or if landmarks do not fit the surfaces, and FilterFailed if a surface has
    no valid map to the sphere. Example:

        mean = conformalsom.mean_shape([first, second, third])
    """
    texts: typing.List[str] = []
    data = [point_set(surface, texts) for surface in expect_some(surfaces)]
    if landmarks is not None:
        properties["landmark_array_name"] = mark_landmarks(data, landmarks)
    template, warnings = updated("vtkSphericalTemplate", data, progress, properties)
    return Surface.of_output(template.GetMeanSurface(), [*texts, *warnings])


def expect_some(surfaces: typing.Iterable[MeshLike]) -> typing.List[MeshLike]:
    """Return surfaces as a list. Raises ValueError if there is none, and TypeError for one surface instead of a list."""
    expect_several(surfaces)
    found = list(surfaces)
    if not found:
        raise ValueError("expected one surface or more, but there is none")
    return found


def read(path: Path) -> Surface:
    """Read a surface that was saved with its map to the sphere, such as a .vtp file of Surface.save().

    Raises FileNotFoundError for a missing file, and FilterFailed or ValueError for a file that cannot be read.
    Example:

        surface = conformalsom.read("surface.vtp")
    """
    return Surface(path)
