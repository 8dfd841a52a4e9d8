#!/usr/bin/python3
"""Measure how much a surface of few points, with a normal map, looks like the surface of many points.

    PYTHONPATH=build/dev/python:Examples/Python xvfb-run -a /usr/bin/python3 \\
        Testing/Benchmarks/measure_normal_maps.py [--scans FILE ...]

Learns a surface from each scan, makes it anew with few points, and computes its normal map from the surface of many
points. Draws all by physically based rendering (vtkProperty), with one light, from directions that are spread evenly.
Prints a row for each scan and number of points:

    plain   peak signal-to-noise ratio of the surface of few points with its normals, without normal map [dB]
    mapped  the same with the normal map [dB]
    inside  both ratios of the pixels that show the object in both pictures: without its outline [dB]
    side    width of the normal map [texels]
    seconds to compute the normal map

Ratios are of the pixels that show the object in either picture. The reference is the surface of many points.
"""
import argparse
import os
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkJPEGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTexture, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401

from conformalsom import (
    vtkAdaptiveSphere, vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkSurfaceNormalMap)
from conformalsom.command.scan_files import scan_reader
from conformalsom.command.textures import image_of
from helpers import builtin_figure

FIGURES = ("bear", "dancer")
POINTS = (2000, 5000, 20000)
SIZE = 512
BACKGROUND = (0.0, 0.0, 255.0)


def directions(count):
    """Unit vectors spread evenly over the sphere, on a Fibonacci spiral."""
    y = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = np.pi * (3.0 - np.sqrt(5.0)) * np.arange(count)
    radius = np.sqrt(1.0 - y * y)
    return np.column_stack([radius * np.sin(angle), y, radius * np.cos(angle)])


class Studio:
    """Draws surfaces from several directions."""

    def __init__(self, bounds):
        box = np.array(bounds).reshape(3, 2)
        self.middle, self.radius = box.mean(axis=1), 0.5 * np.linalg.norm(box[:, 1] - box[:, 0])
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(8)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.renderer.SetBackground(*(channel / 255.0 for channel in BACKGROUND))
        self.light = vtkLight()
        self.light.SetLightTypeToCameraLight()
        self.light.SetPosition(0.6, 0.8, 1.0)
        self.light.SetFocalPoint(0.0, 0.0, 0.0)
        self.light.SetIntensity(1.5)
        self.renderer.AddLight(self.light)

    def pictures(self, surface, views, normal_map=None):
        """Pictures of a surface as arrays of numbers in [0, 255]."""
        actor, mapper = vtkActor(), vtkPolyDataMapper()
        mapper.SetInputData(surface)
        mapper.ScalarVisibilityOff()
        actor.SetMapper(mapper)
        look = actor.GetProperty()
        look.SetInterpolationToPBR()
        look.SetColor(0.9, 0.9, 0.9)
        look.SetRoughness(0.5)
        if normal_map is not None:
            texture = vtkTexture()
            texture.SetInputData(normal_map)
            texture.InterpolateOn()
            texture.MipmapOn()
            look.SetNormalTexture(texture)
        self.renderer.AddActor(actor)
        drawn = [self.picture(view) for view in views]
        self.renderer.RemoveActor(actor)
        return drawn

    def picture(self, view):
        """One picture from a direction."""
        camera = self.renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(self.radius)
        camera.SetFocalPoint(*self.middle)
        camera.SetPosition(*(self.middle + 3.0 * self.radius * view))
        camera.SetViewUp(*((0.0, 1.0, 0.0) if abs(view[1]) < 0.9 else (0.0, 0.0, 1.0)))
        self.renderer.ResetCameraClippingRange()
        self.window.Render()
        grabbed = vtkWindowToImageFilter()
        grabbed.SetInput(self.window)
        grabbed.ReadFrontBufferOff()
        grabbed.Update()
        pixels = vtk_to_numpy(grabbed.GetOutput().GetPointData().GetScalars())
        return pixels.reshape(SIZE, SIZE, -1).astype(float)


