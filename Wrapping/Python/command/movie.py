"""The command conformalsom movie: maps of a body over time, in which each part of the body keeps its place."""
import argparse
import math
import os

from . import jobs, movie_frames, movie_page, movie_results, outputs, volumes
from .plan import Checks, Paths, WrongUsage, expect_extension, expect_name, expect_utf8, in_range, parsed
from .scan_files import inputs_of
from .surfaces import Task

DESCRIPTION = """\
Maps a body that moves and grows, such as an embryo, an organ or an organoid. A frame is a volume
(TIFF stack of ImageJ, NIfTI, MetaImage, NRRD, VTI), a closed surface, or a cloud of points. A TIFF
stack with several time steps has as many frames. Each frame becomes a closed surface with a map to
the sphere, and the maps are made to correspond: a cell has the same place in the maps of all frames.
The maps are written as one TIFF stack, which Fiji, ImageJ and tifffile open with axes TZCYX, spacing,
unit and frame interval."""

EPILOG = """\
maps:
  of volumes    the brightness in layers below and above the surface, all channels
  of surfaces   a point array, by default AreaRate, the relative growth of areas [1/s]

A frame that cannot be used is skipped: its map is 0, and its row of the table is empty.

examples:
  conformalsom movie embryo_*.tif -o map.tif --time-step 30
  conformalsom movie movie.tif -o map.tif --projection mercator --page map.html --table map.csv
  conformalsom movie gut_*.ply -o growth.tif --table growth.csv --surfaces surfaces/

exit status: as that of conformalsom; 1 also if frames were skipped."""

LARGEST = 1000000
INTERVAL_TOLERANCE = 1e-3  # relative: files may have few digits


def make_parser():
    """The options, of which --help and the manual page are made."""
    parser = argparse.ArgumentParser(prog="conformalsom movie", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("frames", nargs="+", metavar="FRAME", help="files, in the order of time")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="stack of maps to write, .tif or .tiff")
    parser.add_argument("--channel", type=in_range(0, LARGEST), default=0, metavar="N",
                        help="channel of volumes in which the outside of the body is found, counted from 0; choose one "
                             "that is bright all over the body; default 0")
    parser.add_argument("--depths", nargs=2, type=float, metavar=("LOW", "HIGH"),
                        help="depths of the first and the last layer, in the unit of the volume, negative below the "
                             "surface; two layers for each voxel. Default: 4 voxels below to 4 above")
    parser.add_argument("--array", metavar="NAME", help="point array of surfaces to map: AreaRate (default), ShearRate, "
                        "NormalVelocity, TangentialVelocity, Velocity, or an array of the files, such as their colors")
    parser.add_argument("--projection", choices=movie_results.PROJECTIONS, default="equirectangular",
                        help="projection of the maps; default equirectangular. The poles are the ends of the longest axis of the body")
    parser.add_argument("--size", type=in_range(16, 16384), default=1000, metavar="N",
                        help="width of the maps in pixels; the projection determines the height; default 1000")
    parser.add_argument("--reference", type=in_range(0, LARGEST), metavar="N",
                        help="frame whose map stays as it is, counted from 0; the spacing of the maps is true for it. "
                             "Default: the first that can be used")
    parser.add_argument("--time-step", type=float, metavar="SECONDS",
                        help="time between two frames; default: that of TIFF stacks with several time steps, which must "
                             "agree, else 1")
    parser.add_argument("--unit", metavar="NAME", help="unit of all coordinates, such as micron; default: that of the volumes")
    parser.add_argument("--table", metavar="FILE", help="measures of each frame to write, .csv: area, volume, speeds and rates")
    parser.add_argument("--surfaces", metavar="FOLDER", help="folder for a .vtp file of each frame: the surface with map, "
                        "velocities, rates and layers")
    parser.add_argument("--page", metavar="FILE", help="page to write, .html: the surface and its map with a slider for time")
    parser.add_argument("--overwrite", action="store_true", help="replace existing files, except inputs, and remove "
                        "earlier surfaces of frames that are skipped")
    parser.set_defaults(report=None, jobs=1)  # of which jobs ask
    return parser


