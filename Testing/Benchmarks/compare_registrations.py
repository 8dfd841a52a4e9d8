#!/usr/bin/python3
"""vtkSphericalRegistration in figures: tables of Documentation/Correspondence.md.

    compare_registrations.py FOLDER [--landmarks 0 7 21] [--both] [--space Rotation] ...

FOLDER has closed meshes NAME.off of genus zero, and for each a file NAME.landmarks: point ids, one a line, which
correspond from file to file. Every pair is registered by some of the landmarks (0: by shape alone); the error is that
of the others, or of all where all are given: each landmark of the moving surface is looked up where it ends on the
fixed one's sphere, and the way from there along the fixed surface's edges to the true landmark counts, over the
square root of the surface's area. A pair is wrong if its mean error is above 0.25, and reported if Ambiguous is 1.
With --template, vtkSphericalTemplate registers all meshes with their mean, and pairs correspond through the mean.
PYTHONPATH is that of the build.
"""
import argparse
import glob
import itertools
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from compare_lattices import triangulated  # pylint: disable=wrong-import-position
from helpers import paper_models  # pylint: disable=wrong-import-position
from conformalsom import (  # pylint: disable=wrong-import-position
    vtkGlobalConformalMap, vtkSphericalRegistration, vtkSphericalTemplate)
from conformalsom.command import scan_files  # pylint: disable=wrong-import-position
from conformalsom.inputs import mark_landmarks  # pylint: disable=wrong-import-position

FAR = 0.25  # an error as from head to tail


class SpherePlaces:
    """A surface with a map, on which directions on the sphere are looked up."""

    def __init__(self, points, triangles, sphere):
        self.points, self.triangles = points, triangles
        a, b, c = points[triangles.T]
        self.size = np.sqrt(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())
        a, b, c = sphere[triangles.T]
        # A direction d is in the triangle whose three products with d are at least 0.
        self.inside = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=1)
        self.inside /= np.einsum("ij,ij->i", a, self.inside[:, 0])[:, None, None]

    def find(self, direction):
        """The corners of the triangle that has a direction, and the position there."""
        weights = self.inside @ direction
        found = weights.min(axis=1).argmax()
        weights = np.maximum(weights[found], 0.0)
        corners = self.triangles[found]
        return corners, weights @ self.points[corners] / weights.sum()

    def landmark_errors(self, directions, distances):
        """From where each direction leads to the landmark, whose distances to all points are given, by the size."""
        result = []
        for direction, lengths in zip(directions, distances):
            corners, place = self.find(direction)
            ways = lengths[corners] + np.linalg.norm(self.points[corners] - place, axis=1)
            result.append(ways.min() / self.size)
        return np.array(result)


class Model(SpherePlaces):
    """A mapped mesh with its landmarks, and how far every point is from each of them."""

    def __init__(self, path, balance):
        self.name = os.path.splitext(os.path.basename(path))[0]
        with open(os.path.splitext(path)[0] + ".landmarks", encoding="ascii") as file:
            self.landmarks = [int(word) for word in file.read().split()]
        reader, conformal = scan_files.scan_reader(path), vtkGlobalConformalMap()
        conformal.SetAreaBalance(balance)
        reader.Update()
        conformal.SetInputData(triangulated(reader.GetOutput()))
        begin = time.process_time()
        self.mapped = paper_models.run(conformal)
        self.seconds = time.process_time() - begin
        self.points = vtk_to_numpy(self.mapped.GetPoints().GetData()).astype(float)
        if not self.landmarks or not 0 <= min(self.landmarks) <= max(self.landmarks) < len(self.points):
            raise ValueError(f"{self.name}.landmarks: expected ids of the {len(self.points)} points of {self.name}.off")
        super().__init__(self.points, vtk_to_numpy(self.mapped.GetPolys().GetConnectivityArray()).reshape(-1, 3),
                         sphere_of(self.mapped))
        self.distances = [self.distances_from(point) for point in self.landmarks]

    def distances_from(self, point):
        """Lengths of the shortest ways along edges to all points."""
        paths, lengths = vtkDijkstraGraphGeodesicPath(), vtkDoubleArray()
        paths.SetInputData(self.mapped)
        paths.SetStartVertex(point)
        paths.SetEndVertex(point)
        paths.StopWhenEndReachedOff()
        paths.Update()
        paths.GetCumulativeWeights(lengths)
        return vtk_to_numpy(lengths).copy()


def sphere_of(surface):
    return vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition")).astype(float)


def flips_of(surface, triangles):
    """Triangles of the map that do not lie as most of them do."""
    a, b, c = sphere_of(surface)[triangles.T]
    sides = np.einsum("ij,ij->i", a, np.cross(b, c))
    return int(min((sides <= 0.0).sum(), (sides >= 0.0).sum()))


