"""Write numbers on a map as a GeoTIFF, by GDAL's module for Python."""
import errno
import math
import os
import sys
import typing

import numpy as np

from .plan import WrongUsage

try:
    from osgeo import gdal, osr
    gdal.UseExceptions()
    osr.UseExceptions()
except ImportError:
    gdal = None

UNITS = {"slope": "degree", "area": "m2"}  # all others: m


def expect_available(crs):
    """Raise WrongUsage without GDAL, and for a reference system that it does not know or that is not in degrees."""
    if gdal is None:
        raise WrongUsage("maps need GDAL's module for Python: install python3-gdal (Debian) or gdal (PyPI)")
    if crs:
        try:
            fits = is_in_degrees(crs)
        except RuntimeError as error:
            raise WrongUsage(f"--crs {crs}: {error}") from None
        except TypeError:  # a text that is not UTF-8
            raise WrongUsage(f"--crs {crs}: GDAL does not know it") from None
        if not fits:
            raise WrongUsage(f"--crs {crs}: expected a system of longitude and latitude in degrees, such as "
                             "IAU_2015:200000400")


def is_in_degrees(crs):
    """Whether a reference system, as a file has it, is of longitude and latitude in degrees. Raises RuntimeError."""
    system = osr.SpatialReference()
    system.SetFromUserInput(crs)
    written = osr.SpatialReference()  # also geographic where a code of IAU has planetocentric latitudes
    written.ImportFromWkt(system.ExportToWkt())
    if not written.IsGeographic() or written.IsDerivedGeographic():  # derived: rotated poles
        return False
    return math.isclose(written.GetAngularUnits(), math.radians(1.0), rel_tol=1e-9)


def reference_system(crs, name, radius):
    """Return the reference system of a code, or longitude and latitude on a sphere [degrees] of a radius in meters."""
    system = osr.SpatialReference()
    if crs:
        system.SetFromUserInput(crs)
    else:
        title = "".join(c for c in name if c.isprintable() and c not in '"[]') or "body"
        system.SetGeogCS(f"{title} planetocentric", f"{title}", f"{title}", radius, 0.0, "Longitude 0", 0.0,
                         "degree", np.pi / 180.0)
    system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)  # longitude first
    return system


def write(path, bands, central_longitude, name, radius, crs=None):
    """Write bands by name: rows of pixels from the north, the whole sphere. Raises OSError if GDAL cannot write them."""
    rows, columns = next(iter(bands.values())).shape
    problems: typing.List[str] = []
    file = None
    try:
        file = gdal.GetDriverByName("GTiff").Create(
            path, columns, rows, len(bands), gdal.GDT_Float32,
            ["COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", "BIGTIFF=IF_SAFER"])
        fill(file, bands, central_longitude, reference_system(crs, name, radius))
    except RuntimeError as error:
        problems.append(str(error))
    hook = sys.unraisablehook  # of errors of destructors: without ours, Python prints them and goes on
    sys.unraisablehook = lambda unraisable: problems.append(str(unraisable.exc_value))
    del file  # which closes it
    sys.unraisablehook = hook
    if problems:
        raise OSError(errno.EIO, f"GDAL cannot write it: {problems[0].replace(path, os.path.basename(path))}", path)


def fill(file, bands, central_longitude, system):
    """Write bands into a new file. Raises RuntimeError if GDAL cannot write them."""
    file.SetGeoTransform((central_longitude - 180.0, 360.0 / file.RasterXSize, 0.0, 90.0, 0.0, -180.0 / file.RasterYSize))
    file.SetProjection(system.ExportToWkt())
    for number, (title, values) in enumerate(bands.items(), 1):
        band = file.GetRasterBand(number)
        band.SetDescription(title)
        band.SetUnitType(UNITS.get(title, "m"))
        band.SetNoDataValue(float("nan"))
        band.WriteArray(values)
    file.FlushCache()
