"""Read scans from .stl files.

VTK's reader takes what is left of a binary file that was cut. That of VTK 9.6 refuses text files that begin with SOLID
or with a space, and reads other triangles than those of the file from some text files that were cut.
"""
import array
import os
import struct

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from .cleaning import cells_of
from .obj_files import as_floats
from .python_reader import PythonReader

HEAD = 84  # bytes of a binary file before its triangles
TRIANGLE = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def read(path):
    """The surface of a file, in single precision unless that shifts points, and an empty text.

    Equal corners of triangles are one point; triangles with equal corners are left out. Raises ValueError for what is
    no STL file, or has fewer or more bytes than its triangles need, and OSError.
    """
    with open(path, "rb") as file:
        is_text_file = is_text(file.read(256))
    return surface(text_corners(path) if is_text_file else binary_corners(path)), ""


def is_text(head):
    """Whether an .stl file with these first 256 bytes is text.

    The first word does not decide: headers of binary files may begin with solid, too.
    """
    others = sum(not (32 <= byte < 128 or byte in b"\t\n\r") for byte in head)
    return bool(head) and others < 0.05 * len(head)


def binary_corners(path):
    """Corners of the triangles of a binary file, #T x 3 x 3."""
    with open(path, "rb") as file:
        head = file.read(HEAD)
        triangles = struct.unpack_from("<I", head, HEAD - 4)[0] if len(head) == HEAD else 0
        more = os.path.getsize(path) - HEAD - TRIANGLE.itemsize * triangles
        if triangles == 0 or more < 0:
            raise ValueError("not an STL file, or an incomplete one")
        if more > 0:
            raise ValueError(f"{more:,} bytes follow the {triangles:,} triangles that the file states; "
                             "remove these bytes, or correct the number")
        return np.fromfile(file, TRIANGLE, triangles)["corners"]


def text_corners(path):
    """Corners of the triangles of a text file, #T x 3 x 3."""
    corners, first, last = array.array("d"), b"", b""
    with open(path, "rb") as file:
        for number, line in enumerate(file, 1):
            words = line.split()
            if not words:
                continue
            last = words[0].lower()
            first = first or last
            if first != b"solid":
                raise ValueError("not an STL file")
            if last == b"vertex":
                corners.extend(numbers(number, words[1:]))
            elif last == b"endloop" and len(corners) % 9:
                raise ValueError(f"line {number}: expected a triangle, with three rows that begin with vertex")
    if last != b"endsolid" or not corners:
        raise ValueError("not an STL file, or an incomplete one")
    return as_floats(np.asarray(corners).reshape(-1, 3)).reshape(-1, 3, 3)


def numbers(line, words):
    """The three numbers of a row."""
    try:
        x, y, z = map(float, words)
    except ValueError:
        found = b" ".join(words).decode("latin-1")
        raise ValueError(f"line {line}: expected three numbers with decimal points, not {found}") from None
    return x, y, z


def surface(corners):
    """The surface of triangles #T x 3 x 3, whose equal corners become one point, in the order of the file."""
    vertices = corners.reshape(-1, 3) + 0.0  # -0 becomes 0
    order = np.lexsort(vertices.T)
    is_new = np.ones(len(order), bool)
    is_new[1:] = (vertices[order[1:]] != vertices[order[:-1]]).any(axis=1)
    # lexsort is stable: the first of equal vertices is the first of the file.
    first = np.empty_like(order)
    first[order] = order[is_new][np.cumsum(is_new) - 1]
    kept, ids = np.unique(first, return_inverse=True)
    triangles = ids.reshape(-1, 3)
    triangles = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
    data, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(vertices[kept], deep=True))
    data.SetPoints(points)
    data.SetPolys(cells_of(np.full(len(triangles), 3), triangles.ravel()))
    return data


class STLReader(PythonReader):
    """Reads the triangles of text and binary files."""
    read_file = staticmethod(read)