class Outcome:
    """Of one pair: errors of all landmarks, and which of them were not given."""

    def __init__(self, moving, fixed, given, args, unjudged=()):
        self.name = moving.name + "-" + fixed.name
        registration = vtkSphericalRegistration()
        registration.SetInputData(moving.mapped)
        registration.SetFixedData(fixed.mapped)
        getattr(registration, "SetSpaceOfTransformsTo" + args.space)()
        for name, value in args.settings:
            getattr(registration, "Set" + name)(value)
        for i in given:
            registration.AddLandmark(moving.landmarks[i], fixed.landmarks[i])
        begin = time.process_time()
        registered = paper_models.run(registration)
        second = registration.GetOutput(1)
        self.seconds = time.process_time() - begin
        if args.write:
            write(registered, os.path.join(args.write, self.name + ".vtp"))
        field = registered.GetFieldData()
        errors = fixed.landmark_errors(sphere_of(registered)[moving.landmarks], fixed.distances)
        others = self.judge(errors, given, unjudged)
        self.is_ambiguous = field.GetArray("Ambiguous").GetValue(0) == 1
        self.second = np.inf
        if second.GetNumberOfPoints():
            errors = fixed.landmark_errors(sphere_of(second)[moving.landmarks], fixed.distances)
            self.second = errors[others or given].mean()
        self.unmet = field.GetArray("LandmarkError").GetValue(0)
        self.stretch = field.GetArray("RegistrationStretch").GetValue(0)
        self.flips = max(field.GetArray("NumberOfFolds").GetValue(0), flips_of(registered, moving.triangles))

    def judge(self, errors, given, unjudged):
        """By the landmarks that are returned."""
        others = [i for i in range(len(errors)) if i not in given and i not in unjudged] or given
        self.errors, self.judged = errors, errors[others]
        self.mean = self.judged.mean()
        return others


class TemplateOutcome(Outcome):
    """Of one pair whose maps a template has made correspond."""

    def __init__(self, moving, fixed, given, unjudged, seconds):  # pylint: disable=super-init-not-called
        (model, surface), (other, other_surface) = moving, fixed
        self.name = model.name + "-" + other.name
        on_sphere = SpherePlaces(other.points, other.triangles, sphere_of(other_surface))
        self.judge(on_sphere.landmark_errors(sphere_of(surface)[model.landmarks], other.distances), given, unjudged)
        field = surface.GetFieldData()
        self.is_ambiguous = field.GetArray("Ambiguous").GetValue(0) == 1
        self.second, self.seconds, self.flips = np.inf, seconds, flips_of(surface, model.triangles)
        self.unmet = field.GetArray("LandmarkError").GetValue(0)
        self.stretch = field.GetArray("RegistrationStretch").GetValue(0)


def template_outcomes(models, given, args, unjudged):
    template, surfaces = vtkSphericalTemplate(), [model.mapped for model in models]
    for name, value in args.settings:
        getattr(template, "Set" + name)(value)
    if given:
        template.SetLandmarkArrayName(mark_landmarks(surfaces, [[m.landmarks[i] for i in given] for m in models]))
    for surface in surfaces:
        template.AddInputDataObject(surface)
    begin = time.process_time()
    blocks = paper_models.run(template)
    seconds = (time.process_time() - begin) / len(models)
    registered = [(model, blocks.GetBlock(i)) for i, model in enumerate(models)]
    return [TemplateOutcome(*pair, given, unjudged, seconds)
            for pair in (itertools.permutations if args.both else itertools.combinations)(registered, 2)]


def outcomes_of(models, given, args, unjudged):
    """Of each pair, as they are computed."""
    if args.template:
        yield from template_outcomes(models, given, args, unjudged)
        return
    for pair in (itertools.permutations if args.both else itertools.combinations)(models, 2):
        yield Outcome(*pair, given, args, unjudged)


def write(surface, path):
    from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter  # pylint: disable=import-outside-toplevel
    writer = vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(path)
    if not writer.Write():
        raise OSError(f"{path}: cannot be written")


TITLES = ("bodies", "space of transforms", "input landmarks", "mean error", "median pair", "worst pair",
          f"pairs above {FAR:g}", "landmarks below 0.1", "flipped triangles", "wrong pairs reported",
          "right pairs reported", "CPU seconds per pair")


def reported(outcomes):
    return f"{sum(outcome.is_ambiguous for outcome in outcomes)} of {len(outcomes)}"


def row_of(given, count, outcomes, args):
    """A row of the tables of the guide."""
    means = np.array([outcome.mean for outcome in outcomes])
    judged = np.concatenate([outcome.judged for outcome in outcomes])
    landmarks = "none" if not given else f"all {count}" if len(given) == count else f"{len(given)} of {count}"
    space = args.space + (", template" if args.template else "")
    return (os.path.basename(os.path.normpath(args.folder)), space, landmarks, f"{means.mean():.3f}",
            f"{np.median(means):.3f}", f"{means.max():.3f}", str((means > FAR).sum()),
            f"{100.0 * (judged < 0.1).mean():.0f} %", str(sum(outcome.flips for outcome in outcomes)),
            reported([outcome for outcome in outcomes if outcome.mean > FAR]),
            reported([outcome for outcome in outcomes if outcome.mean <= FAR]),
            f"{np.mean([outcome.seconds for outcome in outcomes]):.1f}")


