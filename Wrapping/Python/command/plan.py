"""What a call reads and writes, checked before any work: every file can be written, and no input is replaced."""
import argparse
import errno
import os
import stat
import typing

import numpy

from . import outputs, scan_files
from .progress import printable


METERS = {"mm": 1e-3, "cm": 1e-2, "in": 0.0254, "m": 1.0, "km": 1e3}  # of units of length
TWICE = "; {} in a name stands for the scan's"  # advice where names of files are equal


class Paths(typing.NamedTuple):
    """What to write for a scan; no picture is an empty name."""
    surfaces: typing.List[str]
    picture: str

    def all(self):
        """Return the surfaces, and the picture if there is one."""
        return [*self.surfaces, *filter(None, [self.picture])]

    def beside(self):
        """Files that may come to lie beside surfaces; those of one picture are shared."""
        return [*dict.fromkeys(file for path in self.surfaces for file in outputs.files_of(path)[1:])]

    def files(self):
        """All files that may come into being by them."""
        return [*self.all(), *self.beside()]


class WrongUsage(Exception):
    """The command makes no sense as given."""


def paths_of(options):
    """The files to write for each scan, after a look at whether they can be written without loss."""
    checks = Checks(inputs_of(options), options.overwrite)
    all_paths = []
    for scan in options.scans:
        paths = Paths([outputs.surface_named(pattern, scan, options.folder_type) for pattern in options.output],
                      outputs.named(options.picture or "", scan))
        for path in paths.surfaces:
            expect_extension(path, outputs.SURFACES, outputs.lacking("Writer"))
        if paths.picture:
            expect_extension(paths.picture, outputs.PICTURES)
        for file in paths.all():
            checks.expect_free(file)
        for file in paths.beside():
            checks.expect_free(file, ", also as a file that belongs to another one")
        all_paths.append(paths)
    if options.report not in (None, "-"):
        checks.expect_free(options.report)
    checks.expect_no_file_is_a_folder()
    return all_paths


def inputs_of(options):
    """All files that are read, those that a scan's reader reads besides included."""
    files = [file for scan in options.scans for file in scan_files.inputs_of(scan)]
    return [*files, options.texture] if options.texture else files


def expect_extension(path, extensions, more=""):
    """Raise WrongUsage for a format that there is no writer for."""
    if outputs.extension_of(path) not in extensions:
        raise WrongUsage(f"{path}: expected a file of type {' '.join(extensions)}{more}")


def expect_name(path):
    """Raise WrongUsage for a name that no writer takes."""
    if any(ord(character) < 32 or ord(character) == 127 for character in path):
        raise WrongUsage(f"{path}: names of files to write cannot have newlines or other control characters")


def in_range(low, high):
    """The type of an integer in [low, high]."""
    def number(text):
        value = int(text)
        if not low <= value <= high:
            raise argparse.ArgumentTypeError(f"{value} is not in [{low}, {high}]")
        return value
    number.__name__ = "integer"  # in the message about other texts
    return number


def positive(text):
    """Parse a positive integer."""
    number = int(text)
    if number < 1:
        raise argparse.ArgumentTypeError(f"{number} is less than 1")
    return number


positive.__name__ = "integer"


def expect_directions(view, up):
    """Raise WrongUsage where the viewer's directions give no picture."""
    across = numpy.cross(view, up)
    if not (numpy.isfinite([*view, *up]).all() and numpy.linalg.norm(across) > 0.0):
        raise WrongUsage("--view and --up must be finite, not zero, and not parallel")


def expect_utf8(name):
    """Raise WrongUsage for a file name that VTK cannot take."""
    try:
        name.encode("utf-8")
    except UnicodeEncodeError:
        raise WrongUsage(f"{ascii(os.fsencode(name))[2:-1]}: names of files must be UTF-8") from None


