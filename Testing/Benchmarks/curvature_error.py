"""Root mean square difference of the mean curvatures of a surface and a reference. Own construction: the mean
curvature of triangles needs no derivative of vertex positions beyond normals, and its average over a disk is equally
defined on coarse and fine meshes.

    curvature_error.py    prints the curvature of an ellipsoid beside the exact curvature

The mean curvature of a surface with unit normal n is H = div(n) / 2. On a triangle, n is interpolated linearly from
unit normals at the vertices, n_i. With the facet normal N, the area A and the edges e_i opposite of the vertices,
H = sum_i n_i . (N x e_i) / (4 A). A vertex normal is the sum of (a x b) / (|a|^2 |b|^2) over the corners of the
vertex, whose edges are a and b (Max 1999); it is exact if the vertex and its neighbors lie on a sphere. At a random
sample of the surface, the mean of H over all triangles within the distance radius, weighted by area, is compared with
the same mean at the closest position of the reference. Triangles whose normals point away from the sample's normal
are left out, since they belong to another side of a thin part.
"""
import numpy as np
from vtkmodules.vtkCommonCore import reference, vtkIdList
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator, vtkStaticPointLocator

from helpers.clouds import cloud_of, points_of, vtk_points
from known_objects import Shape, ellipsoid, facet_normals, gradient, rms, spread, triangles_of

RADIUS, SAMPLES = 0.03, 3000


def vertex_normals(x, triangles):
    """Unit normals by Max (1999)."""
    result = np.zeros_like(x)
    for k in range(3):
        a, b = (x[triangles[:, (k + j) % 3]] - x[triangles[:, k]] for j in (1, 2))
        scale = (a**2).sum(axis=1) * (b**2).sum(axis=1)
        np.add.at(result, triangles[:, k], np.cross(a, b) / np.maximum(scale, 1e-300)[:, None])
    return result / np.maximum(np.linalg.norm(result, axis=1), 1e-300)[:, None]


class Curvature:
    """Mean curvature of a triangle mesh, averaged over disks."""

    def __init__(self, surface, radius=RADIUS):
        self.radius, x, triangles = radius, points_of(surface), triangles_of(surface)
        self.normals, doubled = facet_normals(x, triangles)
        self.areas = 0.5 * doubled
        normals = vertex_normals(x, triangles)
        self.mean = np.zeros(len(triangles))
        for k in range(3):
            edges = x[triangles[:, (k + 2) % 3]] - x[triangles[:, (k + 1) % 3]]
            self.mean += (normals[triangles[:, k]] * np.cross(self.normals, edges)).sum(axis=1)
        self.mean /= np.maximum(4.0 * self.areas, 1e-300)
        self.centroids = cloud_of(x[triangles].mean(axis=1))
        self.near = vtkStaticPointLocator()
        self.near.SetDataSet(self.centroids)
        self.near.BuildLocator()
        self.cells = vtkStaticCellLocator()
        self.cells.SetDataSet(surface)
        self.cells.BuildLocator()

    def at(self, position, triangle):
        """Average over the disk around a position in a triangle."""
        found = vtkIdList()
        self.near.FindPointsWithinRadius(self.radius, position, found)
        ids = np.array([found.GetId(k) for k in range(found.GetNumberOfIds())] or [triangle])
        weights = self.areas[ids] * (self.normals[ids] @ self.normals[triangle] > 0.0)
        return float(weights @ self.mean[ids] / max(weights.sum(), 1e-300))

    def closest(self, positions):
        """Averages at the closest positions of this surface."""
        cell, foot, result = vtkGenericCell(), [0.0] * 3, []
        triangle, part, square = reference(0), reference(0), reference(0.0)
        for position in positions:
            self.cells.FindClosestPoint(position, foot, cell, triangle, part, square)
            result.append(self.at(foot, int(triangle)))
        return np.array(result)


def curvature_error(surface, truth, samples=SAMPLES):
    """surface is a closed triangle mesh, and truth the Curvature of the reference. Both have outward normals."""
    model = Curvature(surface, truth.radius)
    x, _ = spread(points_of(surface), triangles_of(surface), samples, np.random.default_rng(1))
    return rms(model.closest(x) - truth.closest(x))


def main():
    shape, h = Shape("ellipsoid", 2000), 1e-3
    steps = h * np.eye(3)
    unit = lambda x: (lambda g: g / np.linalg.norm(g, axis=1)[:, None])(gradient(ellipsoid((1, 0.7, 0.5)), x))
    exact = sum((unit(shape.points + step) - unit(shape.points - step))[:, k] for k, step in enumerate(steps)) / (4 * h)
    print("mean curvature of the ellipsoid: rms", f"{rms(exact):.4f}, largest {exact.max():.4f}")
    for frequency in (36, 72, 150):
        mesh = shape.sphere(frequency)
        mesh.SetPoints(vtk_points(shape.parametrized(points_of(mesh))))
        for radius in (1e-9, 0.03):
            error = Curvature(mesh, radius).closest(shape.points) - exact
            print(f"{mesh.GetNumberOfPoints():8} vertices, radius {radius:7.2g}: rms error {rms(error):.4f}")


if __name__ == "__main__":
    main()
