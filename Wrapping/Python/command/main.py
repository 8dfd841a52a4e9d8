"""The command conformalsom: from scans to painted surfaces."""
import argparse
import contextlib
import difflib
import importlib
import json
import os
import signal
import sys

from vtkmodules.vtkCommonCore import vtkVersion

import conformalsom
from conformalsom.messages import FilterFailed

from . import details, jobs, outputs, pictures, presets, surfaces, textures
from .plan import METERS, WrongUsage, expect_directions, expect_utf8, in_range, paths_of, positive
from .progress import Bar, printable
from .steps import Interrupted, message_of

DESCRIPTION = """\
Turns the points of 3-D scans into closed, smooth, painted surfaces. A scan may have any format that
ConformalSOM or VTK reads (PLY, OFF, PCD, E57, LAS, points as text, FreeSurfer, GIFTI, OBJ, STL, VTP
...). Its points and colors are used; its triangles are used only if they form one closed surface."""

EPILOG = """\
examples:
  conformalsom scan.ply --texture photo.png -o surface.glb
  conformalsom scan.ply -o surface.vtp -o surface.stl --report figures.json
  conformalsom scans/*.ply -o 'surfaces/{}.glb'
  conformalsom shapes scans/*.ply -o study/
  conformalsom map body.tab -o map.tif
  conformalsom movie frames/*.tif -o map.tif

See conformalsom shapes --help for studies of the shapes of many scans, conformalsom map --help for maps of
bodies as GeoTIFF files, and conformalsom movie --help for maps of tissue over time.

exit status:
  0  all files were written
  1  a file could not be read or written, or a filter failed or crashed; other scans were processed
  2  wrong usage, no file was written. Also if an output file exists, cannot be written, or is an input
  Ctrl-C ends the command by the signal; unfinished files are removed."""

SUBCOMMANDS = {"map": ".maps", "movie": ".movie", "shapes": ".shapes"}  # and their modules
LARGEST = 10000002  # number of points of a geodesic sphere
MINIMUM_POINTS = 500  # of an adaptive sphere


class Renamed(argparse.Action):
    """Option of an earlier version: the error names the new one."""

    def __init__(self, option_strings, dest, new, **kwargs):
        super().__init__(option_strings, dest, nargs="?", **kwargs)
        self.new = new

    def __call__(self, parser, namespace, values, option_string=None):
        parser.error(f"{option_string} is now {self.new}")


