#!/usr/bin/python3
"""Measure surfaces, layers and maps of volumes of tissue.

    PYTHONPATH=build/dev/python:Examples/Python /usr/bin/python3 Testing/Benchmarks/measure_volumes.py [FOLDER]

Prints four tables. The first needs no files. The others need volumes and frames of a movie in FOLDER, with the names
that the project blender-tissue-cartography has given them; without FOLDER they are left out.

    shell     A bright shell of known depth under a bumpy ellipsoid: distance of the layer of the largest value, between
              layers, from the known depth [voxels], for shells at several depths.
    tissue    Surfaces that are learned from the outside of an embryo and an organoid:
              euler, inverted and folded [percent], warnings of vtkConformalSOM, bright voxels that are outside of the
              surface by more than a voxel [percent], CPU seconds of points, surface and layers, faults of layers.
    start     Frames of a movie, learned anew and from the frame before: CPU seconds of a frame, and the mean angle
              between the sphere positions of closest points in neighboring frames, after a rotation [degrees].
    maps      Files of maps, read by tifffile if it is installed: shape, spacing and unit.
"""
import argparse
import os
import tempfile
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkStaticPointLocator
from vtkmodules.vtkFiltersCore import vtkImplicitPolyDataDistance
from vtkmodules.vtkFiltersExtraction import vtkExtractEdges

import conformalsom
from conformalsom.messages import heard

try:
    import tifffile
except ImportError:
    tifffile = None

EMBRYO = "Drosophila_CAAX-mCherry-tiny-8bit.tif"
ORGANOID = "Neural_tube_organoid_DAPI_betaCat-small.tif"


