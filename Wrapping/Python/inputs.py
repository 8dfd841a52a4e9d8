"""Inputs of functions: arrays, files, and the points and meshes of other packages, as data of VTK."""
import errno
import os
import typing

import numpy as np
import numpy.typing as npt
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkCallbackCommand, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkImageData, vtkPolyData
from vtkmodules.vtkIOImage import vtkNrrdReader
from vtkmodules.vtkIOLegacy import vtkDataReader
from vtkmodules.vtkIOXML import vtkXMLReader

from conformalsom.command import cleaning, scan_files, textures, volumes
from conformalsom.command.python_reader import PythonReader
from conformalsom.messages import FilterFailed, errors_outside
from conformalsom.running import run, warn


class HasPolyData(typing.Protocol):
    """A conformalsom.Surface."""
    @property
    def polydata(self) -> vtkPolyData: ...


class IsPointSet(typing.Protocol):
    """A vtkPointSet, also a data set of PyVista with points."""
    def GetPoints(self) -> typing.Any: ...
    def ShallowCopy(self, data: typing.Any) -> None: ...


class HasVertices(typing.Protocol):
    """A mesh or a cloud of trimesh, or a mesh of Open3D."""
    @property
    def vertices(self) -> typing.Any: ...


class HasPoints(typing.Protocol):
    """A cloud of Open3D."""
    @property
    def points(self) -> typing.Any: ...


Path = typing.Union[str, "os.PathLike[str]"]
Numbers = typing.Sequence[typing.Sequence[float]]
MeshLike = typing.Union[HasPolyData, IsPointSet, HasVertices, Path,
                        typing.Tuple["npt.NDArray[typing.Any]", "npt.NDArray[typing.Any]"]]
PointsLike = typing.Union["npt.NDArray[typing.Any]", Numbers, HasPoints, MeshLike]
ImageLike = typing.Union[Path, "npt.NDArray[np.uint8]"]
Texts = typing.Optional[typing.List[str]]
VolumeLike = typing.Union[Path, vtkImageData, "npt.NDArray[typing.Any]"]


def array_of(values: typing.Any, expected: str) -> "npt.NDArray[typing.Any]":
    """Return values as an array.

    Raises TypeError for masked values, which the data of VTK would have without the mask, and ValueError for rows of
    different lengths; `expected` names the values.
    """
    if is_masked(values):
        raise TypeError("masked values are not supported: remove them, such as by numpy.ma.compress_rows(array), or "
                        "replace them by array.filled(value)")
    try:
        return np.asarray(values)
    except ValueError:
        raise ValueError(f"expected {expected}, not rows of different lengths") from None


def is_masked(values: typing.Any) -> bool:
    """Return whether an array, or an item of a list, has masked values."""
    if isinstance(values, (list, tuple)):
        return any(isinstance(item, np.ma.MaskedArray) and np.ma.is_masked(item) for item in values)
    return np.ma.is_masked(values)


def kind_of(values: typing.Any, array: "npt.NDArray[typing.Any]") -> str:
    """Return the type of values, and of the items if there are several, for a message."""
    return type(values).__name__ + (f" of {array.dtype}" if array.ndim > 0 else "")


def expect_several(surfaces: typing.Any, items: str = "surfaces") -> None:
    """Raise TypeError for one surface, such as a file, instead of several."""
    is_one = isinstance(surfaces, (str, bytes, os.PathLike)) or isinstance(surfaces, np.ndarray) and surfaces.ndim < 3 or any(
        hasattr(surfaces, name) for name in ("polydata", "GetPoints", "vertices", "points"))
    if is_one or not isinstance(surfaces, typing.Iterable):
        raise TypeError(f"expected a list of {items}, not {type(surfaces).__name__}")


def keep(texts: Texts, more: typing.Iterable[str]) -> None:
    """Add texts to a list, if there is one."""
    if texts is not None:
        texts.extend(more)


