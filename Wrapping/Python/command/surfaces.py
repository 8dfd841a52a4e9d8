"""From a scan to a painted surface: points -> learned mesh -> smooth surface -> picture on it."""
import typing

from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

from conformalsom import (
    vtkAdaptiveSphere, vtkConformalSOM, vtkCurvedSeamlessSurface, vtkSphericalTextureMap, vtkSurfacePageWriter,
    vtkTexturedSurfaceWriter)

from . import details, labels, outputs, pictures, report, scan_colors, scan_files, textures
from .plan import Paths
from .steps import StepFailed, message_of


AREA_BALANCE = 0.5  # of pictures; see vtkSphericalTextureMap
MINIMUM_POINTS = 500  # of vtkAdaptiveSphere
MAXIMUM_ROUNDS = 5  # to reach a number of points
OPTIONS = {  # of the command, for properties in messages
    "set Border to CLOSED": "use --closed", "Border OPEN": "--open",
    "set Border to Automatic or Closed, or TrainingMode to Batch and MeshType to Automatic or Adaptive":
    "leave out --open or --mesh-type",
    ", or with another StartingShape or HullMethod of vtkConformalSOM": " (--neurons)",
    ", or with a larger Smoothness of vtkConformalSOM": " (--neurons)",
    "set AreaBalance to 0": "use --texture-map conformal"}
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
    getattr(network, "SetBorderTo" + options.border)()
    return network


def is_open(mesh):
    """Whether a learned mesh has a border."""
    borders = mesh.GetOutputDataObject(0).GetFieldData().GetArray("NumberOfBorders")
    return borders is not None and borders.GetValue(0) > 0


def texture_map(surface, options, projection):
    """The filter that lays a texture on a surface, in its middle what the viewer sees first."""
    painted = vtkSphericalTextureMap()
    painted.SetInputConnection(surface.GetOutputPort())
    getattr(painted, "SetProjectionTo" + projection)()
    if projection == "Square":
        return painted
    painted.SetViewDirection(options.view)
    painted.SetViewUp(options.up)
    painted.SetAreaBalance(AREA_BALANCE if options.texture_map == "balanced" else 0.0)
    if projection == "Octahedral":
        painted.SetMargin(0.01)
    return painted


def projection_for(mesh, shows_all):
    """The projection of a picture, from one side or of the whole surface, closed or with a border."""
    return "Square" if is_open(mesh) else "Octahedral" if shows_all else "Stereographic"


def smooth_surface(mesh, number, steps):
    """The filter that makes the smooth surface, after it has run; with a number of points unless that is None."""
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputConnection(mesh.GetOutputPort())
    if number is not None and is_open(mesh):
        points = mesh.GetOutputDataObject(0).GetNumberOfPoints()
        surface.SetSubdivisions(max(1, round((number / points) ** 0.5)))
    elif number is not None:
        sphere = vtkAdaptiveSphere()
        sphere.SetInputConnection(mesh.GetOutputPort())
        sphere.SetNumberOfPoints(number)
        steps.run("Place the points", sphere)
        surface.SetSphereConnection(sphere.GetOutputPort())
    steps.run("Build the smooth surface", surface)
    return surface


def cut_surface(result, options, steps, projection):
    """The filter that cuts a surface along its picture, after it has run."""
    cut = texture_map(result, options, projection)
    cut.SplitSeamOn()  # for programs that draw each triangle as it is
    steps.run("Cut along the picture", cut)
    return cut


def cut_to_number(cut, number, make):
    """A cut surface with a number of points, where points on both sides of a cut count twice.

    make(n) returns the cut surface made of one with n points; cut is that of make(number).
    """
    asked = number
    for _ in range(MAXIMUM_ROUNDS):
        found = cut.GetOutput().GetNumberOfPoints()
        next_number = max(asked + number - found, MINIMUM_POINTS)
        if abs(found - number) <= ROUNDS_END * number or next_number == asked:
            break
        asked = next_number
        cut = make(asked)
    return cut


