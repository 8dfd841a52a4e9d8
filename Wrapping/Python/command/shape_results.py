"""Results of a study of shapes: surfaces, mean, modes, tables and page, written together at the end."""
import contextlib
import csv
import json
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPolyData
from vtkmodules.vtkFiltersGeneral import vtkWarpVector

import conformalsom

from . import jobs, outputs, shape_groups, shape_page, shape_steps

REPORT = "study.json"
SIGMAS = (-2, -1, 1, 2)  # of modes that are written; the mean is between them


def make(step, options, _, steps):
    """Make all results from the registered surfaces; returns an entry of a report, and what to print."""
    remesh = shape_steps.remeshed(step.sources, options, steps, "Find the modes")
    surfaces = [remesh.GetOutput().GetBlock(i) for i in range(len(step.sources))]
    mean = remesh.GetMeanSurface()
    scores = shape_steps.scores_of(remesh)
    shares = shape_steps.shares_of(remesh)
    kept = min(options.modes, len(shares))
    for k in range(kept, len(shares)):
        mean.GetPointData().RemoveArray(f"ShapeMode{k + 1}")
    report = {"Version": conformalsom.__version__, "Alignment": options.alignment, "Rounds": options.rounds,
              "NumberOfPoints": mean.GetNumberOfPoints(), "Scans": options.scans, "Groups": options.groups_of,
              "NumberOfLandmarks": len(options.landmarks_of[0]) if options.landmarks_of else 0}
    if options.groups_of:
        report.update(tested(surfaces, mean, options, steps))
    with Results(options.output, step.token, steps) as results:
        for name, surface in zip(options.names, surfaces):
            results.surface(os.path.join("surfaces", name + options.format), surface)
        for k in range(kept):
            for sigmas in SIGMAS:
                name = os.path.join("modes", f"mode{k + 1}_{sigmas:+}{options.format}")
                results.surface(name, varied(mean, k, sigmas))
        results.surface("mean.vtp", mean)
        head = ["scan", *(["group"] if options.groups_of else []), *(f"mode{k + 1}" for k in range(kept))]
        firsts = zip(options.names, options.groups_of) if options.groups_of else zip(options.names)
        results.table("scores.csv", head, [[*first, *map(text_of, row[:kept])] for first, row in zip(firsts, scores)])
        results.table("variance.csv", ["mode", "fraction", "cumulative"], [
            [k + 1, text_of(share), text_of(sum_)] for k, (share, sum_) in enumerate(zip(shares, np.cumsum(shares)))])
        results.text("index.html", shape_page.page_of(mean, shares, scores[:, :kept], report, options))
        report["Files"] = results.names
        results.text(REPORT, json.dumps(report, indent=2) + "\n")
        with jobs.blocked_signals():
            results.publish(options.overwrite)
    entry = {"Scan": step.scan, "Surface": {"NumberOfPoints": mean.GetNumberOfPoints()}, "Seconds": steps.seconds,
             "Warnings": steps.warnings}
    return entry, summary_of(shares[:kept], report)


def text_of(number):
    """A number in the shortest text that gives the same number again."""
    return repr(float(number))


def summary_of(shares, report):
    """What to print at the end."""
    lines = ["variance of modes   " + (" ".join(f"{share:.3f}" for share in shares)
                                       or "none: all shapes are equal, so that there are no modes")]
    if "MinimumCorrectedP" in report:
        lines.append(f"groups              {report['MinimumCorrectedP']:.4g} is the smallest corrected p; "
                     f"{report['SignificantFraction']:.1%} of the vertices are below 0.05")
    return "\n".join(lines) + "\n"


def tested(surfaces, mean, options, steps):
    """Add arrays of the test of groups to the mean; returns what is to be reported."""
    shapes = np.array([vtk_to_numpy(surface.GetPoints().GetData()) for surface in surfaces])
    label = "Test the groups"
    steps.began(label)
    test = shape_groups.test_groups(shapes, options.groups_of, options.permutations, options.random_seed,
                                    lambda fraction: steps.advanced(label, fraction))
    for name, values in zip(("GroupF", "GroupP", "GroupPCorrected"), test):
        mean.GetPointData().AddArray(shape_steps.vtk_numbers(values, name))
    return {"Permutations": options.permutations, "RandomSeed": options.random_seed,
            "MinimumCorrectedP": float(test.corrected.min()),
            "SignificantFraction": float((test.corrected < 0.05).mean())}


