#!/usr/bin/python3
"""Measure errors and times of vtkSurfaceGeodesics.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_geodesics.py \\
      [SURFACE ...] [--picture geodesics.jpg]

spheres   geodesic spheres, on which distances from a point are known exactly. The error is relative, as mean over all
          other points. Seconds are CPU seconds: of the first source with the factorization, of each further one, and of
          a source by Method EXACT.
spheroids spheres flattened along z, on which distances are those of geographiclib (MIT), if it is installed. Seconds are
          not printed.
surfaces  files: mean relative difference from exact polyhedral distances of pygeodesic (MIT), if it is installed, from
          three points each, of the distances and paths of vtkSurfaceGeodesics, and of paths along edges by
          vtkDijkstraGraphGeodesicPath. "longer" are paths that are longer by more than 1e-6 than the exact distance:
          they pass an obstacle on the other side. Milliseconds of CPU are those of a path among a thousand.
          A second table shows the largest relative difference of Method EXACT, of its distances and of its paths, and
          CPU seconds of a source by vtkSurfaceGeodesics and by pygeodesic. A third one shows potpourri3d (MIT), if it
          is installed: its heat method (robust) and its paths by edge flips (signpost), from the same points.
--picture draws a bear with distances from the tip of an ear, and with the cells of this point and 30 farthest points.
"""
import argparse
import pathlib
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkBandedPolyDataContourFilter, vtkDijkstraGraphGeodesicPath

import conformalsom
from conformalsom.command import pictures, scan_files
from helpers import builtin_figure, paper_models


def sphere(frequency):
    source = conformalsom.vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    return paper_models.run(source)


def points_of(surface):
    return vtk_to_numpy(surface.GetPoints().GetData()).astype(float)


def geodesics(surface, sources=(), farthest=0):
    filter_ = conformalsom.vtkSurfaceGeodesics()
    filter_.SetInputData(surface)
    for source in sources:
        filter_.AddSourceId(int(source))
    filter_.SetNumberOfFarthestPoints(farthest)
    filter_.Update()
    return filter_.GetOutput()


def distances_of(surface, source):
    return vtk_to_numpy(geodesics(surface, [source]).GetPointData().GetArray("GeodesicDistance"))


def exact_filter(surface, source):
    filter_ = conformalsom.vtkSurfaceGeodesics()
    filter_.SetInputData(surface)
    filter_.SetMethodToExact()
    filter_.AddSourceId(int(source))
    return filter_


def seconds(work):
    begin = time.process_time()
    work()
    return time.process_time() - begin


