"""Clouds of a known object with errors as scanners make them.

x are exact positions on the object, n by 3, and normals the object's unit normals there. Every function returns the
points, and a mask of the points that are not outliers. s is the standard deviation of the error. Lengths are in units
of the object's largest radius.
"""
import numpy as np

AXES = np.vstack([np.eye(3), -np.eye(3)])
OUTLIERS, REACH = 0.01, 0.1  # fraction of outliers, and their largest distance from the surface
WAVES, WAVELENGTH = 12, 0.5  # of the error that changes slowly over a pass


def gaussian(x, _normals, s, random):
    """Equal noise along each axis."""
    return x + s * random.standard_normal(x.shape), np.ones(len(x), bool)


def views_of(normals, random):
    """For each point, the direction to a scanner on one of the six half-axes, at most 80 degrees from the normal."""
    cosines = normals @ AXES.T
    chance = np.where(cosines > np.cos(np.radians(80.0)), random.random(cosines.shape), -1.0)
    return AXES[chance.argmax(axis=1)]


def along_view(x, normals, s, random):
    """Noise s along the direction to the scanner, and s / 5 along each axis."""
    views = views_of(normals, random)
    points = x + s * views * random.standard_normal((len(x), 1)) + 0.2 * s * random.standard_normal(x.shape)
    return points, np.ones(len(x), bool)


def outliers(x, normals, s, random):
    """Noise along the view. Of the points, 1 % are moved by up to REACH along the view."""
    points, inside = along_view(x, normals, s, random)
    moved = random.permutation(len(x))[:int(OUTLIERS * len(x))]
    points[moved] += views_of(normals[moved], random) * random.uniform(-REACH, REACH, (len(moved), 1))
    inside[moved] = False
    return points, inside


def slow_field(x, random):
    """A smooth random function with standard deviation 1."""
    waves = random.standard_normal((WAVES, 3))
    waves *= 2.0 * np.pi / WAVELENGTH / np.linalg.norm(waves, axis=1)[:, None]
    return np.sqrt(2.0 / WAVES) * np.cos(x @ waves.T + random.uniform(0.0, 2.0 * np.pi, WAVES)).sum(axis=1)


def two_passes(x, normals, s, random):
    """Two scans of the object, each with half of the points.

    The first scan is shifted by s / 2 and rotated by s / 2 radians, the second by the opposite amounts. In addition,
    each scan has an error along the normal that changes slowly (s / 2), and noise along each axis (s / 2).
    """
    way, axis = (v / np.linalg.norm(v) for v in random.standard_normal((2, 3)))
    second = random.random(len(x)) < 0.5
    points = x + 0.5 * s * random.standard_normal(x.shape)
    for chosen, sign in ((~second, 1.0), (second, -1.0)):
        points[chosen] += 0.5 * s * (sign * (way + np.cross(axis, x[chosen]))
                                     + normals[chosen] * slow_field(x[chosen], random)[:, None])
    return points, np.ones(len(x), bool)


NOISES = {"gaussian": gaussian, "view": along_view, "outliers": outliers, "passes": two_passes}
