"""The command conformalsom shapes: a study of the shapes of many scans."""
import argparse
import os

from . import jobs, outputs, shape_groups, shape_landmarks, shape_page, shape_results, shape_steps
from .plan import Checks, Paths, WrongUsage, expect_directions, expect_name, expect_utf8, in_range, parsed, positive
from .scan_files import inputs_of, scan_reader

DESCRIPTION = """\
Compares the shapes of many scans. Makes a closed surface of each scan, registers all surfaces with
their mean, aligns them, and computes their principal components (modes). All surfaces that are
written have the same triangles, and points with equal ids correspond."""

EPILOG = """\
files in FOLDER:
  surfaces/   one aligned surface for each scan
  mean.vtp    the mean, with the modes, and with the test of the groups, as point arrays
  modes/      the mean, moved by -2, -1, 1 and 2 standard deviations of each mode
  scores.csv  scores of each scan, in standard deviations of each mode
  variance.csv  fraction of the variance that each mode explains
  index.html  a page that shows modes by sliders, and groups by color
  study.json  settings, and names of all files
  work/       surfaces that are registered; a call that was stopped continues with them

exit status: as that of conformalsom. After an error, results are not written."""

WORK = "work"  # name of the folder of surfaces that are registered
FORMATS = [extension for extension in outputs.SURFACES if extension not in (".glb", ".html")]


def make_parser():
    """The options, of which --help and the manual page are made."""
    parser = argparse.ArgumentParser(prog="conformalsom shapes", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scans", nargs="+", metavar="SCAN", help="file with the points of one object; two or more")
    parser.add_argument("-o", "--output", required=True, metavar="FOLDER", help="folder to write")
    parser.add_argument("--alignment", choices=("rigid", "similarity"), default="rigid",
                        help="differences that are no shape: position and orientation (rigid), or also size "
                             "(similarity); default rigid")
    parser.add_argument("--groups", metavar="FILE", help="CSV file with the columns scan and group; test at each "
                        "vertex whether the means of the groups differ")
    parser.add_argument("--landmarks", metavar="FILE", help="CSV file with the columns scan, name, x, y and z: points with "
                        "the same names on all scans, in the coordinates of their files. The registered maps agree at "
                        "these points")
    parser.add_argument("--permutations", type=in_range(99, 1000000), default=1000, metavar="N",
                        help="number of permutations of the test, in [99, 1000000]; default 1000")
    parser.add_argument("--random-seed", type=in_range(0, 2**32 - 1), default=0, metavar="N",
                        help="seed of the permutations; default 0")
    parser.add_argument("--points", type=in_range(500, 1000000), default=20000, metavar="N",
                        help="number of points of each surface, within 2 %%; in [500, 1000000], default 20000")
    parser.add_argument("--modes", type=in_range(1, 1000), default=10, metavar="N",
                        help="maximum number of modes to write; default 10")
    parser.add_argument("--rounds", type=in_range(0, 100), default=2, metavar="N",
                        help="how often all surfaces are registered with their mean; in [0, 100], default 2")
    parser.add_argument("--format", choices=FORMATS, default=".ply", help="format of the surfaces and modes; default .ply")
    parser.add_argument("--view", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 0, 1),
                        help="direction to the viewer of the page, in coordinates of the first scan; default 0 0 1")
    parser.add_argument("--up", nargs=3, type=float, metavar=("X", "Y", "Z"), default=(0, 1, 0),
                        help="direction that is up in the page; default 0 1 0")
    parser.add_argument("--overwrite", action="store_true", help="replace the results of an earlier study in FOLDER")
    parser.add_argument("--jobs", type=positive, default=1, metavar="N",
                        help="number of surfaces to process at a time; default 1")
    parser.set_defaults(report=None)  # of which jobs ask
    return parser


def arguments(argv):
    """What the command line says."""
    return parsed(make_parser(), argv, expect_sense)


def expect_sense(options):
    """Raise WrongUsage where the call makes no sense, or would replace what it must not."""
    for name in (*options.scans, options.output, options.groups, options.landmarks):
        expect_utf8(name or "")
    expect_directions(options.view, options.up)
    if len(options.scans) < 2:
        raise WrongUsage("two scans or more are needed")
    options.names = [os.path.splitext(os.path.basename(scan))[0] for scan in options.scans]
    for name in options.names:
        expect_name(name)
        if options.names.count(name) > 1:
            raise WrongUsage(f"two scans have the name {name}, which names their surfaces")
    expect_folder(options)