def make_parser():
    """The options, of which --help and the manual page are made."""
    parser = argparse.ArgumentParser(
        prog="conformalsom", description=DESCRIPTION, epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scans", nargs="+", metavar="SCAN", help="file with the points of one object")
    parser.add_argument("-o", "--output", action="append", default=[], metavar="FILE",
                        help="surface to write; repeat for several files: " + " ".join(outputs.SURFACES)
                        + "; {} stands for the scan's name without extension, a folder for FOLDER/{}.glb")
    parser.add_argument("--texture", metavar="IMAGE",
                        help="PNG or JPEG of up to 2^28 pixels to paint with; default: the scan's own colors, if it has some")
    parser.add_argument("--texture-map", choices=("balanced", "conformal"), default="balanced",
                        help="map by which pictures are laid: one that balances areas and angles (balanced), or the "
                             "surface's own map (conformal), which distorts pictures least; default balanced")
    parser.add_argument("--texture-size", type=in_range(1, 16384), metavar="N",
                        help="width and height of the texture with the scan's colors, in pixels, in [1, 16384]; by default, the "
                             "density of the scan determines it, up to 4096")
    parser.add_argument("--view", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 0, 1),
                        help="direction from the object to the viewer, which the texture's middle faces; default 0 0 1")
    parser.add_argument("--up", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 1, 0),
                        help="direction that is up in the texture; default 0 1 0")
    parser.add_argument("--mesh-type", choices=("automatic", "adaptive", "geodesic"), default="automatic",
                        help="type of the learned mesh: triangles of equal size (adaptive), the paper's geodesic "
                        "sphere (geodesic), or adaptive unless the points lie in a plane (automatic)")
    parser.add_argument("--lattice", action=Renamed, new="--mesh-type", help=argparse.SUPPRESS)
    parser.add_argument("--neurons", type=in_range(12, LARGEST), metavar="N",
                        help="number of points of the learned mesh; by default, the number of points of the "
                             "scan and their noise determine it, up to 12962; for a geodesic mesh the nearest 10 f^2 + 2")
    border = parser.add_mutually_exclusive_group()
    border.add_argument("--open", dest="border", action="store_const", const="Open", default="Automatic",
                        help="end the surface where the points end, for scans from one side; small holes are filled. By "
                             "default, the surface is open if more than 22 percent of the closed surface has no points")
    border.add_argument("--closed", dest="border", action="store_const", const="Closed",
                        help="close the surface where there are no points")
    parser.add_argument("--points", type=in_range(MINIMUM_POINTS, LARGEST), metavar="N",
                        help="number of points of the surface in each written file, within 2 percent, in [500, "
                             "10000002]. Points that are duplicated where a picture is cut are counted, too. A note "
                             "says so if the cut of a picture needs more points; by default, each triangle of the learned mesh is divided until there are 64002 or more")
    parser.add_argument("--preset", choices=presets.PRESETS,
                        help="values of options for a purpose, unless they are given: web (10,000 points with a normal "
                             "map, compressed), game (8,000, 2,000 and 500 to 1,000 points with a normal map), print "
                             "(a closed surface as .3mf and .stl in millimeters), archive (250,000 points)")
    parser.add_argument("--normal-map", action="store_true", default=None,
                        help="show the details of the smooth surface on one of N points: write a normal map into .glb "
                             "files; with --points N")
    parser.add_argument("--levels", type=positive, metavar="N",
                        help="number of levels of detail in .glb files (extension MSFT_lod); with --points N. Each "
                             "level has about a quarter of the points of the one before, but at least 500 and those "
                             "that are duplicated where a picture is cut, together up to about 1,000; default 1")
    parser.add_argument("--unit", choices=METERS,
                        help="unit of the scan's coordinates; .glb files are in meters, as glTF requires, .3mf files in "
                             "millimeters, and with --preset print also .stl files. Default: that of the label beside a "
                             "plate model (.lbl or .xml), else m")
    parser.add_argument("--compress", action="store_true",
                        help="write small .glb files: points and triangles by the extensions KHR_mesh_quantization and "
                             "EXT_meshopt_compression of glTF, and pictures as JPEG")
    parser.add_argument("--measure", action="store_true",
                        help="measure distances to the scan and distortion of the map, and print a table")
    parser.add_argument("--report", metavar="FILE", help="write figures, times and warnings as JSON; with - to the standard output, "
                        "and the table to the standard error")
    parser.add_argument("--picture", metavar="FILE",
                        help="draw scan, mesh and surface side by side, .png or .jpg; before VTK 9.4, this needs a display")
    parser.add_argument("--overwrite", action="store_true", help="replace existing files, except inputs")
    parser.add_argument("--jobs", type=positive, default=1, metavar="N",
                        help="number of scans to process at a time, with the processors divided among them; default 1")
    parser.add_argument("--version", action="version",
                        version=f"ConformalSOM {conformalsom.__version__}, VTK {vtkVersion.GetVTKVersion()}")
    return parser


def arguments(argv):
    """What the command line says."""
    parser = make_parser()
    options = parser.parse_args(argv)
    try:
        return options, plan_of(options)
    except WrongUsage as error:
        parser.error(printable(str(error)))


def plan_of(options):
    """The files to write for each scan, after a look at whether the call makes sense."""
    expect_no_subcommand(options.scans[0])
    if not (options.output or options.picture or options.report or options.measure):
        raise WrongUsage("there is nothing to do: use --output, --picture, --report or --measure")
    expect_directions(options.view, options.up)
    presets.apply(options)
    if options.texture and options.texture_size is not None:
        raise WrongUsage("--texture-size is the size of a texture made from the scan's colors; without --texture")
    for name in (*options.scans, *options.output, options.texture, options.report, options.picture):
        expect_utf8(name or "")
    all_paths = paths_of(options)
    presets.expect_sense(options, [path for paths in all_paths for path in paths.surfaces])
    details.expect_classes(options)
    if options.picture and not pictures.can_draw():
        raise WrongUsage("--picture needs a display: put xvfb-run before the command")
    return all_paths


