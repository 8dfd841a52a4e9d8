#!/usr/bin/python3
"""vtkSphericalTimeSeries in figures: the tables of Documentation/Correspondence.md.

    measure_time_series.py                 bodies made by code, whose points are known at all times
    measure_time_series.py FRAME FRAME ... files of time steps, such as frames of a film of an organ

Bodies grow, bend, twist and carry cells along by a known flow. Each time step has another mesh, and a map of its own
by vtkGlobalConformalMap (AreaBalance 0.5). A cell is a vertex of the first time step. Its place at a later time is
where its position on the sphere is found on the later surface. The error is the distance from the true place, in
percent of the square root of the area: along the normal, and along the surface (slip). PositionWeight was chosen with
body "bean"; the others were not looked at before. PYTHONPATH is that of the build.
"""
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData

from conformalsom import (vtkGeodesicSphereSource, vtkGlobalConformalMap, vtkSphericalAlignment,
                          vtkSphericalRegistration, vtkSphericalTimeSeries)
from conformalsom.command import scan_files
from compare_registrations import SpherePlaces, sphere_of
from helpers import paper_models

STEPS = 11


def bean(n, t):
    """A round body that becomes a bent bean."""
    x, y, z = n.T
    width = 0.55 + 0.08 * np.sin(2 * z)
    return (1 + 0.25 * t) * np.stack([width * x + 0.5 * t * z * z, width * y, (1.4 + 0.4 * t) * z], axis=1)


def gut(n, t):
    """A body of revolution that folds strongly, and turns about its axis by 30 degrees."""
    x, y, z = n.T
    turn = 0.52 * t
    x, y = x * np.cos(turn) - y * np.sin(turn), x * np.sin(turn) + y * np.cos(turn)
    width = 0.5 * (1 - 0.5 * t * np.exp(-(z / 0.25) ** 2)) * (1 - 0.35 * t * np.exp(-((z - 0.6) / 0.2) ** 2))
    length = 1.6 * z
    bend = 1.1 * t
    radius = 1 / max(bend, 1e-6)
    angle = length / radius
    return np.stack([radius - (radius - width * x) * np.cos(angle), width * y,
                     (radius - width * x) * np.sin(angle)], axis=1)


def lobes(n, t):
    """A ball from which three lobes grow, while one half twists against the other by 40 degrees."""
    reach = np.ones(len(n))
    for k, axis in enumerate(((1, 0, 0.3), (-0.5, 0.8, 0.2), (-0.4, -0.7, -0.6))):
        axis = np.array(axis) / np.linalg.norm(axis)
        reach += (0.3 + 0.7 * t * (0.6 + 0.2 * k)) * np.exp((n @ axis - 1) / 0.12)
    p = n * reach[:, None]
    turn = 0.35 * t * np.tanh(2 * p[:, 2])
    return np.stack([p[:, 0] * np.cos(turn) - p[:, 1] * np.sin(turn),
                     p[:, 0] * np.sin(turn) + p[:, 1] * np.cos(turn), p[:, 2]], axis=1)


def mapped(surface):
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    conformal.SetAreaBalance(0.5)
    return paper_models.run(conformal)


