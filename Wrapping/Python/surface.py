"""A closed surface with a map to the sphere, as arrays of NumPy."""
from __future__ import annotations

import numbers
import os
import typing

import numpy as np
import numpy.typing as npt
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer

from conformalsom import exports, pages, pickling
from conformalsom.command import outputs, scan_colors
from conformalsom.command.sizes import frequency_of
from conformalsom.filters import updated
from conformalsom.inputs import (
    ImageLike, MeshLike, Path, PointsLike, VolumeLike, array_of, expect_several, image_of, own_data, point_set,
    volume_of)
from conformalsom.keywords import expect_number, properties_of
from conformalsom.messages import FilterFailed, heard
from conformalsom.reporting import Progress
from conformalsom.running import run, warn
from conformalsom.triangles import triangles_of

Array = npt.NDArray[typing.Any]
AREA_BALANCE = 0.5  # of pictures; see vtkSphericalTextureMap


class Harmonics(typing.NamedTuple):
    """Spherical harmonics of a surface, made by Surface.harmonics().

    coefficients: (L + 1)^2 x 3 numbers for the degree L, in the unit of the coordinates. The rows are sorted
    by degree l from 0 to L, then by order m from -l to l. The columns are x, y and z.
    surface: the surface that is rebuilt from the harmonics. Its dictionary `quality` has "HarmonicPower",
    "ShapeSpectrum" and "RootMeanSquareDistance", see conformalsom.vtkSurfaceHarmonics.
    """
    coefficients: Array
    surface: "Surface"


class Layers(typing.NamedTuple):
    """Maps of a volume in layers below and above a surface, made by Surface.layers().

    maps: layers x rows x columns, the brightness of the volume. The innermost layer and the north are first.
    depths: depth of each layer, in the unit of the volume, negative inside of the surface.
    spacing: width and height of a pixel, on average over the surface.
    surface: the surface with the point arrays "Layers", "LayerMaximum", "LayerMean" and "DepthOfMaximum".
    """
    maps: Array
    depths: Array
    spacing: typing.Tuple[float, float]
    surface: "Surface"


