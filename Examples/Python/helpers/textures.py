"""Pictures to paint on a surface, drawn by code."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

# A glazed tile's colors.
CREAM, COBALT, OCHRE, BRICK, LEAF = (np.array(c) / 255.0 for c in (
    (250, 243, 226), (29, 66, 138), (232, 165, 39), (186, 62, 45), (64, 124, 92)))


def to_image(colors):
    """A #rows by #columns by 3 array of colors in [0, 1], first row on top, as a vtkImageData."""
    rows, columns, _ = colors.shape
    image = vtkImageData()
    image.SetDimensions(columns, rows, 1)
    bytes_ = np.clip(np.rint(colors[::-1] * 255.0), 0, 255).astype(np.uint8)
    image.GetPointData().SetScalars(numpy_to_vtk(bytes_.reshape(-1, 3), deep=True))
    return image


def pixel_centers(size):
    """x to the right and y up, of every pixel of a square from -1 to 1, first row on top."""
    steps = (np.arange(size) + 0.5) * 2.0 / size - 1.0
    return np.meshgrid(steps, -steps)


def paint(canvas, distance, color):
    """Fill where distance is negative, with an edge one pixel soft."""
    pixel = 2.0 / len(canvas)
    cover = np.clip(0.5 - distance / pixel, 0.0, 1.0)[..., None]
    canvas += cover * (color - canvas)


def checkerboard(size=1024, fields=16):
    """A checkerboard whose every field tells where it is.

    The dark fields grow redder to the right and greener upwards, so a mirrored or turned picture
    is seen at once; the arrow in the middle points up.
    """
    x, y = pixel_centers(size)
    column, row = np.floor((x + 1) / 2 * fields), np.floor((y + 1) / 2 * fields)
    dark = (column + row) % 2 == 0
    red, green = (column + 0.5) / fields, (row + 0.5) / fields
    graded = np.stack([0.1 + 0.8 * red, 0.1 + 0.65 * green, 0.75 - 0.35 * (red + green)], axis=-1)
    canvas = np.where(dark[..., None], graded, 0.97)
    head = np.maximum(np.abs(x) - (0.2 - y) * 0.7, 0.02 - y)
    shaft = np.maximum(np.abs(x) - 0.05, np.abs(y + 0.1) - 0.13)
    paint(canvas, np.minimum(head, shaft) - 0.015, np.array([1.0, 1.0, 1.0]))
    paint(canvas, np.minimum(head, shaft), np.array([0.1, 0.1, 0.1]))
    return to_image(canvas)


def petals(radius, angle, count, inner, outer, width, turn=0.0):
    """Signed distance to a wreath of leaf-shaped petals that point away from the center."""
    sector = 2.0 * np.pi / count
    offset = (angle - turn + sector / 2.0) % sector - sector / 2.0
    along, across = radius * np.cos(offset), np.abs(radius * np.sin(offset))
    # A leaf is where two circles overlap; its tips lie on the axis at inner and outer.
    half = (outer - inner) / 2.0
    bow = (half**2 - width**2) / (2.0 * width)
    return np.hypot(along - (inner + outer) / 2.0, across + bow) - (bow + width)


def dots(radius, angle, count, at, size, turn=0.0):
    """Signed distance to a ring of dots."""
    sector = 2.0 * np.pi / count
    offset = (angle - turn + sector / 2.0) % sector - sector / 2.0
    return np.hypot(radius * np.cos(offset) - at, radius * np.sin(offset)) - size


def rosette(size=1024):
    """A painted tile: wreaths of petals and dots around the middle; its border is one color."""
    x, y = pixel_centers(size)
    radius, angle = np.hypot(x, y), np.arctan2(x, y)  # from the top, clockwise
    canvas = np.ones((size, size, 3)) * CREAM

    def ring(at, width, color):
        paint(canvas, np.abs(radius - at) - width / 2.0, color)

    def wreath(*shape, color, turn=0.0, rim=None, vein=None):
        distance = petals(radius, angle, *shape, turn=turn)
        if rim is not None:
            paint(canvas, distance - 0.012, rim)
        paint(canvas, distance, color)
        if vein is not None:
            paint(canvas, distance + shape[3] * 0.55, vein)

    wreath(24, 0.70, 0.93, 0.052, color=COBALT, vein=CREAM)
    paint(canvas, dots(radius, angle, 24, 0.90, 0.020, np.pi / 24), BRICK)
    paint(canvas, dots(radius, angle, 24, 0.80, 0.013, np.pi / 24), LEAF)
    ring(0.685, 0.035, COBALT)
    ring(0.645, 0.012, OCHRE)
    wreath(12, 0.30, 0.62, 0.085, color=OCHRE, turn=np.pi / 12, rim=COBALT, vein=CREAM)
    paint(canvas, dots(radius, angle, 12, 0.575, 0.030), LEAF)
    wreath(12, 0.22, 0.52, 0.065, color=BRICK, rim=CREAM, vein=CREAM)
    ring(0.235, 0.03, COBALT)
    paint(canvas, radius - 0.222, CREAM)
    wreath(8, 0.05, 0.215, 0.038, color=COBALT)
    paint(canvas, dots(radius, angle, 8, 0.175, 0.016, np.pi / 8), OCHRE)
    paint(canvas, radius - 0.062, OCHRE)
    paint(canvas, radius - 0.034, BRICK)
    return to_image(canvas)