def expect_folder(options):
    """Raise WrongUsage if a study cannot be written to the folder, or would replace something else."""
    folder = options.output
    expect_name(folder)
    real = os.path.realpath(folder)
    inputs = [file for scan in options.scans for file in inputs_of(scan)]
    inputs += [table for table in (options.groups, options.landmarks) if table]
    for path in inputs:
        if os.path.realpath(path).startswith(os.path.join(real, "")):
            raise WrongUsage(f"{path} is an input, but lies in the folder to write")
    if not os.path.lexists(folder):
        parent = os.path.dirname(real)
        while not os.path.lexists(parent):
            parent = os.path.dirname(parent)
        if not (os.path.isdir(parent) and outputs.may(parent, os.W_OK | os.X_OK)):
            raise WrongUsage(f"{folder} cannot be made: no files can be made in {parent}")
        return
    work = os.path.join(folder, WORK)
    for path in (folder, work) if os.path.lexists(work) else (folder,):
        if not os.path.isdir(path):
            raise WrongUsage(f"{path} is not a folder")
        if not outputs.may(path, os.W_OK | os.X_OK):
            raise WrongUsage(f"{path}: this user may not write it")
    expect_study(options)
    checks = Checks(inputs, options.overwrite)
    for path in (os.path.join(folder, name) for name in shape_results.names_of(options)):
        if os.path.islink(path):
            raise WrongUsage(f"{path} is not a regular file")
        checks.expect_free(path)


def expect_study(options):
    """Raise WrongUsage if the folder has files of no study, or without --overwrite more than a stopped call leaves."""
    folder = options.output
    there = {name for name in os.listdir(folder) if not name.startswith(outputs.PREFIX)}  # else of a killed call
    if there and not there & {WORK, shape_results.REPORT}:
        raise WrongUsage(f"{folder} has files that are not of a study; use a new folder")
    if options.overwrite:
        return
    if shape_results.REPORT in there:
        raise WrongUsage(f"{folder} has a study already; use --overwrite or another folder")
    if there - {WORK}:
        raise WrongUsage(f"{folder} has more than the folder {WORK}; use --overwrite or another folder")


class Failed(Exception):
    """A step failed, and its message has been printed."""


class Study:
    """The steps of a study; those whose files exist are not done again."""

    def __init__(self, options, bar):
        self.options, self.bar = options, bar
        self.work = os.path.join(options.output, WORK)

    def jobs(self, steps, make):
        """Do steps, each in a process of its own."""
        entries = jobs.Jobs(steps, self.options, None, self.bar, make).run()
        if any("Error" in entry for entry in entries):
            raise Failed

    def done(self, steps):
        """Do steps; returns their files."""
        steps = list(steps)
        waiting = {step.file: step for step in steps if not os.path.isfile(step.file)}
        if waiting:
            self.jobs(list(waiting.values()), shape_steps.make)
        return [step.file for step in steps]

    def registered(self, maps, fixed, number=None):
        """All maps registered with a surface: the map of this number, which stays as it is, or a mean."""
        landmarks = self.options.landmarks_of
        of_fixed = landmarks[number:number + 1] if landmarks and number is not None else ()
        stays = [path == fixed and tuple(landmarks[i:i + 1]) == tuple(of_fixed) for i, path in enumerate(maps)]
        files = iter(self.done(
            shape_steps.step_of("register", self.options.scans[i], [path, fixed], self.work,
                                landmarks=(*landmarks[i:i + 1], *of_fixed))
            for i, path in enumerate(maps) if not stays[i]))
        return [path if stays[i] else next(files) for i, path in enumerate(maps)]

    def mean(self, surfaces, first):
        """The mean of surfaces, oriented as one of them."""
        landmarks = self.options.landmarks_of
        order, places = ([items[first], *items[:first], *items[first + 1:]] if items else []
                         for items in (surfaces, landmarks))
        return self.done([shape_steps.step_of("mean", "mean", order, self.work, self.options.alignment,
                                              landmarks=tuple(places))])[0]

    def surfaces(self):
        """All surfaces registered with their mean, in the order of vtkSphericalTemplate."""
        maps = self.done(shape_steps.step_of("map", scan, [scan], self.work) for scan in self.options.scans)
        self.note_copies(maps)
        surfaces = self.registered(maps, maps[0], 0)
        start = shape_steps.closest_of(self.mean(surfaces, 0))
        surfaces = self.registered(maps, maps[start], start)
        for _ in range(self.options.rounds):
            surfaces = self.registered(maps, self.mean(surfaces, start))
        return surfaces

    def note_copies(self, maps):
        """Show which scans have the same content: the names of their maps are hashes of it."""
        for path in dict.fromkeys(maps):
            first, *copies = (scan for scan, map_ in zip(self.options.scans, maps) if map_ == path)
            if copies:
                self.bar.note(f"conformalsom: {first}: note: its content is that of {', '.join(copies)}; scans must be "
                              "independent, so that modes and tests are true: use each scan once")

    def run(self):
        """Make the study; returns the exit status."""
        os.makedirs(self.work, exist_ok=True)
        try:
            mean = os.path.join(self.options.output, "mean.vtp")
            step = shape_steps.Step("results", self.options.output, tuple(self.surfaces()), Paths([mean], ""),
                                    outputs.new_token(), self.work)
            self.jobs([step], shape_results.make)
        except Failed:
            return 1
        return 0


def run(options, bar):
    """Make a study; returns the exit status. Raises ValueError or OSError for unsuitable inputs."""
    for scan in options.scans:
        scan_reader(scan)
        with open(scan, "rb"):  # or an error that names the reason
            pass
    options.groups_of = shape_groups.read_groups(options.groups, options.names) if options.groups else []
    options.landmarks_of = shape_landmarks.read_landmarks(options.landmarks, options.names) if options.landmarks else []
    shape_page.template()  # or an error before any work
    return Study(options, bar).run()