class Surface:
    """A surface that is mapped to the sphere. learn(), conformal_map(), read() and mean_shape() make surfaces.

    mesh: a mesh with the point array "SpherePosition": a vtkPolyData, or any input of conformal_map(). Its arrays are
    copied.

    Arrays of a surface cannot be changed. Methods return a new surface.

    Example:

        surface = conformalsom.learn(points).smooth(64_000)
        surface.points, surface.faces, surface.sphere, surface.quality
    """

    def __init__(self, mesh: MeshLike, *, warnings: typing.Iterable[str] = ()) -> None:
        texts: typing.List[str] = []
        self._data: typing.Any = own_data(mesh, texts)
        self._warnings = unique([*texts, *warnings])
        self._picture: typing.Tuple[typing.Optional[vtkImageData], typing.Dict[str, typing.Any]] = None, {}
        self._picture_file: typing.Optional[str] = None
        self._second: typing.Optional[Surface] = None
        if not isinstance(self._data, vtkPolyData):
            raise TypeError(f"expected a mesh of triangles, not {self._data.GetClassName()}")

    @classmethod
    def of_output(cls, output: vtkPolyData, warnings: typing.Iterable[str]) -> "Surface":
        """Return the output of a filter as a surface, without a copy of its arrays."""
        surface = cls(vtkPolyData(), warnings=warnings)
        surface._data = point_set(output)
        return surface

    @property
    def polydata(self) -> vtkPolyData:
        """The surface as vtkPolyData, an input for any filter of VTK. Do not change it."""
        return self._data

    @property
    def points(self) -> Array:
        """Coordinates of the points: n x 3 numbers, in the unit of the input."""
        return constant(self._data.GetPoints().GetData()) if self._data.GetPoints() else np.empty((0, 3))

    @property
    def faces(self) -> Array:
        """Triangles: m x 3 integers, ids of points from 0, counter-clockwise seen from outside.

        conformal_map(), read(), time_series(), paint(), bake(), register(), posed(), harmonics() and save() keep the
        triangles of the input, also those that are clockwise; smooth() and mean_shape() make new ones.
        """
        triangles = triangles_of(self._data)
        triangles.flags.writeable = False
        return triangles

    @property
    def sphere(self) -> Array:
        """Positions of the points on the unit sphere: n x 3 numbers. Raises KeyError if there is no map."""
        array = self._data.GetPointData().GetArray("SpherePosition")
        if array is None:
            raise KeyError("SpherePosition: the surface has no map to the sphere; make one by conformal_map(surface)")
        return constant(array)

    @property
    def point_data(self) -> typing.Dict[str, Array]:
        """Arrays with a value for each point, by name, such as "SpherePosition", "Normals" and "Supported"."""
        return arrays_of(self._data.GetPointData())

    @property
    def quality(self) -> typing.Dict[str, typing.Any]:
        """Numbers about the whole surface, by name: a number, or an array if there are several.

        The filter's help describes the numbers as field data: help(conformalsom.vtkConformalSOM) describes
        "UncoveredFraction" and others.
        """
        found = arrays_of(self._data.GetFieldData())
        return {name: array.item() if array.size == 1 else array for name, array in found.items()}

    @property
    def warnings(self) -> typing.List[str]:
        """Warnings of all readers and filters that made this surface and its inputs, each text once.

        A text begins with the name of the class.
        """
        return list(self._warnings)

    @property
    def second(self) -> typing.Optional["Surface"]:
        """The second best result of register() if two correspondences are about equally good; otherwise None."""
        return self._second

    @property
    def texture(self) -> typing.Optional[Array]:
        """The picture that paint() laid on the surface: rows x columns x 3 or 4 bytes, first row on top; or None."""
        if self.image is None:
            return None
        columns, rows, _ = self.image.GetDimensions()
        return constant(self.image.GetPointData().GetScalars()).reshape(rows, columns, -1)[::-1]

    @property
    def image(self) -> typing.Optional[vtkImageData]:
        """The picture that paint() laid on the surface as vtkImageData, or None. Do not change it."""
        return self._picture[0]

    @property
    def picture_file(self) -> typing.Optional[str]:
        """Absolute path of the file that paint() read; None if there is no picture or it came from no file."""
        return self._picture_file

    @property
    def placement(self) -> typing.Dict[str, typing.Any]:
        """Keyword arguments of paint() that placed the picture."""
        return dict(self._picture[1])

    def painted_as(self, other: "Surface") -> "Surface":
        """Return this surface with the picture of another surface that has the same map to the sphere."""
        if other.texture is None:
            return self
        painted = self.paint(other.texture, **other.placement)
        painted._picture_file = other.picture_file
        return painted

    @properties_of("vtkCurvedSeamlessSurface", without=("frequency",))
    def smooth(self, number_of_points: typing.Optional[int] = None, *, progress: Progress = False,
               **properties: typing.Any) -> "Surface":
        """Make the surface smooth and dense.

        number_of_points: approximate minimum number of points of the result, in [12, 10,000,002]; default is
        64,002.
        progress: True for a bar, or a function that gets the completed fraction in [0, 1].

        Raises FilterFailed if the surface has no valid map to the sphere. Example:

            smooth = surface.smooth(64_000)
        """
        if number_of_points is not None:
            expect_number("number_of_points", number_of_points, 12, 10_000_002, numbers.Real)
            properties["frequency"] = frequency_of(number_of_points)
        return self._filtered("vtkCurvedSeamlessSurface", progress, properties)

    @properties_of("vtkSphericalTextureMap", without=("area_balance",))
    def paint(self, image: ImageLike, *, area_balance: typing.Optional[float] = None, progress: Progress = False,
              **properties: typing.Any) -> "Surface":
        """Lay a picture on the surface. Its middle faces view_direction, and its top view_up.

        image: a PNG or JPEG file of up to 2^28 pixels, or an array of rows x columns x 3 or 4 bytes, first row
        on top. A separate process decodes files, and turns JPEG files as their EXIF orientation says.
        area_balance: trade-off of the picture between angles (0) and areas (1), in [0, 1]; default is 0.5, or 0 if the
        surface has a border: other values are then not used, with a warning. With 0, the picture is laid by the
        surface's own map to the sphere. If that map is conformal, the picture is not distorted, but long parts of the
        surface show few of its pixels.
        progress: True for a bar, or a function that gets the completed fraction in [0, 1].

        Raises FileNotFoundError if there is no such file, and ValueError if it is no picture or is broken. Example:

            surface.paint("photo.png", view_direction=(0, 0, 1)).save("figure.glb")
        """
        picture = image_of(image)
        placement = {**properties, "area_balance": self._balance_of_picture(area_balance)}
        painted = self._filtered("vtkSphericalTextureMap", progress, placement)
        painted._picture = picture, placement
        painted._picture_file = os.path.abspath(image) if isinstance(image, (str, os.PathLike)) else None
        return painted

    def bake(self, scan: PointsLike, *, colors: typing.Optional[npt.ArrayLike] = None,
             texture_size: typing.Optional[int] = None, area_balance: typing.Optional[float] = None,
             progress: Progress = False) -> "Surface":
        """Paint the surface with the colors of a scan, averaged over each pixel of the picture.

        scan: points with colors: a file, a vtkPointSet, or any input of learn(). Points that are not finite are left
        out with a warning.
        colors: red, green and blue of the points, n x 3 bytes in [0, 255]; default is the scan's own colors.
        texture_size: width and height of the picture in pixels, in [1, 16384]; by default, the density of the
        scan's points determines it, up to 4096.
        area_balance: trade-off of the picture between angles (0) and areas (1), in [0, 1]; default is 0.5, or 0 if the
        surface has a border: other values are then not used, with a warning.
        progress: True for a bar, or a function that gets the completed fraction in [0, 1], once for each of two
        filters.

        Raises ValueError if there are no colors, or not as many as points, and FilterFailed if the surface has no
        valid map to the sphere. Example:

            surface.bake("scan.ply").save("figure.glb")
        """
        texts: typing.List[str] = []
        points = point_set(scan, texts)
        found = scan_colors.colors_of(points) if colors is None else colors_in(colors, points.GetNumberOfPoints())
        if found is None:
            raise ValueError("the scan has no colors: pass an array of n x 3 bytes as colors")
        if texture_size is not None:
            expect_number("texture_size", texture_size, 1, 16384)
        count = points.GetNumberOfPoints()
        points, found = scan_colors.finite_part(points, found)
        left_out = count - points.GetNumberOfPoints()
        if left_out > 0:
            texts.append(f"vtkSphericalTextureImage: {left_out} points are not finite and left out")
            warn(texts[-1:])
        placement: typing.Dict[str, typing.Any] = {"area_balance": self._balance_of_picture(area_balance)}
        if self._has_border():
            placement["projection"] = "Square"
        else:
            placement.update(projection="Octahedral", margin=0.01)
        painted = self._filtered("vtkSphericalTextureMap", progress, placement)
        source = vtkTrivialProducer()
        source.SetOutput(painted.polydata)
        image = scan_colors.baked(source, points, found, texture_size)
        if texture_size is None:
            with heard(image) as messages:
                image.FitImageSize()
            if messages.errors:
                raise FilterFailed(f"{image.GetClassName()}: {messages.errors[0]}")
        texts += run(image, progress)
        painted._picture = image.GetOutput(), placement
        painted._warnings = unique([*painted._warnings, *texts])
        return painted

    @properties_of("vtkSphericalRegistration", without=("fixed",))
    def register(self, fixed: MeshLike, *, progress: Progress = False, **properties: typing.Any) -> "Surface":
        """Deform the map to the sphere until corresponding points of two surfaces have the same position.

        Map both surfaces in the same way, by conformal_map(mesh, area_balance=0.5) if they have limbs.

        fixed: the surface to which this surface is registered. It must have a map to the sphere.
        progress: True for a bar, or a function that gets the completed fraction in [0, 1].

        Returns this surface with the deformed map. If two correspondences are about equally good, a warning is
        issued, and `second` of the result is the other one. Raises FilterFailed if a surface has no valid map to the
        sphere, or if a landmark is not on its surface. Example:

            registered = surface.register(other, landmarks=[(12, 57)])
        """
        if fixed is None:
            raise TypeError("expected the surface to which this surface is registered, not None")
        algorithm, texts = updated("vtkSphericalRegistration", [self], progress, {**properties, "fixed": fixed},
                                   reworded={"on output port 1": "`second` of the result"})
        registered, second = (Surface.of_output(algorithm.GetOutput(port), texts) for port in (0, 1))
        registered._second = second if len(second) else None
        return registered

    @properties_of("vtkDeformationTransfer", without=("source", "pose"))
    def posed(self, source: MeshLike, poses: typing.Iterable[PointsLike], *, progress: Progress = False,
              **properties: typing.Any) -> typing.List["Surface"]:
        """Deform this surface as another surface is deformed: transfer poses or facial expressions.

        source: the other surface at rest, registered to this surface, so that their maps correspond.
        poses: the other surface in each pose: arrays of n x 3 points, or meshes with the triangles of `source`.
        progress: True for a bar, or a function that gets the completed fraction in [0, 1], once for each pose.

        Returns this surface in each pose. Raises FilterFailed if a pose does not fit the source. Example:

            happy, sad = face.posed(other.register(face), [happy_points, sad_points])
        """
        expect_several(poses, "poses")
        rest, shapes = Surface(source), []
        algorithm: typing.Any = None
        for pose in poses:
            read: typing.List[str] = []
            data = point_set(pose, read)
            if data.GetNumberOfCells() == 0 or not isinstance(data, vtkPolyData):
                points, data = data.GetPoints(), vtkPolyData()
                data.SetPoints(points)
                if data.GetNumberOfPoints() == len(rest):  # otherwise the filter reports the numbers
                    data.SetPolys(rest.polydata.GetPolys())
                    data.SetStrips(rest.polydata.GetStrips())
            if algorithm is None:
                algorithm, found = updated("vtkDeformationTransfer", [self], progress,
                                           {**properties, "source": rest, "pose": data})
            else:
                algorithm.SetPoseData(data)
                found = run(algorithm, progress)
            texts = [*self._warnings, *rest.warnings, *read, *found]
            shapes.append(Surface.of_output(algorithm.GetOutput(), texts))
        return shapes

    @properties_of("vtkSurfaceLayers", without=("volume",))
    def layers(self, volume: VolumeLike, *, spacing: typing.Optional[typing.Sequence[float]] = None,
               progress: Progress = False, **properties: typing.Any) -> Layers:
        """Sample a volume in layers below and above the surface, and unroll the layers to maps.

        volume: any input of surface_from_volume(), in the coordinates of the surface.
        spacing: of an array: size of a voxel along x (columns), y (rows) and z (slices). Default is (1, 1, 1).
        Files and vtkImageData have a spacing of their own, and with spacing they raise ValueError.
        progress: True for a bar, or a function that gets the completed fraction in [0, 1].

        Raises FilterFailed if the surface has no valid map to the sphere. Example:

            maps = surface.layers(volume, depth_range=(-10, 5), projection="Mercator", image_size=(800, 800)).maps
        """
        texts: typing.List[str] = []
        image = volume_of(volume, spacing, texts)
        algorithm, more = updated("vtkSurfaceLayers", [self], progress, {**properties, "volume": image},
                                  lambda data, found: data if data is image else point_set(data, found))
        stack = algorithm.GetOutputDataObject(1)
        maps = constant(stack.GetPointData().GetScalars()).reshape(stack.GetDimensions()[::-1])[:, ::-1]
        surface = Surface.of_output(algorithm.GetOutput(), [*texts, *more])
        depths = surface.polydata.GetFieldData().GetArray("LayerDepths")
        return Layers(maps, constant(depths), stack.GetSpacing()[:2], surface)

    @properties_of("vtkSurfaceHarmonics", without=("degree",))
    def harmonics(self, degree: int = 20, *, progress: Progress = False, **properties: typing.Any) -> Harmonics:
        """Compute the spherical harmonics of the surface.

        degree: maximum degree L of the harmonics, in [0, 256].
        progress: True for a bar, or a function that gets the completed fraction in [0, 1].

        Returns coefficients, (L + 1)^2 x 3 numbers, and the surface that is rebuilt from them. Example:

            coefficients, rebuilt = surface.harmonics(20)
        """
        algorithm, texts = updated("vtkSurfaceHarmonics", [self], progress, {**properties, "degree": degree})
        table = algorithm.GetCoefficients()
        columns = [vtk_to_numpy(table.GetColumnByName(name)) for name in "XYZ"]
        return Harmonics(np.stack(columns, axis=1), Surface.of_output(algorithm.GetOutput(), texts))

    def save(self, path: Path, *, overwrite: typing.Optional[bool] = None) -> None:
        """Write the surface to a file: .glb, .obj, .ply, .off, .m, .gii, .html, .stl, .3mf, .vtp or .vtk.

        A picture of paint() or bake() is written with .glb, .obj, .ply and .html. The picture of NAME.ply is the file
        NAME.png beside it. Beside NAME.obj are NAME.mtl and NAME.png. Coordinates in .3mf files are millimeters; those
        of the surface are written as they are; if the surface has a border, a warning says that it cannot be printed as a
        solid. All files are written completely, or none is written.

        overwrite: True to replace existing files, False to replace none. By default, the file and those that belong
        to it are replaced. Another file NAME.png or NAME.mtl, which NAME.ply or NAME.obj does not name, is not
        replaced unless it stays the same.

        Raises FileExistsError if a file exists and is not to be replaced, OSError if a file cannot be written, and
        ValueError for other extensions, if NAME.png is the file that paint() read, and for .html if the surface has no
        map to the sphere. Example:

            surface.save("figure.glb")
        """
        name = os.fspath(path)
        exports.save(self, name, overwrite)
        if outputs.extension_of(name) == ".3mf" and self._has_border():
            warn([f"{name}: the surface has a border, and cannot be printed as a solid; "
                  'learn it with border="Closed"'])

    def show(self) -> None:
        """Show the surface and its map to the sphere: in a notebook, or as a page in the web browser.

        Raises ValueError outside of a notebook if the surface has no map to the sphere.
        """
        pages.show(self)

    def to_pyvista(self) -> typing.Any:
        """Return a copy as pyvista.PolyData, with all arrays. Raises ModuleNotFoundError without PyVista."""
        return exports.to_pyvista(self)

    def to_trimesh(self) -> typing.Any:
        """Return a copy as trimesh.Trimesh, with its picture. Raises ModuleNotFoundError without trimesh."""
        return exports.to_trimesh(self)

    def __len__(self) -> int:
        return self._data.GetNumberOfPoints()

    def __repr__(self) -> str:
        return (f"<conformalsom.Surface: {len(self):,} points, {len(self.faces):,} triangles"
                f"{', painted' if self.image else ''}>")

    def _repr_html_(self) -> typing.Optional[str]:
        return pages.frame(self) if exports.has_map(self) else None

    def __getstate__(self) -> typing.Dict[str, typing.Any]:
        return {"data": pickling.dumps(self._data), "texture": self.texture, "placement": self.placement,
                "picture_file": self._picture_file, "warnings": self._warnings, "second": self._second}

    def __setstate__(self, state: typing.Dict[str, typing.Any]) -> None:
        self._data = pickling.loads(state["data"])
        self._picture = None if state["texture"] is None else image_of(state["texture"]), state["placement"]
        self._picture_file = state.get("picture_file")
        self._warnings = state["warnings"]
        self._second = state.get("second")

    def _has_border(self) -> bool:
        """Return whether the surface is mapped to a hemisphere, as are surfaces with a border."""
        map_ = self.polydata.GetPointData().GetArray("SpherePosition")
        return map_ is not None and map_.GetRange(2)[0] >= 0.0

    def _balance_of_picture(self, area_balance: typing.Optional[float]) -> float:
        """Return the trade-off of a picture between angles and areas: as given, or the default."""
        if area_balance is not None:
            return area_balance
        return 0.0 if self._has_border() else AREA_BALANCE  # maps of surfaces with a border cannot be balanced

    def _filtered(self, class_name: str, progress: Progress, properties: typing.Mapping[str, typing.Any]) -> "Surface":
        """Run a filter on this surface; return its first output as a surface."""
        algorithm, texts = updated(class_name, [self], progress, properties)
        return Surface.of_output(algorithm.GetOutput(), texts)


