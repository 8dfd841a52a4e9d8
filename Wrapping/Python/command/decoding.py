"""Decodes a picture and puts its pixels on the standard output: a program that textures.py starts for each picture.

VTK's readers crash on some broken pictures, and allocate what their headers claim. So this process has limits of
memory and time, and whatever ends it is an error message of the process that started it. Its output is a line of
JSON, {"error": ...} or {"rows": ..., "columns": ..., "channels": ...}, and then the bytes of the pixels, the lowest
row first. Imports nothing of the package, which takes longer to load than a picture.
"""
import json
import os
import struct
import sys

import numpy as np
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

try:
    import resource
except ModuleNotFoundError:  # Windows
    resource = None

READERS = {".png": vtkPNGReader, ".jpg": vtkJPEGReader, ".jpeg": vtkJPEGReader}
MAXIMUM_PIXELS = 2**28
BYTES_PER_PIXEL = 24  # RGBA of 16 bits is there twice while VTK reads it, and then as 8 bits
SPARE_BYTES = 2**28
SECONDS = 5
PIXELS_PER_SECOND = 2**23  # beyond these seconds; real pictures are decoded several times faster
MAXIMUM_LOG = 2**16  # bytes on the standard error
BLOCK = 2**22  # pixels that are converted at once


ORIENTATION, SHORT = 0x0112, 3  # a tag of EXIF, and the type of its value
# For each orientation from 1 to 8: whether rows and columns are exchanged, and then rows and columns are reversed.
TURNS = [(False, False, False), (False, False, True), (False, True, True), (False, True, False),
         (True, False, False), (True, False, True), (True, True, True), (True, True, False)]


class Refused(Exception):
    """The picture is not one that can be painted with; the text says why."""


def limit(name, value):
    """Lower a limit of this process, where the system has it."""
    kind = getattr(resource, name, None)
    if kind is not None:
        most = resource.getrlimit(kind)[1]
        value = value if most == resource.RLIM_INFINITY else min(value, most)
        resource.setrlimit(kind, (value, most))


