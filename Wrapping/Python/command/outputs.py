"""Files to write: which format an extension stands for, what they are called, and how they get whole."""
import contextlib
import errno
import os
import secrets
import shutil
import stat

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkPolyDataWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

import conformalsom
from conformalsom import vtkTexturedSurfaceWriter

from conformalsom.messages import FilterFailed

from .threemf import ThreeMFWriter
from .xml_names import escape_input

PREFIX = ".conformalsom-"  # of what is not finished
ACCESS_LIST = "system.posix_acl_access"
FIRST_VTK_ERROR, OUT_OF_DISK_SPACE = 20000, 20007  # of vtkErrorCode.h, which is not wrapped; errno is below

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
    ".3mf": ThreeMFWriter,
    **{extension: getattr(conformalsom, name) for extension, name in OURS.items()
       if name not in conformalsom.CLASSES_LEFT_OUT},
}
SURFACES = sorted({*PAINTED, *PLAIN})
FLOAT_SHIFT = 1e-5  # of the size, by which floats may shift points
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


def surface_named(pattern, scan, folder_type):
    """The path that a pattern stands for, in which a folder stands for a file of folder_type in it, named after the scan."""
    if pattern.endswith(os.sep) or os.path.isdir(pattern):
        pattern = os.path.join(pattern, "{}" + folder_type)
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
    if isinstance(writer, vtkXMLPolyDataWriter):
        writer.SetCompressionLevel(1)  # coordinates are as large at level 5, which takes 1.5 times as long
        writer.SetEncodeAppendedData(False)  # as in ParaView's files: base64 adds a third
    return writer


def compress(writer):
    """Let the writer of a .glb file make a small one; returns False if the build lacks meshoptimizer, and quantizes only."""
    writer.SetTextureFormatToJPEG()
    if writer.GetHasMeshopt():
        writer.SetCompressionToMeshopt()
        return True
    writer.SetCompressionToQuantized()
    return False


@contextlib.contextmanager
def whole(path, token=None, files=None, overwrite=True, shared=()):
    """A path to write to instead; what is there takes its place at the end, and nothing after an error.

    So do the files that may come to lie beside it. All come into being in a folder beside their places that is named
    after the token, and into which no other user can look; discard() removes what a process that crashed left there.
    Files in shared may be replaced: a picture is the same for an .obj and a .ply file of one scan.
    """
    token, files = token or new_token(), files or files_of(path)
    places = [Place(file, overwrite or file in shared) for file in files]
    with named_errors(path):
        os.makedirs(places[0].folder, exist_ok=True)
    try:
        folder = stage(places[0], token)
        yield os.path.join(folder, os.path.basename(path))
        made, known = set(os.listdir(folder)), {os.path.basename(file) for file in files}
        if not made <= known:
            raise RuntimeError(f"{path}: the writer made files that were not checked: {' '.join(sorted(made - known))}")
        with named_errors(path):
            take_places([(os.path.join(folder, os.path.basename(place.name)), place)
                         for place in places if os.path.basename(place.name) in made], token)
    finally:
        discard(files, token)


@contextlib.contextmanager
def named_errors(name):
    """Let errors of the system name what was to be written."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, name) from error


def new_token():
    """What to name folders of unfinished files after."""
    return secrets.token_hex(8)


class Place:
    """Where a file is to be: that behind all links, and what is there."""

    def __init__(self, name, overwrite=True):
        self.name = name
        self.path = os.path.realpath(name)
        self.folder = os.path.dirname(self.path)
        self.old = None
        if os.path.lexists(self.path):  # also a link that leads in a circle, which fails
            self.old = os.stat(self.path)
            if not overwrite:
                raise OSError(errno.EEXIST, "it was created in the meantime; use --overwrite or another name", name)
            self.expect_regular()
            if not may(self.path, os.W_OK):
                raise OSError(errno.EACCES, os.strerror(errno.EACCES), name)

    def expect_regular(self):
        """Raise OSError if what is there now is no regular file."""
        if os.path.lexists(self.path) and not stat.S_ISREG(os.lstat(self.path).st_mode):
            raise OSError(errno.EINVAL, "not a regular file", self.name)


def may(path, mode):
    """Whether this process may use a file as os.access has it."""
    return os.access(path, mode, effective_ids=os.access in os.supports_effective_ids)


def stage(place, token):
    """The folder for unfinished files beside a place."""
    folder = os.path.join(place.folder, PREFIX + token)
    with named_errors(place.name):
        if not os.path.isdir(folder):
            os.mkdir(folder, 0o700)
    return folder


def discard(files, token):
    """Remove what is left of unfinished files that were to be written."""
    for folder in {os.path.dirname(os.path.realpath(file)) for file in files}:
        shutil.rmtree(os.path.join(folder, PREFIX + token), ignore_errors=True)


def take_places(files, token):
    """Put all files into their places, or none: pairs of a path and a Place."""
    ready = []
    for number, (part, place) in enumerate(files):
        folder = stage(place, token)
        new = os.path.join(folder, f"{number}.new")
        with named_errors(place.name):
            shutil.move(part, new)  # copies if a link leads to another file system
            if place.old is not None:
                copy_access(place, new)
            flush(new)
        ready.append((new, os.path.join(folder, f"{number}.old"), place))
    begun, taken = [], set()
    try:
        for new, kept, place in ready:
            begun.append((kept, place))
            with named_errors(place.name):
                place.expect_regular()  # writing may have taken long
                if place.old is not None:
                    keep(place.path, kept)
                os.replace(new, place.path)
            taken.add(place)
    except BaseException:
        for kept, place in reversed(begun):
            if os.path.lexists(kept):
                os.replace(kept, place.path)
            elif place in taken:
                os.unlink(place.path)
        raise


def keep(path, kept):
    """Give a file another name, from which it can be put back."""
    try:
        os.link(path, kept)
    except OSError:  # no hard links here
        os.rename(path, kept)


def flush(path):
    """Wait until a file is on the disk: a full one may be noticed only here."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno != errno.EINVAL:  # a file system that has nothing to flush
            raise
    finally:
        os.close(descriptor)