def expect_no_subcommand(scan):
    """Raise WrongUsage if the first scan is no file, and nearly the name of a subcommand."""
    near = difflib.get_close_matches(scan.lower(), SUBCOMMANDS, 1, 0.7)
    if near and not os.path.splitext(scan)[1] and not os.path.exists(scan):
        raise WrongUsage(f"{scan}: no such file; the subcommand is {near[0]}")


def complain(text):
    """Say what went wrong."""
    if sys.stderr is not None:
        print(f"conformalsom: {printable(text)}", file=sys.stderr)


def write_report(path, entries, overwrite):
    """Write the figures of all scans as JSON."""
    text = json.dumps({"Version": conformalsom.__version__, "Surfaces": entries}, indent=2) + "\n"
    if path == "-":
        with outputs.named_errors("the standard output"):
            print(text, end="", flush=True)
        return
    with outputs.whole(path, files=[path], overwrite=overwrite) as part:
        with outputs.named_errors(path), open(part, "w", encoding="utf-8") as file:
            file.write(text)


def run(options, all_paths, bar):
    """Make all surfaces; returns the exit status."""
    pixels = None
    if options.texture:
        bar.show(options.texture, "Read the texture", 0)
        pixels = textures.read_picture(options.texture)
    tasks = [surfaces.Task(scan, paths, outputs.new_token()) for scan, paths in zip(options.scans, all_paths)]
    entries = jobs.Jobs(tasks, options, pixels, bar).run()
    if options.report:
        write_report(options.report, entries, options.overwrite)
    return 1 if any("Error" in entry for entry in entries) else 0


def drop_output():
    """Discard output that could not be printed, so that Python does not print it again at exit."""
    if sys.stdout:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def occupy_standard_streams():
    """Open closed standard streams, so that no file gets descriptor 0, 1 or 2."""
    while True:
        descriptor = os.open(os.devnull, os.O_RDWR)
        if descriptor > 2:
            os.close(descriptor)
            return


class Interruption:
    """A signal handler that stops the command once, however often it is called."""

    def __init__(self):
        self.number = None

    def __call__(self, number, _):
        if self.number is None:
            self.number = number
            raise Interrupted(number)


def main(argv=None):
    """Run the command; returns the exit status."""
    argv = sys.argv[1:] if argv is None else list(argv)
    occupy_standard_streams()
    if argv and argv[0] in SUBCOMMANDS:
        return subcommand(argv)
    return guarded(lambda bar: surfaces_of(argv, bar))


def surfaces_of(argv, bar):
    """Run the command without a subcommand; returns the exit status."""
    with named_help():
        options, all_paths = arguments(argv)
    if sys.stdout is None and (options.measure or options.report == "-"):
        complain("the standard output is closed, but the table or the report needs it")
        return 1
    return run(options, all_paths, bar)


def subcommand(argv):
    """Run shapes, map or movie, which need classes that a build may leave out; returns the exit status."""
    try:
        chosen = importlib.import_module(SUBCOMMANDS[argv[0]], __package__)
    except ImportError as error:
        complain(f"{argv[0]}: {error}")
        return 1

    def work(bar):
        with named_help():
            options = chosen.arguments(argv[1:])
        return chosen.run(options, bar)
    return guarded(work)


@contextlib.contextmanager
def named_help():
    """Raise OSError if the text of --help or --version, after which argparse exits, cannot be printed."""
    try:
        try:
            yield
        except SystemExit:
            if sys.stdout is not None:
                sys.stdout.flush()
            raise
    except OSError as error:
        raise OSError(error.errno, error.strerror, error.filename or "the standard output") from error


def guarded(work):
    """Call work() with a bar, and end as asked by signals; returns the exit status."""
    jobs.silence()
    bar = Bar()
    jobs.handle_signals(Interruption())
    try:
        return work(bar)
    except Interrupted as interrupted:
        bar.clear()
        number = interrupted.args[0]
        signal.signal(number, signal.SIG_DFL)
        os.kill(os.getpid(), number)  # so that whoever called knows
        return 128 + number
    except BrokenPipeError:  # nobody reads on
        drop_output()
        return 1
    except (ValueError, OSError, FilterFailed, MemoryError) as error:
        bar.clear()
        complain(message_of(error))
        drop_output()
        return 1
