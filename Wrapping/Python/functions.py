"""Functions that make surfaces: learn(), conformal_map(), mean_shape() and read()."""
from __future__ import annotations

import typing

from conformalsom.filters import updated
from conformalsom.inputs import MeshLike, Path, PointsLike
from conformalsom.keywords import properties_of
from conformalsom.reporting import Progress
from conformalsom.surface import Surface


@properties_of("vtkConformalSOM")
def learn(points: PointsLike, *, progress: Progress = False, **properties: typing.Any) -> Surface:
    """Learn a closed surface with a map to the sphere from the points of a scan.

    points: an array of n x 3 numbers, a file, a vtkPointSet, a data set of PyVista, a mesh or cloud of trimesh
    or Open3D, or a pair of arrays (points, triangles). Contiguous arrays of 32 or 64 bit floats are not copied.
    progress: True for a bar, or a function that gets the completed fraction in [0, 1].

    Raises FileNotFoundError for a missing file, TypeError or ValueError for unsuitable arguments, and FilterFailed
    for points from which no surface can be learned, such as no points. Warnings are issued as FilterWarning, and
    are kept in the surface. Example:

        surface = conformalsom.learn(points, number_of_neurons=5000)
    """
    network, warnings = updated("vtkConformalSOM", [points], progress, properties)
    return Surface(network.GetOutput(), warnings=warnings)


@properties_of("vtkGlobalConformalMap")
def conformal_map(mesh: MeshLike, *, progress: Progress = False, **properties: typing.Any) -> Surface:
    """Map a closed surface of genus zero to the sphere. Points and triangles are kept.

    mesh: a surface, a file, a vtkPolyData, a mesh of PyVista, trimesh or Open3D, or a pair of arrays
    (points, triangles).
    progress: True for a bar, or a function that gets the completed fraction in [0, 1].

    Raises FileNotFoundError for a missing file, and FilterFailed if the surface is not closed or has handles. Example:

        surface = conformalsom.conformal_map((points, triangles))
    """
    mapped, warnings = updated("vtkGlobalConformalMap", [mesh], progress, properties)
    return Surface(mapped.GetOutput(), warnings=warnings)


@properties_of("vtkSphericalTemplate")
def mean_shape(surfaces: typing.Iterable[MeshLike], *, progress: Progress = False,
               **properties: typing.Any) -> Surface:
    """Register several surfaces with their mean, and return the mean.

    surfaces: mapped surfaces in one coordinate system.
    progress: True for a bar, or a function that gets the completed fraction in [0, 1].

    Raises FilterFailed if a surface has no valid map to the sphere. Example:

        mean = conformalsom.mean_shape([first, second, third])
    """
    template, warnings = updated("vtkSphericalTemplate", surfaces, progress, properties)
    return Surface(template.GetMeanSurface(), warnings=warnings)


def read(path: Path) -> Surface:
    """Read a surface that was saved with its map to the sphere, such as a .vtp file of Surface.save().

    Raises FileNotFoundError for a missing file, and FilterFailed or ValueError for a file that cannot be read.
    Example:

        surface = conformalsom.read("surface.vtp")
    """
    return Surface(path)
