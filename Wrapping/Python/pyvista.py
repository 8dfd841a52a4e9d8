"""Apply the filters to PyVista's meshes by functions:

    from conformalsom.pyvista import learn, paint, smooth

    surface = smooth(learn(cloud, number_of_neurons=5000))
    paint(surface, "photo.png").plot(rgb=True)

Properties of the filters are keywords: Set methods without "Set", in snake case. Values of enumerations may
be names: mesh_type="Geodesic" calls SetMeshTypeToGeodesic. An error of a filter is raised as FilterFailed
with the filter's message. Warnings of a filter are issued as Python warnings.
"""
import os
import warnings

import numpy as np

try:
    import pyvista
except ModuleNotFoundError as error:
    raise ModuleNotFoundError("conformalsom.pyvista needs PyVista: python3-pyvista in Debian 13 and later, or "
                              "pip install pyvista", name="pyvista") from error

from conformalsom import vtkConformalSOM, vtkCurvedSeamlessSurface, vtkGlobalConformalMap, vtkSphericalTextureMap
from conformalsom.command import textures
from conformalsom.messages import FilterFailed, heard


ADVICE = "pyvista.read() reads files, and the blocks of a MultiBlock are data sets"


def learn(cloud, **properties) -> pyvista.PolyData:
    """Learn a closed mesh with a map to the sphere from points: vtkConformalSOM.

    The cloud is any PyVista data set with points, or an array of n x 3 numbers. The mesh is a
    pyvista.PolyData; its point array "SpherePosition" is the map.
    """
    if not isinstance(cloud, pyvista.DataSet):
        if isinstance(cloud, (str, os.PathLike, type(None), pyvista.MultiBlock)):
            raise TypeError(f"expected a data set of PyVista or an array of n x 3, not {type(cloud).__name__}; "
                            + ADVICE)
        points = np.asarray(cloud, dtype=float)
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"expected points as an array of n x 3, not of the shape {points.shape}")
        cloud = pyvista.PolyData(points)
    return run(vtkConformalSOM(), cloud, **properties)


def smooth(mesh, **properties) -> pyvista.PolyData:
    """Make a mapped mesh smooth and dense: vtkCurvedSeamlessSurface."""
    return run(vtkCurvedSeamlessSurface(), single(mesh), **properties)


def conformal_map(mesh, **properties) -> pyvista.PolyData:
    """Map a closed triangle mesh of genus zero to the sphere: vtkGlobalConformalMap."""
    return run(vtkGlobalConformalMap(), single(mesh), **properties)


def paint(mesh, image, **properties) -> pyvista.PolyData:
    """Lay an image on a mapped mesh: vtkSphericalTextureMap.

    The middle of the image faces view_direction, (0, 0, 1) by default, and its top view_up, (0, 1, 0) by default.
    The image is a PNG or JPEG file, a pyvista.Texture, or an array of rows x columns x 3 or 4 bytes, first row on
    top. A separate process decodes files. The result has texture coordinates, and the color of the image at each
    point as active scalars, in the point array "RGB" or "RGBA".
    """
    pixels = pixels_of(image)
    painted = run(vtkSphericalTextureMap(), single(mesh), **properties)
    colors = sampled(pixels, painted.active_texture_coordinates)
    painted.point_data["RGB" if colors.shape[1] == 3 else "RGBA"] = colors
    painted.set_active_scalars("RGB" if colors.shape[1] == 3 else "RGBA")
    return painted


def single(mesh):
    """Return the mesh; raise TypeError for several meshes and for other types."""
    if not isinstance(mesh, pyvista.DataSet):
        raise TypeError(f"expected a mesh of PyVista, not {type(mesh).__name__}; {ADVICE}")
    return mesh


def run(algorithm, *inputs, **properties):
    """Run any filter on data, one for each of its input ports, and return its first output."""
    for name, value in properties.items():
        set_property(algorithm, name, value)
    ports = algorithm.GetNumberOfInputPorts()
    if len(inputs) > ports:
        raise ValueError(f"{algorithm.GetClassName()} has {ports} input ports, but {len(inputs)} inputs were given")
    for port, data in enumerate(inputs):
        algorithm.SetInputData(port, pyvista.wrap(data))
    with heard(algorithm) as messages:
        algorithm.Update()
    if messages.errors:
        raise FilterFailed(f"{algorithm.GetClassName()}: {messages.errors[0]}")
    for text in messages.warnings:
        warnings.warn(f"{algorithm.GetClassName()}: {text}", stacklevel=3)
    return pyvista.wrap(algorithm.GetOutputDataObject(0))


def set_property(algorithm, name, value):
    """Set a property by its name in snake case; names of values of enumerations call SetPropertyToName."""
    setter = "Set" + "".join(word[:1].upper() + word[1:] for word in name.split("_"))
    if not hasattr(algorithm, setter):
        raise TypeError(f"{algorithm.GetClassName()} has no property {name}")
    names = [method[len(setter) + 2:] for method in dir(algorithm) if method.startswith(setter + "To")]
    if isinstance(value, str) and value in names:
        getattr(algorithm, setter + "To" + value)()
    elif isinstance(value, str) and names:
        raise ValueError(f"{name} is {value}, but must be one of {', '.join(names)}")
    else:
        getattr(algorithm, setter)(value)


def pixels_of(image):
    """Return an image as an array of rows x columns x 3 or 4 bytes, first row on top."""
    if isinstance(image, (str, os.PathLike)):
        image = textures.read_picture(os.fspath(image))[::-1]
    pixels = image.to_array() if isinstance(image, pyvista.Texture) else np.asarray(image)
    if pixels.ndim != 3 or pixels.shape[2] not in (3, 4) or pixels.dtype != np.uint8 or pixels.size == 0:
        raise ValueError("expected an image of rows x columns x 3 or 4 bytes, "
                         f"not of the shape {pixels.shape} and of {pixels.dtype}")
    return pixels


def sampled(pixels, coordinates):
    """Interpolate an image at texture coordinates bilinearly; outside of the image use the color of its border."""
    size = np.array([pixels.shape[1], pixels.shape[0]])
    place = np.asarray(coordinates) * (1, -1) + (0, 1)  # from the upper left corner
    place = np.clip(place * size - 0.5, 0, size - 1)
    (left, top), (right, bottom) = np.floor(place).astype(int).T, np.ceil(place).astype(int).T
    across, down = (place % 1).T[:, :, None]
    upper = (1 - across) * pixels[top, left] + across * pixels[top, right]
    lower = (1 - across) * pixels[bottom, left] + across * pixels[bottom, right]
    return np.rint((1 - down) * upper + down * lower).astype(np.uint8)
