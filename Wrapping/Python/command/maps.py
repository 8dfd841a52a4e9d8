"""The command conformalsom map: a map of a body as a GeoTIFF of numbers, or as a picture."""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from conformalsom import vtkBodyMap, vtkBodyMapImage

from . import geotiff, jobs, labels, map_picture, mapped_files, outputs, pictures, scan_files
from .plan import METERS, Checks, WrongUsage, expect_extension, expect_utf8, in_range, parsed
from .progress import printable
from .steps import BarSteps

DESCRIPTION = """\
Draws the surface of a body, such as an asteroid, as a map in longitude and latitude. The file is a
GeoTIFF with bands of 32-bit numbers, for GDAL, QGIS and other programs. It needs GDAL's module for
Python (Debian: python3-gdal)."""

EPILOG = """\
bands:
  1 height  over an ellipsoid with the volume and the moments of the body [m]
  2 slope   angle between the surface and this ellipsoid [degrees]
            (height and slope are computed at vertices, and interpolated between them)
  3 radius  distance from the center [m]
  4 area    of the surface in a pixel [m^2]
  5, 6, 7   x, y, z of the surface [m]
Pixels without a value, where no ray from the center meets the body, are NaN, the NoData value.

A shape model has its origin in the center of the body, its z axis to the north, and its x axis to
longitude 0. If not, use --center and --axis."""

DRAWN = "HeightSlopeNormal"
GRAZING = 0.05  # least cosine between a ray and a normal, so that few pixels do not have most of the area
BANDS = ("height", "slope", "radius", "area", "x", "y", "z")
AREA_BALANCE = 0.5  # of maps that are computed; see vtkGlobalConformalMap


def make_parser():
    """The options, of which --help and the manual page are made."""
    parser = argparse.ArgumentParser(prog="conformalsom map", description=DESCRIPTION, epilog=EPILOG,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("body", metavar="BODY", help="file with a closed surface without handles (.tab, .obj, .ply ...)")
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help="GeoTIFF to write (.tif or .tiff)")
    parser.add_argument("--unit", choices=METERS, help="unit of the coordinates in BODY; default: that of the label "
                        "beside BODY (.lbl or .xml of the Planetary Data System), else km")
    parser.add_argument("--width", type=in_range(16, 40000), default=2000, metavar="N",
                        help="width in pixels, twice the height; in [16, 40000], default 2000")
    parser.add_argument("--coordinates", choices=("planetocentric", "map"), default="planetocentric",
                        help="planetocentric: longitude and latitude as catalogs use them; a pixel shows the point "
                             "farthest from the center. map: those of a map to the sphere, in which every point of "
                             "the surface has its own pixel; no catalog has these. Default planetocentric")
    parser.add_argument("--central-longitude", type=float, default=0.0, metavar="DEGREES",
                        help="east longitude in the middle of the map; in [-360, 360], default 0")
    parser.add_argument("--center", nargs=3, type=float, default=(0.0, 0.0, 0.0), metavar=("X", "Y", "Z"),
                        help="center of the body, in the unit of BODY; default 0 0 0")
    parser.add_argument("--axis", nargs=3, type=float, default=(0.0, 0.0, 1.0), metavar=("X", "Y", "Z"),
                        help="direction of north; default 0 0 1")
    parser.add_argument("--crs", metavar="CODE", help="coordinate reference system of longitude and latitude in "
                        "degrees, as GDAL knows it, such as IAU_2015:200000400; default: longitude and latitude on a "
                        "sphere with the volume of the body")
    parser.add_argument("--picture", metavar="FILE", help="also draw the heights with labels, a legend and a scale; .png "
                        "or .jpg")
    parser.add_argument("--overwrite", action="store_true", help="replace files")
    return parser


def arguments(argv):
    """What the command line says."""
    return parsed(make_parser(), argv, expect_sense)


def expect_sense(options):
    """Raise WrongUsage where the call cannot give a map."""
    expect_utf8(options.body)
    checks = Checks(scan_files.inputs_of(options.body), options.overwrite)
    for path, extensions in ((options.output, (".tif", ".tiff")), (options.picture, outputs.PICTURES)):
        if path:
            expect_utf8(path)
            expect_extension(path, extensions)
            checks.expect_free(path)
    for path in companions_of(options.output):  # which will be removed
        checks.expect_free(path)
    checks.expect_no_file_is_a_folder()
    if not abs(options.central_longitude) <= 360.0:
        raise WrongUsage("--central-longitude must be in [-360, 360]")
    if not np.isfinite([*options.center, *options.axis]).all() or not np.any(options.axis):
        raise WrongUsage("--center and --axis must be finite, and --axis not zero")
    geotiff.expect_available(options.crs)


def companions_of(path):
    """Files that GDAL has made for a map: statistics, overviews and a mask. They are not those of a new map."""
    names = dict.fromkeys((path, os.path.realpath(path)))  # GDAL looks for them beside a link, too
    return [name + extension for name in names for extension in (".aux.xml", ".ovr", ".msk")
            if os.path.lexists(name + extension)]