def point_set(points: typing.Any, texts: Texts = None) -> typing.Any:
    """Return points, or a mesh with its triangles, as vtkPointSet; add the warnings of a file or a surface to texts.

    Arrays of 32 or 64 bit floats are not copied if they are contiguous.
    """
    if isinstance(points, (str, os.PathLike)):
        return with_whole_cells(read(points, texts), texts, f"{os.fspath(points)}: ")
    if hasattr(points, "polydata"):
        keep(texts, getattr(points, "warnings", ()))
        return points.polydata
    if hasattr(points, "GetPoints") and hasattr(points, "ShallowCopy"):
        copy = points.NewInstance()  # so that several threads can use one data set
        copy.ShallowCopy(points)
        return with_whole_cells(copy, texts)
    if hasattr(points, "vertices"):
        faces = getattr(points, "faces", getattr(points, "triangles", None))
        return with_triangles(cloud_of(points.vertices), faces)
    if hasattr(points, "points"):
        return with_normals(cloud_of(points.points), getattr(points, "normals", None))
    if isinstance(points, tuple) and len(points) == 2 and np.ndim(points[0]) == 2:
        return with_triangles(cloud_of(points[0]), points[1])
    return cloud_of(points)


def with_whole_cells(data: typing.Any, texts: Texts, name: str = "") -> typing.Any:
    """Return the data, without cells of too few points; a warning states their number, and is added to texts.

    Raises ValueError if a cell refers to a point that is not there. Messages begin with `name`.
    """
    if not isinstance(data, vtkPolyData):
        return data
    try:
        data, text = cleaning.with_whole_cells(data)
    except ValueError as error:
        raise ValueError(f"{name}{error}") from None
    if text:
        warn([name + text])
        keep(texts, [name + text])
    return data


def own_data(mesh: typing.Any, texts: Texts = None) -> typing.Any:
    """Return a mesh as point_set() does, but share no memory with what the caller may change later."""
    data = point_set(mesh, texts)
    if isinstance(mesh, (str, os.PathLike)) or hasattr(mesh, "polydata"):  # surfaces do not change
        return data
    copy = data.NewInstance()
    copy.DeepCopy(data)
    return copy


def cloud_of(points: typing.Any) -> vtkPolyData:
    """Return an array of n x 3 numbers as points of VTK."""
    array = array_of(points, "points as an array of n x 3")
    if array.dtype.kind not in "fiub" or array.ndim == 0:
        raise TypeError(f"expected points, such as an array of n x 3 numbers, not {kind_of(points, array)}")
    if array.shape == (0,):  # an empty list; the filter states that there are no points
        array = array.reshape(0, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"expected points as an array of n x 3, not of the shape {array.shape}")
    coordinates, cloud = vtkPoints(), vtkPolyData()
    coordinates.SetData(as_floats(array))
    cloud.SetPoints(coordinates)
    return cloud


def as_floats(array: "npt.NDArray[typing.Any]") -> typing.Any:
    """Return an array of VTK over the memory of 32 or 64 bit floats, or over a copy of other numbers."""
    type_ = array.dtype.newbyteorder("=") if array.dtype in (np.float32, np.float64) else np.dtype(np.float64)
    return numpy_to_vtk(np.ascontiguousarray(array, type_), deep=False)


def with_triangles(mesh: vtkPolyData, faces: typing.Any) -> vtkPolyData:
    """Add triangles, an array of n x 3 ids of points, if there are any."""
    if faces is None or len(faces) == 0:
        return mesh
    corners = array_of(faces, "triangles as an array of n x 3 integers")
    if corners.ndim != 2 or corners.shape[1] != 3 or corners.dtype.kind not in "iu":
        raise ValueError(f"expected triangles as an array of n x 3 integers, not of the shape {corners.shape} "
                         f"and of {corners.dtype}")
    if corners.min() < 0 or corners.max() >= mesh.GetNumberOfPoints():
        raise ValueError(f"ids of points of triangles must be in [0, {mesh.GetNumberOfPoints() - 1}], "
                         f"not in [{corners.min()}, {corners.max()}]")
    polygons = vtkCellArray()
    polygons.SetData(numpy_to_vtkIdTypeArray(np.arange(0, corners.size + 1, 3, dtype=np.int64), deep=True),
                     numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners, np.int64).ravel(), deep=True))
    mesh.SetPolys(polygons)
    return mesh


