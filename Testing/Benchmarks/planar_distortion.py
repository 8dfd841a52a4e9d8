"""Distortion of triangles by texture coordinates or by a map to the plane."""
import numpy as np


def corner_angles(a, b, c):
    """Angles at the three corners of triangles in degrees, n by 3."""
    corners = []
    for o, p, q in ((a, b, c), (b, c, a), (c, a, b)):
        u, v = p - o, q - o
        lengths = np.linalg.norm(u, axis=1) * np.linalg.norm(v, axis=1)
        cosines = (u * v).sum(axis=1) / np.maximum(lengths, 1e-300)
        corners.append(np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0))))
    return np.column_stack(corners)


def planar_distortion(x, triangles, plane, charts=None):
    """Compare triangles, m by 3, between positions x, n by 3, and plane, n by 2.

    Returns the mean ratio K of the largest to the smallest stretch, the mean change of angles in degrees, the standard
    deviation of the logarithm of the area ratio, and the number of triangles that are flipped or have no area.
    Triangles without area are left out of the first three. Flipped triangles have the orientation that fewer triangles
    of their chart have. charts has the chart of each triangle, an integer from 0 on; by default there is one chart.
    """
    a, b, c = (x[triangles[:, k]] for k in range(3))
    u, v, w = (plane[triangles[:, k]] for k in range(3))
    along = np.linalg.norm(b - a, axis=1)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    signed = (v - u)[:, 0] * (w - u)[:, 1] - (v - u)[:, 1] * (w - u)[:, 0]
    charts = np.zeros(len(triangles), int) if charts is None else charts
    flipped = np.minimum(np.bincount(charts, signed <= 0.0), np.bincount(charts, signed >= 0.0)).sum()
    kept = (area > 0.0) & (signed != 0.0)
    a, b, c, u, v, w, along, area, flat = (t[kept] for t in (a, b, c, u, v, w, along, area, signed))
    # Columns of the Jacobian, in an orthonormal basis of the triangle whose first vector is along b - a.
    first = (v - u) / along[:, None]
    skew = ((c - a) * (b - a)).sum(axis=1) / along
    second = ((w - u) - skew[:, None] * first) * (along / area)[:, None]
    total, product = (first**2 + second**2).sum(axis=1), np.abs(flat) / area
    largest = 0.5 * (total + np.sqrt(np.maximum(total**2 - 4.0 * product**2, 0.0)))  # squared stretch
    return (np.mean(largest / product), np.abs(corner_angles(u, v, w) - corner_angles(a, b, c)).mean(),
            np.std(np.log(product)), int(flipped))


def stretch(x, triangles, plane):
    """Stretch L2 and the largest stretch Linf of Sander, Snyder, Gortler, Hoppe (2001), from the plane to the surface.

    1 is the best possible: the plane is scaled so that its area is that of the surface. Triangles without area are left
    out.
    """
    a, b, c = (x[triangles[:, k]] for k in range(3))
    u, v, w = (plane[triangles[:, k]] for k in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    twice = (v - u)[:, 0] * (w - u)[:, 1] - (v - u)[:, 1] * (w - u)[:, 0]
    with np.errstate(divide="ignore", invalid="ignore"):
        by_s = (a * (v - w)[:, 1:] + b * (w - u)[:, 1:] + c * (u - v)[:, 1:]) / twice[:, None]
        by_t = (a * (w - v)[:, :1] + b * (u - w)[:, :1] + c * (v - u)[:, :1]) / twice[:, None]
        squares = (by_s**2).sum(axis=1), (by_t**2).sum(axis=1), (by_s * by_t).sum(axis=1)
        sum_, difference = squares[0] + squares[1], squares[0] - squares[1]
        largest = np.sqrt(0.5 * (sum_ + np.sqrt(difference**2 + 4.0 * squares[2] ** 2)))
    scale = np.sqrt(0.5 * np.abs(twice).sum() / area.sum())
    kept = (area > 0.0) & (twice != 0.0)
    return (scale * np.sqrt((0.5 * sum_ * area)[kept].sum() / area[kept].sum()), scale * largest[kept].max())
