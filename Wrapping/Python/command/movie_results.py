"""Results of a movie: the stack of maps, the table of measures, surfaces and page."""
import csv
import math
import os
import typing

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData

from conformalsom import vtkBodyMapImage, vtkSphericalTimeSeries, vtkSurfaceLayers, vtkTIFFStackWriter

from . import movie_frames, movie_page, outputs, volumes

PROJECTIONS = {"equirectangular": "Equirectangular", "lambert": "LambertAzimuthal", "mollweide": "Mollweide",
               "peirce": "PeirceQuincuncial", "mercator": "Mercator"}
SQUARE = ("peirce", "mercator")
COLUMNS = {"mean_normal_speed": "MeanNormalSpeed",
           "mean_tangential_speed": "MeanTangentialSpeed", "mean_area_rate": "MeanAreaRate",
           "mean_shear_rate": "MeanShearRate", "relative_displacement": "RelativeDisplacement",
           "folds": "NumberOfFolds"}  # of the table, and their names in that of vtkSphericalTimeSeries
LARGEST_FILE = 2**32 - 2**21
DEFAULT_ARRAY = "AreaRate"
MOTION = ("AreaRate", "ShearRate", "NormalVelocity", "TangentialVelocity", "Velocity")
BRIGHTNESS_WEIGHT = 1.0  # as that of the shape, see vtkSphericalTimeSeries


def make(task, options, _, steps):
    """Make all results; returns an entry of a report, and what to print."""
    note_disorder(options.frames, steps)
    frames = options.all_frames
    surfaces = movie_frames.Surfaces(options, steps)
    found = surfaces.of_all(frames)
    usable = [k for k, surface in enumerate(found) if surface is not None]
    if not usable:
        raise ValueError(f"{task.scan}: no frame can be used")
    reference = usable[0] if options.reference is None else options.reference
    if reference not in usable:
        raise ValueError(f"{task.scan}: frame {reference}, {frames[reference].name}, cannot be used as reference; "
                         "choose another by --reference")
    if not options.has_volumes:
        expect_array(found[reference], frames[reference], options.array)
    found[reference] = movie_frames.with_long_axis(found[reference], steps)
    series = Series(found, reference, options, steps)
    maps = (LayerMaps if options.has_volumes else ArrayMaps)(options, series, steps)
    for k in usable:
        if series.state(k) != "skipped":
            maps.add(k, frames[k])
    kept = sorted(maps.surfaces)
    unit = options.unit or surfaces.unit
    if len(kept) == 1 and not options.has_volumes:
        steps.note("Maps", "there is one frame only, so that all rates are 0")
    write_all(task, options, steps, maps, series, kept, unit)
    points = sum(maps.surfaces[k].GetNumberOfPoints() for k in kept)
    entry = {"Scan": task.scan, "Surface": {"NumberOfPoints": points}, "Seconds": steps.seconds,
             "Warnings": steps.warnings, "Skipped": len(frames) - len(maps.surfaces)}
    shape = maps.pixels.shape
    return entry, (f"wrote {task.scan}: {len(maps.surfaces)} of {shape[0]} frames, {shape[1]} "
                   f"{'layers' if options.has_volumes else 'layer'}, {shape[4]} "
                   f"{'channel' if shape[4] == 1 else 'channels'}, {shape[3]} x {shape[2]} pixels\n")


def note_disorder(paths, steps):
    """Show if files may not be in the order of time, as where a shell sorts their names."""
    disorder = movie_frames.disorder_of(paths)
    if disorder:
        first, second = disorder
        steps.note("Order", f"{first} is before {second}: the numbers of the frames do not ascend; number files as in "
                            "t01, t02, t10, or list them in the order of time")


def expect_array(surface, frame, name):
    """Raise ValueError if a surface has no point array of this name, and will have none."""
    data = surface.GetPointData()
    if name and name not in MOTION and not data.HasArray(name):
        known = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())]
        raise ValueError(f"{frame.path}: no point array {name}; there are {', '.join([*filter(None, known), *MOTION])}")


