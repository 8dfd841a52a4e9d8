"""Bodies with handles, made by code: implicit functions, their surfaces, and clouds of points on these surfaces."""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import clouds, level_sets

EXTENT = 1.5  # the bodies are in the cube [-EXTENT, EXTENT]^3


def joined(a, b, radius=0.06):
    """Return the union of two bodies, with rounded edges between them."""
    h = np.clip(0.5 + 0.5 * (b - a) / radius, 0.0, 1.0)
    return b * (1.0 - h) + a * h - radius * h * (1.0 - h)


def ring(x, y, z, radius, tube):
    """Return the distance from a torus around the axis z."""
    return np.hypot(np.hypot(x, y) - radius, z) - tube


def capsule(x, y, z, start, end, radius):
    """Return the distance from a cylinder with round ends."""
    start, end = np.asarray(start, float), np.asarray(end, float)
    along = end - start
    t = ((x - start[0]) * along[0] + (y - start[1]) * along[1] + (z - start[2]) * along[2]) / (along @ along)
    t = np.clip(t, 0.0, 1.0)
    return np.sqrt((x - start[0] - t * along[0]) ** 2 + (y - start[1] - t * along[1]) ** 2
                   + (z - start[2] - t * along[2]) ** 2) - radius


def cylinder(x, y, z, radius, half, rounding=0.06):
    """Return the distance from a cylinder around the axis z with rounded edges."""
    a, b = np.hypot(x, y) - radius + rounding, np.abs(z) - half + rounding
    return np.minimum(np.maximum(a, b), 0.0) + np.hypot(np.maximum(a, 0.0), np.maximum(b, 0.0)) - rounding


def torus(x, y, z):
    """A torus of revolution: genus 1."""
    return ring(x, y, z, 1.0, 0.4)


def mug(x, y, z):
    """A mug with a handle: genus 1."""
    outside, inside = cylinder(x, y, z, 0.6, 0.7), cylinder(x, y, z - 0.25, 0.45, 0.8)
    handle = ring(x - 0.62, z, y, 0.36, 0.09)
    return np.maximum(joined(outside, np.maximum(handle, 0.53 - np.hypot(x, y))), -inside)


def vertebra(x, y, z):
    """A body like a vertebra, with the foramen of the spinal cord: genus 1."""
    body = cylinder(x, y - 0.55, z, 0.5, 0.3)
    arch = np.hypot(np.hypot(x / 1.15, y + 0.2) - 0.38, z / 1.5) - 0.12
    parts = joined(body, arch, 0.1)
    for end in ((0.0, -1.25, -0.3), (0.95, -0.5, 0.05), (-0.95, -0.5, 0.05)):
        start = (0.0, -0.6, 0.0) if end[0] == 0.0 else (0.4 * np.sign(end[0]), -0.25, 0.0)
        parts = joined(parts, capsule(x, y, z, start, end, 0.13), 0.1)
    return parts


def two_rings(x, y, z):
    """Two tori that are joined side by side: genus 2."""
    return joined(ring(x - 0.62, y, z, 0.5, 0.2), ring(x + 0.62, y, z, 0.5, 0.2))


def horseshoe(x, y, z):
    """A ring with a narrow gap: genus 0. A hull whose offset is half the gap joins its ends."""
    gap = np.maximum(np.abs(y) - 0.03, -x)
    return np.maximum(ring(x, y, z, 0.9, 0.3), -gap)


def ball(x, y, z):
    """A ball: genus 0."""
    return np.sqrt(x * x + y * y + z * z) - 1.0


BODIES = {"ball": (ball, 0), "horseshoe": (horseshoe, 0), "torus": (torus, 1), "mug": (mug, 1),
          "vertebra": (vertebra, 1), "two rings": (two_rings, 2)}


def surface_of(body, size=160):
    """Return the surface of a body, extracted from a grid of size^3 nodes."""
    axis = np.linspace(-EXTENT, EXTENT, size)
    z, y, x = np.meshgrid(axis, axis, axis, indexing="ij")
    return level_sets.zero_level(body(x, y, z).ravel(), [size] * 3, [-EXTENT] * 3, 2.0 * EXTENT / (size - 1))


def arrays_of(surface):
    """Return the points and triangles of a surface."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    return points, vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def cloud_of(surface, count, noise=0.0, seed=1):
    """Return random points of a surface, with normally distributed noise of a standard deviation."""
    random = np.random.default_rng(seed)
    points, triangles = arrays_of(surface)
    c, b, a = (points[triangles[:, k]] for k in range(3))  # the picture of handles.py was made with this order
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    chosen = random.choice(len(triangles), count, p=areas / areas.sum())
    u, v = random.random((2, count, 1))
    u, v = np.where(u + v > 1.0, 1.0 - u, u), np.where(u + v > 1.0, 1.0 - v, v)
    samples = a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen]
    samples += random.normal(0.0, noise, samples.shape) if noise else 0.0
    return clouds.cloud_of(samples)


def euler_number(surface):
    """Return vertices minus edges plus triangles, and the number of edges that are not of two triangles."""
    triangles = arrays_of(surface)[1]
    sides = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    edges, counts = np.unique(sides, axis=0, return_counts=True)
    return len(np.unique(triangles)) - len(edges) + len(triangles), int((counts != 2).sum())
