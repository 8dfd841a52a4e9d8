"""The built-in scan: a toy bear made by code, as a scanner would see it.

The bear is the zero set of a signed distance, a smooth union of ellipsoids and round cones. Its
surface is sampled evenly and every sample is moved by a little noise, so that what comes out is
what a scanner hands over: points without triangles. One piece, no holes, no handles (genus 0);
+y is up and the bear looks along +z. The same arguments give the same points.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

from . import clouds, level_sets

LOW, HIGH = np.array([-0.9, -1.0, -0.75]), np.array([0.9, 1.25, 0.8])  # a box around the bear
SPACING = 0.03


def ellipsoid(center, radii):
    """Signed distance to an ellipsoid, exact to first order near its surface."""
    def distance(p):
        q = (p - center) / radii
        length = np.linalg.norm(q, axis=1)
        return length * (length - 1.0) / np.maximum(np.linalg.norm(q / radii, axis=1), 1e-12)
    return distance


def dot(vectors, vector):
    """Dot products, added in a stated order: those of @ depend on the linear algebra behind NumPy."""
    return vectors[..., 0] * vector[0] + vectors[..., 1] * vector[1] + vectors[..., 2] * vector[2]


def limb(start, end, start_radius, end_radius):
    """Signed distance to a capsule whose radius changes evenly from start to end."""
    start, axis = np.asarray(start), np.subtract(end, start)

    def distance(p):
        t = np.clip(dot(p - start, axis) / dot(axis, axis), 0.0, 1.0)
        radius = start_radius + (end_radius - start_radius) * t
        return np.linalg.norm(p - start - t[:, None] * axis, axis=1) - radius
    return distance


def on_both_sides(part):
    """A part and its mirror image in the plane x = 0."""
    return lambda p: part(np.column_stack([np.abs(p[:, 0]), p[:, 1:]]))


# Limbs are short: one that learns from points alone spans webs between long ones.
# Each part with the width over which it melts into those before it.
PARTS = [
    (ellipsoid((0.0, -0.22, 0.0), (0.60, 0.55, 0.52)), 0.0),                            # belly
    (ellipsoid((0.0, 0.15, 0.0), (0.50, 0.40, 0.45)), 0.20),                            # chest
    (ellipsoid((0.0, 0.56, 0.04), (0.54, 0.46, 0.47)), 0.17),                           # head
    (on_both_sides(ellipsoid((0.42, 0.93, 0.0), (0.19, 0.20, 0.15))), 0.08),            # ears
    (ellipsoid((0.0, 0.44, 0.44), (0.22, 0.16, 0.16)), 0.08),                           # muzzle
    (ellipsoid((0.0, 0.53, 0.59), (0.08, 0.06, 0.05)), 0.03),                           # nose
    (on_both_sides(ellipsoid((0.20, 0.69, 0.445), (0.06, 0.07, 0.05))), 0.02),          # eyes
    (on_both_sides(limb((0.42, 0.0, 0.10), (0.63, 0.0, 0.24), 0.19, 0.17)), 0.20),      # arms
    (on_both_sides(limb((0.30, -0.54, 0.16), (0.39, -0.65, 0.46), 0.22, 0.21)), 0.16),  # legs
    (ellipsoid((0.0, -0.45, -0.49), (0.14, 0.14, 0.14)), 0.08),                         # tail
]


# Arms up and legs apart: what spans webs when learned from a sphere.
DANCER = [
    (limb((0.0, -0.30, 0.0), (0.0, 0.30, 0.0), 0.24, 0.28), 0.0),                       # trunk
    (ellipsoid((0.0, 0.80, 0.0), (0.22, 0.26, 0.23)), 0.20),                            # head
    (on_both_sides(limb((0.22, 0.38, 0.0), (0.68, 0.95, 0.12), 0.12, 0.10)), 0.12),     # arms
    (on_both_sides(limb((0.14, -0.40, 0.0), (0.40, -0.84, 0.10), 0.16, 0.11)), 0.10),   # legs
]


def union(parts):
    """Signed distance to parts that melt into each other; negative inside."""
    def distance(p):
        result = np.full(len(p), 10.0)
        for part, width in parts:
            d = part(p)
            overlap = np.maximum(width - np.abs(result - d), 0.0)
            result = np.minimum(result, d) - overlap**2 / (4.0 * max(width, 1e-12))
        return result
    return distance


bear, dancer = union(PARTS), union(DANCER)


def zero_set(distance):
    """Outward triangles close to the surface where a signed distance is zero, as a vtkPolyData."""
    size = np.ceil((HIGH - LOW) / SPACING).astype(int) + 1
    x, y, z = (low + SPACING * np.arange(n) for low, n in zip(LOW, size))
    grid_z, grid_y, grid_x = np.meshgrid(z, y, x, indexing="ij")
    grid = np.column_stack([grid_x.ravel(), grid_y.ravel(), grid_z.ravel()])
    return level_sets.zero_level(distance(grid), size, LOW, SPACING)


def even_samples(mesh, count, random, corners=(0, 1, 2)):
    """Points spread over the triangles in proportion to area. Another order of the corners gives other points."""
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    a, b, c = points[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)[:, corners].T]
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    chosen = np.searchsorted(np.cumsum(area), random.random(count) * area.sum())
    u, v = random.random((2, count, 1))
    outside = u + v > 1.0
    u, v = np.where(outside, 1.0 - u, u), np.where(outside, 1.0 - v, v)
    return a[chosen] + u * (b - a)[chosen] + v * (c - a)[chosen]


def project(points, distance, steps=3):
    """Newton's method down the gradient: the points, moved on to the zero set."""
    h = 1e-5
    for _ in range(steps):
        d = distance(points)
        gradient = np.column_stack([
            (distance(points + h * axis) - d) / h for axis in np.eye(3)])
        points = points - gradient * (d / (gradient**2).sum(axis=1))[:, None]
    return points


def figure_surface():
    """The bear without noise, as triangles: what a perfect result would look like."""
    return zero_set(bear)


def figure_cloud(number_of_points=60000, noise=0.001, random_seed=1, figure=bear):
    """A figure as a vtkPolyData of points only.

    noise is the standard deviation of a point's displacement along each axis, as a share of the
    figure's height.
    """
    random = np.random.RandomState(random_seed)
    # Pictures and tables were made of the points that this order of the corners gives.
    points = project(even_samples(zero_set(figure), number_of_points, random, (2, 1, 0)), figure)
    height = np.ptp(points[:, 1])
    points = points + noise * height * random.standard_normal(points.shape)
    return clouds.cloud_of(points)
