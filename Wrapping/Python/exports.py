"""Surfaces as files, and as meshes of other packages."""
import errno
import os
import typing

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import conformalsom
from conformalsom.command import outputs, textures
from conformalsom.filters import updated
from conformalsom.running import run

if typing.TYPE_CHECKING:
    from conformalsom.surface import Surface


class Quiet:
    """Steps of the command that print nothing."""

    @staticmethod
    def run(_, writer, work=None):  # pylint: disable=unused-argument
        """Write a file, which aborts at an exception such as KeyboardInterrupt."""
        if isinstance(writer, outputs.ThreeMFWriter):  # in Python, which other threads cannot run
            writer.Write()
        else:
            run(writer)


def save(surface: "Surface", path: str, overwrite: bool) -> None:
    """Write a surface to a file of the type of its extension."""
    if outputs.extension_of(path) not in outputs.SURFACES:
        raise ValueError(f"{path}: expected a file of type {' '.join(outputs.SURFACES)}")
    for file in outputs.files_of(path):
        if not overwrite and os.path.lexists(os.path.realpath(file)):
            raise FileExistsError(errno.EEXIST, "it exists; pass overwrite=True or another name", file)
    outputs.write(Quiet, writer_of(surface, path), path, overwrite=overwrite)


def writer_of(surface: "Surface", path: str) -> typing.Any:
    """Return the writer of a file type, with the surface and its picture as inputs."""
    writer: typing.Any = outputs.writer_of(path, painted=surface.texture is not None)
    if isinstance(writer, conformalsom.vtkTexturedSurfaceWriter):
        writer.SetInputData(0, placed(surface))
        writer.SetInputData(1, surface.image or textures.one_pixel())
    elif outputs.extension_of(path) == ".html":
        writer.SetInputData(0, placed(surface))
        if surface.image is not None:
            writer.SetTextureData(surface.image)
        for name, value in surface.placement.items():
            if name in ("view_direction", "view_up"):
                getattr(writer, "SetViewDirection" if name == "view_direction" else "SetViewUp")(value)
    else:
        writer.SetInputData(surface.polydata)
    return writer


def placed(surface: "Surface") -> typing.Any:
    """Return a surface with texture coordinates, cut along the seams of its picture."""
    properties = {"split_seam": True, **surface.placement} if surface.image is not None else {}
    return updated("vtkSphericalTextureMap", [surface], properties=properties)[0].GetOutput()


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
