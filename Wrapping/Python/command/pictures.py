"""Draws the stages of a run side by side."""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkFiltersGeneral import vtkVertexGlyphFilter
from vtkmodules.vtkFiltersPoints import vtkPCANormalEstimation
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOImage import vtkJPEGWriter, vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkCamera, vtkLightKit, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkTextActor,
    vtkTexture, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (draws the labels)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (draws everything)

from .outputs import extension_of

CLAY, INK, SLATE = (0.80, 0.62, 0.46), (0.20, 0.24, 0.30), (0.28, 0.42, 0.60)
HAZE = (0.93, 0.94, 0.96)  # what lies behind the dots of a cloud
FINER = 2  # pixels drawn for each pixel kept, along each axis


def actor_of(data):
    """An actor that shows a data set in one color, whatever arrays it has."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputDataObject(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(CLAY)
    actor.GetProperty().BackfaceCullingOn()  # surfaces are closed: none of their inside is seen
    actor.GetProperty().SetSpecular(0.15)
    actor.GetProperty().SetSpecularPower(20)
    return actor


def cloud_actor(points, view, colors=SLATE):
    """The points as dots, shaded as the surface they lie on; far ones fade into the background.

    In one color, or each in its own of an array of #points by 3, all in [0, 1].
    """
    normals = vtkPCANormalEstimation()
    normals.SetInputData(points)
    normals.SetSampleSize(20)
    normals.SetNormalOrientationToPoint()
    normals.SetOrientationPoint(points.GetCenter() + 100.0 * points.GetLength() * np.array(view))
    dots = vtkVertexGlyphFilter()
    dots.SetInputConnection(normals.GetOutputPort())
    dots.Update()
    depth = vtk_to_numpy(points.GetPoints().GetData()) @ np.array(view)
    nearness = np.clip(2.0 * (depth - depth.min()) / max(np.ptp(depth), 1e-300), 0.2, 1.0)
    colors = nearness[:, None] * colors + np.outer(1.0 - nearness, HAZE)
    dots.GetOutput().GetPointData().SetScalars(
        numpy_to_vtk(np.rint(255 * colors).astype(np.uint8), deep=True))
    actor = actor_of(dots.GetOutput())
    actor.GetMapper().ScalarVisibilityOn()
    actor.GetProperty().SetPointSize(1.25 * FINER)
    return actor


def mesh_actor(mesh):
    """The triangles with their edges."""
    actor = actor_of(mesh)
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetColor(0.95, 0.92, 0.87)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.42, 0.46, 0.52)
    actor.GetProperty().SetLineWidth(0.4 * FINER)
    return actor


def textured_actor(surface, image):
    """The surface with the image on it."""
    texture = vtkTexture()
    texture.SetInputData(image)
    texture.InterpolateOn()
    texture.MipmapOn()
    texture.SetWrap(vtkTexture.ClampToEdge)
    actor = actor_of(surface)
    actor.GetProperty().SetColor(1.0, 1.0, 1.0)
    actor.SetTexture(texture)
    return actor


def camera_on(points, view, up, aspect, azimuth=18, elevation=8):
    """A camera that sees the points from the direction view, a little from the side and above.

    They fill a panel whose width is aspect times its height, but for a margin.
    """
    camera = vtkCamera()
    camera.SetPosition(view)
    camera.SetViewUp(up)
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    camera.OrthogonalizeViewUp()
    upward, toward = np.array(camera.GetViewUp()), np.array(camera.GetDirectionOfProjection()) * -1
    axes = np.stack([np.cross(upward, toward), upward, toward])
    seen = vtk_to_numpy(points.GetPoints().GetData()) @ axes.T
    low, high = seen.min(axis=0), seen.max(axis=0)
    half, center = (high - low) / 2.0, axes.T @ ((low + high) / 2.0)
    camera.ParallelProjectionOn()
    camera.SetParallelScale(max(half[1] / 0.8, half[0] / (0.9 * aspect)))
    distance = 10.0 * half.max()
    camera.SetFocalPoint(center)
    camera.SetPosition(center + distance * toward)
    camera.SetClippingRange(distance - 2.0 * half.max(), distance + 2.0 * half.max())
    return camera


def scene(actor, label, camera):
    """A renderer that shows the actor by a camera, above a label."""
    renderer = vtkRenderer()
    renderer.SetActiveCamera(camera)
    renderer.SetBackground(0.86, 0.88, 0.91)
    renderer.SetBackground2(0.98, 0.98, 0.98)
    renderer.GradientBackgroundOn()
    renderer.AddActor(actor)
    lights = vtkLightKit()
    lights.SetKeyLightIntensity(0.9)
    lights.SetKeyToFillRatio(2.0)
    lights.AddLightsToRenderer(renderer)
    text = vtkTextActor()
    text.SetInput(label)
    text.GetTextProperty().SetFontSize(15 * FINER)
    text.GetTextProperty().SetColor(INK)
    text.GetTextProperty().SetJustificationToCentered()
    text.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    text.SetPosition(0.5, 0.03)
    renderer.AddActor(text)
    return renderer


def image_scene(image, label, aspect):
    """A renderer that shows an image by itself above a label, in a panel of the given aspect."""
    columns, rows, _ = image.GetDimensions()
    plane = vtkPlaneSource()
    plane.SetPoint1(columns / rows - 0.5, -0.5, 0.0)
    plane.Update()
    actor = textured_actor(plane.GetOutput(), image)
    actor.GetProperty().LightingOff()
    camera = camera_on(
        plane.GetOutput(), (0, 0, 1), (0, 1, 0), aspect, azimuth=0, elevation=0)
    return scene(actor, label, camera)


def draw_side_by_side(scenes, width, height, rows=1):
    """Draw the scenes, each by its own camera, from left to right: a filter that puts out the picture.

    They share its width and height, in as many rows as asked for.
    """
    columns = len(scenes) // rows
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(width * FINER, height * FINER)
    for i, renderer in enumerate(scenes):
        column, row = i % columns, rows - 1 - i // columns
        renderer.SetViewport(
            column / columns, row / rows, (column + 1) / columns, (row + 1) / rows)
        window.AddRenderer(renderer)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(grab.GetOutputPort())
    shrink.SetShrinkFactors(FINER, FINER, 1)
    shrink.AveragingOn()
    shrink.Update()
    return shrink


def can_draw():
    """Whether there is a display; from VTK 9.4 none is needed."""
    version = vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()
    return version >= (9, 4) or sys.platform != "linux" or bool(os.environ.get("DISPLAY"))


def picture_writer(path):
    """The writer for a PNG file, or for a JPEG file by the ending .jpg."""
    writer = vtkPNGWriter()
    if extension_of(path) == ".jpg":
        writer = vtkJPEGWriter()
        writer.SetQuality(90)
    writer.SetFileName(path)
    return writer


def write_side_by_side(path, scenes, width, height, rows=1):
    """Draw the scenes into a PNG file, or into a JPEG file by the ending .jpg."""
    drawn, writer = draw_side_by_side(scenes, width, height, rows), picture_writer(path)
    writer.SetInputConnection(drawn.GetOutputPort())
    writer.Write()


def draw_stages(scan, mesh, surface, painted, image, colors, view, up):
    """Draw the cloud, the mesh, the surface and the surface with the image side by side.

    The cloud in its own colors, 0 to 255, if it has some. Without an image the last is left out.
    """
    camera = camera_on(scan, view, up, aspect=0.8)
    cloud = cloud_actor(scan, view, SLATE if colors is None else colors / 255.0)
    scenes = [
        scene(cloud, f"Scan: {scan.GetNumberOfPoints():,} points", camera),
        scene(mesh_actor(mesh), f"Learned mesh: {mesh.GetNumberOfPolys():,} triangles", camera),
        scene(actor_of(surface), f"Smooth surface: {surface.GetNumberOfPolys():,} triangles", camera),
    ]
    if image is not None:
        scenes.append(scene(textured_actor(painted, image), "Painted surface", camera))
    return draw_side_by_side(scenes, 400 * len(scenes), 500)