def limit_work(pixels):
    """Limit memory and time to what so many pixels need."""
    try:
        with open("/proc/self/statm", encoding="ascii") as file:
            used = int(file.read().split()[0]) * os.sysconf("SC_PAGE_SIZE")
        limit("RLIMIT_AS", used + SPARE_BYTES + BYTES_PER_PIXEL * pixels)
    except (OSError, ValueError):  # a system without it
        pass
    limit("RLIMIT_CPU", int(sum(os.times()[:2])) + 1 + SECONDS + pixels // PIXELS_PER_SECOND)


def checked_size(reader):
    """Columns and rows as the header has them."""
    low_x, high_x, low_y, high_y = reader.GetDataExtent()[:4]
    columns, rows = high_x - low_x + 1, high_y - low_y + 1
    if columns < 1 or rows < 1 or columns * rows > MAXIMUM_PIXELS:
        raise Refused(f"the picture has {columns} x {rows} pixels; there can be 1 to {MAXIMUM_PIXELS:,}, "
                      "as many as 16384 x 16384: make it smaller")
    return columns, rows


def colors_of(values):
    """Values of pixels as 3 or 4 bytes: gray becomes RGB, and 16 bits become 8."""
    if values.dtype == np.uint16:
        values = ((values.astype(np.uint32) + 128) // 257).astype(np.uint8)
    if values.shape[1] < 3:
        values = values[:, [0, 0, 0, 1][:values.shape[1] + 2]]
    return np.ascontiguousarray(values)


def updated(reader, update):
    """Call a method that reads; raise Refused if the reader reports an error."""
    errors = []

    @calldata_type(VTK_STRING)
    def keep(_, __, text):
        errors.append(text.split("): ", 1)[-1].strip().partition("\n")[0])

    sources = (reader, reader.GetExecutive())
    tags = [source.AddObserver("ErrorEvent", keep) for source in sources]
    update()
    for source, tag in zip(sources, tags):
        source.RemoveObserver(tag)
    if errors or reader.GetErrorCode():
        own = [text for text in errors if "could not read file" not in text and "returned failure" not in text]
        raise Refused("the picture is broken" + "".join(f": {text}" for text in own[:1]))


def exif_of(path):
    """The EXIF data of a JPEG file, which begin with a header of TIFF; empty if there are none."""
    with open(path, "rb") as file:
        file.seek(2)
        while True:
            start = file.read(4)
            if len(start) < 4:
                return b""
            marker, length = struct.unpack(">HH", start)
            if not (0xFFE0 <= marker <= 0xFFEF or marker == 0xFFFE) or length < 2:  # segments of programs, comments
                return b""
            data = file.read(length - 2)
            if marker == 0xFFE1 and data.startswith(b"Exif\0\0"):
                return data[6:]


def orientation_of(exif):
    """The orientation, in [1, 8], of EXIF data; 1 if there is none or if the data are damaged."""
    order = {b"II*\0": "<", b"MM\0*": ">"}.get(exif[:4])
    if order is None:
        return 1
    try:
        place, = struct.unpack_from(order + "I", exif, 4)
        count, = struct.unpack_from(order + "H", exif, place)
        for i in range(count):
            entry = struct.unpack_from(order + "HHIH", exif, place + 2 + 12 * i)
            if entry[:3] == (ORIENTATION, SHORT, 1):
                return entry[3] if 1 <= entry[3] <= len(TURNS) else 1
    except struct.error:  # the data end early
        pass
    return 1


def upright(columns, rows, values, orientation):
    """Columns, rows and values of a picture, the lowest row first, after it is turned as its orientation says."""
    exchanged, rows_reversed, columns_reversed = TURNS[orientation - 1]
    pixels = values.reshape(rows, columns, -1)[::-1]  # the highest row first, as in EXIF
    if exchanged:
        pixels = pixels.swapaxes(0, 1)
    pixels = pixels[::-1 if rows_reversed else 1, ::-1 if columns_reversed else 1][::-1]
    return pixels.shape[1], pixels.shape[0], pixels.reshape(columns * rows, -1)


def pixels_of(path):
    """Columns, rows, and an array of #pixels by 1 to 4 numbers; a JPEG file is turned as its EXIF data say."""
    kind = READERS[os.path.splitext(path)[1].lower()]
    reader = kind()
    name = "JPEG" if kind is vtkJPEGReader else "PNG"
    if not reader.CanReadFile(path):
        raise Refused(f"not a {name} file, or an incomplete one")
    reader.SetFileName(path)
    limit_work(0)
    updated(reader, reader.UpdateInformation)
    columns, rows = checked_size(reader)
    limit_work(columns * rows)
    updated(reader, reader.Update)
    scalars = reader.GetOutput().GetPointData().GetScalars()
    if scalars is None or scalars.GetNumberOfTuples() != columns * rows:
        raise Refused("the picture is broken")
    values = vtk_to_numpy(scalars).reshape(columns * rows, -1)
    if values.dtype not in (np.uint8, np.uint16) or values.shape[1] > 4:
        raise Refused(f"the picture has {values.shape[1]} numbers of the type {values.dtype} for each pixel; "
                      "save it as RGB of 8 bits")
    if kind is vtkJPEGReader and values.shape[1] == 4:  # a JPEG file has no opacity
        raise Refused("a JPEG file of the four inks CMYK, whose colors depend on a printer; save it as RGB")
    orientation = orientation_of(exif_of(path)) if kind is vtkJPEGReader else 1
    return upright(columns, rows, values, orientation)


def main(path):
    """Decode the picture, and exit."""
    with os.fdopen(os.dup(1), "wb") as output:
        os.dup2(2, 1)  # what libraries print is not among the pixels
        limit("RLIMIT_CORE", 0)
        limit("RLIMIT_FSIZE", MAXIMUM_LOG)
        vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
        vtkOutputWindow.SetInstance(vtkStringOutputWindow())
        try:
            columns, rows, values = pixels_of(path)
            channels = colors_of(values[:1]).shape[1]
            told = {"rows": rows, "columns": columns, "channels": channels}
        except Refused as error:
            values, told = np.empty((0, 3)), {"error": str(error)}
        except MemoryError:
            values, told = np.empty((0, 3)), {"error": "the picture needs more memory than its size allows"}
        output.write(json.dumps(told).encode() + b"\n")
        for start in range(0, len(values), BLOCK):
            output.write(colors_of(values[start:start + BLOCK]).data)


if __name__ == "__main__":
    main(sys.argv[1])
