#!/usr/bin/python3
"""What comes out of a scan with holes, hidden sides, noise, outliers, scan lines, few points, or of a depth camera?

Spreads points over closed models (in any format that quickstart.py opens; default: a toy bear made by
code), spoils them in several ways, learns each with the default settings and prints how far the mesh is
from the model where there were points, beside the CPU time that it took, of that of the clean scan.
"""
import argparse
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import (vtkGenericCell, vtkPolyData, vtkStaticCellLocator,
                                           vtkStaticPointLocator)
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from conformalsom import vtkConformalSOM
from conformalsom.command import scan_files

from helpers import builtin_figure, depth_camera
from helpers.clouds import cloud_of, vtk_points

COLUMNS = ("s2p", "web %", "miss %", "inverted %", "normals", "volume", "area", "time", "warnings")
AXES = np.eye(3)


class Surface:
    """A closed model or mesh, its largest radius 1 if wanted."""

    def __init__(self, data, scaled=False):
        triangles = vtkTriangleFilter()
        triangles.PassVertsOff()
        triangles.PassLinesOff()
        triangles.SetInputData(data)
        triangles.Update()
        self.data = vtkPolyData()
        self.data.ShallowCopy(triangles.GetOutput())
        points = vtk_to_numpy(self.data.GetPoints().GetData()).astype(float)
        if scaled:
            points = points - points.mean(axis=0)
            points /= np.linalg.norm(points, axis=1).max()
            self.data.SetPoints(vtk_points(points))
        ids = vtk_to_numpy(self.data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        self.corners = points[ids]
        self.areas = 0.5 * np.cross(self.corners[:, 1] - self.corners[:, 0],
                                    self.corners[:, 2] - self.corners[:, 0])
        self.sizes = np.linalg.norm(self.areas, axis=1)
        self.volume = np.einsum("ij,ij->", self.corners[:, 0], self.areas) / 3.0
        self.normals = self.areas / np.maximum(self.sizes, 1e-300)[:, None]
        if scaled and self.volume < 0.0:
            self.normals, self.volume = -self.normals, -self.volume
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.data)
        self.locator.BuildLocator()

    def sampled(self, count, random):
        """Points evenly over the area, and their normals."""
        chosen = random.choice(len(self.sizes), count, p=self.sizes / self.sizes.sum())
        u = random.random_sample((count, 2))
        u[u.sum(axis=1) > 1.0] = 1.0 - u[u.sum(axis=1) > 1.0]
        a, b, c = (self.corners[chosen, k] for k in range(3))
        return a + u[:, :1] * (b - a) + u[:, 1:] * (c - a), self.normals[chosen]

    def lines(self, count, ratio, random):
        """Points on cuts by planes across z, so many times as far apart as the points on them, and
        their normals."""
        gap = (ratio * self.sizes.sum() / count) ** 0.5
        z = self.corners[:, :, 2]
        starts, ends, cut = [], [], []
        for height in np.arange(z.min() + 0.5 * gap, z.max(), gap):
            above = z > height
            for triangle in np.flatnonzero(above.any(axis=1) & ~above.all(axis=1)):
                crossings = []
                for k in range(3):
                    a, b = self.corners[triangle, k], self.corners[triangle, (k + 1) % 3]
                    if (a[2] > height) != (b[2] > height):
                        crossings.append(a + (height - a[2]) / (b[2] - a[2]) * (b - a))
                starts.append(crossings[0])
                ends.append(crossings[1])
                cut.append(triangle)
        origins, ways = np.array(starts), np.array(ends) - np.array(starts)
        lengths = np.linalg.norm(ways, axis=1)
        chosen = random.choice(len(ways), int(lengths.sum() * ratio / gap), p=lengths / lengths.sum())
        return (origins[chosen] + random.random_sample((len(chosen), 1)) * ways[chosen],
                self.normals[np.array(cut)[chosen]])

    def closest(self, points):
        """Distances of points, and the triangles they are to."""
        cell, hit, near = vtkGenericCell(), [0.0] * 3, []
        triangle, part, square = reference(0), reference(0), reference(0.0)
        for point in points:
            self.locator.FindClosestPoint(point, hit, cell, triangle, part, square)
            near.append((float(square) ** 0.5, int(triangle)))
        distances, triangles = zip(*near)
        return np.array(distances), np.array(triangles)

    def seen(self, points, normals, directions):
        """Whether the points are seen from far away in one of the directions."""
        seen = np.zeros(len(points), bool)
        where, hit, part, cell = [0.0] * 3, [0.0] * 3, reference(0), reference(0)
        way = reference(0.0)
        for direction in directions:
            for i in np.flatnonzero((normals @ direction > 0.15) & ~seen):
                seen[i] = not self.locator.IntersectWithLine(
                    points[i] + 3e-3 * direction, points[i] + 4.0 * direction, 1e-6, way, where, hit,
                    part, cell)
        return seen


