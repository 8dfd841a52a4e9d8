"""A picture of a map for people: shaded heights with longitudes, latitudes, a legend and a scale. Needs no display."""
import warnings

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (draws the letters)

LONGEST = 2000  # pixels along the width of the map; wider maps are averaged
SHORTEST = 400  # pixels along the width of the map, so that labels do not overlap; narrower maps are enlarged
INK, PAPER, MISSING = np.array([32, 38, 46]), 255, 200
LOW, MIDDLE, HIGH = np.array([48, 86, 154]), np.array([232, 226, 212]), np.array([168, 62, 44])
SPACING = 30  # degrees between labels
FONT = 18  # points, for a map that is 1000 pixels wide


def draw(bands, central_longitude, title):
    """The picture of rows x columns of heights and radii [m]: a vtkImageData."""
    heights, radii = (reduced(bands[name]) for name in ("height", "radius"))
    largest = float(np.nanmax(np.abs(heights))) if np.isfinite(heights).any() else 0.0
    radius = float(np.nanmean(radii)) if np.isfinite(radii).any() else 0.0
    colors = enlarged(colored(heights, largest, shade(heights, radii)))
    rows, columns, _ = colors.shape
    font = max(9, round(FONT * columns / 1000))
    left, top, right, below = 5 * font, 3 * font, 9 * font, 5 * font
    page = np.full((top + rows + below, left + columns + right, 3), PAPER, np.uint8)
    plane = page[top:top + rows, left:left + columns]
    plane[:] = colors
    degree = columns / 360.0
    for longitude in range(-360, 721, SPACING):
        across = (longitude - central_longitude + 180.0) * degree
        if 0 <= across <= columns:
            darken(plane[:, min(int(across), columns - 1)])
            write(page, f"{longitude % 360}\u00b0 E", font, left + across, top + rows + font, 0.5)
    for latitude in range(-90, 91, SPACING):
        down = (90 - latitude) * degree
        darken(plane[min(int(down), rows - 1)])
        label = f"{abs(latitude)}\u00b0 {'N' if latitude > 0 else 'S' if latitude < 0 else ''}".strip()
        write(page, label, font, left - font // 2, top + down, 1.0)
    write(page, title, round(1.2 * font), left, 1.5 * font, 0.0)
    draw_legend(page[top:top + rows, left + columns:], largest, font)
    if radius > 0.0:
        draw_scale(page[top + rows:, left:left + columns], np.degrees(1.0 / radius) * degree, font)
    return image_of(page)


def reduced(values):
    """Rows and columns, averaged to LONGEST columns or fewer; a mean leaves out pixels without a value."""
    step = -(-values.shape[1] // LONGEST)
    rows, columns = (size // step for size in values.shape)
    blocks = values[:rows * step, :columns * step].reshape(rows, step, columns, step)
    known = np.isfinite(blocks)
    number = known.sum(axis=(1, 3))
    return np.where(number > 0, np.where(known, blocks, 0.0).sum(axis=(1, 3)) / np.maximum(number, 1), np.nan)


def enlarged(colors):
    """Rows and columns of colors, each repeated as often as SHORTEST columns or more need."""
    factor = -(-SHORTEST // colors.shape[1])
    return colors.repeat(factor, axis=0).repeat(factor, axis=1)


def shade(heights, radii):
    """Cosines between the surface and light from the northwest, 45 degrees above the horizon, as on atlases."""
    rows, columns = heights.shape
    meters = np.radians(180.0 / rows) * radii
    latitude = np.radians(90.0 - (np.arange(rows) + 0.5) * 180.0 / rows)[:, None]
    east = (np.roll(heights, -1, axis=1) - np.roll(heights, 1, axis=1)) / (2.0 * meters * np.cos(latitude))
    north = -np.gradient(heights, axis=0) / meters
    light = (1.0 + (east - north) / np.sqrt(2.0)) / np.sqrt(2.0 * (1.0 + east**2 + north**2))
    return np.where(np.isfinite(light), light, np.sqrt(0.5))


def darken(pixels):
    """Draw a line over a row or a column of pixels."""
    pixels[:] = pixels // 2 + INK // 2


def diverging(parts):
    """Colors of numbers, in [0, 255]: red from 1 on, light at 0, blue from -1 on."""
    parts = np.clip(parts, -1.0, 1.0)[..., None]
    return np.where(parts > 0, MIDDLE + parts * (HIGH - MIDDLE), MIDDLE - parts * (LOW - MIDDLE))


def colored(heights, largest, light):
    """Bytes of three colors: red at the largest height, blue at its negative, gray without a value."""
    colors = diverging(np.nan_to_num(heights / largest if largest > 0.0 else 0.0 * heights))
    shaded = np.clip(colors * (0.45 + 0.55 * np.sqrt(2.0) * np.maximum(light, 0.0)[..., None]), 0, 255)
    return np.where(np.isnan(heights)[..., None], MISSING, shaded).astype(np.uint8)


def draw_legend(page, largest, font):
    """The colors and their heights, beside the map."""
    rows = page.shape[0]
    column = np.linspace(largest, -largest, rows)[:, None]
    page[:, font:2 * font] = colored(column, largest, np.full_like(column, np.sqrt(0.5)))
    factor, unit = (1e-3, "km") if largest >= 2000.0 else (1.0, "m")
    for part in (1.0, 0.5, 0.0, -0.5, -1.0):
        text = f"{part * largest * factor:.3g} {unit}".replace("-", "\u2212")
        write(page, text, font, 2.5 * font, np.clip((1.0 - part) / 2.0 * rows, font / 2, rows - font / 2), 0.0)


def draw_scale(page, pixels_per_meter, font):
    """A bar of a round length, at the equator."""
    longest = 0.25 * page.shape[1] / pixels_per_meter
    power = 10.0 ** np.floor(np.log10(longest))
    length = max(step for step in (1, 2, 5) if step * power <= longest) * power
    end = max(int(length * pixels_per_meter), 1)
    page[3 * font:3 * font + max(font // 4, 2), :end] = INK
    text = f"{length / 1000:g} km" if length >= 1000.0 else f"{length:g} m"
    write(page, f"{text} at the equator", font, end + font // 2, 3.1 * font, 0.0)


def write(page, text, size, x, y, anchor):
    """Write text into a page; x is its left end (anchor 0), middle (0.5) or right end (1), and y its middle."""
    style, image, extent = vtkTextProperty(), vtkImageData(), [0, 0]
    style.SetFontSize(size)
    renderer = vtkTextRenderer.GetInstance()
    with warnings.catch_warnings():  # VTK 9.1 calls all overloads deprecated
        warnings.simplefilter("ignore", DeprecationWarning)
        renderer.RenderString(style, text, image, extent, 72, renderer.Default)
    columns, rows, _ = image.GetDimensions()
    alpha = vtk_to_numpy(image.GetPointData().GetScalars())[:, 3].reshape(rows, columns)[extent[1]::-1, :extent[0] + 1]
    alpha = alpha / 255.0
    top, left = (int(round(place)) for place in (y - alpha.shape[0] / 2, x - anchor * alpha.shape[1]))
    top, left = max(top, 0), max(left, 0)
    part = page[top:top + alpha.shape[0], left:left + alpha.shape[1]]
    alpha = alpha[:part.shape[0], :part.shape[1], None]
    part[:] = np.rint(part * (1.0 - alpha) + INK * alpha)


def image_of(page):
    """An image of rows from the top."""
    image = vtkImageData()
    image.SetDimensions(page.shape[1], page.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(page[::-1]).reshape(-1, 3), deep=True))
    return image
