"""Volumes from files: TIFF stacks, also with time steps, and images of three dimensions that VTK reads."""
import os
import re

from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOImage import vtkMetaImageReader, vtkNIFTIImageReader, vtkNrrdReader
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

import conformalsom
from conformalsom.messages import errors_outside

from . import outputs

READERS = {
    ".nii": vtkNIFTIImageReader,
    ".nii.gz": vtkNIFTIImageReader,
    ".mha": vtkMetaImageReader,
    ".mhd": vtkMetaImageReader,
    ".nrrd": vtkNrrdReader,
    ".vti": vtkXMLImageDataReader,
}
STACKS = (".tif", ".tiff")
EXTENSIONS = sorted({*READERS, *STACKS})
NIFTI_UNITS = {1: "m", 2: "mm", 3: "micron"}  # of the lowest three bits of xyzt_units
MICRONS = {"micron", "microns", "um", "\u00b5m", "\u03bcm"}


def extension_of(path):
    """The extension of a volume, in lower case; also .nii.gz."""
    return ".nii.gz" if path.lower().endswith(".nii.gz") else outputs.extension_of(path)


def name_of(path):
    """The file's name without its extension."""
    name = os.path.basename(path)
    return name[:-len(extension_of(path))] if extension_of(path) else name


def is_volume(path):
    """Whether the extension is that of a volume."""
    return extension_of(path) in EXTENSIONS


def volume_reader(path):
    """The reader for a volume, with the file name set. Raises ValueError for other types of files."""
    extension = extension_of(path)
    if extension not in EXTENSIONS:
        raise ValueError(f"{path}: expected a file of type {' '.join(EXTENSIONS)}")
    reader = READERS[extension]() if extension in READERS else conformalsom.vtkTIFFStackReader()
    reader.SetFileName(path)
    return reader


def times_of(reader):
    """Times of the time steps that a reader offers, after it has read the header; [0] if there are none."""
    info, key = reader.GetOutputInformation(0), vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    return [info.Get(key, i) for i in range(info.Length(key))] if info.Has(key) else [0.0]


def unit_of(volume, reader=None):
    """The unit of a volume's coordinates that its file has, or an empty text."""
    words = volume.GetFieldData().GetAbstractArray("Unit")
    if words:
        return words.GetValue(0)
    if isinstance(reader, vtkNIFTIImageReader) and reader.GetNIFTIHeader():
        return NIFTI_UNITS.get(reader.GetNIFTIHeader().GetXYZTUnits() & 7, "")
    return ""


def is_same_unit(first, second):
    """Whether two texts name one unit."""
    return first == second or {first, second} <= MICRONS


def expect_header(path, reader):
    """Raise ValueError for a file that is no MetaImage file, about which VTK's reader prints errors."""
    if isinstance(reader, vtkMetaImageReader):
        with open(path, "rb") as file:
            if b"NDims" not in file.read(2**16):
                raise ValueError(f"{path}: not a MetaImage file")


def expect_one_volume(path, reader):
    """Raise ValueError if a file has time steps that its reader would not read."""
    if isinstance(reader, vtkNIFTIImageReader) and reader.GetTimeDimension() > 1:
        raise ValueError(f"{path}: has {reader.GetTimeDimension()} time steps; write a file for each of them")


def expect_whole(path, reader):
    """Raise ValueError for a MetaImage file that ends early, of whose voxels VTK's reader takes the rest as 0.

    Files are checked if their voxels are binary and in one place: not text, a list or a pattern of files. For NRRD
    files, VTK's reader reports an error outside of itself, which errors_outside() collects.
    """
    if isinstance(reader, vtkMetaImageReader):
        expect_whole_meta_image(path, reader)


def expect_whole_meta_image(path, reader):
    """Raise ValueError for a MetaImage file with fewer voxels than its header states."""
    with open(path, "rb") as file:
        head = file.read(2**16)
    begin, key, rest = head.partition(b"ElementDataFile")
    value, end, _ = rest.partition(b"\n")
    words = dict(re.findall(rb"^(\w+)\s*=\s*(\S+)", begin, flags=re.M))
    data = os.fsdecode(value.strip(b" =\t\r"))
    beside = os.path.join(os.path.dirname(path), data)
    if not is_true(words, b"BinaryData") or not (data.lower() == "local" or os.path.isfile(beside)):
        return
    needed = bytes_of(reader.GetOutput())
    if is_true(words, b"CompressedData"):
        needed = int(words.get(b"CompressedDataSize", b"0"))
    if data.lower() == "local":
        found = os.path.getsize(path) - len(begin + key + value + end)
    else:
        found = os.path.getsize(beside)
    expect_bytes(path, found, needed)


def bytes_of(volume):
    """The size of all voxels."""
    return volume.GetNumberOfPoints() * volume.GetNumberOfScalarComponents() * volume.GetScalarSize()


def expect_bytes(path, found, needed):
    """Raise ValueError if a file has fewer bytes of voxels than it needs."""
    if found < needed:
        raise ValueError(f"{path}: the file ends early: it has {found} of {needed} bytes of voxels")


def is_true(words, key):
    """Whether a MetaImage file has a key with a value that its reader takes as true."""
    return words.get(key, b"").lower().startswith((b"t", b"1"))


def read(path, steps, label, time=0.0):
    """The volume at a time, and its unit. Raises StepFailed or ValueError for a file that cannot be read."""
    reader = volume_reader(path)
    expect_header(path, reader)
    with errors_outside() as broken:
        steps.run(label, reader, lambda: reader.UpdateTimeStep(time))
    if broken:
        raise ValueError(f"{path}: {broken[0]}")
    expect_one_volume(path, reader)
    expect_whole(path, reader)
    volume = reader.GetOutput()
    if volume.GetNumberOfPoints() == 0 or volume.GetPointData().GetScalars() is None:
        raise ValueError(f"{path}: the volume is empty")
    return volume, unit_of(volume, reader)
