#!/usr/bin/python3
"""Measure how sharply baked textures show the colors of scans: the default of the command, and other settings.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_textures.py

Makes scans of objects whose color is a function of the position, learns a surface from each scan, and bakes the
colors of the scan's points. Rays are then cast from several directions. Where a ray meets the surface, the color of
the texture (bilinear, as a renderer shows it) is compared with the function. Prints a row for each scan and setting:

    side     width of the texture [texels]
    error    mean difference of a color from that of the object, in [0, 255]
    under    share of the surface with fewer texels than scan points
    1 %, 50 % percentiles of the number of texels for each scan point
    seconds  to lay and bake the texture
"""
import argparse
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import mutable
from vtkmodules.vtkCommonDataModel import vtkStaticCellLocator

import conformalsom.inputs
from conformalsom import vtkSphericalTextureImage, vtkSphericalTextureMap
from helpers import builtin_figure

BEFORE = {"balance": 0.0, "side": 1024, "average": False}
OWN_MAP = {"balance": 0.0, "side": None, "average": True}
DEFAULT = {"balance": 0.5, "side": None, "average": True}
SETTINGS = {"before": BEFORE, "own map, averaged": OWN_MAP, "default": DEFAULT}
VIEWS = ((0, 0, 1), (1, 0.2, 0.3), (-1, 0.3, 0.2), (0.2, 0.1, -1), (0.3, 1, 0.4), (0.5, -1, 0.6))
TUNED_VIEWS = ((0.4, 0.3, 1), (-0.7, 0.1, -0.7))


def tiles(points):
    """Two colors that alternate in space, with sharp edges, eight to ten scan points from edge to edge."""
    sign = np.prod(np.sin(np.pi * points / 0.1 + 0.3), axis=1) > 0.0
    return np.where(sign[:, None], (235.0, 180.0, 60.0), (30.0, 60.0, 140.0))


def clouds(points):
    """Smooth shades of several sizes."""
    waves = [np.sin(points @ (k * np.array(axis)) + k)
             for k, axis in ((6.0, (1, 0.3, -0.5)), (17.0, (-0.4, 1, 0.6)), (41.0, (0.5, -0.6, 1)))]
    return 127.5 + 40.0 * np.column_stack([waves[0] + waves[1], waves[1] + waves[2], waves[2] + waves[0]])


def spots(points):
    """Dark spots on a light ground, whose edges are as sharp as a scan of 60,000 points shows."""
    nearest = np.linalg.norm((points + 0.075) % 0.15 - 0.075, axis=1)
    share = 1.0 / (1.0 + np.exp((nearest - 0.05) / 0.006))
    return 225.0 - share[:, None] * np.array((180.0, 150.0, 60.0))


def colored(points, color):
    """Points with colors as a scan of VTK."""
    scan = conformalsom.inputs.cloud_of(points)
    array = numpy_to_vtk(np.clip(np.rint(color(points)), 0, 255).astype(np.uint8), deep=True)
    array.SetName("Color")
    scan.GetPointData().SetScalars(array)
    return scan


def texture_of(surface, scan, balance, side, average):
    """A surface with texture coordinates, cut, and its texture as rows x columns x 3."""
    laid, image = vtkSphericalTextureMap(), vtkSphericalTextureImage()
    laid.SetInputData(surface)
    laid.SetProjectionToOctahedral()
    laid.SetMargin(0.01)
    laid.SetAreaBalance(balance)
    laid.SplitSeamOn()
    image.SetInputConnection(laid.GetOutputPort())
    image.SetSourceData(scan)
    image.SetSampling(int(average))
    if side is None:
        image.FitImageSize()
    else:
        image.SetImageSize(side, side)
    image.Update()
    columns, rows, _ = image.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
    return laid.GetOutput(), pixels.reshape(rows, columns, 3).astype(float)