def varied(mean, mode, sigmas):
    """The mean, moved by so many standard deviations of a mode."""
    warp = vtkWarpVector()
    warp.SetInputData(mean)
    warp.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, f"ShapeMode{mode + 1}")
    warp.SetScaleFactor(sigmas)
    warp.Update()
    shape = vtkPolyData()
    shape.CopyStructure(warp.GetOutput())
    shape.GetPointData().AddArray(mean.GetPointData().GetArray(shape_steps.SPHERE))
    return shape


def names_of(options):
    """Names of all files that a study may write."""
    modes = (f"mode{k + 1}_{sigmas:+}" for k in range(min(options.modes, len(options.names))) for sigmas in SIGMAS)
    return [*(os.path.join("surfaces", name + options.format) for name in options.names),
            *(os.path.join("modes", name + options.format) for name in modes),
            "mean.vtp", "scores.csv", "variance.csv", "index.html", REPORT]


class Results:
    """Files that are made in a folder of their own, and take their places together. The block removes the folder."""

    def __init__(self, output, token, steps):
        self.output, self.token, self.steps = output, token, steps
        self.names, self.made = [], []  # of files, and of new folders
        self.folder = os.path.join(output, outputs.PREFIX + token)
        os.mkdir(self.folder, 0o700)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        outputs.discard(map(self.place, [REPORT, *self.names]), self.token)
        for folder in self.made:
            with contextlib.suppress(OSError):  # it has files now
                os.rmdir(folder)

    def place(self, name):
        """Where a file is to be."""
        return os.path.join(self.output, name)

    def path(self, name):
        """Where to write a file for now."""
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        self.names.append(name)
        return path

    def surface(self, name, surface):
        """Write a surface."""
        writer = outputs.writer_of(name, painted=False)
        writer.SetInputData(surface)
        outputs.write_part(self.steps, writer, self.path(name), self.place(name))

    def table(self, name, head, rows):
        """Write a table."""
        with outputs.named_errors(self.place(name)), open(self.path(name), "w", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows([head, *rows])

    def text(self, name, text):
        """Write a text."""
        with outputs.named_errors(self.place(name)), open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def publish(self, overwrite):
        """Put all files into their places, or none, and remove those of an earlier study."""
        for name in self.names:
            place = self.place(name)
            if os.path.islink(place) or os.path.lexists(place) and not os.path.isfile(place):
                raise ValueError(f"{place} is not a regular file")
        stale = set(files_of_study(self.output)) - set(self.names)
        for folder in {os.path.dirname(self.place(name)) for name in self.names}:
            if not os.path.isdir(folder):
                os.mkdir(folder)
                self.made.append(folder)
        places = {name: outputs.Place(self.place(name), overwrite) for name in self.names}
        files = [(os.path.join(self.folder, name), place) for name, place in places.items()]
        with self.set_aside(places[REPORT]):
            outputs.take_places(files, self.token)
        self.remove(stale)

    @contextlib.contextmanager
    def set_aside(self, report):
        """Move an old report away during the block, while files are of two studies; after an error, put it back."""
        if report.old is None:
            yield
            return
        kept = os.path.join(self.folder, "earlier")
        outputs.copy_access(report, os.path.join(self.folder, REPORT))
        os.rename(report.path, kept)
        report.old = None
        try:
            yield
        except BaseException:
            os.replace(kept, report.path)
            raise

    def remove(self, names):
        """Remove files. A note names a file that cannot be removed: the study is complete nevertheless."""
        for name in names:
            try:
                os.unlink(self.place(name))
            except FileNotFoundError:
                pass
            except OSError as error:
                self.steps.note("Remove the earlier study", f"{self.place(name)}: {error.strerror}")


def files_of_study(folder):
    """The files of a complete study in a folder, as its report lists them; else none."""
    try:
        with open(os.path.join(folder, REPORT), encoding="utf-8") as file:
            names = json.load(file)["Files"]
    except (OSError, ValueError, KeyError, TypeError):
        return []
    return [name for name in names if isinstance(name, str) and os.path.basename(name) not in ("", ".", "..")
            and os.path.dirname(name) in ("", "surfaces", "modes")]
