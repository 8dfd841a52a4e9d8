"""Spherical harmonics of mapped meshes, by ConformalSOM and by pyshtools.

Maps are those of vtkGlobalConformalMap with AreaBalance 0.5. pyshtools solves a least-squares problem with a dense
matrix (SHExpandWLSQ), once for each coordinate. The weight of a point is the area around it.

Each object is expanded, and also the sum of its harmonics up to the degree, whose coefficients are known. Columns of
the table: distance, the root mean square distance between the points of the object and of the sum, weighted by area
(the object's largest radius is 1); error, the largest error of a coefficient, found for the sum; seconds and MB are for
the object.
"""
import numpy as np

import conformalsom

from known_objects import facet_normals
from map_methods import mapped
from separate_process import measured, missing, print_header, print_row, rounded

ORTHONORMAL = {"norm": 4, "csphase": 1}  # the convention of vtkSurfaceHarmonics


def point_areas(x, triangles):
    return np.bincount(triangles.ravel(), np.repeat(facet_normals(x, triangles)[1] / 6.0, 3), len(x))


def conformalsom_harmonics(x, triangles, sphere, degree):
    """Coefficients, (L + 1)^2 by 3 for degree L, by degree l, then by order from -l to l."""
    return conformalsom.Surface(mapped(x, triangles, sphere)).harmonics(degree).coefficients.copy()


def degrees_of(sphere):
    """Latitudes and longitudes in degrees."""
    return np.degrees(np.arcsin(np.clip(sphere[:, 2], -1.0, 1.0))), np.degrees(np.arctan2(sphere[:, 1], sphere[:, 0]))


def pyshtools_harmonics(x, triangles, sphere, degree):
    """Coefficients in the order of conformalsom_harmonics()."""
    from pyshtools.expand import SHExpandWLSQ  # pylint: disable=import-outside-toplevel
    weights, directions, columns = point_areas(x, triangles), degrees_of(sphere), []
    for values in x.T:
        c = SHExpandWLSQ(values, weights, *directions, degree, **ORTHONORMAL)[0]
        columns.append(np.concatenate([np.concatenate([c[1, l, l:0:-1], c[0, l, :l + 1]]) for l in range(degree + 1)]))
    return np.column_stack(columns)


def sums(coefficients, sphere):
    """Positions of points, n by 3, for directions n by 3."""
    heights = np.clip(sphere[:, 2], -1.0, 1.0)
    along, across = np.arctan2(sphere[:, 1], sphere[:, 0]), np.sqrt(1.0 - heights**2)
    degree, result = int(np.sqrt(len(coefficients))) - 1, np.zeros((len(sphere), 3))
    start = np.full(len(sphere), np.sqrt(0.25 / np.pi))  # of degree and order m
    for m in range(degree + 1):
        if m:
            start = start * across * np.sqrt((2.0 * m + 1.0) / (2.0 * m))
        before, legendre = np.zeros(len(sphere)), start
        scale = np.sqrt(2.0) if m else 1.0
        for l in range(m, degree + 1):
            if l > m:
                up = np.sqrt((4.0 * l * l - 1.0) / (l * l - m * m))
                down = np.sqrt(((l - 1.0)**2 - m * m) / (4.0 * (l - 1.0)**2 - 1.0))
                before, legendre = legendre, up * (heights * legendre - down * before)
            result += np.outer(scale * legendre * np.cos(m * along), coefficients[l * l + l + m])
            if m:
                result += np.outer(scale * legendre * np.sin(m * along), coefficients[l * l + l - m])
    return result


METHODS = {"ConformalSOM": ("conformalsom", conformalsom_harmonics), "pyshtools": ("pyshtools", pyshtools_harmonics)}


def print_table(meshes, degrees):
    print_header("object", "points", "L", "method", "distance", "error", "seconds", "MB")
    for name, x, triangles in meshes:
        sphere, areas = conformalsom.conformal_map((x, triangles), area_balance=0.5).sphere, point_areas(x, triangles)
        for degree in degrees:
            known = conformalsom_harmonics(x, triangles, sphere, degree)
            rebuilt = sums(known, sphere)
            for method, (library, function) in METHODS.items():
                if missing([library]):
                    continue
                found, seconds, memory = measured(library, function, x, triangles, np.array(sphere), degree)
                again = measured(library, function, rebuilt, triangles, np.array(sphere), degree)[0]
                squares = ((sums(found, sphere) - x)**2).sum(axis=1)
                print_row(name, f"{len(x):,}", degree, method, rounded(np.sqrt(np.average(squares, weights=areas))),
                          rounded(np.abs(again - known).max()), f"{seconds:.1f}", f"{memory:,.0f}")
