"""Presets: values of options for a purpose, unless they are given."""
import typing

from . import outputs
from .plan import WrongUsage


class Preset(typing.NamedTuple):
    """Values of options, and the type of files in a folder."""
    points: typing.Optional[int] = None
    normal_map: bool = False
    levels: int = 1
    compress: bool = False
    border: str = ""
    folder_type: str = ".glb"


PRESETS = {
    "web": Preset(points=10000, normal_map=True, compress=True),
    "game": Preset(points=8000, normal_map=True, levels=3),
    "print": Preset(border="Closed", folder_type=".3mf"),
    "archive": Preset(points=250000),
}
FOR_PRINTERS = (".3mf", ".stl")
MINIMUM_POINTS = 500  # of a level; see vtkAdaptiveSphere
SHARE_OF_NEXT_LEVEL = 0.25  # of the points


def apply(options):
    """Set the options that are not given to the values of the preset; raises WrongUsage if options contradict it."""
    preset = PRESETS.get(options.preset, Preset())
    options.folder_type = preset.folder_type
    if options.points is None:
        options.points = preset.points
    if options.normal_map is None:
        options.normal_map = preset.normal_map and not options.texture
    if options.levels is None:
        options.levels = preset.levels
    options.compress = options.compress or preset.compress
    if preset.border:
        if options.border == "Open":
            raise WrongUsage(f"--preset {options.preset} is for closed surfaces; leave out --open")
        options.border = preset.border
    if options.preset == "print" and options.unit is None:
        raise WrongUsage("--preset print needs the unit of the scan's coordinates, such as --unit mm: printers use "
                         "millimeters")


def expect_sense(options, files):
    """Raise WrongUsage if options for details do not fit each other or the files to write."""
    types = {outputs.extension_of(file) for file in files}
    if options.preset == "print" and not types <= set(FOR_PRINTERS):
        raise WrongUsage(f"--preset print writes files of type {' '.join(FOR_PRINTERS)}")
    if options.normal_map and options.texture:
        raise WrongUsage("--normal-map is not possible with --texture, which shows one side of the surface only")
    wanted = [name for name, isWanted in (("--normal-map", options.normal_map), ("--levels", options.levels > 1))
              if isWanted]
    if wanted and options.points is None:
        raise WrongUsage(f"{wanted[0]} needs --points, the number of points of the surface in the file")
    if wanted and options.preset is None and ".glb" not in types:
        raise WrongUsage(f"{wanted[0]} is for files of type .glb only")
    if options.levels > 1 and options.points * SHARE_OF_NEXT_LEVEL ** (options.levels - 1) < MINIMUM_POINTS:
        raise WrongUsage(f"--levels {options.levels} needs more points: the last level would have fewer than "
                         f"{MINIMUM_POINTS}")
