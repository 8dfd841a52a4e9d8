#!/usr/bin/python3
"""Prints how surfaces are learned of scans with a part that is missing: limbs, separate objects, views.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_missing_parts.py FILES
    ... measure_missing_parts.py --tables views FILES

Clouds have 40,000 random points of a closed model, largest radius 1, without normals. Tables:

  limbs     The points in a ball of radius 0.3 are missing, which cuts off the end of a limb.
  separate  A ball beside the model is scanned, too. "share" is the fraction of the surface on the ball.
  views     The model is scanned from 3 or 5 directions, without and with the positions of the scanners.

web is the percentage of the surface farther than 0.02 from the model, miss that of the model farther than 0.02
from the surface; both without what is within 0.03 of missing points.
"""
import argparse

import numpy as np
from scan_defects import AXES, Surface, far_from, learned, measured
from vtkmodules.util.numpy_support import numpy_to_vtk

from conformalsom.command import scan_files
from helpers.clouds import cloud_of


def tips(points, count):
    """Ids of points that are far from the middle and from each other."""
    radii = np.linalg.norm(points - np.median(points, axis=0), axis=1)
    found = [int(radii.argmax())]
    apart = np.full(len(points), 2.0)
    while len(found) < count:
        apart = np.minimum(apart, np.linalg.norm(points - points[found[-1]], axis=1))
        found.append(int((apart * radii).argmax()))
    return found


def print_row(name, case, model, cloud, known):
    mesh, seconds, warnings = learned(cloud)
    row = measured(model, mesh, known, seconds, warnings)
    print(f"{name:<24}{case:<20}" + "".join(f"{row[key]:>9.3f}" for key in ("web %", "miss %", "volume")) +
          f"{seconds:>9.1f}{warnings:>9}", flush=True)


def limbs(name, model):
    points, _ = model.sampled(40000, np.random.RandomState(3))
    center = np.median(points, axis=0)
    for number, tip in enumerate(tips(points, 4)):
        inward = center - points[tip]
        place = points[tip] + 0.4 * inward / np.linalg.norm(inward)
        middle = points[np.linalg.norm(points - place, axis=1).argmin()]
        left = np.linalg.norm(points - middle, axis=1) > 0.3
        print_row(name, f"limb {number + 1}", model, cloud_of(points[left]),
                  lambda x, middle=middle: np.linalg.norm(x - middle, axis=1) > 0.33)


def separate(name, model):
    points, _ = model.sampled(40000, np.random.RandomState(3))
    random = np.random.RandomState(5)
    tip = points[np.linalg.norm(points, axis=1).argmax()]
    for radius, gap in ((0.2, 0.3), (0.4, 0.2), (0.4, 0.4)):
        ball = random.standard_normal((int(40000 * 4 * np.pi * radius**2 / model.sizes.sum()), 3))
        ball *= radius / np.linalg.norm(ball, axis=1)[:, None]
        center = tip * (1.0 + (gap + radius) / np.linalg.norm(tip))
        mesh, seconds, warnings = learned(cloud_of(np.vstack([points, center + ball])))
        there, _ = mesh.sampled(20000, random)
        share = (np.linalg.norm(there - center, axis=1) < 1.1 * radius).mean()
        print(f"{name:<24}{f'ball {radius}, gap {gap}':<20} share {share:.4f}{seconds:>9.1f}{warnings:>9}", flush=True)


def views(name, model):
    points, normals = model.sampled(40000, np.random.RandomState(3))
    for directions in (AXES, np.vstack([AXES, -AXES[:2]])):
        scanners = np.full(points.shape, np.nan)
        for direction in directions:
            new = np.isnan(scanners[:, 0]) & model.seen(points, normals, direction[None])
            scanners[new] = points[new] + 50.0 * direction
        seen = ~np.isnan(scanners[:, 0])
        for given in (False, True):
            cloud = cloud_of(points[seen])
            if given:
                positions = numpy_to_vtk(scanners[seen], deep=True)
                positions.SetName("ScannerPosition")
                cloud.GetPointData().AddArray(positions)
            case = f"{len(directions)} views" + (", positions" if given else "")
            print_row(name, case, model, cloud, far_from(points[~seen]))


def main():
    tables = {"limbs": limbs, "separate": separate, "views": views}
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", help="closed models")
    parser.add_argument("--tables", default=",".join(tables), help="default: all")
    args = parser.parse_args()
    models = {name: Surface(data, scaled=True) for name, data in scan_files.read_models(args.files).items()}
    for table in args.tables.split(","):
        print(f"{table:<44}{'web %':>9}{'miss %':>9}{'volume':>9}{'CPU s':>9}{'warnings':>9}")
        for name, model in models.items():
            tables[table](name, model)


if __name__ == "__main__":
    main()
