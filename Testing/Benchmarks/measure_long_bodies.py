#!/usr/bin/python3
"""Measure maps of long bodies: angles of the map to the sphere, and areas that pixels of plane maps show.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_long_bodies.py \\
      [FOLDER] [--bodies straight bent tapered midgut] [--balances 0 0.5]

Bodies are tubes of radius 1 with round ends (straight, bent, and tapered to half the radius), 2 to 20 times as long as
thick, and frames of a movie of a fly's midgut in FOLDER.

    sphere    angles: mean and 95 % of the quasi-conformal error K over the area (1 is none), flipped triangles, tier of
              vtkGlobalConformalMap, and the logarithm of the ratio of the largest to the smallest area of triangles on
              the sphere over that on the body.
    maps      the areas that pixels show over their mean, on maps with Axis ENDS: the range that has the middle 90
              percent of the body's area, as a ratio of both ends. 1.0 if all pixels show equal areas. Also the
              fraction of the body that is not on the map, and the aspect of the capsule.
"""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData

import conformalsom
from conformalsom.messages import heard


def surface_of(points, triangles):
    surface = vtkPolyData()
    vertices = vtkPoints()
    vertices.SetDataTypeToDouble()
    vertices.SetData(numpy_to_vtk(np.ascontiguousarray(points, dtype=float), deep=True))
    surface.SetPoints(vertices)
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(triangles, dtype=np.int64).ravel(), deep=True))
    surface.SetPolys(cells)
    return surface


def tube(aspect, kind, columns=48):
    """A tube with round ends. The rings are perpendicular to a middle line in the x, z plane."""
    half, longest = aspect - 1.0, aspect - 1.0 + 0.5 * np.pi
    rings = 2 * int(np.ceil(longest * columns / (2.0 * np.pi)))
    arcs = longest * (2.0 * np.arange(1, rings) / rings - 1.0)
    beyond = np.maximum(np.abs(arcs) - half, 0.0)
    along = np.concatenate([[-aspect], np.sign(arcs) * (np.minimum(np.abs(arcs), half) + np.sin(beyond)), [aspect]])
    radii = np.concatenate([[0.0], np.cos(beyond), [0.0]])
    if kind == "tapered":
        radii *= 0.75 + 0.25 * along / aspect
    turn = {"bent": 1.2 * np.pi / (2.0 * aspect)}.get(kind, 0.0)  # an arc of 216 degrees
    turn = min(turn, 0.6)
    x = (1.0 - np.cos(turn * along)) / turn if turn else 0.0 * along
    z = np.sin(turn * along) / turn if turn else along
    points = [[x[0], 0.0, z[0]]]
    for j in range(1, rings):
        a = 2.0 * np.pi * (np.arange(columns) + 0.5 * (j % 2)) / columns
        across = radii[j] * np.cos(a)
        points += np.column_stack([x[j] + across * np.cos(turn * along[j]), radii[j] * np.sin(a),
                                   z[j] - across * np.sin(turn * along[j])]).tolist()
    points.append([x[-1], 0.0, z[-1]])
    triangles, last, i = [], len(points) - 1, np.arange(columns)
    n = (i + 1) % columns
    triangles += np.column_stack([0 * i, 1 + n, 1 + i]).tolist()
    triangles += np.column_stack([last + 0 * i, last - columns + i, last - columns + n]).tolist()
    for j in range(1, rings - 1):
        low, high = 1 + (j - 1) * columns, 1 + j * columns
        if j % 2 == 0:
            triangles += np.column_stack([low + i, low + n, high + i]).tolist()
            triangles += np.column_stack([low + n, high + n, high + i]).tolist()
        else:
            triangles += np.column_stack([low + i, low + n, high + n]).tolist()
            triangles += np.column_stack([low + i, high + n, high + i]).tolist()
    return surface_of(points, triangles)


def bodies(folder, kinds):
    for kind in ("straight", "bent", "tapered"):
        for aspect in (2, 5, 10, 20) if kind in kinds else ():
            yield f"{kind}, {aspect} : 1", tube(aspect, kind)
    for number in range(1, 11) if folder and "midgut" in kinds else ():
        reader = conformalsom.vtkConformalPLYReader()
        reader.SetFileName(os.path.join(folder, f"midgut_{number:02d}.ply"))
        reader.Update()
        yield f"midgut {number}", reader.GetOutput()


def mapped(surface, balance):
    """The surface with its map, and the messages of the filter."""
    map_ = conformalsom.vtkGlobalConformalMap()
    map_.SetInputData(surface)
    map_.SetAreaBalance(balance)
    with heard(map_) as messages:
        map_.Update()
    return map_.GetOutput(), messages


def cells(data, name):
    return vtk_to_numpy(data.GetCellData().GetArray(name))


def field(data, name):
    array = data.GetFieldData().GetArray(name)
    return array.GetValue(0) if array else float("nan")