def triangles_of(surface):
    """Corners in space and in the texture: two arrays of #triangles x 3 x 3 and x 2."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(surface.GetPoints().GetData())
    return points[corners], vtk_to_numpy(surface.GetPointData().GetTCoords()).astype(float)[corners]


def texels_of_points(surface, side, count):
    """Number of texels for each scan point, for evenly spread points; and the area of each triangle."""
    space, texture = triangles_of(surface)
    area = 0.5 * np.linalg.norm(np.cross(space[:, 1] - space[:, 0], space[:, 2] - space[:, 0]), axis=1)
    a, b = texture[:, 1] - texture[:, 0], texture[:, 2] - texture[:, 0]
    texels = 0.5 * np.abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]) * side**2
    return texels / np.maximum(area, 1e-300) * area.sum() / count, area


def percentile(values, weights, share):
    """The value below which a share of the weight lies."""
    order = np.argsort(values)
    return values[order][np.searchsorted(np.cumsum(weights[order]), share * weights.sum())]


def hits(surface, views, across):
    """Where rays first meet the surface: positions, triangles and barycentric coordinates."""
    locator = vtkStaticCellLocator()
    locator.SetDataSet(surface)
    locator.BuildLocator()
    box = np.array(surface.GetBounds()).reshape(3, 2)
    middle, radius = box.mean(axis=1), 0.5 * np.linalg.norm(box[:, 1] - box[:, 0])
    found = []
    t, x, pcoords, part, cell = mutable(0.0), [0.0] * 3, [0.0] * 3, mutable(0), mutable(0)
    for view in views:
        ahead = np.array(view, float) / np.linalg.norm(view)
        right = np.cross((0.0, 1.0, 0.1), ahead)
        right /= np.linalg.norm(right)
        up = np.cross(ahead, right)
        for u in np.linspace(-1, 1, across):
            for v in np.linspace(-1, 1, across):
                start = middle + radius * (u * right + v * up)
                if locator.IntersectWithLine(start + 2 * radius * ahead, start - 2 * radius * ahead, 1e-9, t, x,
                                             pcoords, part, cell):
                    found.append((*x, int(cell), pcoords[0], pcoords[1]))
    table = np.array(found)
    b, c = table[:, 4], table[:, 5]
    return table[:, :3], table[:, 3].astype(int), np.column_stack((1 - b - c, b, c))


def shown(pixels, st):
    """Colors of a texture at texture coordinates, bilinear."""
    rows, columns, _ = pixels.shape
    place = np.clip(st * (columns, rows) - 0.5, 0, (columns - 1, rows - 1))
    low = np.minimum(place.astype(int), (columns - 2, rows - 2))
    (i, j), (u, v) = low.T, (place - low).T[..., None]
    return ((1 - u) * (1 - v) * pixels[j, i] + u * (1 - v) * pixels[j, i + 1]
            + (1 - u) * v * pixels[j + 1, i] + u * v * pixels[j + 1, i + 1])


def measured(surface, scan, color, setting, views=VIEWS, across=110):
    """Figures of one setting, by name."""
    start = time.perf_counter()
    laid, pixels = texture_of(surface, scan, **setting)
    seconds = time.perf_counter() - start
    place, triangle, weights = hits(laid, views, across)
    st = np.einsum("ik,ikj->ij", weights, triangles_of(laid)[1][triangle])
    error = np.abs(shown(pixels, st) - np.clip(color(place), 0, 255)).mean()
    texels, area = texels_of_points(laid, pixels.shape[0], scan.GetNumberOfPoints())
    return {"side": pixels.shape[1], "error": error, "under": area[texels < 1.0].sum() / area.sum(),
            "least": percentile(texels, area, 0.01), "middle": percentile(texels, area, 0.5), "seconds": seconds}


def points_of(name):
    """Points of a scan: a built-in object, or a file."""
    if name in ("bear", "dancer"):
        scan = builtin_figure.figure_cloud(figure=getattr(builtin_figure, name))
    else:
        scan = conformalsom.inputs.read(name)
    return vtk_to_numpy(scan.GetPoints().GetData()).astype(float)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scans", nargs="*", default=["bear", "dancer"], help="bear, dancer, or files of scans")
    parser.add_argument("--colors", nargs="+", default=["tiles", "clouds", "spots"])
    options = parser.parse_args()
    print(f"{'scan':<10}{'colors':<9}{'setting':<20}{'side':>6}{'error':>8}{'under':>9}{'1 %':>7}{'50 %':>7}{'seconds':>9}")
    for name in options.scans:
        points = points_of(name)
        surface = conformalsom.learn(points).smooth().polydata
        for color in map(globals().get, options.colors):
            scan = colored(points, color)
            for label, setting in SETTINGS.items():
                figures = measured(surface, scan, color, setting)
                print(f"{name.rsplit('/', 1)[-1][:9]:<10}{color.__name__:<9}{label:<20}{figures['side']:>6}"
                      f"{figures['error']:>8.2f}{figures['under']:>9.2%}{figures['least']:>7.2f}"
                      f"{figures['middle']:>7.2f}{figures['seconds']:>9.2f}", flush=True)


if __name__ == "__main__":
    main()
