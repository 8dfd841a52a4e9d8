#!/usr/bin/python3
"""Measure how accurate the measures of vtkMapOutlines and vtkMapLabels are.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_map_measures.py \\
      [--picture map_outlines.png] [--long-picture long_bodies.png]

The body is a sphere, so that all measures are known, and its mesh has more or fewer points. Drawn are circles (1000
corners) and triangles of great circles (400 corners on each side), with radii of 0.25, around 30 directions up to 60
degrees from the equator. Errors are relative, as mean and largest of all figures, those of angles in degrees.

    outlines  length and area of circles, angles at the corners of triangles, by projection and mesh.
    labels    area and perimeter of circles that are painted in maps, by projection and width of the map.
    seconds   CPU seconds of vtkMapOutlines for 1000 circles of 64 corners.

--picture draws a map with painted cells and drawn outlines, and both on the surface. --long-picture draws cells of a
bent tube, its map by Mercator's projection, and on a capsule.
"""
import argparse
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

import conformalsom
from conformalsom.command import pictures
from measure_long_bodies import mapped, tube, with_ends

RADIUS = 0.25
WIDTH = 1000


def sphere(frequency):
    source = conformalsom.vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    return source.GetOutput()


def mollweide(sines):
    """The angle of Mollweide's map, 2 t + sin 2 t = pi sin(latitude), by Newton's method."""
    t = np.arcsin(sines)
    for _ in range(60):
        t = t - (2.0 * t + np.sin(2.0 * t) - np.pi * sines) / np.maximum(2.0 + 2.0 * np.cos(2.0 * t), 1e-12)
    return t


def drawn(n, projection, width):
    """Pixels of directions in a map, x to the right and y down, and the size of the map."""
    longitude, latitude = np.arctan2(n[:, 1], n[:, 0]), np.arctan2(n[:, 2], np.hypot(n[:, 0], n[:, 1]))
    height = width if projection == "Mercator" else width // 2
    if projection == "Equirectangular":
        x, y = longitude / np.pi, latitude / (0.5 * np.pi)
    elif projection == "Mercator":
        x, y = longitude / np.pi, np.arcsinh(np.tan(latitude)) / np.pi
    else:
        t = mollweide(n[:, 2])
        x, y = longitude / np.pi * np.cos(t), np.sin(t)
    return np.column_stack([0.5 * width * (1.0 + x), 0.5 * height * (1.0 - y)]), (width, height)