def array_of(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def field(data, name):
    return data.GetFieldData().GetArray(name).GetValue(0)


def volume_of(values, spacing, origin):
    """An image of values[k, j, i]."""
    image = vtkImageData()
    image.SetDimensions(*values.shape[::-1])
    image.SetSpacing(*spacing)
    image.SetOrigin(*origin)
    scalars = numpy_to_vtk(np.ascontiguousarray(values, dtype=np.float32).ravel(), deep=True)
    scalars.SetName("Intensity")
    image.GetPointData().SetScalars(scalars)
    return image


def bumpy_ellipsoid(frequency=60):
    """A smooth closed surface with its directions as a map, 36 to 60 voxels wide."""
    source = conformalsom.vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    surface = vtkPolyData()
    surface.DeepCopy(source.GetOutput())
    n = array_of(surface, "SpherePosition")
    radius = 1.0 + 0.06 * np.sin(4.0 * n[:, :1]) * np.cos(3.0 * n[:, 1:2] + 0.5) + 0.05 * n[:, 2:] * n[:, :1]
    points = vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(numpy_to_vtk(radius * n * np.array([30.0, 21.0, 18.0]), deep=True))
    surface.SetPoints(points)
    return surface


def distances(surface, positions):
    """Signed distances of positions from a surface, negative inside."""
    measure = vtkImplicitPolyDataDistance()
    measure.SetInput(surface)
    result = numpy_to_vtk(np.zeros(len(positions)), deep=True)
    measure.FunctionValue(numpy_to_vtk(np.ascontiguousarray(positions), deep=True), result)
    return vtk_to_numpy(result)


def measure_shell():
    print("| depth [voxels] | mean error | 95 % | largest | limited points |\n| --- | --- | --- | --- | --- |")
    surface = bumpy_ellipsoid()
    size, spacing = (48, 56, 76), (1.0, 1.0, 1.0)
    origin = [-0.5 * (n - 1) for n in size[::-1]]
    k, j, i = np.meshgrid(*(np.arange(n) for n in size), indexing="ij")
    positions = np.column_stack([i.ravel(), j.ravel(), k.ravel()]) * spacing + origin
    depth_of_voxel = distances(surface, positions).reshape(size)
    for depth in (-4.0, -2.3, -0.6, 1.5):
        layers = conformalsom.vtkSurfaceLayers()
        layers.SetInputData(surface)
        layers.SetVolumeData(volume_of(100.0 * np.exp(-0.5 * ((depth_of_voxel - depth) / 1.2) ** 2), spacing, origin))
        layers.SetDepthRange(-6.0, 3.0)
        layers.SetNumberOfLayers(19)
        layers.SetImageSize(64, 32)
        layers.Update()
        output = layers.GetOutput()
        error = np.abs(array_of(output, "DepthOfMaximum") - depth)
        limited = array_of(output, "InwardLimit") < 6.0
        print(f"| {depth} | {error.mean():.3f} | {np.percentile(error, 95):.3f} | {error.max():.3f} | "
              f"{100.0 * limited.mean():.1f} % |", flush=True)


def read(path):
    reader = conformalsom.vtkTIFFStackReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def timed(filter_):
    start = time.process_time()
    with heard(filter_) as messages:
        filter_.Update()
    return time.process_time() - start, messages.warnings


def outside_points(volume, component=0):
    points = conformalsom.vtkVolumeSurfacePoints()
    points.SetInputData(volume)
    points.SetComponent(component)
    return points


def learned(points, start=None, neurons=4000):
    som = conformalsom.vtkConformalSOM()
    som.SetInputData(0, points)
    if start:
        som.SetInputData(1, start)
    som.SetNumberOfNeurons(neurons)
    return som


def euler(surface):
    edges = vtkExtractEdges()
    edges.SetInputData(surface)
    edges.Update()
    return surface.GetNumberOfPoints() - edges.GetOutput().GetNumberOfLines() + surface.GetNumberOfPolys()


def bright_positions(volume, component, level):
    values = vtk_to_numpy(volume.GetPointData().GetScalars()).reshape(volume.GetNumberOfPoints(), -1)[:, component]
    ids = np.flatnonzero(values > level)
    size = volume.GetDimensions()
    index = np.column_stack([ids % size[0], ids // size[0] % size[1], ids // (size[0] * size[1])])
    return index * np.array(volume.GetSpacing())


def measure_tissue(folder):
    print("\n| volume | points | euler | inverted | folded | warnings | bright outside | s points | s surface | s layers |"
          " faults |\n" + "| --- " * 11 + "|")
    maps = {}
    for title, file, component in (("embryo", EMBRYO, 0), ("organoid, DAPI", ORGANOID, 0),
                                   ("organoid, beta-catenin", ORGANOID, 1)):
        volume = read(os.path.join(folder, file))
        points = outside_points(volume, component)
        s_points, _ = timed(points)
        som = learned(points.GetOutput())
        s_surface, warnings = timed(som)
        surface = som.GetOutput()
        layers = conformalsom.vtkSurfaceLayers()
        layers.SetInputData(surface)
        layers.SetVolumeData(volume)
        layers.SetComponent(component)
        layers.SetAxisToLongAxis()
        s_layers, _ = timed(layers)
        bright = bright_positions(volume, component, 1.5 * field(points.GetOutput(), "Level"))
        outside = distances(surface, bright) > min(volume.GetSpacing())
        print(f"| {title} | {points.GetOutput().GetNumberOfPoints():,} | {euler(surface)} | "
              f"{100.0 * field(surface, 'InvertedFraction'):.2f} % | {100.0 * field(surface, 'FoldedFraction'):.2f} % | "
              f"{len(warnings)} | {100.0 * outside.mean():.2f} % | {s_points:.2f} | {s_surface:.1f} | {s_layers:.1f} | "
              f"{field(layers.GetOutput(), 'LayerFaults')} |", flush=True)
        maps[title] = layers
    return maps


def turned(a, b):
    """The rotation that moves the directions a closest to b."""
    u, _, v = np.linalg.svd(a.T @ b)
    return u @ np.diag([1.0, 1.0, np.linalg.det(u @ v)]) @ v


def angle_between(one, two):
    """Mean angle between the sphere positions of closest points, after the best rotation [degrees]."""
    locator = vtkStaticPointLocator()
    locator.SetDataSet(one)
    locator.BuildLocator()
    positions = vtk_to_numpy(two.GetPoints().GetData())
    closest = np.array([locator.FindClosestPoint(p) for p in positions])
    a, b = array_of(one, "SpherePosition")[closest], array_of(two, "SpherePosition")
    cosines = np.clip(np.sum((a @ turned(a, b)) * b, axis=1), -1.0, 1.0)
    return np.degrees(np.arccos(cosines)).mean()


def measure_start(folder):
    print("\n| start | CPU s a frame | warnings | angle to the frame before, mean | largest |\n| --- " + "| --- " * 4 + "|")
    frames = [conformalsom.vtkConformalPLYReader() for _ in range(5)]
    for number, reader in enumerate(frames, 1):
        reader.SetFileName(os.path.join(folder, f"midgut_{number:02d}.ply"))
        reader.Update()
    for title in ("sphere or hull", "frame before"):
        seconds, angles, count, before = [], [], 0, None
        for reader in frames:
            points = vtkPolyData()
            points.SetPoints(reader.GetOutput().GetPoints())
            som = learned(points, before if title == "frame before" else None)
            needed, warnings = timed(som)
            if before:
                seconds.append(needed)
                count += len(warnings)
                angles.append(angle_between(before, som.GetOutput()))
            before = vtkPolyData()
            before.DeepCopy(som.GetOutput())
        print(f"| {title} | {np.mean(seconds):.2f} | {count} | {np.mean(angles):.2f} | {np.max(angles):.2f} |", flush=True)


def measure_maps(maps):
    print("\n| map | size of the file | tifffile: shape | spacing x, y, z | unit |\n| --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for title, layers in maps.items():
            writer = conformalsom.vtkTIFFStackWriter()
            writer.SetInputConnection(layers.GetOutputPort(1))
            writer.SetUnit("pixel" if title == "embryo" else "micron")
            writer.SetYAxisToUp()
            path = os.path.join(folder, "map.tif")
            writer.SetFileName(path)
            if not writer.Write():
                raise RuntimeError(f"{path} is not written")
            shape = spacing = unit = "not installed"
            if tifffile:
                with tifffile.TiffFile(path) as file:
                    shape = file.asarray().shape
                    tags = file.pages[0].tags
                    ratios = [tags[name].value for name in ("XResolution", "YResolution")]
                    spacing = ", ".join(f"{b / a:.4f}" for a, b in ratios)
                    spacing += f", {file.imagej_metadata['spacing']:.4f}"
                    unit = file.imagej_metadata["unit"]
            print(f"| {title} | {os.path.getsize(path):,} | {shape} | {spacing} | {unit} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", metavar="FOLDER")
    folder = parser.parse_args().folder
    measure_shell()
    if folder:
        maps = measure_tissue(folder)
        measure_start(folder)
        measure_maps(maps)


if __name__ == "__main__":
    main()
