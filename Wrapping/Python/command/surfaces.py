"""From a scan to a painted surface: points -> learned mesh -> smooth surface -> picture on it."""
import typing

from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from conformalsom import (
    vtkAdaptiveSphere, vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkSurfacePageWriter,
    vtkTexturedSurfaceWriter)

from . import labels, outputs, pictures, report, scan_colors, scan_files, textures
from .plan import Paths


AREA_BALANCE = 0.5  # of pictures; see vtkSphericalTextureMap
MINIMUM_POINTS = 500  # of vtkAdaptiveSphere
MAXIMUM_ROUNDS = 5  # to reach a number of points
ROUNDS_END = 0.01  # share of the number by which it may differ


class Task(typing.NamedTuple):
    """A scan, what to write for it, and what to name files after that are not finished."""
    scan: str
    paths: Paths
    token: str


def learned_mesh(scan, options):
    """The filter that learns the mesh."""
    network = vtkConformalSOM()
    network.SetInputConnection(scan.GetOutputPort())
    getattr(network, "SetMeshTypeTo" + options.mesh_type.capitalize())()
    if options.neurons is not None:
        network.SetNumberOfNeurons(options.neurons)
    return network


def texture_map(surface, options, all_around):
    """The filter that lays a texture on a surface, in its middle what the viewer sees first.

    One that shows the whole surface goes all around it, a picture lies on one side.
    """
    painted = vtkSphericalTextureMap()
    painted.SetInputConnection(surface.GetOutputPort())
    painted.SetViewDirection(options.view)
    painted.SetViewUp(options.up)
    painted.SetAreaBalance(AREA_BALANCE if options.texture_map == "balanced" else 0.0)
    if all_around:
        painted.SetProjectionToOctahedral()
        painted.SetMargin(0.01)
    return painted


def smooth_surface(mesh, number, steps):
    """The filter that makes the smooth surface, after it has run; with a number of points unless that is None."""
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(mesh.GetOutputPort())
    if number is not None:
        sphere = vtkAdaptiveSphere()
        sphere.SetInputConnection(mesh.GetOutputPort())
        sphere.SetNumberOfPoints(number)
        steps.run("Place the points", sphere)
        surface.SetSphereConnection(sphere.GetOutputPort())
    steps.run("Build the smooth surface", surface)
    return surface


def cut_surface(result, options, steps, all_around):
    """The filter that cuts a surface along its picture, after it has run."""
    cut = texture_map(result, options, all_around)
    cut.SplitSeamOn()  # for programs that draw each triangle as it is
    steps.run("Cut along the picture", cut)
    return cut


def cut_to_number(mesh, scan, cut, options, steps, all_around):
    """A cut surface with the number of points of --points, where points on both sides of a cut count twice."""
    number, surface = options.points, None
    for _ in range(MAXIMUM_ROUNDS):
        found = cut.GetOutput().GetNumberOfPoints()
        if abs(found - options.points) <= ROUNDS_END * options.points:
            break
        number = max(number + options.points - found, MINIMUM_POINTS)
        surface = smooth_surface(mesh, number, steps)
        cut = cut_surface(surface, options, steps, all_around)
    if surface is not None and (options.measure or options.report):
        cut = cut_surface(report.measured(steps, "surface", surface, scan), options, steps, all_around)
    return cut


def expect_number(surface, options, steps):
    """Warn if a surface does not have the number of points of --points."""
    found = surface.GetOutputDataObject(0).GetNumberOfPoints()
    if options.points is not None and abs(found - options.points) > 0.02 * options.points:
        steps.warnings.append(f"--points: the surface has {found:,} points instead of {options.points:,}")
        steps.ended("Points", steps.warnings[-1:])


def one_color():
    """A source of a picture of one pixel, for a format that wants one where there is none."""
    source = vtkTrivialProducer()
    source.SetOutput(textures.one_pixel())
    return source


def make_surface(task, texture, options, steps):
    """Learn a surface from a scan and write it; returns figures for a report, and the scan, mesh and surface.

    The texture is a source of an image, or None: then the scan's own colors are used if it has some.
    """
    scan_path, paths = task.scan, task.paths
    scan = scan_files.scan_reader(scan_path)
    steps.take_outside_messages()
    steps.run("Read the scan", scan)
    broken = [text for text in steps.take_outside_messages() if text.startswith("Error")]
    if broken:  # so VTK's reader of .vtk tells of a file that ends early
        raise ValueError(f"{scan_path}: {broken[0]}")
    points = scan.GetOutputDataObject(0)
    if points.GetNumberOfPoints() == 0:
        raise ValueError(f"{scan_path}: no points found")
    colors = scan_colors.colors_of(points) if texture is None else None
    meters = labels.meters_of(points, options.unit, "m", steps)

    network = learned_mesh(scan, options)
    steps.run("Learn the mesh", network)
    surface = smooth_surface(network, options.points, steps)
    painted = texture_map(surface, options, all_around=colors is not None)
    steps.run("Lay the texture", painted)

    mesh, result = network, painted
    if options.measure or options.report:
        mesh = report.measured(steps, "mesh", network, scan)
        result = report.measured(steps, "surface", painted, scan)

    cut = result
    if texture is not None or colors is not None:
        cut = cut_surface(result, options, steps, all_around=colors is not None)
        if options.points is not None:
            cut = cut_to_number(network, scan, cut, options, steps, all_around=colors is not None)
        expect_number(cut, options, steps)
    if colors is not None:
        texture = scan_colors.baked(cut, points, colors, options.texture_size)
        steps.run("Bake the scan's colors", texture, lambda: scan_colors.bake(texture, options.texture_size))

    picture = texture or one_color()
    written = []
    for path in paths.surfaces:
        writer = outputs.writer_of(path, painted=texture is not None)
        if isinstance(writer, vtkTexturedSurfaceWriter):
            writer.SetInputConnection(0, cut.GetOutputPort())
            writer.SetInputConnection(1, picture.GetOutputPort())
            writer.SetMetersPerUnit(meters)
            if options.compress and outputs.extension_of(path) == ".glb" and not outputs.compress(writer):
                steps.warnings.append("--compress: this build lacks the library meshoptimizer, so that the files are "
                                      "only quantized")
                steps.ended("Compress", steps.warnings[-1:])
        elif isinstance(writer, vtkSurfacePageWriter):
            writer.SetInputConnection(0, cut.GetOutputPort())
            if texture is not None:
                writer.SetInputConnection(1, texture.GetOutputPort())
            writer.SetViewDirection(options.view)
            writer.SetViewUp(options.up)
        else:
            writer.SetInputConnection(result.GetOutputPort())
        outputs.write(steps, writer, path, task.token, options.overwrite, shared=written)
        written += outputs.files_of(path)[1:]
    learned, smoothed, laid = (stage.GetOutputDataObject(0) for stage in (mesh, result, cut))
    if paths.picture:
        image = texture.GetOutputDataObject(0) if texture else None
        drawn = pictures.draw_stages(
            points, learned, smoothed, laid, image, colors, options.view, options.up)
        writer = pictures.picture_writer(paths.picture)
        writer.SetInputConnection(drawn.GetOutputPort())
        outputs.write(steps, writer, paths.picture, task.token, options.overwrite)
    entry = {
        "Scan": scan_path,
        "Files": paths.all(),
        "NumberOfScanPoints": points.GetNumberOfPoints(),
        "Mesh": report.figures_of(learned),
        "Surface": report.figures_of(smoothed),
        "Seconds": steps.seconds,
        "Warnings": steps.warnings,
    }
    return entry, (points, learned, smoothed)
