"""The command conformalsom: from scans to painted surfaces."""
import argparse
import json
import os
import signal
import sys
import typing

import numpy
from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow, vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

import conformalsom

from . import outputs, pictures, scan_files, surfaces, textures
from .progress import Bar
from .steps import Interrupted, StepFailed

DESCRIPTION = """\
Turns the points of 3-D scans into closed, smooth, painted surfaces. A scan may be in any format that
ConformalSOM or VTK reads (PLY, OFF, PCD, points as text, FreeSurfer, GIFTI, OBJ, STL, VTP ...); only
its points and colors are used, and its triangles where they are one closed surface."""

EPILOG = """\
examples:
  conformalsom scan.ply --texture photo.png -o surface.glb
  conformalsom scan.ply -o surface.vtp -o surface.stl --report figures.json
  conformalsom scans/*.ply -o 'surfaces/{}.glb'

exit status:
  0  everything was made
  1  a file could not be read or written, or a filter failed; other scans were gone on with
  2  wrong usage: nothing was done. Also if a file to write exists or is an input
  Ctrl-C stops early by the signal; files that were not whole are gone."""

SIZES = range(12, 10000003)  # those of geodesic spheres


class Paths(typing.NamedTuple):
    """What to write for a scan; no picture is an empty name."""
    surfaces: typing.List[str]
    picture: str

    def all(self):
        """All of them."""
        return [*self.surfaces, *filter(None, [self.picture])]


class WrongUsage(Exception):
    """The command makes no sense as given."""


def size(text):
    """A number of points."""
    number = int(text)
    if number not in SIZES:
        raise argparse.ArgumentTypeError(f"{number} is not in [{SIZES[0]}, {SIZES[-1]}]")
    return number


class Renamed(argparse.Action):
    """Option of an earlier version: the error names the new one."""

    def __init__(self, option_strings, dest, new, **kwargs):
        super().__init__(option_strings, dest, nargs="?", **kwargs)
        self.new = new

    def __call__(self, parser, namespace, values, option_string=None):
        parser.error(f"{option_string} is now {self.new}")


def arguments(argv):
    """What the command line says."""
    parser = argparse.ArgumentParser(
        prog="conformalsom", description=DESCRIPTION, epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scans", nargs="+", metavar="SCAN", help="file with the points of one object")
    parser.add_argument("-o", "--output", action="append", default=[], metavar="FILE",
                        help="surface to write, may be given several times: " + " ".join(outputs.SURFACES)
                        + "; {} in it is the scan's name without extension, a folder is FOLDER/{}.glb")
    parser.add_argument("--texture", metavar="IMAGE",
                        help="PNG or JPEG to paint with; default: the scan's own colors, if it has some")
    parser.add_argument("--view", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 0, 1),
                        help="from the object to the viewer, where the texture's middle is; default 0 0 1")
    parser.add_argument("--up", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 1, 0),
                        help="what is up in the texture; default 0 1 0")
    parser.add_argument("--mesh-type", choices=("automatic", "adaptive", "geodesic"), default="automatic",
                        help="of the learned mesh: triangles of one size (adaptive, which automatic "
                        "is unless the points lie in a plane), or the paper's geodesic sphere")
    parser.add_argument("--lattice", action=Renamed, new="--mesh-type", help=argparse.SUPPRESS)
    parser.add_argument("--neurons", type=size, metavar="N",
                        help="points of the learned mesh, default 12962; if geodesic the nearest 10 f^2 + 2")
    parser.add_argument("--points", type=size, metavar="N",
                        help="points of the smooth surface at least, or about; default 64002")
    parser.add_argument("--measure", action="store_true",
                        help="measure distances to the scan and distortion of the map, and print a table")
    parser.add_argument("--report", metavar="FILE", help="write these figures as JSON; - is the standard output, and the table "
                        "goes to the standard error")
    parser.add_argument("--picture", metavar="FILE",
                        help="draw scan, mesh and surface side by side, .png or .jpg; wants a display")
    parser.add_argument("--overwrite", action="store_true", help="replace files that exist, but no inputs")
    parser.add_argument("--version", action="version",
                        version=f"ConformalSOM {conformalsom.__version__}, VTK {vtkVersion.GetVTKVersion()}")
    options = parser.parse_args(argv)
    try:
        return options, paths_of(options)
    except WrongUsage as error:
        parser.error(str(error))


def expect_extension(path, extensions, more=""):
    """Raise WrongUsage for a format that there is no writer for."""
    if outputs.extension_of(path) not in extensions:
        raise WrongUsage(f"{path}: expected a file of type {' '.join(extensions)}{more}")


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