def frames(count, seed=1):
    """Directions up to 60 degrees from the equator, and two perpendicular ones, away from the seam."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        longitude, z = random.uniform(-2.5, 2.5), random.uniform(-np.sin(np.pi / 3), np.sin(np.pi / 3))
        radius = np.sqrt(1.0 - z * z)
        n = np.array([radius * np.cos(longitude), radius * np.sin(longitude), z])
        u = np.cross(n, random.normal(size=3))
        u /= np.linalg.norm(u)
        yield n, u, np.cross(n, u)


def circle(n, u, v, corners=1000):
    a = 2.0 * np.pi * np.arange(corners)[:, None] / corners
    return np.cos(RADIUS) * n + np.sin(RADIUS) * (np.cos(a) * u + np.sin(a) * v)


def triangle(n, u, v, pieces=400):
    corners = circle(n, u, v, 3)
    t = np.arange(pieces)[:, None] / pieces
    points = np.concatenate([corners[k] + t * (corners[(k + 1) % 3] - corners[k]) for k in range(3)])
    return points / np.linalg.norm(points, axis=1)[:, None]


def polygons(outlines):
    result, points, ids, first = vtkPolyData(), vtkPoints(), [], 0
    for outline in outlines:
        ids += [len(outline), *range(first, first + len(outline))]
        first += len(outline)
    points.SetDataTypeToDouble()
    xy = np.concatenate(outlines)
    points.SetData(numpy_to_vtk(np.column_stack([xy, np.zeros(len(xy))]), deep=True))
    cells = vtkCellArray()
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(np.array(ids, dtype=np.int64), deep=True))
    result.SetPoints(points)
    result.SetPolys(cells)
    return result


def measured(surface, outlines, projection, width=WIDTH):
    pixels = [drawn(outline, projection, width) for outline in outlines]
    filter_ = conformalsom.vtkMapOutlines()
    filter_.SetInputData(surface)
    filter_.SetOutlinesData(polygons([xy for xy, _ in pixels]))
    getattr(filter_, f"SetProjectionTo{projection}")()
    filter_.SetImageSize(*pixels[0][1])
    filter_.Update()
    return filter_


def column(filter_, name):
    return vtk_to_numpy(filter_.GetMeasures().GetColumnByName(name))


def text(errors, unit=" %", factor=100.0):
    return f"{factor * np.mean(errors):.2g}{unit} | {factor * np.max(errors):.2g}{unit}"


def measure_outlines():
    print("| mesh, points | projection | length, mean | largest | area, mean | largest | angles, mean | largest |\n"
          + "| --- " * 8 + "|")
    length, area = 2.0 * np.pi * np.sin(RADIUS), 2.0 * np.pi * (1.0 - np.cos(RADIUS))
    for frequency in (20, 40, 80, 160):
        surface = sphere(frequency)
        for projection in ("Equirectangular", "Mercator", "Mollweide"):
            circles = measured(surface, [circle(*frame) for frame in frames(30)], projection)
            sides = [triangle(*frame) for frame in frames(30)]
            corners = measured(surface, sides, projection).GetOutput().GetPointData()
            ids, found = vtk_to_numpy(corners.GetArray("Corner")), vtk_to_numpy(corners.GetArray("Angle"))
            a, b, c = sides[0][0], sides[0][400], sides[0][800]
            p, q = np.cross(a, b), np.cross(a, c)
            true = np.degrees(np.arccos(p @ q / np.linalg.norm(p) / np.linalg.norm(q)))
            angles = np.abs(found[(ids >= 0) & (ids % 400 == 0)] - true)
            print(f"| {surface.GetNumberOfPoints():,} | {projection} | "
                  f"{text(np.abs(column(circles, 'Length') / length - 1))} | {text(np.abs(column(circles, 'Area') / area - 1))} | {text(angles, '°', 1.0)} |", flush=True)


def painted(outline_frames, projection, width):
    """An image of labels: pixels in circles."""
    height = width if projection == "Mercator" else width // 2
    x, y = np.meshgrid((np.arange(width) + 0.5) / (0.5 * width) - 1.0,
                       (np.arange(height) + 0.5) / (0.5 * height) - 1.0)
    if projection == "Equirectangular":
        longitude, latitude = np.pi * x, 0.5 * np.pi * y
    elif projection == "Mercator":
        longitude, latitude = np.pi * x, np.arctan(np.sinh(np.pi * y))
    else:
        t = np.arcsin(y)
        longitude = np.pi * x / np.cos(t)
        latitude = np.arcsin((2.0 * t + np.sin(2.0 * t)) / np.pi)
        longitude[np.abs(longitude) > np.pi] = np.nan
    n = np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], -1)
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    labels = np.zeros((height, width), dtype=np.int32)
    labels[n @ outline_frames[0] > np.cos(RADIUS)] = 1
    scalars = numpy_to_vtk(labels.ravel(), deep=True)
    scalars.SetName("Label")
    image.GetPointData().SetScalars(scalars)
    return image


def measure_labels():
    print("\n| width of the map | projection | area, mean | largest | perimeter, mean | largest |\n" + "| --- " * 6 + "|")
    length, area = 2.0 * np.pi * np.sin(RADIUS), 2.0 * np.pi * (1.0 - np.cos(RADIUS))
    surface = sphere(80)
    for width in (250, 500, 1000):
        for projection in ("Equirectangular", "Mercator", "Mollweide"):
            areas, perimeters = [], []
            for frame in frames(12):
                labels = conformalsom.vtkMapLabels()
                labels.SetInputData(surface)
                labels.SetLabelsData(painted(frame, projection, width))
                getattr(labels, f"SetProjectionTo{projection}")()
                labels.Update()
                areas.append(abs(column(labels, "Area")[0] / area - 1.0))
                perimeters.append(abs(column(labels, "Perimeter")[0] / length - 1.0))
            print(f"| {width} | {projection} | {text(areas)} | {text(perimeters)} |", flush=True)


def measure_seconds():
    print("\n| mesh, points | outlines | CPU s |\n| --- | --- | --- |")
    for frequency in (40, 80):
        surface = sphere(frequency)
        start = time.process_time()
        measured(surface, [circle(*frame, corners=64) for frame in frames(1000)], "Mercator")
        print(f"| {surface.GetNumberOfPoints():,} | 1000 | {time.process_time() - start:.1f} |", flush=True)


def cells_of(surface, count, seed=3):
    """Point scalars: colors of cells of about equal area, with dark borders."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    random = np.random.default_rng(seed)
    chosen = [0]
    distances = np.linalg.norm(points - points[0], axis=1)
    for _ in range(count - 1):
        chosen.append(int(np.argmax(distances)))
        distances = np.minimum(distances, np.linalg.norm(points - points[chosen[-1]], axis=1))
    all_ = np.sort(np.stack([np.linalg.norm(points - points[c], axis=1) for c in chosen]), axis=0)
    owner = np.argmin(np.stack([np.linalg.norm(points - points[c], axis=1) for c in chosen]), axis=0)
    colors = random.integers(110, 250, size=(count, 3))[owner]
    colors[all_[1] - all_[0] < 0.12 * all_[1].mean()] = 40
    array = numpy_to_vtk(colors.astype(np.uint8), deep=True)
    array.SetName("Cells")
    surface.GetPointData().AddArray(array)


