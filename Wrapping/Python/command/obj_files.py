"""Read scans from .obj files.

VTK's reader repeats the coordinate of the line before where one cannot be read. It gives each corner of a polygon a
point of its own where texture coordinates differ, and before VTK 9.6 drops colors.
"""
import array
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .cleaning import cells_of
from .python_reader import PythonReader

FLOAT_SHIFT = 1e-5  # of the size, by which floats may shift points


def read(path):
    """The surface or cloud of a file, and a warning or an empty text.

    Raises ValueError with the number of a line that cannot be read, and OSError.
    """
    rows = Rows()
    with open(path, encoding="latin-1") as file:  # which every file is
        rows.read(file)
    return rows.data(), rows.warning()


def logical_lines(file):
    """Numbers of lines and their words. Lines that end in a backslash continue; comments are left out."""
    lines = enumerate(file, 1)
    for number, line in lines:
        while line.endswith("\\\n"):
            line = line[:-2] + " " + next(lines, (0, ""))[1]
        if "#" in line:
            line = line.partition("#")[0]
        words = line.split()
        if words:
            yield number, words


class Rows:
    """Rows of an .obj file: coordinates, colors and normals of vertices, and polygons, as flat arrays of numbers."""

    def __init__(self):
        self.coordinates, self.colors, self.normals = array.array("d"), array.array("d"), array.array("d")
        self.corners, self.sizes, self.lines = array.array("q"), array.array("q"), array.array("q")

    def read(self, file):
        """Read all lines. Raises ValueError for a line that cannot be read."""
        kinds = {"v": self.add_vertex, "vn": self.add_normal, "f": self.add_polygon}
        for number, words in logical_lines(file):
            add = kinds.get(words[0])
            if add is None:
                continue
            try:
                add(number, words)
            except (ValueError, OverflowError) as error:
                raise ValueError(f"line {number}: {error}") from None
        self.expect_vertices()

    def add_vertex(self, _number, words):
        """Add the vertex of a row v x y z, with a color if r g b follow."""
        self.coordinates.extend(finite(words, 1))
        if len(words) >= 7:
            self.colors.extend(finite(words, 4))

    def add_normal(self, _number, words):
        """Add the normal of a row vn x y z."""
        self.normals.extend(finite(words, 1))

    def add_polygon(self, number, words):
        """Add the polygon of a row f with corners v, v/vt, v//vn or v/vt/vn.

        A negative v counts from the last vertex before the row.
        """
        try:
            corners = [int(word.partition("/")[0]) for word in words[1:]]
        except ValueError:
            raise ValueError(f"expected numbers of vertices after f, not {' '.join(words[1:])}") from None
        if len(corners) < 3:
            raise ValueError("a polygon needs three or more vertices")
        if min(corners) < 0:
            count = len(self.coordinates) // 3
            corners = [corner if corner >= 0 else count + 1 + corner for corner in corners]
        self.corners.extend(corners)
        self.sizes.append(len(corners))
        self.lines.append(number)

    def expect_vertices(self):
        """Raise ValueError for a polygon with a vertex that is not there; a file may have it after the polygon."""
        count, corners = len(self.coordinates) // 3, np.asarray(self.corners)
        wrong = np.flatnonzero((corners < 1) | (corners > count))
        if wrong.size:
            polygon = np.searchsorted(np.cumsum(self.sizes), wrong[0], side="right")
            raise ValueError(f"line {self.lines[polygon]}: a polygon has a vertex that is not in the file, "
                             f"which has {count} vertices")

    def has_all(self, values):
        """Whether there are three numbers for each vertex."""
        return len(values) == len(self.coordinates) > 0

    def warning(self):
        """What the file has that is not used, or an empty text."""
        if not self.colors or self.has_all(self.colors):
            return ""
        colored, count = len(self.colors) // 3, len(self.coordinates) // 3
        return f"colors are not used, since only {colored:,} of {count:,} vertices have one"

    def data(self):
        """The surface or cloud."""
        data, points = vtkPolyData(), vtkPoints()
        points.SetData(numpy_to_vtk(as_floats(vectors(self.coordinates)), deep=True))
        data.SetPoints(points)
        if self.sizes:
            data.SetPolys(cells_of(self.sizes, np.asarray(self.corners) - 1))
        elif self.has_all(self.normals):
            data.GetPointData().SetNormals(named(vectors(self.normals).astype(np.float32), "Normals"))
        if self.has_all(self.colors):
            data.GetPointData().SetScalars(named(as_bytes(vectors(self.colors)), "RGB"))
        return data


def finite(words, first):
    """Three numbers of a row. Raises ValueError unless they are there and finite."""
    try:
        x, y, z = map(float, words[first:first + 3])
        if math.isfinite(x) and math.isfinite(y) and math.isfinite(z):
            return x, y, z
    except ValueError:
        pass
    raise ValueError(f"expected three finite numbers with decimal points, not {' '.join(words[first:first + 3])}")


def vectors(values):
    """A flat array as one of n x 3."""
    return np.asarray(values).reshape(-1, 3)


def as_floats(coordinates):
    """Coordinates in single precision, as VTK's readers have them, unless that shifts points."""
    single = coordinates.astype(np.float32)
    if coordinates.size and np.abs(single - coordinates).max() > FLOAT_SHIFT * np.ptp(coordinates, axis=0).max():
        return coordinates
    return single


def as_bytes(colors):
    """Colors as bytes. The numbers of a file are in [0, 1], or in [0, 255] if the largest is above 1."""
    scale = 255.0 if colors.max() <= 1.0 else 1.0
    return np.clip(np.rint(scale * colors), 0, 255).astype(np.uint8)


def named(values, name):
    """Numbers as an array of VTK."""
    result = numpy_to_vtk(values, deep=True)
    result.SetName(name)
    return result


class OBJReader(PythonReader):
    """Reads vertices, in the order of the file, with their colors, and polygons.

    Normals are read if the file has no polygons and one normal for each vertex.
    """
    read_file = staticmethod(read)