def with_normals(cloud: vtkPolyData, normals: typing.Any) -> vtkPolyData:
    """Add the normals of the points if there are any."""
    if normals is not None and len(normals) == cloud.GetNumberOfPoints() > 0:
        cloud.GetPointData().SetNormals(as_floats(array_of(normals, "normals as an array of n x 3")))
    return cloud


def mark_landmarks(surfaces: typing.List[typing.Any], landmarks: typing.Sequence[typing.Sequence[int]]) -> str:
    """Replace surfaces by copies with a point array: 1, 2 ... at landmarks, else 0. Return the name of the array."""
    name = "Landmark"
    expected = f"landmarks must be {len(surfaces)} lists of ids, one for each surface and all of one length"
    if isinstance(landmarks, str) or not isinstance(landmarks, typing.Iterable):
        raise TypeError(expected)
    lists = [array_of(ids, "landmarks as lists of ids") for ids in landmarks]
    if len(lists) != len(surfaces) or len({ids.shape for ids in lists}) != 1:
        raise ValueError(expected)
    if lists[0].size == 0:
        raise ValueError("landmarks are empty lists; leave landmarks out, or pass the ids of one or more")
    for i, (surface, ids) in enumerate(zip(surfaces, lists)):
        count = surface.GetNumberOfPoints()
        if ids.ndim != 1 or ids.dtype.kind not in "iu":
            raise ValueError(f"landmarks of surface {i} must be integers, ids of points, not {ids.dtype}")
        if not 0 <= ids.min() <= ids.max() < count:
            raise ValueError(f"landmarks of surface {i} must be ids of points in [0, {count - 1}]")
        if len(np.unique(ids)) < ids.size:
            raise ValueError(f"landmarks of surface {i} repeat an id")
        numbers = np.zeros(count, np.int32)
        numbers[ids] = np.arange(1, ids.size + 1)
        array = numpy_to_vtk(numbers, deep=True)
        array.SetName(name)
        surfaces[i] = surface.NewInstance()
        surfaces[i].ShallowCopy(surface)
        surfaces[i].GetPointData().AddArray(array)
    return name


def read(path: Path, texts: Texts = None) -> typing.Any:
    """Read a scan or a mesh, and add the reader's warnings to texts; content and extension select the reader.

    Raises FileNotFoundError if there is no such file, and FilterFailed or ValueError for a file that cannot be
    read.
    """
    name = os.fspath(path)
    reader_class = scan_files.reader_class(name)
    expect_file(name)
    if reader_class is not None and issubclass(reader_class, PythonReader):  # which cannot run on another thread
        return read_by_python(reader_class, name, texts)
    # Without a class, scan_reader() raises an error that lists the known types.
    reader: typing.Any = scan_files.scan_reader(name) if reader_class is None else reader_class()
    reader.SetFileName(name)
    quiet_parser(reader)
    keep(texts, run_reader(reader))
    return reader.GetOutputDataObject(0)


def read_by_python(reader_class: typing.Any, name: str, texts: Texts) -> vtkPolyData:
    """Read an .obj or .stl file; a warning of the reader is issued as FilterWarning, and added to texts."""
    try:
        data, warning = reader_class.read_file(name)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from None
    if warning:
        found = [f"{name}: {warning}"]
        warn(found)
        keep(texts, found)
    return data


def run_reader(reader: typing.Any) -> typing.List[str]:
    """Run a reader; return its warnings.

    Raises FilterFailed also for a .vtk or .nrrd file that ends early, which is no failure for VTK.
    """
    if not isinstance(reader, (vtkDataReader, vtkNrrdReader)):
        return run(reader)
    with errors_outside() as broken:
        warnings = run(reader)
    if broken:
        raise FilterFailed(f"{reader.GetClassName()}: {reader.GetFileName()}: {broken[0]}")
    return warnings


def quiet_parser(reader: typing.Any) -> None:
    """Let the parser of a reader of XML files print nothing. The reader reports that it failed."""
    if isinstance(reader, vtkXMLReader):
        reader.SetParserErrorObserver(vtkCallbackCommand())  # which does nothing; without it, errors are printed