def arguments(argv):
    """What the command line says."""
    return parsed(make_parser(), argv, expect_sense)


def expect_sense(options):
    """Raise WrongUsage where the call makes no sense, or would replace what it must not."""
    for name in (*options.frames, options.output, options.table, options.surfaces, options.page, options.unit):
        expect_utf8(name or "")
    if len({volumes.is_volume(path) for path in options.frames}) > 1:
        raise WrongUsage("some frames are volumes, others are surfaces; use one kind")
    options.has_volumes = volumes.is_volume(options.frames[0])
    if options.has_volumes and options.array:
        raise WrongUsage("--array is of surfaces; maps of volumes show their brightness")
    if not options.has_volumes and (options.depths or options.channel):
        raise WrongUsage("--depths and --channel are of volumes, but the frames are surfaces")
    if options.depths and not options.depths[0] < options.depths[1]:
        raise WrongUsage("--depths: the first must be less than the last")
    if options.depths and not all(abs(depth) < float("inf") for depth in options.depths):
        raise WrongUsage("--depths must be finite")
    if options.time_step is not None and not 1e-9 <= options.time_step <= 1e9:
        raise WrongUsage("--time-step must be in [1e-9, 1e9]")
    if options.unit is not None and ("=" in options.unit or not options.unit.isprintable() or not options.unit):
        raise WrongUsage("--unit must be a word such as micron")
    options.all_frames, intervals = movie_frames.frames_of(options.frames)
    options.interval = options.time_step or interval_of(intervals)
    names = [frame.name for frame in options.all_frames]
    if options.surfaces and len(set(names)) < len(names):
        twice = next(name for name in names if names.count(name) > 1)
        raise WrongUsage(f"two frames have the name {twice}, which names their surfaces")
    if options.reference is not None and options.reference >= len(names):
        raise WrongUsage(f"--reference is {options.reference}, but there are {len(names)} frames, counted from 0")
    expect_files(options)


def interval_of(intervals):
    """The interval of pairs of path and interval [s], or 1 without files. Raises WrongUsage if intervals differ."""
    first, interval = intervals[0] if intervals else ("", 1.0)
    for path, other in intervals[1:]:
        if not math.isclose(other, interval, rel_tol=INTERVAL_TOLERANCE):
            raise WrongUsage(f"{first} has a frame each {interval:g} s, but {path} each {other:g} s; give --time-step")
    return interval if 1e-9 <= interval <= 1e9 else 1.0


def expect_files(options):
    """Raise WrongUsage if a file cannot be written, or would replace something."""
    checks = Checks([file for path in options.frames
                     for file in ([path] if options.has_volumes else inputs_of(path))], options.overwrite)
    for path, extensions in ((options.output, (".tif", ".tiff")), (options.table, (".csv",)), (options.page, (".html",))):
        if path:
            expect_extension(path, extensions)
            checks.expect_free(path)
    options.surface_files = []
    if options.surfaces:
        expect_name(options.surfaces)
        if os.path.lexists(options.surfaces) and not os.path.isdir(options.surfaces):
            raise WrongUsage(f"{options.surfaces} is not a folder")
        options.surface_files = [os.path.join(options.surfaces, frame.name + ".vtp") for frame in options.all_frames]
    for path in options.surface_files:
        checks.expect_free(path)
    checks.expect_no_file_is_a_folder()


def run(options, bar):
    """Make the maps; returns the exit status. Raises OSError for a frame that is not there."""
    for path in options.frames:
        with open(path, "rb"):  # or an error that names the reason
            pass
    if options.page:
        movie_page.template()  # or an error before any work
    paths = Paths([*filter(None, (options.output, options.table, options.page)), *options.surface_files], "")
    task = Task(options.output, paths, outputs.new_token())
    entries = jobs.Jobs([task], options, None, bar, movie_results.make).run()
    return 1 if any("Error" in entry or entry.get("Skipped") for entry in entries) else 0
