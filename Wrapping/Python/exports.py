"""Surfaces as files, and as meshes of other packages."""
import errno
import filecmp
import os
import typing

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

import conformalsom
from conformalsom.command import outputs, textures
from conformalsom.filters import updated
from conformalsom.running import run

if typing.TYPE_CHECKING:
    from conformalsom.surface import Surface

HEAD = 2**16  # bytes of a file in which it names the files that belong to it


class Quiet:
    """Steps of the command that print nothing. Files in `kept` are replaced by equal files only."""

    def __init__(self, kept: typing.Iterable[str]) -> None:
        self.kept = kept

    def run(self, _, writer, work=None):  # pylint: disable=unused-argument
        """Write a file, which aborts at an exception such as KeyboardInterrupt."""
        if isinstance(writer, outputs.ThreeMFWriter):  # in Python, which other threads cannot run
            writer.Write()
        else:
            run(writer)
        for file in self.kept:
            new = os.path.join(os.path.dirname(writer.GetFileName()), os.path.basename(file))
            if os.path.exists(file) and not filecmp.cmp(file, new, shallow=False):
                raise FileExistsError(errno.EEXIST, "it exists and is not part of the file to be replaced; "
                                      "pass overwrite=True or another name", file)


def save(surface: "Surface", path: str, overwrite: typing.Optional[bool]) -> None:
    """Write a surface to a file of the type of its extension."""
    if outputs.extension_of(path) not in outputs.SURFACES:
        raise ValueError(f"{path}: expected a file of type {' '.join(outputs.SURFACES)}")
    writer = writer_of(surface, path)
    files = outputs.files_of(path) if isinstance(writer, conformalsom.vtkTexturedSurfaceWriter) else [path]
    for file in files[1:]:
        if is_same_file(file, surface.picture_file):
            raise ValueError(f"{file} is the picture that paint() read, and would be replaced: choose another name")
    for file in files:
        if overwrite is False and os.path.lexists(os.path.realpath(file)):
            raise FileExistsError(errno.EEXIST, "it exists; pass overwrite=True or another name", file)
    steps = Quiet(not_named(files) if overwrite is None else ())
    outputs.write(steps, writer, path, overwrite=overwrite is not False, files=files)


def is_same_file(path: str, other: typing.Optional[str]) -> bool:
    """Return whether two paths lead to one file that exists."""
    return other is not None and os.path.exists(path) and os.path.exists(other) and os.path.samefile(path, other)


def not_named(files: typing.Sequence[str]) -> typing.List[str]:
    """Return the files after the first that the file in front of each does not name, or not any more.

    An .obj file names its .mtl file, which names the picture; a .ply file names its picture.
    """
    for i, (file, next_file) in enumerate(zip(files, files[1:]), 1):
        if not names(file, os.path.basename(next_file)):
            return list(files[i:])
    return []


def names(path: str, name: str) -> bool:
    """Return whether a line at the beginning of a file, if it exists, ends with a name."""
    if not os.path.isfile(path):
        return False
    with open(path, "rb") as file:
        lines = file.read(HEAD).splitlines()
    return any(line.endswith(b" " + os.fsencode(name)) for line in lines)


def writer_of(surface: "Surface", path: str) -> typing.Any:
    """Return the writer of a file type, with the surface and its picture as inputs."""
    writer: typing.Any = outputs.writer_of(path, painted=surface.texture is not None)
    if isinstance(writer, conformalsom.vtkTexturedSurfaceWriter):
        writer.SetInputData(0, placed(surface))
        writer.SetInputData(1, surface.image or textures.one_pixel())
    elif outputs.extension_of(path) == ".html":
        if not has_map(surface):
            raise ValueError(f"{path}: a page needs a map to the sphere, and the surface has none: save it as .glb, or "
                             "map a closed surface without handles by conformal_map()")
        writer.SetInputData(0, placed(surface))
        if surface.image is not None:
            writer.SetTextureData(surface.image)
        for name, value in surface.placement.items():
            if name in ("view_direction", "view_up"):
                getattr(writer, "SetViewDirection" if name == "view_direction" else "SetViewUp")(value)
    else:
        writer.SetInputData(surface.polydata)
    return writer


def has_map(surface: "Surface") -> bool:
    """Return whether a surface has a map to the sphere. Surfaces with handles have none."""
    return bool(surface.polydata.GetPointData().HasArray("SpherePosition"))


def placed(surface: "Surface") -> typing.Any:
    """Return a surface with texture coordinates, cut along the seams of its picture."""
    if not has_map(surface):
        return in_one_color(surface)
    properties = {"split_seam": True, **surface.placement} if surface.image is not None else {}
    return updated("vtkSphericalTextureMap", [surface], properties=properties)[0].GetOutput()


def in_one_color(surface: "Surface") -> typing.Any:
    """Return a copy of a surface that shows a single pixel of a picture."""
    copy = vtkPolyData()
    copy.ShallowCopy(surface.polydata)
    copy.GetPointData().SetTCoords(numpy_to_vtk(np.zeros((len(surface), 2), dtype=np.float32), deep=True))
    return copy


def to_pyvista(surface: "Surface") -> typing.Any:
    """Return a copy of a surface as pyvista.PolyData."""
    import pyvista  # pylint: disable=import-outside-toplevel
    mesh = pyvista.PolyData()
    mesh.DeepCopy(surface.polydata)
    return mesh


def to_trimesh(surface: "Surface") -> typing.Any:
    """Return a copy of a surface as trimesh.Trimesh."""
    import trimesh.visual  # pylint: disable=import-outside-toplevel
    if surface.image is None:
        attributes: typing.Dict[str, typing.Any] = {
            name: np.array(values) for name, values in surface.point_data.items()}
        return trimesh.Trimesh(np.array(surface.points), np.array(surface.faces), vertex_attributes=attributes,
                               metadata=surface.quality, process=False)
    from PIL import Image  # pylint: disable=import-outside-toplevel
    cut = conformalsom.Surface(placed(surface))
    coordinates = vtk_to_numpy(cut.polydata.GetPointData().GetTCoords())
    picture = Image.fromarray(np.ascontiguousarray(surface.texture))
    visual = trimesh.visual.TextureVisuals(uv=np.array(coordinates, dtype=float), image=picture)
    return trimesh.Trimesh(np.array(cut.points), np.array(cut.faces), visual=visual, metadata=surface.quality,
                           process=False)