def map_of(surface, projection, size):
    image = conformalsom.vtkBodyMapImage()
    image.SetInputData(surface)
    image.SetArrayName("Cells")
    getattr(image, f"SetProjectionTo{projection}")()
    image.SetImageSize(*size)
    image.SetGraticuleSpacing(0.0)
    image.Update()
    output = image.GetOutput()
    outside = vtk_to_numpy(output.GetPointData().GetArray("OutsideSurface")) == 1
    vtk_to_numpy(output.GetPointData().GetScalars())[outside] = 255
    output.SetSpacing(1.0, 1.0, 1.0)
    output.SetOrigin(0.0, 0.0, 0.0)
    return output


def lines_actor(lines, color, width=5):
    actor = pictures.actor_of(lines)
    actor.GetMapper().ScalarVisibilityOff()
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetLineWidth(width)
    actor.GetProperty().LightingOff()
    return actor


def surface_scene(surface, label, aspect, outlines=None, direction=(1.0, -0.45, 0.2)):
    surface.GetPointData().SetActiveScalars("Cells")
    actor = pictures.actor_of(surface)
    actor.GetMapper().ScalarVisibilityOn()
    scene = pictures.scene(actor, label, pictures.camera_on(surface, direction, (0.0, 0.0, 1.0), aspect))
    if outlines:
        scene.AddActor(lines_actor(outlines, (0.9, 0.0, 0.0), 10))
    return scene


def draw(path):
    surface = sphere(100)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float) * [1.0, 1.0, 1.6]
    stretched = vtkPoints()
    stretched.SetData(numpy_to_vtk(points, deep=True))
    surface.SetPoints(stretched)
    cells_of(surface, 120)
    outlines = [circle(*frame, corners=100) for frame in ([np.array(v) for v in frame] for frame in (
        ([1, 0, 0], [0, 1, 0], [0, 0, 1]), ([0.6, 0, 0.8], [0, 1, 0], [-0.8, 0, 0.6]),
        ([0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]), ([0.5, 0.75, -0.43], [0.83, -0.55, 0.0], [0.24, 0.36, 0.9])))]
    filter_ = measured(surface, outlines, "Mercator")
    drawn_lines = polygons(
        [drawn(outline, "Mercator", WIDTH)[0] * [1, -1] / WIDTH + [-0.5, 0.5] for outline in outlines])
    picture = map_of(surface, "Mercator", (WIDTH, WIDTH))
    scene = pictures.image_scene(picture, "drawn in the map", 1.0)
    outline_points = vtk_to_numpy(drawn_lines.GetPoints().GetData())
    outline_points[:, 2] = 0.001
    drawn_actor = lines_actor(drawn_lines, (0.9, 0.0, 0.0))
    drawn_actor.GetProperty().SetRepresentationToWireframe()
    scene.AddActor(drawn_actor)
    measured_scene = surface_scene(surface, "measured on the surface", 1.0, filter_.GetOutput())
    pictures.write_side_by_side(path, [scene, measured_scene], 1200, 600)


def draw_long(path):
    surface = with_ends(mapped(tube(8, "bent", 160), 0.0)[0])
    cells_of(surface, 250)
    scenes = [surface_scene(surface, "cells of equal area", 0.5, direction=(0.2, -1.0, 0.0)),
              pictures.image_scene(map_of(surface, "Mercator", (500, 500)), "Mercator: 40 % of the body", 0.8),
              pictures.image_scene(map_of(surface, "Capsule", (300, 900)), "Capsule", 0.5)]
    pictures.write_side_by_side(path, scenes, 1440, 700)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--picture", metavar="FILE")
    parser.add_argument("--long-picture", metavar="FILE")
    arguments = parser.parse_args()
    if arguments.picture:
        draw(arguments.picture)
    if arguments.long_picture:
        draw_long(arguments.long_picture)
    if not arguments.picture and not arguments.long_picture:
        measure_outlines()
        measure_labels()
        measure_seconds()


if __name__ == "__main__":
    main()