def noise(x, y, cells, random_seed=1):
    """Smooth random heights in [0, 1] over the square from -1 to 1, about `cells` hills across."""
    heights = np.random.RandomState(random_seed).random_sample((cells + 2, cells + 2))

    def part(coordinate):
        place = np.clip((coordinate + 1.0) / 2.0, 0.0, 1.0) * cells
        below = np.minimum(place.astype(int), cells)
        share = place - below
        return below, share * share * (3.0 - 2.0 * share)
    (i, u), (j, v) = part(x), part(y)
    lower = heights[j, i] * (1.0 - u) + heights[j, i + 1] * u
    upper = heights[j + 1, i] * (1.0 - u) + heights[j + 1, i + 1] * u
    return lower * (1.0 - v) + upper * v


def wood(size=1024, rings=11):
    """A board sawn close to the heart of a pine: rings drawn out to long arches, pores, rays."""
    x, y = pixel_centers(size)
    # The board cuts the trunk, whose axis leans towards it, at a slant: rings become ellipses.
    wobble = 0.10 * (noise(x, y, 3) - 0.5) + 0.025 * (noise(x, y, 9, 2) - 0.5)
    radius = np.hypot(x - 0.18 + wobble, 0.16 * (y + 1.35) + 0.5 * wobble)
    ring = radius * rings
    grown = ring % 1.0  # light early wood turns slowly into dark late wood, then breaks off
    late = np.clip((grown - 0.45) / 0.45, 0.0, 1.0) ** 2 * np.clip((1.0 - grown) / 0.06, 0.0, 1.0)
    year = np.random.RandomState(3).random_sample(4 * rings)[ring.astype(int)]
    fibre = noise(24.0 * x % 2.0 - 1.0, y, 24, 4) - 0.5
    fibre = fibre + noise(x, 0.2 * y, 200, 5) - 0.5
    shade = 0.62 * late * (0.6 + 0.4 * year) + 0.10 * year + 0.14 * fibre
    early, dark = np.array([0.90, 0.70, 0.45]), np.array([0.42, 0.20, 0.08])
    return to_image(early + np.clip(shade, 0.0, 1.0)[..., None] * (dark - early))


# Digits of five rows of three dots each, first row on top.
DIGITS = ("111101101101111", "010110010010111", "111001111100111", "111001011001111", "101101111001001",
          "111100111001111", "111100111101111", "111001010010010", "111101111101111", "111101111001111")


def numbered_grid(size=1024, fields=8):
    """A grid whose fields count from 0 at the lower left, to the right and then upwards.

    A number that stands on its head, is mirrored or missing says what went wrong where.
    """
    x, y = pixel_centers(size)
    u, v = (x + 1.0) / 2.0 * fields, (y + 1.0) / 2.0 * fields
    column = np.minimum(u.astype(int), fields - 1)
    row = np.minimum(v.astype(int), fields - 1)
    u, v = u - column, v - row
    red, green = column / (fields - 1.0), row / (fields - 1.0)
    canvas = np.stack([0.72 + 0.26 * red, 0.74 + 0.24 * green, 0.98 - 0.18 * red * green], axis=-1)
    dots_ = np.array([[c == "1" for c in digit] for digit in DIGITS])
    number = row * fields + column
    digits = len(str(fields * fields - 1))
    for place in range(digits):
        value = number // 10 ** (digits - 1 - place) % 10
        a = (u - 0.5) * 10.0 + (4.0 * digits - 1.0) / 2.0 - 4.0 * place  # in dots from the digit's left
        b = (0.5 - v) * 10.0 + 2.5
        inside = (a >= 0.0) & (a < 3.0) & (b >= 0.0) & (b < 5.0)
        dot = np.clip(b.astype(int), 0, 4) * 3 + np.clip(a.astype(int), 0, 2)
        canvas[inside & dots_[value, dot]] = (0.12, 0.16, 0.24)
    border = np.minimum(np.minimum(u, 1.0 - u), np.minimum(v, 1.0 - v)) * 2.0 / fields
    paint(canvas, border - 0.006, np.array([0.25, 0.30, 0.40]))
    return to_image(canvas)