def run(options, bar):
    """Read, map, draw and write; returns the exit status."""
    steps = BarSteps(bar, options.body)
    jobs.handle_signals(steps.interrupt)  # aborts the filter that runs: VTK drops what an observer raises
    surface = mapped_files.read(options.body, AREA_BALANCE, steps)
    meters = labels.meters_of(surface, options.unit, "km", steps)
    name = labels.target_of(surface) or mapped_files.name_of(options.body)
    body = vtkBodyMap()
    body.SetInputData(surface)
    body.SetCenter(options.center)
    body.SetRotationAxis(options.axis)
    steps.run("Find longitudes and latitudes", body)
    bands = bands_of(options, body.GetOutput(), meters, steps)
    radii = vtk_to_numpy(body.GetOutput().GetFieldData().GetArray("ReferenceRadii")) * meters
    with outputs.whole(options.output, files=[options.output], overwrite=options.overwrite) as path:
        with outputs.named_errors(options.output):
            geotiff.write(path, bands, options.central_longitude, name, float(np.prod(radii)**(1.0 / 3.0)), options.crs)
    for companion in companions_of(options.output):
        os.remove(companion)
    if options.picture:
        write_picture(options, bands, name, steps)
    bar.clear()
    if sys.stdout is not None:
        with outputs.named_errors("the standard output"):
            print(summary_of(options, bands), flush=True)
    return 0


def summary_of(options, bands):
    """A line with the size of the map and the range of the heights."""
    missing = np.isnan(bands["radius"]).mean()
    return (f"wrote {printable(options.output)}: {options.width} x {options.width // 2} pixels, heights "
            f"{np.nanmin(bands['height']):.4g} to {np.nanmax(bands['height']):.4g} m, {100.0 * missing:.3g} % without values")


def write_picture(options, bands, name, steps):
    """Draw and write the picture."""
    kind = "planetocentric coordinates" if options.coordinates == "planetocentric" else "coordinates of a map to the sphere"
    title = f"{printable(name)}: heights over an ellipsoid, {kind}"
    writer = pictures.picture_writer(options.picture)
    writer.SetInputData(map_picture.draw(bands, options.central_longitude, title))
    outputs.write(steps, writer, options.picture, overwrite=options.overwrite)


def bands_of(options, body, meters, steps):
    """Rows of pixels from the north for each band, in meters, degrees and square meters; NaN without a value."""
    data = body.GetPointData()
    values = np.column_stack([*(vtk_to_numpy(data.GetArray(name)) for name in ("Height", "Slope")), normals_of(body)])
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    array.SetName(DRAWN)
    data.AddArray(array)
    chart = vtkBodyMapImage()
    chart.SetInputData(body)
    chart.SetArrayName(DRAWN)
    chart.SetCoordinates(chart.PLANETOCENTRIC if options.coordinates == "planetocentric" else chart.MAP)
    chart.SetCentralLongitude(options.central_longitude)
    chart.SetImageSize(options.width, options.width // 2)
    chart.SetGraticuleSpacing(0.0)
    chart.GeneratePositionsOn()
    steps.run("Draw the map", chart)

    def pixels(name):
        array = vtk_to_numpy(chart.GetOutput().GetPointData().GetArray(name))
        return array.reshape(options.width // 2, options.width, -1)[::-1]

    outside = pixels("OutsideSurface")[..., 0] > 0
    drawn = np.where(outside[..., None], np.nan, pixels(DRAWN))
    positions = np.where(outside[..., None], np.nan, pixels("BodyPosition") * meters)
    rays = positions - np.multiply(options.center, meters)
    radius = np.linalg.norm(rays, axis=-1)
    area = area_of_rays(rays, drawn[..., 2:]) if options.coordinates == "planetocentric" else area_of_pixels(positions)
    bands = (drawn[..., 0] * meters, drawn[..., 1], radius, area, *np.moveaxis(positions, -1, 0))
    return dict(zip(BANDS, (band.astype(np.float32) for band in bands)))


def normals_of(body):
    """A normal for each point."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(body)
    normals.SplittingOff()
    normals.Update()
    return vtk_to_numpy(normals.GetOutput().GetPointData().GetNormals())


def area_of_rays(rays, normals):
    """Area of the surface in each pixel of longitude and latitude, from rays from the center to the surface."""
    rows, columns = rays.shape[:2]
    sines = np.sin(np.linspace(np.pi / 2, -np.pi / 2, rows + 1))
    angles = (sines[:-1] - sines[1:]) * 2 * np.pi / columns  # solid angle of a pixel
    lengths = np.linalg.norm(rays, axis=-1)
    cosines = np.abs((rays * normals).sum(axis=-1)) / (lengths * np.linalg.norm(normals, axis=-1))
    return angles[:, None] * lengths**2 / np.maximum(cosines, GRAZING)


def area_of_pixels(positions):
    """Area of the parallelogram between the neighbors of a pixel in its row and column."""
    across = (np.roll(positions, -1, axis=1) - np.roll(positions, 1, axis=1)) / 2.0
    return np.linalg.norm(np.cross(across, np.gradient(positions, axis=0)), axis=-1)