def expect_number(surface, options, steps, has_border):
    """Warn if a cut surface does not have the number of points of --points."""
    found = surface.GetOutputDataObject(0).GetNumberOfPoints()
    if options.points is not None and abs(found - options.points) > 0.02 * options.points:
        reason = "all triangles of an open surface are divided equally" if has_border else (
            "the cut of the picture adds points")
        steps.note("--points", f"the surface has {found:,} points instead of {options.points:,}, since {reason}")


def one_color():
    """A source of a picture of one pixel, for a format that wants one where there is none."""
    source = vtkTrivialProducer()
    source.SetOutput(textures.one_pixel())
    return source


class Drawn:
    """Sources of what files show: the closed surface, the cut one, its texture, normal map, and coarser levels."""

    def __init__(self, closed, cut, texture, meters):
        self.closed, self.cut, self.texture = closed, cut, texture
        self.picture = texture or one_color()
        self.meters = meters  # of a unit of length
        self.normal_map, self.levels = None, []


def textured_writer(writer, drawn, path, options, steps):
    """Connect the writer of surfaces with textures."""
    writer.SetInputConnection(0, drawn.cut.GetOutputPort())
    writer.SetInputConnection(1, drawn.picture.GetOutputPort())
    writer.SetMetersPerUnit(drawn.meters)
    if outputs.extension_of(path) != ".glb":
        return
    if drawn.normal_map is not None:
        writer.SetInputConnection(0, drawn.normal_map.GetOutputPort(1))
        writer.SetInputConnection(2, drawn.normal_map.GetOutputPort(0))
    for level in drawn.levels:
        writer.AddInputConnection(3, level.GetOutputPort())
    if options.compress and not outputs.compress(writer):
        steps.note("--compress", "this build lacks the library meshoptimizer, so that the files are only quantized")


def in_millimeters(surface, meters, steps):
    """A source of a surface in millimeters, moved to the origin if it is too far away for the floats of printers."""
    scale = vtkTransform()
    scale.Scale(*3 * [1000.0 * meters])
    data = surface.GetOutputDataObject(0)
    if outputs.shift_of_floats(data) > outputs.FLOAT_SHIFT:
        moved = [-round(coordinate) for coordinate in data.GetCenter()]
        scale.Translate(*moved)
        steps.note("Move the surface", f"files for printers hold floats, so that {moved} is added to its coordinates")
    scaled = vtkTransformPolyDataFilter()
    scaled.SetTransform(scale)
    scaled.SetInputConnection(surface.GetOutputPort())
    return scaled


def write_or_keep_error(failed, steps, writer, path, task, options, shared=()):
    """Write a file, or add the error to failed, since other files can be written nevertheless."""
    try:
        outputs.write(steps, writer, path, task.token, options.overwrite, shared)
    except (ValueError, OSError, StepFailed) as error:
        failed[path] = message_of(error, task.scan)


def write_surfaces(drawn, task, options, steps):
    """Write all files of a surface; returns a dictionary of those that could not be written, with the errors."""
    written, failed, scaled = [], {}, None
    for path in task.paths.surfaces:
        writer = outputs.writer_of(path, painted=drawn.texture is not None)
        if isinstance(writer, vtkTexturedSurfaceWriter):
            textured_writer(writer, drawn, path, options, steps)
        elif isinstance(writer, vtkSurfacePageWriter):
            writer.SetInputConnection(0, drawn.cut.GetOutputPort())
            if drawn.texture is not None:
                writer.SetInputConnection(1, drawn.texture.GetOutputPort())
            writer.SetViewDirection(options.view)
            writer.SetViewUp(options.up)
        elif outputs.extension_of(path) == ".3mf" or options.preset == "print":
            scaled = scaled or in_millimeters(drawn.closed, drawn.meters, steps)
            writer.SetInputConnection(scaled.GetOutputPort())
        else:
            writer.SetInputConnection(drawn.closed.GetOutputPort())
        write_or_keep_error(failed, steps, writer, path, task, options, shared=written)
        if path not in failed:
            written += outputs.files_of(path)[1:]
    return failed


