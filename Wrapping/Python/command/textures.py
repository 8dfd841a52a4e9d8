"""Pictures to paint with, from files."""
import os
import struct
import zlib

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader

from .scan_files import opened

TEXTURE_READERS = {".png": vtkPNGReader, ".jpg": vtkJPEGReader, ".jpeg": vtkJPEGReader}
CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}  # by PNG's types of color
MOST_OF_A_BYTE = 1032  # bytes that one byte of a PNG file can stand for


def texture_reader(path):
    """The reader for a picture, with the file name set."""
    reader = opened(path, lambda path: TEXTURE_READERS.get(os.path.splitext(path)[1].lower()),
                    " ".join(TEXTURE_READERS))
    if isinstance(reader, vtkPNGReader):
        check_png(path)
    elif not reader.CanReadFile(path):
        raise ValueError(f"{path}: not a JPEG file")
    return reader


def check_png(path):
    """Raise ValueError for a PNG file that is broken, at which VTK's reader would crash."""
    with open(path, "rb") as file:
        data = file.read()
    if not data.startswith(b"\x89PNG\r\n\x1a\n"):
        raise ValueError(f"{path}: not a PNG file")
    place, kind, packed = 8, b"", 0
    columns, rows, bits, color = 0, 0, 0, 0
    while kind != b"IEND":
        length, kind = struct.unpack(">I4s", data[place:place + 8].ljust(8, b"\0"))
        end = place + 12 + length  # length, name and checksum have 4 bytes each
        checksum = zlib.crc32(data[place + 4:end - 4]).to_bytes(4, "big")
        if data[end - 4:end] != checksum:
            raise ValueError(f"{path}: the PNG file is broken at byte {place}")
        if kind == b"IHDR":
            columns, rows, bits, color = struct.unpack(">IIBB", data[place + 8:place + 18].ljust(10, b"\0"))
        packed += length if kind == b"IDAT" else 0
        place = end
    if rows * columns * CHANNELS.get(color, 1) * bits > 8 * MOST_OF_A_BYTE * packed:
        raise ValueError(f"{path}: the PNG file is too short for {columns} x {rows} pixels")


def colors_of(image):
    """The picture with 3 or 4 bytes a pixel: gray becomes RGB, and 16 bits become 8."""
    scalars = image.GetPointData().GetScalars()
    pixels = vtk_to_numpy(scalars).reshape(image.GetNumberOfPoints(), -1)
    if pixels.dtype == np.uint16:
        pixels = ((pixels.astype(np.uint32) + 128) // 257).astype(np.uint8)
    if pixels.shape[1] in (1, 2):
        pixels = pixels[:, [0, 0, 0, 1][:pixels.shape[1] + 2]]
    colors = vtkImageData()
    colors.CopyStructure(image)
    colors.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(pixels), deep=True))
    return colors
