#!/usr/bin/python3
"""A map of tissue: from a volume of a microscope to its outer layers, unrolled.

The volume is a TIFF stack of ImageJ or Fiji; without one, an ellipsoid of cells is made by code. Points on its outside
are found, a closed surface is learned from them, and the volume is sampled in layers along the normals. The layers are
written as a stack of maps, which ImageJ, Fiji and tifffile open with its spacing. --picture draws a slice of the volume,
the surface with its brightest layer, and the map, side by side.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from conformalsom import (
    vtkConformalSOM, vtkSurfaceLayers, vtkTIFFStackReader, vtkTIFFStackWriter, vtkVolumeSurfacePoints)
from conformalsom.command import pictures
from conformalsom.command.steps import StepFailed, Steps

PROJECTIONS = ["Equirectangular", "LambertAzimuthal", "Mollweide", "PeirceQuincuncial", "Mercator"]
SQUARE = ("PeirceQuincuncial", "Mercator")
PANEL = 480, 360


def cells_of_an_ellipsoid(size=(72, 52, 46), cells=220, seed=2):
    """A volume: the bright membranes between cells on an ellipsoid, under them yolk. Values are 0 to 255."""
    random = np.random.default_rng(seed)
    k, j, i = np.meshgrid(*(np.arange(n) for n in size[::-1]), indexing="ij")
    positions = np.column_stack([i.ravel(), j.ravel(), k.ravel()]) - 0.5 * (np.array(size) - 1)
    radii = 0.5 * np.array(size) - 5.0
    scaled = positions / radii
    length = np.linalg.norm(scaled, axis=1)
    seeds = random.normal(size=(cells, 3))
    seeds /= np.linalg.norm(seeds, axis=1)[:, None]
    nearest = np.sort(np.array([np.linalg.norm(scaled / length[:, None].clip(1e-9) - s, axis=1) for s in seeds]),
                      axis=0)[:2]
    border = np.exp(-((nearest[1] - nearest[0]) / 0.05) ** 2)
    depth = (length - 1.0) * radii.min()
    values = 235.0 * (0.25 + 0.75 * border) * np.exp(-0.5 * ((depth + 2.0) / 1.4) ** 2)
    values += 30.0 / (1.0 + np.exp(2.0 * (depth + 2.0))) + random.uniform(0.0, 12.0, len(values))
    image = vtkImageData()
    image.SetDimensions(*size)
    scalars = numpy_to_vtk(values.clip(0, 255).astype(np.uint8), deep=True)
    scalars.SetName("Intensity")
    image.GetPointData().SetScalars(scalars)
    return image


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("volume", nargs="?", help="a TIFF stack; default: an ellipsoid of cells made by code")
    parser.add_argument("--channel", type=int, default=0, help="of the stack, counted from 0; default 0")
    parser.add_argument("--neurons", type=int, default=4000, help="of the surface, default 4000")
    parser.add_argument("--depths", nargs=2, type=float, default=(0.0, 0.0), metavar=("FROM", "TO"),
                        help="of the layers, negative inside, in the unit of the volume; default: 4 voxels inside to 4 outside")
    parser.add_argument("--projection", choices=PROJECTIONS, default=PROJECTIONS[0],
                        help=f"of the sphere, default {PROJECTIONS[0]}")
    parser.add_argument("--width", type=int, default=800, help="of the map in pixels, default 800")
    parser.add_argument("--output", metavar="FILE", default="tissue_map.tif", help="default tissue_map.tif")
    parser.add_argument("--picture", metavar="FILE", help="to draw slice, surface and map, PNG or JPEG")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    for path in (args.output, args.picture):
        if path and os.path.lexists(path):
            parser.error(f"{path} already exists")
    if args.width < 16:
        parser.error("--width must be at least 16")
    return args


def volume_of(args, steps):
    if not args.volume:
        return cells_of_an_ellipsoid()
    reader = vtkTIFFStackReader()
    reader.SetFileName(args.volume)
    steps.run(f"Read {args.volume}", reader)
    return reader.GetOutput()


def gray(values, valid=None):
    """Bytes of 3 colors, black and white for the values at 1 and 98.5 percent; other pixels are white."""
    used = values if valid is None else values[valid]
    low, high = np.percentile(used, [1.0, 98.5])
    bytes_ = (255.0 * (values - low) / max(high - low, 1e-9)).clip(0, 255).astype(np.uint8)
    if valid is not None:
        bytes_[~valid] = 255
    return np.repeat(bytes_[:, None], 3, axis=1)


def picture_of(values, width, height, spacing, valid=None):
    image = vtkImageData()
    image.SetDimensions(width, height, 1)
    image.SetSpacing(spacing[0], spacing[1], 1.0)
    image.GetPointData().SetScalars(numpy_to_vtk(gray(values, valid), deep=True))
    return image


def slice_of(volume, channel):
    """The middle slice; its first row is at the top, as in ImageJ."""
    size = volume.GetDimensions()
    values = vtk_to_numpy(volume.GetPointData().GetScalars()).reshape(*size[::-1], -1)
    middle = values[size[2] // 2, ::-1, :, channel].astype(float)
    return picture_of(middle.ravel(), size[0], size[1], volume.GetSpacing())


def map_of(summary):
    size = summary.GetDimensions()
    arrays = summary.GetPointData()
    return picture_of(vtk_to_numpy(arrays.GetArray("LayerMaximum")), size[0], size[1], summary.GetSpacing(),
                      vtk_to_numpy(arrays.GetArray("OutsideSurface")) == 0)


def surface_scene(surface, label):
    normals = vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.Update()
    shaded = normals.GetOutput()
    shaded.GetPointData().SetScalars(
        numpy_to_vtk(gray(vtk_to_numpy(shaded.GetPointData().GetArray("LayerMaximum"))), deep=True))
    actor = pictures.actor_of(shaded)
    actor.GetMapper().ScalarVisibilityOn()
    return pictures.scene(actor, label, pictures.camera_on(surface, (0.3, -0.4, -1.0), (0.0, -1.0, 0.0),
                                                           PANEL[0] / PANEL[1]))


def main():
    args = arguments()
    steps = Steps()
    volume = volume_of(args, steps)
    points = vtkVolumeSurfacePoints()
    points.SetInputData(volume)
    points.SetComponent(args.channel)
    steps.run("Find points on the outside", points)
    som = vtkConformalSOM()
    som.SetInputConnection(points.GetOutputPort())
    som.SetNumberOfNeurons(args.neurons)
    steps.run("Learn the surface", som)
    layers = vtkSurfaceLayers()
    layers.SetInputConnection(som.GetOutputPort())
    layers.SetVolumeData(volume)
    layers.SetComponent(args.channel)
    layers.SetDepthRange(args.depths)
    layers.SetAxisToLongAxis()
    getattr(layers, f"SetProjectionTo{args.projection}")()
    layers.SetImageSize(args.width, args.width if args.projection in SQUARE else args.width // 2)
    steps.run("Sample the layers", layers)
    writer = vtkTIFFStackWriter()
    writer.SetInputConnection(layers.GetOutputPort(1))
    words = volume.GetFieldData().GetAbstractArray("Unit")
    writer.SetUnit(words.GetValue(0) if words else "pixel")
    writer.SetYAxisToUp()
    writer.SetFileName(args.output)
    steps.run(f"Write {args.output}", writer, writer.Write)
    if args.picture:
        aspect = PANEL[0] / PANEL[1]
        pictures.write_side_by_side(args.picture, [
            pictures.image_scene(slice_of(volume, args.channel), "a slice of the volume", aspect),
            surface_scene(layers.GetOutput(), "the brightest layer on the surface"),
            pictures.image_scene(map_of(layers.GetOutputDataObject(2)), f"its map, {args.projection}", aspect),
        ], 3 * PANEL[0], PANEL[1])
        print(f"wrote {args.picture}")


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, OSError, ValueError) as error:
        sys.exit(f"tissue_map: {error}")
