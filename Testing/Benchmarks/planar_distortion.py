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
