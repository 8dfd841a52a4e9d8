"""Files to write: which format an extension stands for, what they are called, and how they get whole."""
import contextlib
import errno
import os
import stat
import tempfile

from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import conformalsom
from conformalsom import vtkSurfaceFileWriter, vtkTexturedSurfaceWriter

# What takes a picture too, and what then lies beside the file.
PAINTED = {".glb": (), ".obj": (".mtl", ".png"), ".ply": (".png",)}
OURS = {
    ".ply": "vtkConformalPLYWriter",
    ".off": "vtkConformalOFFWriter",
    ".m": "vtkGuMeshWriter",
    ".gii": "vtkGIFTIWriter",
    ".html": "vtkSurfacePageWriter",
}
PLAIN = {
    ".obj": vtkOBJWriter,
    ".vtp": vtkXMLPolyDataWriter,
    ".vtk": vtkPolyDataWriter,
    ".stl": vtkSTLWriter,
    **{extension: getattr(conformalsom, name) for extension, name in OURS.items()
       if name not in conformalsom.CLASSES_LEFT_OUT},
}
SURFACES = sorted({*PAINTED, *PLAIN})
PICTURES = [".jpg", ".png"]


def lacking(kind):
    """What to add to a message about types of files where this build lacks some: kind is Reader or Writer."""
    if not any(name.endswith(kind) for name in conformalsom.CLASSES_LEFT_OUT):
        return ""
    return ("; for more of them build these, too: "
            "cmake --preset quickstart-files && cmake --build --preset release")


def extension_of(path):
    """The extension, in lower case and with its dot."""
    return os.path.splitext(path)[1].lower()


def named(pattern, scan):
    """The path that a pattern stands for: {} is the scan's name without its extension."""
    return pattern.replace("{}", os.path.splitext(os.path.basename(scan))[0])


def surface_named(pattern, scan):
    """The same, where a folder stands for .glb files in it."""
    if pattern.endswith(os.sep) or os.path.isdir(pattern):
        pattern = os.path.join(pattern, "{}.glb")
    return named(pattern, scan)


def files_of(path):
    """The file and those that may come to lie beside it."""
    beside = PAINTED.get(extension_of(path), ())
    return [path, *(os.path.splitext(path)[0] + extension for extension in beside)]


def writer_of(path, painted):
    """The writer for a surface, with a picture or without."""
    extension = extension_of(path)
    if painted and extension in PAINTED or extension not in PLAIN:
        return vtkTexturedSurfaceWriter()
    writer = PLAIN[extension]()
    if isinstance(writer, (vtkPolyDataWriter, vtkSTLWriter)):
        writer.SetFileTypeToBinary()
    return writer


@contextlib.contextmanager
def whole(path):
    """A path to write to instead; what is there takes its place at the end, and nothing after an error."""
    path = os.path.realpath(path)
    folder = os.path.dirname(path)
    os.makedirs(folder, exist_ok=True)
    mode = None
    if os.path.lexists(path):
        mode = os.stat(path).st_mode
        if not stat.S_ISREG(mode):
            raise OSError(errno.EINVAL, "not a regular file", path)
        if not os.access(path, os.W_OK):
            raise OSError(errno.EACCES, os.strerror(errno.EACCES), path)
    try:
        made = tempfile.TemporaryDirectory(prefix=".conformalsom-", dir=folder)
    except OSError as error:
        raise OSError(error.errno, error.strerror, path) from error
    with made as temporary:
        part = os.path.join(temporary, os.path.basename(path))
        yield part
        if mode is not None:
            os.chmod(part, stat.S_IMODE(mode))
        os.replace(part, path)


def write(steps, writer, path):
    """Write a file by a writer that has its inputs: whole, or not at all."""
    label = f"Write {os.path.basename(path)}"
    if isinstance(writer, vtkSurfaceFileWriter):  # does so by itself
        os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
        writer.SetFileName(path)
        steps.run(label, writer, writer.Write)
        return
    with whole(path) as part:
        writer.SetFileName(part)
        steps.run(label, writer, writer.Write)
        if isinstance(writer, vtkOBJWriter):  # which does not notice a full disk
            expect_polygons(part, writer.GetInputDataObject(0, 0).GetNumberOfPolys(), path)


def expect_polygons(part, number, path):
    """Raise OSError unless an .obj file has so many polygons; path is what it is to become."""
    with open(part, "rb") as file:
        data = file.read()
    if not data.endswith(b"\n") or data.count(b"\nf ") != number:
        raise OSError(errno.EIO, "it could not be written whole", path)