def parsed(parser, argv, expect_sense):
    """What the command line says, after expect_sense(options), which may raise WrongUsage."""
    options = parser.parse_args(argv)
    try:
        expect_sense(options)
    except WrongUsage as error:
        parser.error(printable(str(error)))
    return options


class Checks:
    """Files that are read, and files that are to be written, whatever they are called; one look at each.

    A file is the same as another if they have one name behind all links, or one place on the disk.
    """

    def __init__(self, inputs, overwrite):
        self.overwrite = overwrite
        self.real_folders, self.folder_problems = {}, {}
        self.written, self.folders = set(), {}
        self.inputs = set()
        for path in inputs:
            self.inputs.update(self.identities(path)[0])

    def identities(self, path):
        """What a file is recognized by, its name behind all links, and its status or None."""
        real = self.real(path)
        try:
            status = os.stat(path)
        except FileNotFoundError:
            return [real], real, None
        except NotADirectoryError:
            return [real], real, None
        except OSError as error:
            if error.errno == errno.EACCES:  # in a folder that cannot be entered
                return [real], real, None
            raise WrongUsage(f"{path}: {error.strerror}") from None
        return [real, (status.st_dev, status.st_ino)], real, status

    def real(self, path):
        """The name behind all links; folders are looked up once."""
        folder, name = os.path.split(path)
        if name in ("", ".", "..") or os.path.islink(path):
            return os.path.realpath(path)
        if folder not in self.real_folders:
            self.real_folders[folder] = os.path.realpath(folder)
        return os.path.join(self.real_folders[folder], name)

    def expect_free(self, path, role=""):
        """Raise WrongUsage for a file that must not or cannot be written; role says what for."""
        expect_name(path)
        if path.endswith(os.sep):
            raise WrongUsage(f"{path} is the name of a folder; expected that of a file")
        identities, real, status = self.identities(path)
        if not self.written.isdisjoint(identities):
            raise WrongUsage(f"{path} would be written twice{role or TWICE}")
        self.written.update(identities)
        if status is not None and not stat.S_ISREG(status.st_mode):
            raise WrongUsage(f"{path} is not a regular file")
        if not self.inputs.isdisjoint(identities):
            raise WrongUsage(f"{path} is an input and would be replaced")
        folder = os.path.dirname(real)
        if os.path.islink(path) and not os.path.isdir(folder):
            raise WrongUsage(f"{path} is a link to {real}, where there is no folder")
        self.expect_folder(path, folder)
        if status is not None and not self.overwrite:
            raise WrongUsage(f"{path} already exists; use --overwrite or another name")
        if status is not None and not (outputs.may(path, os.W_OK) and self.may_remove(status, folder)):
            raise WrongUsage(f"{path} cannot be replaced: this user may not write it")

    def expect_folder(self, path, folder):
        """Raise WrongUsage unless files can be made in the folder, which may have to be made before."""
        if folder not in self.folder_problems:
            self.folders[folder] = path
            there = folder
            while not os.path.lexists(there):
                there = os.path.dirname(there)
            can = os.path.isdir(there) and outputs.may(there, os.W_OK | os.X_OK)
            self.folder_problems[folder] = "" if can else f"{there} cannot be written to"
        if self.folder_problems[folder]:
            raise WrongUsage(f"{path}: {self.folder_problems[folder]}")

    @staticmethod
    def may_remove(status, folder):
        """Whether a sticky folder lets this user replace a file."""
        if not hasattr(os, "geteuid") or os.geteuid() in (0, status.st_uid):
            return True
        around = os.stat(folder)
        return not around.st_mode & stat.S_ISVTX or os.geteuid() == around.st_uid

    def expect_no_file_is_a_folder(self):
        """Raise WrongUsage if a file is to lie in a folder of the name of another file."""
        for folder, path in self.folders.items():
            while not os.path.isdir(folder):
                if folder in self.written:
                    raise WrongUsage(f"{path}: {folder} is to be a file and a folder")
                folder = os.path.dirname(folder)
