#!/usr/bin/python3
"""Prints whether surfaces of broken scans are right, and whether warnings say so if they are not.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_broken_scans.py FILES
    ... measure_broken_scans.py --bodies 2 --seed 1 --only subset base FILES
    ... measure_broken_scans.py --bodies 0 --points 6000,12000 FILES

Objects are closed models, and --bodies busts and horses made by code. A bust has a flat base. A horse has long thin
legs. The largest radius of an object is 1. Scans have 40,000 random points without normals, unless stated otherwise:

  clean        no defect
  half 1, 2    half of the object's own vertices, chosen at random, at most 20,000
  hole 1, 2    the points in a ball of radius 0.3 are missing, at a random place
  leg 1, 2     the same across a limb, 0.4 from its end
  base         the points whose height is lowest, within 0.004, or whose normal there points down, are missing
  5 views      the points seen from five directions
  lines        scan lines that are 20 times as far apart as their points
  few          3,000 points

With --points, there are clean scans of these numbers of points instead.

web is the percentage of the surface farther than 0.02 from the object, miss that of the object farther than 0.02 from
the surface, and inverted that of the surface that faces the wrong way; all without what is within 0.03 of missing
points. largest is the largest distance of the whole surface from the object. A surface is right if web and miss are at
most 0.2 and inverted is at most 0.5. A warning for a right surface of a scan without missing points is a false alarm.

Each warning has a word: map (the map is not conformal), details (too few points for the object's details), uncovered,
outliers (points apart from the surface), inverted and folded (the surface), crossing (triangles), unsupported (surface
without points), layers and shell (two layers of points), noise, leaks, handles, border, ground. Others are other.
"""
import argparse
import time

import numpy as np
from scan_defects import AXES, Surface, far_from
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkQuadricDecimation, vtkReverseSense

from conformalsom import vtkConformalSOM, vtkGenusZeroCheck
from conformalsom.command import scan_files
from helpers import bodies
from helpers.clouds import cloud_of
from measure_missing_parts import tips

# Words of each warning, and its name in the table.
WARNINGS = {
    "to the sphere is not conformal": "map", "the mesh: it does not": "uncovered", "faces the wrong way": "inverted",
    "are folded": "folded", "have noise": "noise", "for the object's details": "details", "lie on two layers": "layers",
    "left out: outliers": "outliers", "no points nearby (": "unsupported", "cross each other": "crossing",
    "distinguish inside": "leaks", "had handles": "handles", "has a border": "border", "two layers around": "shell",
    "stands on a plane": "ground"}
COLUMNS = ("web %", "miss %", "inverted %", "largest")


class Bust(bodies.Body):
    """A head on shoulders and a plinth with a flat base."""
    floor = 0.0

    def height(self, points):
        return np.maximum(super().height(points), self.floor - points[:, 2])


def bust(random):
    body, head = Bust(0.02), bodies.head(random, 0.5)
    body.cones = head.cones
    neck = next(cone[1] for cone in head.cones if cone[1][2] == min(c[1][2] for c in head.cones))
    width, down = random.uniform(0.2, 0.3), random.uniform(0.05, 0.1)
    for sign in (1, -1):
        body.cone(neck, neck + (0, sign * width, -down), 0.12, random.uniform(0.07, 0.1))
    if random.random() < 0.5:  # a tall hat
        body.cone((-0.1, 0, 0.18), (-random.uniform(0.2, 0.3), 0, 0.42), 0.15, random.uniform(0.17, 0.22))
    body.cone(neck, neck - (0, 0, 0.3), random.uniform(0.12, 0.15), random.uniform(0.16, 0.22))
    body.floor = neck[2] - 0.27
    return body


def horse(random):
    body, u = bodies.Body(0.012), random.uniform
    rump, withers = np.array((-0.3, 0, 0)), np.array((0.3, 0, u(-0.02, 0.04)))
    body.cone(rump, withers, u(0.12, 0.15), u(0.12, 0.15))
    poll = body.cone(withers, withers + (u(0.15, 0.3), u(-0.05, 0.05), u(0.2, 0.35)), 0.1, u(0.055, 0.07))
    body.cone(poll, poll + (u(0.12, 0.18), 0, -u(0.08, 0.16)), 0.065, u(0.035, 0.045))
    for sign in (1, -1):
        body.cone(poll, poll + (-0.02, sign * 0.05, u(0.08, 0.1)), 0.025, 0.012)
        for hip in (rump, withers):
            step = u(-0.12, 0.12)
            knee = body.cone(hip + (0, sign * 0.07, -0.05), hip + (step, sign * 0.09, -u(0.28, 0.34)), 0.065, 0.032)
            hoof = body.cone(knee, knee + (u(-0.1, 0.06), 0, -u(0.22, 0.28)), 0.03, u(0.018, 0.024))
            body.cone(hoof, hoof + (0.03, 0, -0.01), 0.026, 0.026)
    bodies.limb(body, rump + (-0.08, 0, 0.06), np.array((-0.8, 0, -0.6)), np.eye(3)[1], [0.1, 0.12, 0.12],
                [0.03, 0.03, 0.025, 0.018], [0.3, -0.5, -0.3])
    return body


