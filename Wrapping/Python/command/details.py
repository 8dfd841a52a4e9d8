"""Details of a surface of few points: its normal map, and levels of detail."""
import importlib
import math

import conformalsom

from . import presets
from .plan import WrongUsage

TEXELS_PER_POINT = 8  # of the normal map, for each point of the detailed surface
LARGEST_SIDE = 4096


def expect_classes(options):
    """Raise WrongUsage if this build lacks a class that the options need."""
    for name, is_needed in (("vtkSurfaceNormalMap", options.normal_map), ("vtkSphericalResample", options.levels > 1)):
        if is_needed and name in conformalsom.CLASSES_LEFT_OUT:
            raise WrongUsage(f"this build lacks the class {name}, which --normal-map or --levels needs")


def filter_of(name):
    """A filter by the name of its class, which a build may leave out."""
    return getattr(importlib.import_module("conformalsom"), name)()


def side_of(detail):
    """Width of a normal map that shows the details of a surface."""
    texels = TEXELS_PER_POINT * detail.GetOutputDataObject(0).GetNumberOfPoints()
    return min(64 * math.ceil(math.sqrt(texels) / 64), LARGEST_SIDE)


def normal_map(cut, detail, steps):
    """The filter that computes the normal map of a cut surface from one of more points, after it has run."""
    baked = filter_of("vtkSurfaceNormalMap")
    baked.SetInputConnection(0, cut.GetOutputPort())
    baked.SetInputConnection(1, detail.GetOutputPort())
    baked.SetImageSize(side_of(detail), side_of(detail))
    steps.run("Bake the normal map", baked)
    return baked


def numbers_of_points(options):
    """Numbers of points of the levels after the first."""
    return [round(options.points * presets.SHARE_OF_NEXT_LEVEL ** level) for level in range(1, options.levels)]


def with_picture_of(painted, surface, steps):
    """A source of a surface on which pictures lie as on a painted surface of more points."""
    positions = painted.GetOutputDataObject(0)
    if not positions.GetPointData().HasArray("TexturePosition"):
        return surface
    laid = filter_of("vtkSphericalResample")
    laid.SetInputConnection(0, surface.GetOutputPort())
    laid.SetInputConnection(1, painted.GetOutputPort())
    steps.run("Transfer the texture map", laid)
    laid.GetOutput().GetFieldData().AddArray(positions.GetFieldData().GetArray("TextureAreaBalance"))
    return laid
