"""Scans and pictures from files."""
import os
import struct
import zlib

from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkSTLReader
from vtkmodules.vtkIOImage import vtkJPEGReader, vtkPNGReader
from vtkmodules.vtkIOLegacy import vtkPolyDataReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

import conformalsom

from . import outputs

OUR_READERS = [reader for reader in vars(conformalsom).values()
               if hasattr(reader, "CanReadFile") and issubclass(reader, conformalsom.vtkSurfaceFileReader)]
VTK_READERS = {
    ".obj": vtkOBJReader,
    ".stl": vtkSTLReader,
    ".vtp": vtkXMLPolyDataReader,
    ".vtk": vtkPolyDataReader,
}
TEXTURE_READERS = {".png": vtkPNGReader, ".jpg": vtkJPEGReader, ".jpeg": vtkJPEGReader}


def reader_class(path):
    """That of our readers that knows the file by its content, or one of VTK's by its extension.

    Failing that, ours of the extension, which says what is wrong with the file; else none.
    """
    extension = os.path.splitext(path)[1].lower()
    for reader in OUR_READERS:
        if reader.CanReadFile(path):
            return reader
    if extension in VTK_READERS:
        return VTK_READERS[extension]
    for reader in OUR_READERS:
        if extension in reader().GetFileExtensions().split():
            return reader
    return None


def scan_reader(path):
    """The reader for a scan, with the file name set."""
    extensions = [extension for ours in OUR_READERS for extension in ours().GetFileExtensions().split()]
    return opened(path, reader_class, [*extensions, *VTK_READERS])


def read_models(paths):
    """What is in the files, by their names without folders and extensions."""
    models = {}
    for path in paths:
        reader = scan_reader(path)
        reader.Update()
        models[os.path.splitext(os.path.basename(path))[0]] = reader.GetOutput()
    return models


def texture_reader(path):
    """The reader for a picture, with the file name set."""
    reader = opened(path, lambda path: TEXTURE_READERS.get(os.path.splitext(path)[1].lower()),
                    TEXTURE_READERS)
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
    place, kind = 8, b""
    while kind != b"IEND":
        length, kind = struct.unpack(">I4s", data[place:place + 8].ljust(8, b"\0"))
        end = place + 12 + length  # length, name and checksum have 4 bytes each
        checksum = zlib.crc32(data[place + 4:end - 4]).to_bytes(4, "big")
        if data[end - 4:end] != checksum:
            raise ValueError(f"{path}: the PNG file is broken at byte {place}")
        place = end


def opened(path, choose, extensions):
    """A reader of the class that is chosen for a file."""
    if not os.path.isfile(path):
        raise ValueError(f"{path}: not a file" if os.path.exists(path) else f"{path}: no such file")
    reader_type = choose(path)
    if reader_type is None:
        raise ValueError(f"{path}: expected a file of type {' '.join(extensions)}{outputs.lacking('Reader')}")
    reader = reader_type()
    reader.SetFileName(path)
    return reader