def made_bodies(number, seed):
    """Busts and horses of genus zero, with about 15,000 vertices, denser where the surface is curved."""
    for name, make in (("bust", bust), ("horse", horse)):
        random, made = np.random.default_rng([seed, len(name)]), 0
        while made < number:
            inward, check, coarser = vtkReverseSense(), vtkGenusZeroCheck(), vtkQuadricDecimation()
            inward.SetInputData(make(random).mesh(150))  # tables were made of the samples of this order of corners
            check.SetInputConnection(inward.GetOutputPort())
            check.Update()
            if check.GetOutput().GetFieldData().GetArray("IsGenusZero").GetValue(0) != 1:
                continue
            coarser.SetInputData(check.GetOutput())
            coarser.SetTargetReduction(1.0 - 30000 / check.GetOutput().GetNumberOfCells())
            coarser.Update()
            made += 1
            yield f"{name} {seed}.{made}", coarser.GetOutput()


def scans(model):
    """(name, points, what tells where the object is known or None) for each kind of scan."""
    points, normals = model.sampled(40000, np.random.RandomState(3))
    random = np.random.RandomState(11)
    yield "clean", points, None
    own = vtk_to_numpy(model.data.GetPoints().GetData())
    for half in (1, 2):
        yield f"half {half}", own[random.permutation(len(own))[:min(20000, len(own) // 2)]], None
    center, ends = np.median(points, axis=0), tips(points, 2)
    holes = [(f"hole {k + 1}", points[random.randint(40000)]) for k in range(2)]
    for k, tip in enumerate(ends):
        inward = points[tip] + 0.4 * (center - points[tip]) / np.linalg.norm(center - points[tip])
        holes.append((f"leg {k + 1}", points[np.linalg.norm(points - inward, axis=1).argmin()]))
    for name, middle in holes:
        yield (name, points[np.linalg.norm(points - middle, axis=1) > 0.3],
               lambda x, middle=middle: np.linalg.norm(x - middle, axis=1) > 0.33)
    up = model.up
    heights = points @ up
    below = (heights < heights.min() + 0.03) & ((normals @ up < -0.5) | (heights < heights.min() + 0.004))
    yield "base", points[~below], far_from(points[below])
    seen = model.seen(points, normals, np.vstack([AXES, -AXES[:2]]))
    yield "5 views", points[seen], far_from(points[~seen])
    yield "lines", model.lines(40000, 20.0, np.random.RandomState(5))[0], None
    yield "few", points[:3000], None


def sparse_scans(model, counts):
    """Clean scans of some numbers of points."""
    for count in counts:
        yield f"{count:,} points", model.sampled(count, np.random.RandomState(count + 7))[0], None


def learned(points):
    """The surface, the names of the warnings, and the CPU seconds."""
    network, texts = vtkConformalSOM(), []
    network.SetInputData(cloud_of(points))

    def note(_caller, _event, text):
        texts.append(next((name for words, name in WARNINGS.items() if words in text), "other"))
    note.CallDataType = "string0"
    network.AddObserver("WarningEvent", note)
    begin = time.process_time()
    network.Update()
    return Surface(network.GetOutput()), texts, time.process_time() - begin


def measured(model, mesh, known):
    there = known or (lambda x: np.ones(len(x), bool))
    x, normals = mesh.sampled(20000, np.random.RandomState(7))
    distances, near = model.closest(x)
    inside = there(x)
    others, _ = model.sampled(20000, np.random.RandomState(8))
    missed = mesh.closest(others)[0][there(others)]
    against = (normals * model.normals[near]).sum(axis=1) < 0.0
    return (100.0 * (distances[inside] > 0.02).mean(), 100.0 * (missed > 0.02).mean(), 100.0 * against[inside].mean(),
            distances.max())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", help="closed models")
    parser.add_argument("--bodies", type=int, default=2, help="busts and horses made by code, default 2 each")
    parser.add_argument("--seed", type=int, default=1, help="of the bodies, default 1")
    parser.add_argument("--only", nargs="+", default=[""], metavar="SCAN", help="scans whose names begin so")
    parser.add_argument("--points", metavar="N,...", type=lambda text: [int(number) for number in text.split(",")],
                        help="only clean scans of so many points")
    args = parser.parse_args()
    objects = list(scan_files.read_models(args.files).items()) + list(made_bodies(args.bodies, args.seed))
    counts = dict.fromkeys(("right", "warned", "wrong and silent", "false alarms"), 0)
    print("| " + " | ".join(("object", "scan", *COLUMNS, "CPU s", "verdict", "warnings")) + " |\n|" + " --- |" * 9)
    for name, data in objects:
        model = Surface(data, scaled=True)
        model.up = np.eye(3)[2 if name.startswith(("bust", "horse")) else 1]
        for scan, points, known in sparse_scans(model, args.points) if args.points else scans(model):
            if scan.startswith(tuple(args.only)):
                mesh, warnings, seconds = learned(points)
                web, miss, inverted, largest = measured(model, mesh, known)
                right = web <= 0.2 and miss <= 0.2 and inverted <= 0.5
                verdict = "right" if right else "warned" if warnings else "wrong and silent"
                counts[verdict] += 1
                counts["false alarms"] += right and known is None and len(warnings) > 0
                print(f"| {name} | {scan} | {web:.2f} | {miss:.2f} | {inverted:.2f} | {largest:.3f} | {seconds:.1f} | "
                      f"{verdict} | {', '.join(warnings) or '-'} |", flush=True)
    print("\n" + ", ".join(f"{name}: {count}" for name, count in counts.items()))


if __name__ == "__main__":
    main()