def paths_of(options):
    """The files to write for each scan, after a look at whether they can be written without loss."""
    if not (options.output or options.picture or options.report or options.measure):
        raise WrongUsage("nothing to make: use --output, --picture, --report or --measure")
    expect_directions(options.view, options.up)
    for name in (*options.scans, *options.output, options.texture, options.report, options.picture):
        expect_utf8(name or "")
    inputs = [options.texture or "", *(file for scan in options.scans for file in scan_files.inputs_of(scan))]
    all_paths, files = [], set()
    for scan in options.scans:
        paths = Paths([outputs.surface_named(pattern, scan) for pattern in options.output],
                      outputs.named(options.picture or "", scan))
        for path in paths.surfaces:
            expect_extension(path, outputs.SURFACES, outputs.lacking("Writer"))
        if paths.picture:
            expect_extension(paths.picture, outputs.PICTURES)
        for file in [file for path in paths.all() for file in outputs.files_of(path)]:
            expect_free(file, inputs, options.overwrite, files)
        all_paths.append(paths)
    if options.report not in (None, "-"):
        expect_free(options.report, inputs, options.overwrite, files)
    if options.picture and not pictures.can_draw():
        raise WrongUsage("--picture wants a display: put xvfb-run before the command")
    return all_paths


def expect_free(path, inputs, overwrite, files):
    """Raise WrongUsage for a file that must not be written; the others are added to the files."""
    if os.path.realpath(path) in files:
        raise WrongUsage(f"{path} would be written twice; {{}} in a name stands for the scan's")
    files.add(os.path.realpath(path))
    if os.path.exists(path) and not os.path.isfile(path):
        raise WrongUsage(f"{path} is not a regular file")
    folder = os.path.dirname(os.path.abspath(path))
    while not os.path.lexists(folder):
        folder = os.path.dirname(folder)
    if not (os.path.isdir(folder) and os.access(folder, os.W_OK)):
        raise WrongUsage(f"{path}: {folder} cannot be written to")
    for source in inputs:
        if os.path.exists(source) and os.path.exists(path) and os.path.samefile(source, path):
            raise WrongUsage(f"{path} is an input and would be replaced")
    if os.path.lexists(path) and not overwrite:
        raise WrongUsage(f"{path} already exists; use --overwrite or another name")


def complain(text):
    """Say what went wrong."""
    print(f"conformalsom: {text}", file=sys.stderr)


def message_of(error):
    """What an exception says, with the file it is about."""
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    return str(error)


def write_report(path, entries):
    """Write the figures of all scans as JSON."""
    text = json.dumps({"Version": conformalsom.__version__, "Surfaces": entries}, indent=2) + "\n"
    if path == "-":
        print(text, end="")
        return
    with outputs.whole(path) as part, open(part, "w", encoding="utf-8") as file:
        file.write(text)


def run(options, all_paths, steps):
    """Make all surfaces; returns the exit status."""
    status, texture, entries = 0, None, []
    if options.texture:
        steps.begin(options.texture)
        reader = textures.texture_reader(options.texture)
        steps.run("Read the texture", reader)
        texture = vtkTrivialProducer()
        texture.SetOutput(textures.colors_of(reader.GetOutput()))
    for scan, paths in zip(options.scans, all_paths):
        steps.begin(scan)
        try:
            entries.append(surfaces.make_surface(scan, texture, paths, options, steps))
            steps.summarize(paths.all(), entries[-1]["Surface"]["NumberOfPoints"])
        except (StepFailed, ValueError, OSError) as error:
            text = f"{scan}: {error}" if isinstance(error, StepFailed) else message_of(error)
            entries.append({"Scan": scan, "Error": text})
            steps.clear()
            complain(text)
            status = 1
    if options.report:
        write_report(options.report, entries)
    if sys.stdout:  # it may be closed
        sys.stdout.flush()
    return status


def drop_output():
    """Let what could not be printed go, lest Python tries again at its end."""
    if sys.stdout:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def main(argv=None):
    """Run the command; returns the exit status."""
    options, all_paths = arguments(argv)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)  # what matters is heard by steps
    vtkOutputWindow.SetInstance(vtkStringOutputWindow())
    steps = Bar()
    for number in (signal.SIGINT, signal.SIGTERM):
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, steps.interrupt)
    try:
        return run(options, all_paths, steps)
    except Interrupted as interrupted:
        steps.clear()
        number = interrupted.args[0]
        signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)  # so that whoever called knows
        return 128 + number
    except BrokenPipeError:  # nobody reads on
        drop_output()
        return 1
    except (StepFailed, ValueError, OSError) as error:
        steps.clear()
        complain(message_of(error))
        drop_output()
        return 1