def ratio(pictures, references, combine):
    """Peak signal-to-noise ratio [dB] of the pixels that show the object in either picture (np.logical_or) or in both."""
    squares = []
    for picture, reference in zip(pictures, references):
        shown = combine((picture != BACKGROUND).any(axis=2), (reference != BACKGROUND).any(axis=2))
        squares.append(((picture - reference)[shown] ** 2).ravel())
    return 10.0 * np.log10(255.0**2 / max(np.concatenate(squares).mean(), 1e-12))


def few_points(network, number):
    """The smooth surface with a number of points, cut along the seams of an octahedral image."""
    sphere, surface, laid = vtkAdaptiveSphere(), vtkCurvedSeamlessSurface(), vtkSphericalTextureMap()
    sphere.SetInputData(network)
    sphere.SetNumberOfPoints(number)
    surface.SetInputData(network)
    surface.SetSphereConnection(sphere.GetOutputPort())
    laid.SetInputConnection(surface.GetOutputPort())
    laid.SetProjectionToOctahedral()
    laid.SetAreaBalance(0.5)
    laid.SetMargin(0.01)
    laid.SplitSeamOn()
    laid.Update()
    return laid.GetOutput()


def measure(name, cloud, numbers, views, side, folder):
    """Print the rows of a scan."""
    network, smooth = vtkConformalSOM(), vtkCurvedSeamlessSurface()
    network.SetInputData(cloud)
    smooth.SetInputConnection(network.GetOutputPort())
    smooth.Update()
    detail = smooth.GetOutput()
    studio = Studio(detail.GetBounds())
    references = studio.pictures(detail, views)
    for number in numbers:
        surface = few_points(network.GetOutput(), number)
        baked = vtkSurfaceNormalMap()
        baked.SetInputData(surface)
        baked.SetDetailData(detail)
        baked.SetImageSize(side, side)
        start = time.perf_counter()
        baked.Update()
        seconds = time.perf_counter() - start
        plain = studio.pictures(surface, views)
        mapped = studio.pictures(baked.GetSurface(), views, baked.GetOutput())
        ratios = [ratio(pictures, references, combine) for combine in (np.logical_or, np.logical_and)
                  for pictures in (plain, mapped)]
        print(f"| {name} | {detail.GetNumberOfPoints():,} | {surface.GetNumberOfPoints():,} | {side} | "
              + " | ".join(f"{value:.1f}" for value in ratios) + f" | {seconds:.2f} |", flush=True)
        if folder:
            middle = len(views) // 2
            save(os.path.join(folder, f"{name}_{number}.jpg"), references[middle], plain[middle], mapped[middle])


def save(path, *drawn):
    """Write pictures side by side, on white."""
    pictures = [np.where((picture == BACKGROUND).all(axis=2)[:, :, None], 255.0, picture) for picture in drawn]
    writer = vtkJPEGWriter()
    writer.SetInputData(image_of(np.ascontiguousarray(np.hstack(pictures).astype(np.uint8))))
    writer.SetFileName(path)
    writer.Write()


def main():
    """Measure all scans."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scans", nargs="*", default=[], metavar="FILE", help="scans besides the built-in objects")
    parser.add_argument("--points", nargs="+", type=int, default=POINTS, metavar="N")
    parser.add_argument("--views", type=int, default=50, metavar="N")
    parser.add_argument("--side", type=int, default=1024, metavar="N", help="width of the normal map in texels")
    parser.add_argument("--pictures", metavar="FOLDER", help="write a view from the side for each row")
    options = parser.parse_args()
    print("| scan | many | points | side | plain | mapped | plain inside | mapped inside | seconds |\n"
          "| --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    views = directions(options.views)
    for name in FIGURES:
        measure(name, builtin_figure.figure_cloud(figure=getattr(builtin_figure, name)), options.points, views, options.side, options.pictures)
    for path in options.scans:
        reader = scan_reader(path)
        reader.Update()
        measure(os.path.splitext(os.path.basename(path))[0], reader.GetOutputDataObject(0), options.points, views,
                options.side, options.pictures)


if __name__ == "__main__":
    main()