class Series:
    """The surfaces of all frames with maps that correspond. An empty surface stands for a skipped frame."""

    def __init__(self, surfaces, reference, options, steps):
        self.reference, self.interval, self.steps = reference, options.interval, steps
        self.filter = vtkSphericalTimeSeries()
        for surface in surfaces:
            self.filter.AddInputDataObject(vtkPolyData() if surface is None else surface)
        self.filter.SetReferenceStep(reference)
        self.filter.SetTimeInterval(self.interval)
        if options.has_volumes:
            self.filter.AddFeature(movie_frames.BRIGHTNESS, BRIGHTNESS_WEIGHT)
        steps.run("Make the maps correspond", self.filter, lambda: self.filter.UpdateTimeStep(0.0),
                  known=lambda text: text.endswith("is skipped and interpolated: the surface is empty"))

    def surface(self, k):
        """A copy of the surface of a frame."""
        self.filter.UpdateTimeStep(k * self.interval)
        surface = vtkPolyData()
        surface.ShallowCopy(self.filter.GetOutput())
        return surface

    def value(self, k, column):
        """A number of the table of time steps."""
        return self.filter.GetTable().GetValueByName(k, column).ToDouble()

    def state(self, k):
        """Whether a frame is the reference, was registered or was skipped."""
        return self.filter.GetTable().GetValueByName(k, "State").ToString()