def areas_of(surface):
    p = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    t = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    return 0.5 * np.linalg.norm(np.cross(p[t[:, 1]] - p[t[:, 0]], p[t[:, 2]] - p[t[:, 0]]), axis=1)


def weighted(values, weights, fraction):
    order = np.argsort(values)
    sums = np.cumsum(weights[order])
    return values[order][np.searchsorted(sums, fraction * sums[-1])]


def measure_sphere(title, balance, surface):
    distortion = conformalsom.vtkConformalDistortion()
    distortion.SetInputData(surface)
    distortion.Update()
    output = distortion.GetOutput()
    k, logarithm, areas = cells(output, "QuasiConformalError"), cells(output, "AreaDistortion"), areas_of(output)
    print(f"| {title} | {balance} | {np.average(k, weights=areas):.3f} | {weighted(k, areas, 0.95):.3f} | "
          f"{k.max():.2f} | {field(output, 'NumberOfFlippedTriangles')} | {field(surface, 'SphereMapTier')} | "
          f"{np.ptp(logarithm):.1f} |", flush=True)


def with_ends(surface):
    """The surface with its ends at the poles."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    size = np.ptp(points, axis=0).max()
    volume = vtkImageData()
    volume.SetDimensions(3, 3, 3)
    volume.SetOrigin(points.mean(axis=0) - size)
    volume.SetSpacing(size, size, size)
    values = numpy_to_vtk(np.zeros(27, dtype=np.float32), deep=True)
    values.SetName("Nothing")
    volume.GetPointData().SetScalars(values)
    layers = conformalsom.vtkSurfaceLayers()
    layers.SetInputData(surface)
    layers.SetVolumeData(volume)
    layers.SetAxisToEnds()
    layers.SetNumberOfLayers(1)
    layers.SetDepthRange(-1e-9, 1e-9)
    layers.SetSummaryRange(-1.0, 1.0)
    layers.SetImageSize(8, 8)
    with heard(layers) as messages:
        layers.Update()
    if messages.errors:
        return None
    return layers.GetOutput()


def measure_map(surface, projection, size):
    """The ratio of the scales between which pixels have 90 percent of the area, and the aspect of the capsule."""
    image = conformalsom.vtkBodyMapImage()
    image.SetInputData(surface)
    image.SetArrayName("SpherePosition")
    getattr(image, f"SetProjectionTo{projection}")()
    image.SetImageSize(*size)
    image.SetGraticuleSpacing(0.0)
    image.GenerateAreaScaleOn()
    image.Update()
    low, high = image.GetOutput().GetFieldData().GetArray("AreaScaleRange").GetTuple(0)
    return high / low, field(image.GetOutput(), "CapsuleAspect")


def beyond_mercator(surface):
    """Fraction of the body beyond latitudes of 85.05 degrees."""
    z = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))
    t = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    middles = z[t].mean(axis=1)
    latitude = np.degrees(np.arctan2(np.abs(middles[:, 2]), np.hypot(middles[:, 0], middles[:, 1])))
    areas = areas_of(surface)
    return areas[latitude > 85.0511].sum() / areas.sum()


def measure_maps(surfaces):
    print("\n| body | AreaBalance | Mercator | beyond Mercator | Equirectangular | Mollweide | Capsule | aspect |\n"
          + "| --- " * 8 + "|")
    for title, balance, surface in surfaces:
        turned = with_ends(surface)
        if turned is None:
            print(f"| {title} | {balance} | the ends are not found |")
            continue
        ratios = [measure_map(turned, projection, size) for projection, size in (
            ("Mercator", (400, 400)), ("Equirectangular", (600, 300)), ("Mollweide", (600, 300)),
            ("Capsule", (300, 900)))]
        texts = [f"{ratio:.3g}" for ratio, _ in ratios]
        print(f"| {title} | {balance} | {texts[0]} | {100.0 * beyond_mercator(turned):.0f} % | {texts[1]} | "
              f"{texts[2]} | {texts[3]} | {ratios[3][1]:.2f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", metavar="FOLDER")
    parser.add_argument("--bodies", nargs="+", default=["straight", "bent", "tapered", "midgut"])
    parser.add_argument("--balances", nargs="+", type=float, default=[0.0, 0.5])
    arguments = parser.parse_args()
    surfaces = []
    print("| body | AreaBalance | mean K | 95 % K | largest K | flipped | tier | log area ratio |\n" + "| --- " * 8 + "|")
    for title, body in bodies(arguments.folder, arguments.bodies):
        for balance in arguments.balances:
            surface, messages = mapped(body, balance)
            if not surface.GetNumberOfPoints():
                print(title, balance, messages.warnings, messages.errors)
                continue
            measure_sphere(title, balance, surface)
            surfaces.append((title, balance, surface))
    measure_maps(surfaces)


if __name__ == "__main__":
    main()
