#!/usr/bin/python3
"""Follow a moving body: maps that correspond at all times, velocities, and growth of areas.

The time steps are files of closed surfaces; without files, a body that grows and bends is made by code. Every surface
is mapped to the sphere, and the maps are made to correspond. The table of time steps is printed. --picture draws three
time steps with stripes that are carried along by the maps, and the growth of areas at the last one.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from conformalsom import vtkGeodesicSphereSource, vtkGlobalConformalMap, vtkSphericalTimeSeries
from conformalsom.command import pictures, scan_files
from conformalsom.command.steps import StepFailed, Steps

COLUMNS = ["Time", "State", "RelativeArea", "RelativeVolume", "RelativeDisplacement", "RegistrationStretch",
           "NumberOfFolds", "MeanAreaRate", "MeanShearRate"]
PANEL = 360, 360


def growing_body(step, count):
    """A body that grows at one end and bends. The mesh of each time step differs."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(24 + step % 3)
    source.Update()
    x, y, z = vtk_to_numpy(source.GetOutput().GetPoints().GetData()).astype(float).T
    t = step / (count - 1)
    width = 0.5 * (1.0 + 0.5 * t * np.exp(-((z - 0.7) / 0.35) ** 2)) * (1.0 - 0.3 * np.exp(-(z / 0.3) ** 2))
    positions = np.stack([width * x + 0.7 * t * z * z, width * y, (1.3 + 0.3 * t) * z], axis=1)
    points, surface = vtkPoints(), vtkPolyData()
    points.SetData(numpy_to_vtk(positions, deep=True))
    surface.SetPoints(points)
    surface.SetPolys(source.GetOutput().GetPolys())
    return surface


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="*", help="files of closed surfaces, in the order of time")
    parser.add_argument("--steps", type=int, default=5, help="of the body made by code, default 5")
    parser.add_argument("--picture", metavar="FILE", help="to draw three time steps, PNG or JPEG")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    if args.picture and os.path.lexists(args.picture):
        parser.error(f"{args.picture} already exists")
    if args.steps < 2 or len(args.surfaces) == 1:
        parser.error("at least two time steps are needed")
    return args


def surfaces_of(args, steps):
    if not args.surfaces:
        return [growing_body(step, args.steps) for step in range(args.steps)]
    surfaces = []
    for path in args.surfaces:
        reader = scan_files.scan_reader(path)
        steps.run(f"Read {path}", reader)
        surfaces.append(reader.GetOutput())
    return surfaces


def mapped(surface, steps):
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(surface)
    conformal.SetAreaBalance(0.5)
    steps.run("Map a surface to the sphere", conformal)
    return conformal.GetOutput()


def striped(surface):
    """Colors by the position on the sphere: dark and light fields, redder towards one pole."""
    x, y, z = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition")).T
    longitude, latitude = np.arctan2(y, x), np.arcsin(np.clip(z, -1, 1))
    field = (np.floor(longitude / (np.pi / 6)) + np.floor(latitude / (np.pi / 8))) % 2
    base = np.stack([0.55 + 0.4 * latitude / np.pi, 0.65 + 0.2 * np.cos(longitude) ** 2, 0.75 - 0.4 * latitude / np.pi], 1)
    return (255 * base * (0.45 + 0.55 * field[:, None])).clip(0, 255).astype(np.uint8)


def warm_and_cold(values):
    """Blue below 0, white at 0, red above."""
    scale = max(np.abs(np.percentile(values, [2, 98])).max(), 1e-12)
    s = (values / scale).clip(-1, 1)[:, None]
    colors = np.where(s > 0, 1 - s * np.array([[0.15, 0.8, 0.8]]), 1 + s * np.array([[0.8, 0.6, 0.1]]))
    return (255 * colors).astype(np.uint8)


def scene_of(surface, colors, label, whole):
    copy = vtkPolyData()
    copy.ShallowCopy(surface)
    scalars = numpy_to_vtk(colors, deep=True)
    scalars.SetName("Colors")
    copy.GetPointData().SetScalars(scalars)
    normals = vtkPolyDataNormals()
    normals.SetInputData(copy)
    normals.SplittingOff()
    normals.Update()
    actor = pictures.actor_of(normals.GetOutput())
    actor.GetMapper().ScalarVisibilityOn()
    return pictures.scene(actor, label, pictures.camera_on(whole, (0.2, -1.0, 0.2), (0.0, 0.0, 1.0), PANEL[0] / PANEL[1]))


def main():
    args = arguments()
    steps = Steps()
    series = vtkSphericalTimeSeries()
    surfaces = surfaces_of(args, steps)
    for surface in surfaces:
        series.AddInputDataObject(mapped(surface, steps))
    steps.run("Make the maps correspond", series)
    table = series.GetTable()
    print("  ".join(COLUMNS))
    for row in range(table.GetNumberOfRows()):
        values = [table.GetValueByName(row, name) for name in COLUMNS]
        print("  ".join(value.ToString() if value.IsString() else f"{value.ToDouble():.4g}" for value in values))
    if args.picture:
        scenes = []
        last = len(surfaces) - 1
        for time in (0, last // 2, last):
            series.UpdateTimeStep(time)
            shown = vtkPolyData()
            shown.DeepCopy(series.GetOutput())
            scenes.append(scene_of(shown, striped(shown), f"time {time}", surfaces[-1]))
        rates = vtk_to_numpy(shown.GetPointData().GetArray("AreaRate"))
        scenes.append(scene_of(shown, warm_and_cold(rates), "growth of areas", surfaces[-1]))
        pictures.write_side_by_side(args.picture, scenes, 4 * PANEL[0], PANEL[1])
        print(f"wrote {args.picture}")


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, OSError, ValueError) as error:
        sys.exit(f"time_series: {error}")