class Maps:
    """Maps of all frames: frames x layers x rows x columns x channels, first row in the south."""

    def __init__(self, options, series, steps):
        self.options, self.series, self.steps = options, series, steps
        self.size = options.size, options.size if options.projection in SQUARE else max(options.size // 2, 1)
        self.pixels: typing.Any = None
        self.spacing = 1.0, 1.0, 1.0
        self.surfaces: typing.Dict[int, vtkPolyData] = {}  # by the number of the frame
        # Of the page, by names of arrays: numbers of frames, values, and pixels outside.
        self.pictures: typing.Dict[str, typing.List[typing.Tuple[int, typing.Any, typing.Any]]] = {}

    def add(self, k, frame):
        """Map a frame, which is skipped if that fails."""
        try:
            self.map(k, frame)
        except (movie_frames.StepFailed, movie_frames.Skipped, ValueError, OSError) as error:
            if k == self.series.reference:
                raise
            self.steps.note(frame.name, f"the frame is skipped: {error}")

    def map(self, k, frame):
        """Map a frame by put(), and keep its surface."""
        raise NotImplementedError

    def allocate(self, layers, channels, kind):
        """Make room for all maps when the first one is known."""
        shape = len(self.options.all_frames), layers, self.size[1], self.size[0], channels
        kind = kind if kind in (np.uint8, np.uint16) else np.float32
        if math.prod(shape) * np.dtype(kind).itemsize > LARGEST_FILE:
            raise ValueError(f"{self.options.output}: the maps of {shape[0]} frames with {layers} layers would exceed "
                             "4 GB; use a smaller --size, a smaller range of --depths, or fewer frames")
        self.pixels = np.zeros(shape, kind)

    def put(self, k, values):
        """Keep the map of a frame: layers x rows x columns x channels."""
        if self.pixels is None:
            self.allocate(values.shape[0], values.shape[3], values.dtype.type)
        pixels: typing.Any = self.pixels
        if values.shape != pixels.shape[1:]:
            raise movie_frames.Skipped(f"its map has {values.shape[3]} channels instead of {pixels.shape[4]}")
        pixels[k] = np.rint(values) if np.issubdtype(pixels.dtype, np.integer) else values

    def set_projection(self, filter_, projection, width, height):
        """Set the projection and the size of a filter's maps."""
        getattr(filter_, "SetProjectionTo" + PROJECTIONS[projection])()
        filter_.SetImageSize(width, height)

    def keep_picture(self, name, k, values, outside):
        """Keep a picture for the page, rows from the south."""
        self.pictures.setdefault(name, []).append((k, values, outside))


class LayerMaps(Maps):
    """Maps of the brightness of volumes in layers."""

    def __init__(self, options, series, steps):
        super().__init__(options, series, steps)
        self.depths, self.number = options.depths, 17

    def map(self, k, frame):
        """Sample the layers of all channels."""
        surface = self.series.surface(k)
        volume, _ = volumes.read(frame.path, self.steps, f"Read {frame.name} again", frame.time)
        scalars = volume.GetPointData().GetScalars()
        if self.depths and self.pixels is None:
            voxel = min(volume.GetSpacing())
            self.number = max(2, min(round(2.0 * (self.depths[1] - self.depths[0]) / voxel) + 1, 1000))
            self.allocate(self.number, scalars.GetNumberOfComponents(), vtk_to_numpy(scalars).dtype.type)
        stacks = []
        for channel in range(scalars.GetNumberOfComponents()):
            layers = self.layers(surface, volume, channel, self.options.projection, *self.size)
            self.steps.run(f"Sample layers of {frame.name}", layers)
            stack = layers.GetOutputDataObject(1)
            stacks.append(vtk_to_numpy(stack.GetPointData().GetScalars()).reshape(stack.GetDimensions()[::-1]))
            if channel == self.options.channel:
                shown = layers
        if self.depths is None:
            depths = vtk_to_numpy(shown.GetOutput().GetFieldData().GetArray("LayerDepths"))
            self.depths = float(depths[0]), float(depths[-1])
        values = np.stack(stacks, axis=-1)
        self.put(k, values if self.pixels is not None else values.astype(vtk_to_numpy(scalars).dtype, copy=False))
        if k == self.series.reference:
            self.spacing = shown.GetOutputDataObject(1).GetSpacing()
        self.surfaces[k] = shown.GetOutput()
        if self.options.page:
            self.show(k, frame, surface, volume, shown)

    def layers(self, surface, volume, channel, projection, width, height):
        """The filter that samples a channel of a volume."""
        layers = vtkSurfaceLayers()
        layers.SetInputData(surface)
        layers.SetVolumeData(volume)
        layers.SetComponent(channel)
        if self.depths:
            layers.SetDepthRange(self.depths)
        layers.SetNumberOfLayers(self.number)
        self.set_projection(layers, projection, width, height)
        return layers

    def show(self, k, frame, surface, volume, shown):
        """Keep what the page shows: the brightest layer in longitude and latitude."""
        if self.options.projection != "equirectangular" or self.size[0] > 2 * movie_page.WIDTH:
            shown = self.layers(surface, volume, self.options.channel, "equirectangular", movie_page.WIDTH,
                                movie_page.WIDTH // 2)
            self.steps.run(f"Draw {frame.name} for the page", shown)
        arrays = shown.GetOutputDataObject(2).GetPointData()
        shape = shown.GetOutputDataObject(2).GetDimensions()[1::-1]
        self.keep_picture("LayerMaximum", k, vtk_to_numpy(arrays.GetArray("LayerMaximum")).reshape(shape),
                          vtk_to_numpy(arrays.GetArray("OutsideSurface")).reshape(shape) > 0)


class ArrayMaps(Maps):
    """Maps of a point array of surfaces."""

    def map(self, k, frame):
        """Draw the array of a frame."""
        surface = self.series.surface(k)
        name = self.options.array or DEFAULT_ARRAY
        expect_array(surface, frame, name)
        image = self.drawn(surface, name, self.options.projection, *self.size, f"Draw the map of {frame.name}")
        values, replaced = finite(vtk_to_numpy(image.GetPointData().GetArray(name)))
        if replaced:
            self.steps.note(frame.name, f"{replaced} values of {name} that are not finite are 0 in the map")
        self.put(k, values.reshape(1, self.size[1], self.size[0], -1))
        if k == self.series.reference:
            radius = math.sqrt(movie_frames.area_and_volume(surface)[0] / (4.0 * math.pi))
            scale = math.radians(radius) if self.options.projection == "equirectangular" else radius
            self.spacing = (*(scale * abs(length) for length in image.GetSpacing()[:2]), 1.0)
        self.surfaces[k] = surface
        if self.options.page:
            self.show(k, frame, surface, name)

    def drawn(self, surface, name, projection, width, height, label):
        """The image of a point array."""
        chart = vtkBodyMapImage()
        chart.SetInputData(surface)
        chart.SetArrayName(name)
        self.set_projection(chart, projection, width, height)
        chart.SetGraticuleSpacing(0.0)
        self.steps.run(label, chart)
        return chart.GetOutput()

    def show(self, k, frame, surface, name):
        """Keep what the page shows: the array, and rates of area and shear."""
        for array in dict.fromkeys((name, "AreaRate", "ShearRate", "NormalVelocity")):
            image = self.drawn(surface, array, "equirectangular", movie_page.WIDTH, movie_page.WIDTH // 2,
                               f"Draw {frame.name} for the page")
            arrays, shape = image.GetPointData(), (movie_page.WIDTH // 2, movie_page.WIDTH)
            values = finite(vtk_to_numpy(arrays.GetArray(array)))[0].reshape(*shape, -1)
            self.keep_picture(array, k, values if values.shape[2] == 3 and values.dtype == np.uint8
                              else values[..., 0] if values.shape[2] == 1 else np.linalg.norm(values.astype(float), axis=2),
                              vtk_to_numpy(arrays.GetArray("OutsideSurface")).reshape(shape) > 0)


def finite(values):
    """Values as files of maps have them, whole numbers of 8 and 16 bits or floats: 0 where these are not finite; their number."""
    if values.dtype in (np.uint8, np.uint16):
        return values, 0
    with np.errstate(over="ignore"):
        floats = values.astype(np.float32)
    broken = ~np.isfinite(floats)
    return np.where(broken, np.float32(0.0), floats), np.count_nonzero(broken)


def stack_of(pixels, spacing):
    """An image of all slices of all frames."""
    frames, layers, rows, columns, channels = pixels.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, layers * frames)
    image.SetSpacing(spacing)
    scalars = numpy_to_vtk(pixels.reshape(-1, channels), deep=False)
    scalars.SetName("Intensity")
    image.GetPointData().SetScalars(scalars)
    return image


def write_all(task, options, steps, maps, series, kept, unit):
    """Write all files, the stack of maps last."""
    for k in kept if options.surfaces else []:
        writer = outputs.writer_of(options.surface_files[k], painted=False)
        writer.SetInputData(maps.surfaces[k])
        outputs.write(steps, writer, options.surface_files[k], task.token, options.overwrite)
    if options.table:
        write_text(options.table, task, options, lambda file: csv.writer(file, lineterminator="\n").writerows(
            rows_of(options, maps, kept)))
    if options.page:
        text = movie_page.page_of(maps, kept, unit, options, steps)
        write_text(options.page, task, options, lambda file: file.write(text))
    writer = vtkTIFFStackWriter()
    writer.SetInputData(stack_of(maps.pixels, maps.spacing))
    writer.SetNumberOfFrames(maps.pixels.shape[0])
    writer.SetFrameInterval(options.interval)
    writer.SetYAxisToUp()
    if unit:
        writer.SetUnit(unit)
    outputs.write(steps, writer, options.output, task.token, options.overwrite)
    if options.overwrite:
        remove_earlier([path for k, path in enumerate(options.surface_files) if k not in kept], steps)


def remove_earlier(paths, steps):
    """Remove surfaces that an earlier call wrote for frames that are skipped now. A note names those that remain."""
    for path in paths:
        try:
            os.unlink(path)
        except FileNotFoundError:
            pass
        except OSError as error:
            steps.note("Remove earlier surfaces", f"{path}: {error.strerror}")


def write_text(path, task, options, write):
    """Write a text file, whole or not at all."""
    with outputs.whole(path, task.token, files=[path], overwrite=options.overwrite) as part:
        with outputs.named_errors(path), open(part, "w", encoding="utf-8", newline="") as file:
            write(file)


def rows_of(options, maps, kept):
    """Rows of the table of measures; skipped frames have none."""
    yield ["frame", "file", "time", "state", "area", "volume", *COLUMNS]
    for k, frame in enumerate(options.all_frames):
        start = [k, os.path.basename(frame.path), repr(k * options.interval)]
        if k not in kept:
            yield [*start, "skipped", "", "", *("" for _ in COLUMNS)]
            continue
        values = [*movie_frames.area_and_volume(maps.surfaces[k]),
                  *(maps.series.value(k, column) for column in COLUMNS.values())]
        yield [*start, maps.series.state(k), *map(repr, values[:-1]), int(values[-1])]
