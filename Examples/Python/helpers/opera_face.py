"""A painted face in the manner of Chinese opera, drawn by code."""
import numpy as np

from .textures import paint, pixel_centers, to_image

# Red for loyalty, black for honesty, white, and gold for what is more than human.
RED, BLACK, WHITE, GOLD, BLUE, SKIN = (np.array(c) / 255.0 for c in (
    (196, 30, 36), (22, 20, 24), (248, 244, 236), (226, 172, 54), (40, 78, 140), (238, 196, 168)))


def ellipse(x, y, center, radii, tilt=0.0):
    """Signed distance, to first order, to an ellipse whose first axis is tilted by some degrees."""
    c, s = np.cos(np.radians(tilt)), np.sin(np.radians(tilt))
    dx, dy = x - center[0], y - center[1]
    u, v = (c * dx + s * dy) / radii[0], (-s * dx + c * dy) / radii[1]
    length = np.hypot(u, v)
    slope = np.hypot(u / radii[0], v / radii[1])
    return length * (length - 1.0) / np.maximum(slope, 1e-9)


def stroke(x, y, path, widths):
    """Signed distance to a brush stroke along a smooth curve through the points of a path.

    Its half width changes evenly from point to point as the list of widths says.
    """
    path, widths = np.asarray(path, float), np.asarray(widths, float)
    # Catmull and Rom's curve, cut into straight pieces.
    knots = np.vstack([2 * path[0] - path[1], path, 2 * path[-1] - path[-2]])
    t = np.linspace(0.0, 1.0, 9)[:, None]
    points, radii = [path[:1]], [widths[:1]]
    for i in range(len(path) - 1):
        a, b, c, d = knots[i:i + 4]
        points.append((0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t**2
                              + (3 * b - a - 3 * c + d) * t**3))[1:])
        radii.append((widths[i] + (widths[i + 1] - widths[i]) * t[1:, 0]))
    points, radii = np.vstack(points), np.concatenate(radii)
    result = np.full(x.shape, np.inf)
    for p, q, start, end in zip(points[:-1], points[1:], radii[:-1], radii[1:]):
        axis = q - p
        share = np.clip(((x - p[0]) * axis[0] + (y - p[1]) * axis[1]) / (axis @ axis), 0.0, 1.0)
        distance = np.hypot(x - p[0] - share * axis[0], y - p[1] - share * axis[1])
        result = np.minimum(result, distance - start - share * (end - start))
    return result


def opera_face(size=1024):
    """A general's face: red, black brows like wings, a jewel on the forehead.

    It fills the middle of the picture; the border is the skin's red, so that a surface it does not
    cover shows no edge.
    """
    across, y = pixel_centers(size)
    x = np.abs(across)  # both halves alike
    canvas = np.ones((size, size, 3)) * RED

    def brush(path, widths, color, rim=None, rim_width=0.014):
        distance = stroke(x, y, path, widths)
        if rim is not None:
            paint(canvas, distance - rim_width, rim)
        paint(canvas, distance, color)

    def spot(center, radii, color, tilt=0.0, rim=None, rim_width=0.014):
        distance = ellipse(x, y, center, radii, tilt)
        if rim is not None:
            paint(canvas, distance - rim_width, rim)
        paint(canvas, distance, color)

    # Cheeks: white fields that end in curls, with a blue line inside.
    brush([(0.20, -0.12), (0.36, -0.16), (0.50, -0.06), (0.56, 0.12), (0.50, 0.20)],
          [0.04, 0.12, 0.10, 0.05, 0.01], WHITE, BLACK)
    brush([(0.26, -0.15), (0.40, -0.14), (0.50, -0.03), (0.53, 0.10)],
          [0.005, 0.030, 0.022, 0.004], BLUE)
    # Around the eyes: black wings that rise to the temples, with white feathers.
    brush([(0.05, 0.06), (0.17, 0.12), (0.32, 0.20), (0.46, 0.36), (0.52, 0.54)],
          [0.02, 0.085, 0.10, 0.06, 0.006], BLACK, WHITE)
    brush([(0.30, 0.22), (0.42, 0.34), (0.48, 0.47)], [0.006, 0.024, 0.003], WHITE)
    # Eyes.
    spot((0.20, 0.125), (0.090, 0.042), WHITE, tilt=16)
    spot((0.20, 0.128), (0.036, 0.038), BLACK)
    spot((0.208, 0.140), (0.009, 0.009), WHITE)
    # Brows like flames, gold within.
    brush([(0.07, 0.22), (0.14, 0.34), (0.26, 0.44), (0.34, 0.60), (0.33, 0.72)],
          [0.012, 0.055, 0.065, 0.040, 0.004], BLACK, WHITE)
    brush([(0.12, 0.33), (0.22, 0.43), (0.30, 0.58)], [0.004, 0.022, 0.003], GOLD)
    # Forehead: a jewel between three tongues of fire.
    brush([(0.0, 0.30), (0.0, 0.50), (0.0, 0.78)], [0.030, 0.075, 0.004], GOLD, BLACK)
    brush([(0.0, 0.34), (0.0, 0.48), (0.0, 0.66)], [0.010, 0.042, 0.003], RED)
    spot((0.0, 0.46), (0.030, 0.040), WHITE, rim=BLACK, rim_width=0.008)
    # Nose: a light bridge, dark wings, two curls.
    brush([(0.0, 0.24), (0.0, 0.05), (0.0, -0.10)], [0.012, 0.030, 0.055], SKIN)
    brush([(0.0, -0.14), (0.06, -0.15), (0.10, -0.09), (0.06, -0.06)],
          [0.016, 0.022, 0.016, 0.004], BLACK)
    brush([(0.10, -0.05), (0.16, -0.13), (0.12, -0.22), (0.15, -0.28)],
          [0.004, 0.018, 0.014, 0.003], WHITE)
    # Mouth, and a moustache that swings up.
    brush([(0.0, -0.22), (0.14, -0.25), (0.27, -0.33), (0.40, -0.30), (0.45, -0.22)],
          [0.012, 0.026, 0.030, 0.018, 0.003], BLACK, WHITE, 0.010)
    brush([(0.0, -0.36), (0.09, -0.345), (0.17, -0.33)], [0.040, 0.030, 0.004], np.array([0.45, 0.03, 0.07]),
          BLACK, 0.010)
    brush([(0.0, -0.352), (0.08, -0.34), (0.15, -0.333)], [0.006, 0.005, 0.002], BLACK)
    # Chin: a beard of three locks.
    brush([(0.0, -0.46), (0.0, -0.60), (0.0, -0.80)], [0.025, 0.055, 0.004], BLACK, WHITE, 0.010)
    brush([(0.10, -0.45), (0.17, -0.57), (0.15, -0.72)], [0.012, 0.040, 0.003], BLACK, WHITE, 0.010)
    brush([(0.24, -0.42), (0.34, -0.52), (0.35, -0.64)], [0.010, 0.032, 0.003], BLACK, WHITE, 0.010)
    # Temples and jaw: gold clouds.
    for center, radius in (((0.66, 0.30), 0.055), ((0.63, 0.18), 0.035), ((0.66, -0.22), 0.045)):
        spot(center, (radius, radius), GOLD, rim=BLACK, rim_width=0.010)
        spot(center, (0.45 * radius, 0.45 * radius), RED)
    return to_image(canvas)