def measure_spheres():
    print("| points | mean error | largest error beyond 0.5 | first source, CPU s | further source, CPU s | Exact, CPU s |")
    print("| --- | --- | --- | --- | --- | --- |")
    for frequency in (16, 32, 48, 100):
        surface = sphere(frequency)
        points = points_of(surface)
        errors = []
        for source in (0, 7, len(points) // 2):
            exact = 2 * np.arcsin(np.clip(np.linalg.norm(points - points[source], axis=1) / 2, 0, 1))
            error = np.abs(distances_of(surface, source) - exact) / np.where(exact > 0, exact, 1)
            errors.append((error[exact > 0].mean(), error[exact > 0.5].max()))
        mean, largest = np.array(errors).max(axis=0)
        first = seconds(lambda: geodesics(surface, [0]))
        further = (seconds(lambda: geodesics(surface, [0], 10)) - first) / 10
        exact = seconds(exact_filter(surface, 0).Update)
        print(f"| {len(points):,} | {100 * mean:.2f} % | {100 * largest:.2f} % | {first:.2f} | {further:.3f} | "
              f"{exact:.2f} |", flush=True)


def measure_spheroids():
    try:
        from geographiclib.geodesic import Geodesic
    except ImportError:
        print("geographiclib is not installed; spheroids are not measured")
        return
    print("\n| flattening | points | Method HEAT | Method EXACT |\n| --- | --- | --- | --- |")
    for flattening in (0.1, 0.3, -0.3):
        oracle = Geodesic(1.0, flattening)
        for frequency in (32, 100):
            surface = sphere(frequency)
            unit = points_of(surface)
            places, angles = vtkPoints(), np.degrees(np.arctan2(unit[:, 1], unit[:, 0]))
            places.SetDataTypeToDouble()
            places.SetData(numpy_to_vtk(unit * [1.0, 1.0, 1.0 - flattening], deep=True))
            surface.SetPoints(places)
            normals = unit * [1.0, 1.0, 1.0 / (1.0 - flattening)]
            latitudes = np.degrees(np.arctan2(normals[:, 2], np.hypot(normals[:, 0], normals[:, 1])))
            targets = np.random.default_rng(6).choice(np.arange(1, len(unit)), 500, replace=False)
            exact = np.array([oracle.Inverse(latitudes[7], angles[7], latitudes[i], angles[i])["s12"] for i in targets])
            filter_ = exact_filter(surface, 7)
            filter_.Update()
            found = vtk_to_numpy(filter_.GetOutput().GetPointData().GetArray("GeodesicDistance"))
            heat = distances_of(surface, 7)
            print(f"| {flattening} | {len(unit):,} | {100 * relative(heat[targets], exact).mean():.2f} % | "
                  f"{100 * relative(found[targets], exact).mean():.3f} % |", flush=True)


def along_edges(surface, source, targets):
    path = vtkDijkstraGraphGeodesicPath()
    path.SetInputData(surface)
    path.SetStartVertex(int(source))
    lengths = []
    for target in targets:
        path.SetEndVertex(int(target))
        path.Update()
        points = points_of(path.GetOutput())
        lengths.append(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
    return np.array(lengths)


def paths_of(surface, source, count=1000):
    """Ends and lengths of paths from points to the source, and milliseconds of CPU of a path."""
    points = points_of(surface)
    filter_ = conformalsom.vtkSurfaceGeodesics()
    filter_.SetInputData(surface)
    filter_.AddSourceId(int(source))
    without = seconds(filter_.Update)
    filter_.SetTargetsData(starts_of(points, count))
    milliseconds = 1000 * (seconds(filter_.Update) - without) / count
    return *ends_and_lengths(filter_), milliseconds


def starts_of(points, count):
    starts, places = vtkPolyData(), vtkPoints()
    places.SetData(numpy_to_vtk(points[np.random.default_rng(2).choice(len(points), count, replace=False)], deep=True))
    starts.SetPoints(places)
    return starts


def ends_and_lengths(filter_):
    data = filter_.GetPaths().GetCellData()
    return [vtk_to_numpy(data.GetArray(name)) for name in ("TargetId", "PathLength")]


def relative(values, exact):
    return np.abs(values - exact)[exact > 0] / exact[exact > 0]


def measure_exact(name, surface, solver, sources):
    points, off, paths, ours, theirs = points_of(surface), 0.0, 0.0, 0.0, 0.0
    for source in sources:
        theirs += seconds(lambda: solver.geodesicDistances(np.array([source]), None))
        exact, _ = solver.geodesicDistances(np.array([source]), None)
        filter_ = exact_filter(surface, source)
        ours += seconds(filter_.Update)
        distances = vtk_to_numpy(filter_.GetOutput().GetPointData().GetArray("GeodesicDistance"))
        off = max(off, relative(distances, exact).max())
        filter_.SetTargetsData(starts_of(points, min(1000, len(points))))
        filter_.Update()
        ends, lengths = ends_and_lengths(filter_)
        paths = max(paths, relative(lengths, exact[ends]).max())
    return (f"| {name} | {len(points):,} | {off:.0e} | {paths:.0e} | {ours / len(sources):.2f} | "
            f"{theirs / len(sources):.2f} |")


def measure_rival(name, surface, triangles, solver, sources):
    try:
        import potpourri3d
    except ImportError:
        return None
    points, heat, lengths, times = points_of(surface), [], [], np.zeros(3)
    holder = []
    times[0] = seconds(lambda: holder.append(potpourri3d.MeshHeatMethodDistanceSolver(points, triangles)))
    flips = potpourri3d.EdgeFlipGeodesicSolver(points, triangles)
    for source in sources:
        exact, _ = solver.geodesicDistances(np.array([source]), None)
        distances = []
        times[1] += seconds(lambda: distances.append(holder[0].compute_distance(int(source)))) / len(sources)
        heat.append(relative(distances[0], exact).mean())
        ends = np.random.default_rng(2).choice(np.flatnonzero(exact > 0), 100, replace=False)
        found = []
        times[2] += seconds(lambda: found.extend(flips.find_geodesic_path(int(end), int(source)) for end in ends)) / (
            len(sources) * len(ends))
        found = np.array([np.linalg.norm(np.diff(path, axis=0), axis=1).sum() for path in found])
        lengths.append(relative(found, exact[ends]))
    lengths = np.concatenate(lengths)
    return (f"| {name} | {100 * np.mean(heat):.2f} % | {times[0]:.2f} | {times[1]:.3f} | {100 * lengths.mean():.3f} % | "
            f"{100 * np.mean(lengths > 1e-6):.0f} % | {1000 * times[2]:.2f} |")


def measure_files(paths):
    try:
        import pygeodesic.geodesic as exact_geodesic
    except ImportError:
        print("pygeodesic is not installed; surfaces are not measured")
        return
    exact_rows, rival_rows = [], []
    print("\n| surface | points | distances | paths | longer | largest | ms a path | vtkDijkstraGraphGeodesicPath |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for path in paths:
        surface = paper_models.run(scan_files.scan_reader(str(path)))
        points = points_of(surface)
        triangles = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
        solver = exact_geodesic.PyGeodesicAlgorithmExact(points, triangles.astype(np.int32))
        random = np.random.default_rng(1)
        heat, edges, straight = [], [], []
        sources = random.choice(len(points), 3, replace=False)
        exact_rows.append(measure_exact(path.name, surface, solver, sources))
        rival_rows.append(measure_rival(path.name, surface, triangles, solver, sources))
        for source in sources:
            exact, _ = solver.geodesicDistances(np.array([source]), None)
            other = exact > 0
            heat.append((np.abs(distances_of(surface, source) - exact)[other] / exact[other]).mean())
            targets = random.choice(np.flatnonzero(other), 20, replace=False)
            ends, lengths, milliseconds = paths_of(surface, source)
            straight.append((lengths - exact[ends]) / exact[ends])
            edges.append((np.abs(along_edges(surface, source, targets) - exact[targets]) / exact[targets]).mean())
        straight = np.concatenate(straight)
        print(f"| {path.name} | {len(points):,} | {100 * np.mean(heat):.2f} % | {100 * straight.mean():.3f} % | "
              f"{100 * np.mean(straight > 1e-6):.0f} % | {100 * straight.max():.1f} % | {milliseconds:.2f} | "
              f"{100 * np.mean(edges):.1f} % |", flush=True)
    print("\n| surface | points | Method EXACT: distances | paths | CPU s a source | pygeodesic, CPU s a source |")
    print("| --- | --- | --- | --- | --- | --- |", *exact_rows, sep="\n")
    if all(rival_rows):
        print("\n| surface | potpourri3d: distances | factor, CPU s | source, CPU s | paths | longer | ms a path |")
        print("| --- | --- | --- | --- | --- | --- | --- |", *rival_rows, sep="\n")


def draw(path):
    bear = builtin_figure.figure_surface()
    points = points_of(bear)
    ear = int((points @ [0.3, 1.0, 0.0]).argmax())
    pictures.write_side_by_side(path, [banded(geodesics(bear, [ear])), cells_of(geodesics(bear, [ear], 30))], 1200, 600)


def banded(surface, count=24):
    """Bands of equal distance."""
    largest = surface.GetPointData().GetArray("GeodesicDistance").GetRange()[1]
    surface.GetPointData().SetActiveScalars("GeodesicDistance")
    bands = vtkBandedPolyDataContourFilter()
    bands.SetInputData(surface)
    bands.GenerateValues(count + 1, 0.0, 1.0001 * largest)
    bands.SetScalarModeToIndex()
    bands.Update()
    index = vtk_to_numpy(bands.GetOutput().GetCellData().GetScalars())
    far, odd = index / count, index % 2
    return scene_of(bands.GetOutput(), bands.GetOutput().GetCellData(), "distance from the tip of an ear",
                    np.stack([240 - 90 * odd, 225 - 90 * far - 50 * odd, 150 + 90 * far], axis=1))


def cells_of(surface):
    nearest = vtk_to_numpy(surface.GetPointData().GetArray("NearestSource"))
    ids = np.unique(nearest)
    palette = np.random.default_rng(4).uniform(90, 245, (len(ids), 3))
    return scene_of(surface, surface.GetPointData(), f"nearest of {len(ids)} points",
                    palette[np.searchsorted(ids, nearest)])


def scene_of(surface, data, label, colors):
    array = numpy_to_vtk(colors.astype(np.uint8), deep=True)
    array.SetName("Color")
    data.SetScalars(array)
    actor = pictures.actor_of(surface)
    mapper = actor.GetMapper()
    mapper.ScalarVisibilityOn()
    if data is surface.GetCellData():
        mapper.SetScalarModeToUseCellData()
    return pictures.scene(actor, label, pictures.camera_on(surface, (0.0, 0.0, 1.0), (0.0, 1.0, 0.0), 1.0))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="*", type=pathlib.Path)
    parser.add_argument("--picture", metavar="FILE")
    options = parser.parse_args()
    if options.picture:
        draw(options.picture)
        return
    measure_spheres()
    measure_spheroids()
    measure_files(options.surfaces)


if __name__ == "__main__":
    main()