def made(body, step, random):
    """The surface of a body, and the directions that its points are made from."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(28 + step % 3)
    sphere = paper_models.run(source)
    rotation = np.linalg.qr(random.normal(size=(3, 3)))[0]
    rotation *= np.linalg.det(rotation)
    directions = vtk_to_numpy(sphere.GetPoints().GetData()).astype(float) @ rotation.T
    points, surface = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(body(directions, step / (STEPS - 1)), deep=True))
    surface.SetPoints(points)
    surface.SetPolys(sphere.GetPolys())
    return mapped(surface), directions


class Step(SpherePlaces):
    """A surface with a map, on which positions on the sphere are looked up."""

    def __init__(self, surface, sphere):
        super().__init__(vtk_to_numpy(surface.GetPoints().GetData()).astype(float),
                         vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3), sphere)
        a, b, c = self.points[self.triangles.T]
        cross = np.cross(b - a, c - a)
        self.normals = cross / np.linalg.norm(cross, axis=1)[:, None]

    def places(self, directions):
        return np.array([self.find(direction)[1] for direction in directions])

    def errors(self, places, true):
        """Components of the errors along the normal and along the surface, in percent of the size."""
        centers = self.points[self.triangles].mean(axis=1)
        nearest = np.array([np.linalg.norm(centers - p, axis=1).argmin() for p in true])
        difference = places - true
        normal = np.einsum("ij,ij->i", difference, self.normals[nearest])
        along = np.linalg.norm(difference - normal[:, None] * self.normals[nearest], axis=1)
        return 100 * np.abs(normal) / self.size, 100 * along / self.size


def series_of(surfaces, **properties):
    series = vtkSphericalTimeSeries()
    for surface in surfaces:
        series.AddInputDataObject(surface)
    for name, value in properties.items():
        getattr(series, "Set" + name)(value)
    begin = time.process_time()
    maps = []
    for step in range(len(surfaces)):
        series.UpdateTimeStep(step)
        maps.append(sphere_of(series.GetOutput()))
    table = series.GetTable()
    folds = sum(table.GetValueByName(row, "NumberOfFolds").ToInt() for row in range(len(surfaces)))
    return maps, folds, time.process_time() - begin


def chain_of(surfaces, make):
    """Register each surface with the one before."""
    begin, last, maps = time.process_time(), surfaces[0], [sphere_of(surfaces[0])]
    for surface in surfaces[1:]:
        last = make(surface, last)
        maps.append(sphere_of(last))
    return maps, 0, time.process_time() - begin


def registered(moving, fixed):
    registration = vtkSphericalRegistration()
    registration.SetInputData(moving)
    registration.SetFixedData(fixed)
    return paper_models.run(registration)


def aligned(moving, fixed):
    alignment = vtkSphericalAlignment()
    alignment.SetInputData(moving)
    alignment.SetReferenceData(fixed)
    alignment.SetTransformToMoebius()
    return paper_models.run(alignment)


def nearest_of(steps, cells):
    """No registration: a cell goes to the nearest vertex of the next surface."""
    places = [cells]
    for step in steps[1:]:
        places.append(np.array([step.points[np.linalg.norm(step.points - p, axis=1).argmin()] for p in places[-1]]))
    return places


def measure(body):
    random = np.random.default_rng(5)
    made_steps = [made(body, step, random) for step in range(STEPS)]
    surfaces = [surface for surface, _ in made_steps]
    cells = random.choice(len(made_steps[0][1]), 300, replace=False)
    true = [body(made_steps[0][1][cells], step / (STEPS - 1)) for step in range(STEPS)]
    rows = [("series", *series_of(surfaces)), ("series, no sweep", *series_of(surfaces, NumberOfSweeps=0)),
            ("series, no positions", *series_of(surfaces, PositionWeight=0)),
            ("chain of registrations", *chain_of(surfaces, registered)),
            ("chain of Moebius alignments", *chain_of(surfaces, aligned))]
    steps = [Step(surface, sphere_of(surface)) for surface in surfaces]
    results = []
    for name, maps, folds, seconds in rows:
        placed = [Step(surface, sphere).places(maps[0][cells]) for surface, sphere in zip(surfaces, maps)]
        results.append((name, placed, folds, seconds))
    results.append(("nearest points", nearest_of(steps, true[0]), 0, 0.0))
    for name, placed, folds, seconds in results:
        middle, end = (steps[k].errors(placed[k], true[k]) for k in (STEPS // 2, STEPS - 1))
        print(f"| {body.__name__} | {name} | {middle[0].mean():.2f} | {middle[1].mean():.2f} | {end[0].mean():.2f} | "
              f"{end[1].mean():.2f} | {np.percentile(end[1], 95):.1f} | {folds} | {seconds / (STEPS - 1):.1f} |",
              flush=True)


def angle(a, b):
    return np.degrees(2 * np.arcsin(np.clip(np.linalg.norm(a - b, axis=1) / 2, 0, 1)))


def measure_files(paths):
    begin, surfaces = time.process_time(), []
    for path in paths:
        reader = scan_files.scan_reader(path)
        surfaces.append(mapped(paper_models.run(reader)))
    mapping = time.process_time() - begin
    maps, folds, seconds = series_of(surfaces)
    chain, _, chaining = series_of(surfaces, NumberOfSweeps=0)
    print(f"{len(paths)} files: CPU seconds of maps {mapping:.1f}, of the series {seconds:.1f} "
          f"(without a sweep {chaining:.1f}); folds {folds}")
    print("| step | series against direct registration | largest 5 % | without a sweep | largest 5 % |")
    print("|---|---|---|---|---|")
    for k in range(1, len(paths)):
        direct = sphere_of(registered(surfaces[k], surfaces[0]))
        errors = [angle(direct, m[k]) for m in (maps, chain)]
        print(f"| {k} | " + " | ".join(f"{e.mean():.2f} | {np.percentile(e, 95):.2f}" for e in errors) + " |",
              flush=True)


def main():
    if len(sys.argv) > 1:
        measure_files(sys.argv[1:])
        return
    print("| body | method | step 5: normal | slip | step 10: normal | slip | largest 5 % | folds | CPU s a step |")
    print("|---|---|---|---|---|---|---|---|---|")
    for body in (bean, gut, lobes):
        measure(body)


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, paper_models.StepFailed) as error:
        sys.exit(f"measure_time_series: {error}")