def unique(texts: typing.Iterable[str]) -> typing.Tuple[str, ...]:
    """Return texts without repetitions."""
    return tuple(dict.fromkeys(texts))


def constant(array: typing.Any) -> Array:
    """Return an array of VTK as one of NumPy over the same memory, which cannot be changed; bits as a copy in bytes."""
    values = pickling.numbers_of(array)
    values.flags.writeable = False
    return values


def columns_of(table: typing.Any) -> typing.Dict[str, Array]:
    """Return the columns of a vtkTable by their names, with a number or a text for each row."""
    columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
    return {column.GetName(): np.array([column.GetValue(row) for row in range(column.GetNumberOfValues())])
            for column in columns}


def colors_in(colors: npt.ArrayLike, count: int) -> Array:
    """Return colors as count x 3 bytes. Raises ValueError unless they are such numbers."""
    array = array_of(colors, f"colors as {count} x 3 integers in [0, 255]")
    if array.shape != (count, 3) or array.dtype.kind not in "iu":
        raise ValueError(f"expected colors as {count} x 3 integers in [0, 255], not of the shape {array.shape} and "
                         f"of {array.dtype}")
    if array.size and not 0 <= array.min() <= array.max() <= 255:
        raise ValueError(f"colors must be integers in [0, 255], not in [{array.min()}, {array.max()}]")
    return np.ascontiguousarray(array, np.uint8)


def arrays_of(attributes: typing.Any) -> typing.Dict[str, Array]:
    """Return the numeric arrays of point, cell or field data by their names."""
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {array.GetName(): constant(array) for array in arrays if array is not None and array.GetName()}
