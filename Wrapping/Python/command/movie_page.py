"""The page of a movie: one file that shows the surface at each time beside its map, with a slider for time."""
import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter

from conformalsom import vtkConsistentRemesh

from . import movie_frames, shape_page

WIDTH = 512  # of maps on the page, in pixels
POINTS = 12000  # of the surface on the page
LOWEST, HIGHEST = 1.0, 98.5  # percentiles of brightness that are black and white
MOST = 98.0  # percentile of magnitudes at the end of other colors
MEASURES = (("Mean normal speed", "MeanNormalSpeed", 1, 1),
            ("Mean tangential speed", "MeanTangentialSpeed", 1, 1), ("Mean area rate", "MeanAreaRate", 0, 1),
            ("Mean shear rate", "MeanShearRate", 0, 1))  # with powers of length and of 1 / time
POWERS = {"AreaRate": (0, 1), "ShearRate": (0, 1), "NormalVelocity": (1, 1), "TangentialVelocity": (1, 1),
          "Velocity": (1, 1)}
SIGNED = ("AreaRate", "NormalVelocity")


def template():
    """The page without data; raises OSError if the package is incomplete."""
    return shape_page.template("movie")


def page_of(maps, kept, unit, options, steps):
    """The text of the page."""
    data = shape_page.Data()
    blocks = common_meshes([maps.surfaces[k] for k in kept], steps)
    all_points = [vtk_to_numpy(block.GetPoints().GetData()).astype(float) for block in blocks]
    low = np.min([points.min(axis=0) for points in all_points], axis=0)
    high = np.max([points.max(axis=0) for points in all_points], axis=0)
    size = max(np.linalg.norm(points - 0.5 * (low + high), axis=1).max() for points in all_points) or 1.0
    _, axes = movie_frames.principal_axes(maps.surfaces[maps.series.reference])
    arrays = [describe(data, name, maps.pictures[name], unit) for name in maps.pictures]
    description = {
        "triangles": data.add(vtk_to_numpy(blocks[0].GetPolys().GetConnectivityArray()), "<u4"),
        "sphere": data.add_vectors(vtk_to_numpy(blocks[0].GetPointData().GetArray(movie_frames.SPHERE))),
        "axes": [*axes[0].tolist(), *axes[1].tolist(), *np.cross(axes[0], axes[1]).tolist()],
        "size": arrays[0].pop("size"),
        "arrays": arrays,
        "frames": [{"name": options.all_frames[k].name, "time": k * options.interval,
                    "points": data.add_vectors((points - 0.5 * (low + high)) / size),
                    "measures": measures_of(maps, k, unit)}
                   for k, points in zip(kept, all_points)],
    }
    title = os.path.splitext(os.path.basename(options.output))[0] or "Movie"
    return shape_page.filled(template(), title, description, data)


def measures_of(maps, k, unit):
    """Measures of a frame: names, numbers and units."""
    area, volume = movie_frames.area_and_volume(maps.surfaces[k])
    return [["Area", area, unit_text(unit, 2, 0)], ["Volume", volume, unit_text(unit, 3, 0)],
            *([label, maps.series.value(k, column), unit_text(unit, length, time)]
              for label, column, length, time in MEASURES)]


def common_meshes(surfaces, steps):
    """All surfaces on one mesh, in which equal points have equal positions on the sphere."""
    remesh = vtkConsistentRemesh()
    for surface in surfaces:
        remesh.AddInputDataObject(surface)
    remesh.SetAlignmentToNone()
    remesh.AlignBlocksOff()
    remesh.SetNumberOfModes(0)
    remesh.SetMeshTypeToAdaptive()
    remesh.SetNumberOfPoints(POINTS)
    steps.run("Make the meshes of the page", remesh)
    return [remesh.GetOutput().GetBlock(i) for i in range(len(surfaces))]


def unit_text(unit, length, time):
    """The unit of a quantity, such as micron^2 or 1/s."""
    lengths = f"{unit or 'unit'}^{length}".removesuffix("^1") if length else ""
    if not time:
        return lengths
    return f"{lengths or 1}/s"


def describe(data, name, pictures, unit):
    """What the page knows about an array, with a picture for each frame."""
    height, width = pictures[0][1].shape[:2]
    if pictures[0][1].ndim == 3:
        return {"name": name, "ramp": "colors", "size": [width, height],
                "pictures": [add_picture(data, values) for _, values, _ in pictures]}
    inside = np.concatenate([values[~outside].ravel() for _, values, outside in pictures])
    ramp = "gray" if name == "LayerMaximum" else "signed" if name in SIGNED or inside.min() < 0.0 else "positive"
    if ramp == "gray":
        low, high = np.percentile(inside, [LOWEST, HIGHEST])
    else:
        high = np.percentile(np.abs(inside), MOST)
        low = -high if ramp == "signed" else 0.0
    scale = 254.0 / ((high - low) or 1.0)
    levels = [np.where(outside, 0, 1 + np.rint(scale * (np.clip(values, low, high) - low))).astype(np.uint8)
              for _, values, outside in pictures]
    label = "brightest layer" if name == "LayerMaximum" else name
    return {"name": label, "ramp": ramp, "range": [float(low), float(high)], "size": [width, height],
            "unit": unit_text(unit, *POWERS[name]) if name in POWERS else "",
            "pictures": [add_picture(data, picture) for picture in levels]}


def add_picture(data, pixels):
    """Append a PNG file; rows of pixels are from the south. Returns its place and size in bytes."""
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    values = np.ascontiguousarray(pixels).reshape(-1, pixels[0, 0].size)
    image.GetPointData().SetScalars(numpy_to_vtk(values, deep=True))
    writer = vtkPNGWriter()
    writer.SetInputData(image)
    writer.WriteToMemoryOn()
    writer.Write()
    return data.add(vtk_to_numpy(writer.GetResult()), np.uint8)