def expect_file(name: str) -> None:
    """Raise FileNotFoundError for a missing file."""
    if not os.path.exists(name):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), name)


def image_of(image: typing.Any) -> typing.Any:
    """Return an image as vtkImageData of bytes, 3 or 4 for each pixel.

    The image is a PNG or JPEG file, or an array of rows x columns x 3 or 4 bytes, first row on top.
    """
    if isinstance(image, (str, os.PathLike)):
        name = os.fspath(image)
        expect_file(name)
        return textures.image_of(textures.read_picture(name))
    pixels = array_of(image, "an image of rows x columns x 3 or 4 bytes")
    if pixels.ndim != 3 or pixels.shape[2] not in (3, 4) or pixels.dtype != np.uint8 or pixels.size == 0:
        raise ValueError("expected an image of rows x columns x 3 or 4 bytes, "
                         f"not of the shape {pixels.shape} and of {pixels.dtype}")
    return textures.image_of(np.ascontiguousarray(pixels[::-1]))


def volume_of(volume: typing.Any, spacing: typing.Optional[typing.Sequence[float]] = None,
              texts: Texts = None) -> vtkImageData:
    """Return a volume as vtkImageData, and add the warnings of a file to texts.

    The volume is a file, a vtkImageData, or an array of slices x rows x columns, or slices x rows x columns x
    channels. spacing is that of an array, along x (columns), y (rows) and z (slices), by default (1, 1, 1).
    """
    is_file = isinstance(volume, (str, os.PathLike))
    is_image = hasattr(volume, "GetDimensions") and hasattr(volume, "ShallowCopy")
    if spacing is not None and (is_file or is_image):
        raise ValueError(f"spacing is {spacing!r}, but {'a file' if is_file else 'a vtkImageData'} has a spacing of "
                         "its own: leave spacing out, or pass the voxels as an array")
    if is_file:
        return read_volume(os.fspath(volume), texts)
    if is_image:
        copy = volume.NewInstance()  # so that several threads can use one data set
        copy.ShallowCopy(volume)
        return copy
    values = array_of(volume, "a volume as an array of slices x rows x columns")
    if values.dtype.kind not in "fiub":
        raise TypeError(f"expected a volume, such as an array of slices x rows x columns, not {kind_of(volume, values)}")
    if values.ndim not in (3, 4) or values.size == 0:
        raise ValueError(f"expected a volume as an array of slices x rows x columns, not of the shape {values.shape}")
    lengths = array_of((1.0, 1.0, 1.0) if spacing is None else spacing, "spacing as 3 positive numbers")
    if lengths.shape != (3,) or lengths.dtype.kind not in "fiu" or not (np.isfinite(lengths) & (lengths > 0.0)).all():
        raise ValueError(f"spacing is {spacing!r}, but must be 3 positive numbers")
    values = values if values.ndim == 4 else values[..., None]
    if values.dtype.kind == "b":
        values = values.astype(np.uint8)
    elif values.dtype.kind == "f" and values.dtype.itemsize not in (4, 8):  # VTK has neither half nor long doubles
        values = values.astype(np.float32 if values.dtype.itemsize == 2 else np.float64)
    image = vtkImageData()
    image.SetDimensions(*values.shape[2::-1])
    image.SetSpacing(*lengths.tolist())
    native = np.ascontiguousarray(values, values.dtype.newbyteorder("="))
    scalars = numpy_to_vtk(native.reshape(-1, values.shape[3]), deep=False)
    scalars.SetName("Intensity")
    image.GetPointData().SetScalars(scalars)
    return image


def read_volume(name: str, texts: Texts = None) -> vtkImageData:
    """Read a volume, and add the reader's warnings to texts; the extension selects the reader.

    Of a TIFF stack with time steps, the first is read.

    Raises FileNotFoundError if there is no such file, and FilterFailed or ValueError for a file that cannot be
    read.
    """
    reader: typing.Any = volumes.volume_reader(name)
    expect_file(name)
    volumes.expect_header(name, reader)
    quiet_parser(reader)
    keep(texts, run_reader(reader))
    volumes.expect_one_volume(name, reader)
    volumes.expect_whole(name, reader)
    return reader.GetOutput()