def print_details(name, outcomes):
    """What the table does not contain."""
    worst = max(outcomes, key=lambda outcome: outcome.mean)
    wrong = [outcome for outcome in outcomes if outcome.mean > FAR and outcome.is_ambiguous]
    print(f"{name}: {len(outcomes)} pairs, mean {np.mean([outcome.mean for outcome in outcomes]):.4f}, worst pair "
          f"{worst.name}, largest landmark error {max(outcome.unmet for outcome in outcomes):.1e}; second result "
          f"better in {sum(outcome.second < outcome.mean for outcome in wrong)} of {len(wrong)} wrong pairs that are "
          "reported", flush=True)


def setting(text):
    name, _, value = text.partition("=")
    if not any(hasattr(kind, "Set" + name) for kind in (vtkSphericalRegistration, vtkSphericalTemplate)):
        raise argparse.ArgumentTypeError(f"vtkSphericalRegistration and vtkSphericalTemplate have no property {name}")
    return name, float(value) if "." in value or "e" in value else int(value)


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="of NAME.off and NAME.landmarks")
    parser.add_argument("--models", nargs="+", help="names of those to compare, default all")
    parser.add_argument("--landmarks", nargs="+", type=int, default=[0],
                        help="how many to give, evenly from the list; a table row for each number, default 0")
    parser.add_argument("--given", nargs="+", type=int, action="append", metavar="INDEX",
                        help="indices of landmarks to give, from 0; a row for each option. All rows, also those of "
                        "--landmarks, are then judged by the landmarks that no --given has")
    parser.add_argument("--space", choices=("Rotation", "Moebius", "Diffeomorphic"), default="Diffeomorphic")
    parser.add_argument("--balance", type=float, default=0.5, help="AreaBalance of maps, default 0.5")
    parser.add_argument("--both", action="store_true", help="register each pair in both directions")
    parser.add_argument("--template", action="store_true", help="register all meshes by vtkSphericalTemplate; seconds are "
                        "those for each mesh")
    parser.add_argument("--set", nargs="+", type=setting, default=[], dest="settings", metavar="NAME=VALUE",
                        help="further properties of vtkSphericalRegistration, or of vtkSphericalTemplate")
    parser.add_argument("--pairs", action="store_true", help="print a line for each pair")
    parser.add_argument("--each", action="store_true", help="print the mean error of each landmark")
    parser.add_argument("--write", metavar="DIR", help="write the registered surfaces as MOVING-FIXED.vtp")
    args = parser.parse_args()
    found = sorted(glob.glob(os.path.join(glob.escape(args.folder), "*.off")))
    paths = [path for path in found if os.path.isfile(os.path.splitext(path)[0] + ".landmarks") and
             (not args.models or os.path.splitext(os.path.basename(path))[0] in args.models)]
    if len(paths) < 2:
        parser.error(f"{args.folder}: two files NAME.off with NAME.landmarks or more are needed")
    return args, paths


def main():
    args, paths = arguments()
    models = [Model(path, args.balance) for path in paths]
    counts = {len(model.landmarks) for model in models}
    if len(counts) > 1:
        raise ValueError("models have different numbers of landmarks")
    all_of_them = counts.pop()
    print(f"{len(models)} models, maps with AreaBalance {args.balance:g}: "
          f"{np.mean([model.seconds for model in models]):.2f} CPU seconds each; space {args.space}"
          + "".join(f", {name} {value:g}" for name, value in args.settings))
    rows = [sorted({i * all_of_them // number for i in range(number)} if number else ()) for number in args.landmarks]
    unjudged = {i for given in args.given or () for i in given}
    if unjudged and not 0 <= min(unjudged) <= max(unjudged) < all_of_them:
        raise ValueError(f"--given: expected indices from 0 to {all_of_them - 1}")
    table = [TITLES, ["---"] * len(TITLES)]
    for given in rows + (args.given or []):
        outcomes = []
        for last in outcomes_of(models, given, args, unjudged):
            outcomes.append(last)
            if args.pairs:
                print(f"  {last.name:<14}mean {last.mean:.4f}, largest {last.judged.max():.4f}, stretch "
                      f"{last.stretch:.3f}, landmark error {last.unmet:.1e}, flips {last.flips}, "
                      f"ambiguous {int(last.is_ambiguous)}, second {last.second:.4f}, "
                      f"{last.seconds:.2f} CPU s", flush=True)
        print_details(f"{len(given)} of {all_of_them}", outcomes)
        table.append(row_of(given, all_of_them, outcomes, args))
        if args.each:
            means = np.mean([outcome.errors for outcome in outcomes], axis=0)
            print("  " + "  ".join(f"{i}{'*' if i in given else ''}: {error:.3f}" for i, error in enumerate(means)))
    print()
    for row in table:
        print("| " + " | ".join(row) + " |")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, paper_models.StepFailed) as error:
        sys.exit(f"compare_registrations: {error}")