def copy_access(place, new):
    """Give a new file owner, group and permissions of the old one, as Files/WriteFiles.cxx does for files of our own writers.

    A group that cannot be kept gets no more than all other users had; setuid, setgid and sticky bits are dropped.
    """
    mode, keeps_group = place.old.st_mode & 0o777, True
    if hasattr(os, "chown"):
        keeps_group = succeeds(os.chown, new, -1, place.old.st_gid)
        if not keeps_group:
            mode &= 0o707 | (mode & 0o007) << 3
        succeeds(os.chown, new, place.old.st_uid, -1)
    if hasattr(os, "setxattr"):
        try:
            access = os.getxattr(place.path, ACCESS_LIST)
        except OSError:  # it has none
            access = None
        if keeps_group and access:
            os.setxattr(new, ACCESS_LIST, access)
        else:
            succeeds(os.removexattr, new, ACCESS_LIST)  # the folder may have given it one
    os.chmod(new, mode)


def succeeds(call, *arguments):
    """Call a function of the system; whether it did not fail."""
    try:
        call(*arguments)
    except OSError:
        return False
    return True


def write(steps, writer, path, token=None, overwrite=True, shared=(), files=None):
    """Write a file by a writer that has its inputs: whole, or not at all. See whole() for the other arguments."""
    with whole(path, token, files, overwrite, shared) as part:
        write_part(steps, writer, part, path)


def write_part(steps, writer, part, path):
    """Write an unfinished file by a writer that has its inputs; errors name the path that the file is to have."""
    writer.SetFileName(part)
    if isinstance(writer, vtkXMLPolyDataWriter):
        escape_input(writer)
    try:
        steps.run(f"Write {os.path.basename(path)}", writer, writer.Write)
    except FilterFailed as error:  # which names what only writing needs
        expect_space(writer, path)
        raise type(error)(str(error).replace(part, path)) from None
    except OSError as error:
        raise OSError(error.errno, error.strerror, path if error.filename == part else error.filename) from error
    if isinstance(writer, (vtkSTLWriter, ThreeMFWriter)):  # whose input is up to date only now
        expect_floats(writer.GetInputDataObject(0, 0), path)
    if isinstance(writer, vtkOBJWriter):  # which does not notice a full disk
        expect_polygons(part, writer.GetInputDataObject(0, 0), path)
    if not os.path.exists(part):
        raise OSError(errno.EIO, "it could not be written", path)


def shift_of_floats(surface):
    """The largest distance by which floats shift a coordinate of a point, as a share of the size of the surface."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    shift = float(np.abs(points - points.astype(np.float32)).max(initial=0.0))
    size = float(np.linalg.norm(np.ptp(points, axis=0))) if len(points) > 0 else 0.0
    return shift / size if size > 0.0 else 0.0


def expect_floats(surface, path):
    """Raise ValueError if a file of floats would move points by more than FLOAT_SHIFT."""
    share = shift_of_floats(surface)
    if share > FLOAT_SHIFT:
        raise ValueError(f"{path}: the surface is too far from the origin: the floats of this format would shift points "
                         f"by {share:.2g} of its size; write .ply or .obj instead, or subtract the center "
                         "from the points of the scan first")


def expect_space(writer, path):
    """Raise OSError if a writer of VTK failed because it could not write all: its message misleads, or there is none."""
    code = writer.GetErrorCode()
    if not type(writer).__module__.startswith("vtkmodules."):  # ours give the reason
        return
    if 0 < code < FIRST_VTK_ERROR:  # an error of the system
        raise OSError(code, os.strerror(code), path)
    if code == OUT_OF_DISK_SPACE:  # for all errors of a stream
        raise OSError(errno.EIO, "it could not be written completely; is the disk full?", path)


def expect_polygons(part, surface, path):
    """Raise OSError unless an .obj file has all polygons of a surface; path is what it is to become."""
    strips = surface.GetStrips()  # written as triangles
    number = surface.GetNumberOfPolys() + strips.GetNumberOfConnectivityIds() - 2 * strips.GetNumberOfCells()
    with open(part, "rb") as file:
        data = file.read()
    if not data.endswith(b"\n") or data.count(b"\nf ") != number:
        raise OSError(errno.EIO, "it could not be written completely; is the disk full?", path)