def defects(model, count):
    """(name, points, normals, what tells where the object is known) for each kind of scan."""
    points, normals = model.sampled(count, np.random.RandomState(3))
    random = np.random.RandomState(11)
    everywhere = lambda x: np.ones(len(x), bool)
    yield "clean", points, normals, everywhere
    for hole in range(2):
        center = points[random.randint(count)]
        left = np.linalg.norm(points - center, axis=1) > 0.3
        yield (f"hole {hole + 1}", points[left], normals[left],
               lambda x, center=center: np.linalg.norm(x - center, axis=1) > 0.33)
    for views, directions in ((5, np.vstack([AXES, -AXES[:2]])), (3, AXES)):
        seen = model.seen(points, normals, directions)
        yield f"{views} views", points[seen], normals[seen], far_from(points[~seen])
    front = model.seen(points, normals, AXES[2:])
    behind = far_from(points[~front])
    yield "front", points[front], normals[front], behind
    low, high = points.min(axis=0), points.max(axis=0)
    floor = 0.5 * (low + high) + 3.0 * np.ptp(points[:, [0, 2]]) * (random.random_sample((count, 3)) - 0.5)
    floor[:, 1] = low[1]
    yield ("front with ground", np.vstack([points[front], floor]),
           np.vstack([normals[front], np.tile(AXES[1], (count, 1))]), behind)
    below = points - 0.06 * normals
    deep = model.closest(below)[0] > 0.059
    yield "shell", np.vstack([points, below[deep]]), np.vstack([normals, -normals[deep]]), everywhere
    for noise in (0.01, 0.02):
        yield f"noise {noise}", points + noise * random.standard_normal(points.shape), normals, everywhere
    for few in (3000, 1000):
        yield f"{few} points", points[:few], normals[:few], everywhere
    box = 1.2 * np.array([points.min(axis=0), points.max(axis=0)])
    strays = box[0] + (box[1] - box[0]) * random.random_sample((count // 20, 3))
    yield "5 % outliers", np.vstack([points, strays]), np.vstack([normals, 0.0 * strays]), everywhere
    yield ("scan lines", *model.lines(count, 20.0, random), everywhere)
    turn, half = np.radians(0.6), count // 2
    turned = np.array([[np.cos(turn), np.sin(turn), 0.0], [-np.sin(turn), np.cos(turn), 0.0], [0.0, 0.0, 1.0]])
    yield ("two layers", np.vstack([points[:half], points[half:] @ turned + 0.006 * np.array([1.0, -1.0, 1.0])]),
           np.vstack([normals[:half], normals[half:] @ turned]), everywhere)
    dense, directions = model.sampled(4 * count, random)
    taken = random.random_sample(len(dense)) < np.where(dense[:, 0] > 0.0, 0.5, 0.005)
    yield "uneven 10 : 1", dense[taken], directions[taken], everywhere
    for images in (18000, 9000):
        seen, _, directions = depth_camera.scanned(model.locator, model.normals, images, 0.005, random)
        yield f"camera {images}", seen, directions, everywhere


def clouds(model, args):
    """(name, input, what tells where the object is known)."""
    if args.vertices:
        everywhere = lambda x: np.ones(len(x), bool)
        yield "vertices", cloud_of(vtk_to_numpy(model.data.GetPoints().GetData())), everywhere
        yield "triangles", model.data, everywhere
        return
    for name, points, normals, known in defects(model, args.points):
        yield name, cloud_of(points, normals if args.normals else None), known


def far_from(missing):
    """Tells which points are farther than 0.03 from those missing."""
    locator = vtkStaticPointLocator()
    locator.SetDataSet(cloud_of(missing))
    locator.BuildLocator()

    def known(points):
        near = np.array([locator.FindClosestPoint(point) for point in points])
        return np.linalg.norm(points - missing[near], axis=1) > 0.03
    return known


def learned(cloud):
    """The mesh, the seconds of CPU and the number of warnings."""
    network = vtkConformalSOM()
    network.SetInputData(cloud)
    warnings = []
    network.AddObserver("WarningEvent", lambda *_: warnings.append(1))
    begin = time.process_time()
    network.Update()
    return Surface(network.GetOutput()), time.process_time() - begin, len(warnings)


def measured(model, mesh, known, time_ratio, warnings):
    """The columns by name."""
    points, normals = mesh.sampled(20000, np.random.RandomState(7))
    distances, nearest = model.closest(points)
    there = known(points)
    cosines = (normals * model.normals[nearest]).sum(axis=1)
    angles = np.degrees(np.arccos(np.clip(cosines[there], -1.0, 1.0)))
    others, _ = model.sampled(20000, np.random.RandomState(8))
    missed, _ = mesh.closest(others)
    return dict(zip(COLUMNS, (
        (distances[there] ** 2).mean(), 100.0 * (distances[there] > 0.02).mean(),
        100.0 * (missed[known(others)] > 0.02).mean(), 100.0 * (cosines[there] < 0.0).mean(),
        np.sqrt((angles**2).mean()), mesh.volume / model.volume, mesh.sizes.sum() / model.sizes.sum(), time_ratio,
        warnings)))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="*", help="closed models, default: a toy bear made by code")
    parser.add_argument("--points", type=int, default=40000, help="to learn from, default 40000")
    parser.add_argument("--normals", action="store_true", help="give the points normals")
    parser.add_argument("--vertices", action="store_true",
                        help="learn the models' own vertices, without and with their triangles")
    parser.add_argument("--only", nargs="+", metavar="SCAN",
                        help="scans whose names begin so, beside the first one; default: all")
    args = parser.parse_args()
    if args.points < 3000:
        parser.error("--points must be at least 3000")
    models = scan_files.read_models(args.model)
    print("| " + " | ".join(("model", "scan", *COLUMNS)) + " |\n|" + " --- |" * (2 + len(COLUMNS)))
    for name, data in (models or {"bear": builtin_figure.figure_surface()}).items():
        model = Surface(data, scaled=True)
        first = None
        for scan, cloud, known in clouds(model, args):
            if first and args.only and not scan.startswith(tuple(args.only)):
                continue
            mesh, seconds, warnings = learned(cloud)
            first = first or seconds
            row = measured(model, mesh, known, seconds / first, warnings)
            print(f"| {name} | {scan} | " + " | ".join(f"{value:.3g}" for value in row.values()) + " |", flush=True)
    print("\nLengths: the model's largest radius is 1. Figures farther than 0.03 from what is missing.\n"
          "s2p: mean square distance of the mesh to the model; web: share of the mesh farther than\n"
          "0.02 from it; miss: share of the model farther than 0.02 from the mesh; inverted: share of\n"
          "the mesh that faces against the model; normals: root mean square angle between the normals of\n"
          "mesh and model, in degrees; volume and area: of the model's.")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError) as error:
        sys.exit(f"scan_defects: {error}")