def note_without_effect(network, colors, task, options, steps):
    """Note what the call asks for and the surface does not give."""
    if options.texture_size is not None and colors is None:
        steps.note("--texture-size", "the scan has no colors, so that there is no texture of this size")
    if is_open(network) and any(outputs.extension_of(path) == ".3mf" for path in task.paths.surfaces):
        steps.note("Write .3mf", "the surface has a border, and cannot be printed as a solid; use --closed")


def make_surface(task, texture, options, steps):
    """Learn a surface from a scan and write it; returns figures for a report, and the scan, mesh and surface.

    The texture is a source of an image, or None: then the scan's own colors are used if it has some.
    """
    scan_path, paths = task.scan, task.paths
    _, points = scan_files.read(scan_path, steps)
    if points.GetNumberOfPoints() == 0:
        raise ValueError(f"{scan_path}: no points found")
    bounds = points.GetPoints().GetBounds()
    if bounds[::2] == bounds[1::2]:
        raise ValueError(f"{scan_path}: the points are all equal, so that there is no surface")
    scan_files.note_shift(points, steps)
    scan = vtkTrivialProducer()
    scan.SetOutput(points)
    colors = scan_colors.colors_of(points) if texture is None else None
    meters = labels.meters_of(points, options.unit, "m", steps)

    network = learned_mesh(scan, options)
    steps.run("Learn the mesh", network, reworded=OPTIONS)
    surface = smooth_surface(network, options.points, steps)
    all_around = colors is not None or options.normal_map
    projection = projection_for(network, all_around)
    painted = texture_map(surface, options, projection)
    steps.run("Lay the texture", painted, reworded=OPTIONS)

    mesh, result = network, painted
    if options.measure or options.report:
        mesh = report.measured(steps, "mesh", network, scan)
        result = report.measured(steps, "surface", painted, scan)

    cut, made_anew = result, []
    if texture is not None or all_around:
        def cut_anew(number):
            made_anew.append(smooth_surface(network, number, steps))
            return cut_surface(made_anew[-1], options, steps, projection)
        cut = cut_surface(result, options, steps, projection)
        if options.points is not None:
            cut = cut_to_number(cut, options.points, cut_anew)
        if made_anew and (options.measure or options.report):
            measured = report.measured(steps, "surface", made_anew[-1], scan)
            cut = cut_surface(measured, options, steps, projection)
        expect_number(cut, options, steps, is_open(network))
    if colors is not None:
        texture = scan_colors.baked(cut, points, colors, options.texture_size)
        steps.run("Bake the scan's colors", texture, lambda: scan_colors.bake(texture, options.texture_size))

    drawn = Drawn(result, cut, texture, meters)
    if options.normal_map:
        drawn.normal_map = details.normal_map(cut, smooth_surface(network, None, steps), steps)
    if made_anew and options.levels > 1:  # whose picture the levels share
        painted = texture_map(made_anew[-1], options, projection)
        steps.run("Lay the texture", painted)
    for number in details.numbers_of_points(options):
        def level(count):
            surface = details.with_picture_of(painted, smooth_surface(network, count, steps), steps)
            return cut_surface(surface, options, steps, projection)
        drawn.levels.append(cut_to_number(level(number), number, level))
    note_without_effect(network, colors, task, options, steps)
    failed = write_surfaces(drawn, task, options, steps)
    learned, smoothed, laid = (stage.GetOutputDataObject(0) for stage in (mesh, result, cut))
    if paths.picture:
        image = texture.GetOutputDataObject(0) if texture else None
        stages = pictures.draw_stages(
            points, learned, smoothed, laid, image, colors, options.view, options.up)
        writer = pictures.picture_writer(paths.picture)
        writer.SetInputConnection(stages.GetOutputPort())
        write_or_keep_error(failed, steps, writer, paths.picture, task, options)
    entry = {
        "Scan": scan_path,
        **({"Error": "\n".join(failed.values())} if failed else {}),
        "Files": [path for path in paths.all() if path not in failed],
        "NumberOfScanPoints": points.GetNumberOfPoints(),
        "Mesh": report.figures_of(learned),
        "Surface": report.figures_of(smoothed),
        "Seconds": steps.seconds,
        "Warnings": steps.warnings,
    }
    return entry, (points, learned, smoothed)
