"""Objects whose surface is known, by an equation or by triangles, and points on them."""
import argparse
import os

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell, vtkStaticCellLocator

from conformalsom import vtkCurvedSeamlessSurface, vtkGeodesicSphereSource, vtkSurfaceMismatch
from conformalsom.command import scan_files

from helpers.clouds import points_of, vtk_points

BEND = 0.6  # radius to which the axis of the bean is bent
SCANS = {"igea": "igea-closed.ply", "bunny": "stanford-bunny-closed.ply", "armadillo": "armadillo.ply",
         "fandisk": "fandisk.obj", "spot": "spot.ply"}


def ellipsoid(axes):
    return lambda x: np.sqrt(((x / np.array(axes)) ** 2).sum(axis=1)) - 1.0


def superquadric(x):
    return ((np.abs(x) / np.array((1.0, 0.8, 0.6))) ** 4).sum(axis=1) ** 0.25 - 1.0


def bean(x):
    """An ellipsoid whose long axis is bent to a circle."""
    around, across = np.arctan2(x[:, 1], x[:, 0]), np.hypot(x[:, 0], x[:, 1])
    return ellipsoid((1.0, 0.3, 0.25))(np.column_stack([BEND * around, across - BEND, x[:, 2]]))


def bent(u):
    e = u * np.array((1.0, 0.3, 0.25))
    around, across = e[:, 0] / BEND, BEND + e[:, 1]
    return np.column_stack([across * np.cos(around), across * np.sin(around), e[:, 2]])


def radial(equation):
    return lambda u: u / (equation(u) + 1.0)[:, None]


EQUATIONS = {"sphere": ellipsoid((1, 1, 1)), "ellipsoid": ellipsoid((1, 0.7, 0.5)), "superquadric": superquadric,
             "bean": bean}


def gradient(equation, x, h=1e-5):
    steps = h * np.eye(3)
    return np.column_stack([(equation(x + step) - equation(x - step)) / (2 * h) for step in steps])


def triangles_of(surface):
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def facet_normals(x, triangles):
    normals = np.cross(x[triangles[:, 1]] - x[triangles[:, 0]], x[triangles[:, 2]] - x[triangles[:, 0]])
    lengths = np.linalg.norm(normals, axis=1)
    return normals / np.maximum(lengths, 1e-300)[:, None], lengths


def spread(x, triangles, count, random):
    """Random positions, uniform over the area, and the ids of their triangles."""
    areas = facet_normals(x, triangles)[1]
    ids = random.choice(len(triangles), count, p=areas / areas.sum())
    chosen = triangles[ids]
    u, v = np.sqrt(random.random((count, 1))), random.random((count, 1))
    return (1 - u) * x[chosen[:, 0]] + u * (1 - v) * x[chosen[:, 1]] + u * v * x[chosen[:, 2]], ids


class Shape:
    """An object known by an equation."""
    stride = 1  # of all positions, one in so many is measured

    def __init__(self, name, count):
        self.name, self.equation = name, EQUATIONS[name]
        sphere = self.sphere(60)
        self.points, _ = spread(self.parametrized(points_of(sphere)), triangles_of(sphere), count,
                                np.random.default_rng(5))
        for _ in range(4):
            g = gradient(self.equation, self.points)
            self.points -= (self.equation(self.points) / (g ** 2).sum(axis=1))[:, None] * g

    @staticmethod
    def sphere(frequency):
        source = vtkGeodesicSphereSource()
        source.SetFrequency(frequency)
        source.Update()
        return source.GetOutput()

    def parametrized(self, u):
        """The object's positions for positions u on the unit sphere."""
        return (bent if self.name == "bean" else radial(self.equation))(u)

    def mesh(self):
        """Triangles between 100,002 exact positions."""
        result = self.sphere(100)
        result.SetPoints(vtk_points(self.parametrized(points_of(result))))
        return result

    def distances(self, x):
        return self.equation(x) / np.linalg.norm(gradient(self.equation, x), axis=1)

    def normals(self, x):
        g = gradient(self.equation, x)
        return g / np.linalg.norm(g, axis=1)[:, None]


class Scan:
    """An object known by its triangles."""
    stride = 5

    def __init__(self, surface, count):
        self.surface = surface
        x, triangles = points_of(self.surface), triangles_of(self.surface)
        self.facets = facet_normals(x, triangles)[0]
        self.locator = vtkStaticCellLocator()
        self.locator.SetDataSet(self.surface)
        self.locator.BuildLocator()
        self.points, self.ids = spread(x, triangles, count, np.random.default_rng(5))

    @classmethod
    def read(cls, path, count):
        reader = scan_files.scan_reader(path)
        reader.Update()
        return cls(reader.GetOutput(), count)

    def mesh(self):
        return self.surface

    def closest(self, x):
        """Distances of positions from the object, and the triangles closest to them."""
        cell, foot = vtkGenericCell(), [0.0] * 3
        cell_id, part, square = reference(0), reference(0), reference(0.0)
        squares, ids = [], []
        for position in x:
            self.locator.FindClosestPoint(position, foot, cell, cell_id, part, square)
            squares.append(float(square))
            ids.append(int(cell_id))
        return np.sqrt(squares), ids

    def distances(self, x):
        return self.closest(x)[0]

    def normals(self, x):
        return self.facets[self.closest(x)[1]]


def angles(truth, x, normals):
    g = truth.normals(x)
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(normals, g), axis=1), (normals * g).sum(axis=1)))


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def largest_radius(x):
    return np.linalg.norm(x - x.mean(axis=0), axis=1).max()


def field_value(output, name):
    """Value of a field data array, or NaN if there is no such array."""
    array = output.GetFieldData().GetArray(name)
    return array.GetValue(0) if array else float("nan")


def mismatch(surface, reference_mesh):
    """off, p2s and normals: root mean square distance of the surface from the reference, mean square distance of the
    reference's vertices from the surface, and root mean square angle of the normals in degrees. The reference's
    largest radius is 1."""
    measure = vtkSurfaceMismatch()
    measure.SetInputData(0, surface)
    measure.SetReferenceData(reference_mesh)
    measure.SetNumberOfSamples(20000)
    measure.Update()
    off, p2s, normals = (field_value(measure.GetOutput(), name) for name in (
        "MeanSquareSurfaceToPoint", "MeanSquarePointToSurface", "RootMeanSquareNormalAngle"))
    return np.sqrt(off), p2s, normals


def smooth_surface(mesh):
    """The smooth surface over a learned mesh, by default properties."""
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputData(mesh)
    surface.Update()
    return surface.GetOutput()


def known_object(name, scans, count=0):
    """The object of this name with count points, by default 40,000 of an equation, 60,000 of a scan.

    scans is the folder of the files of SCANS.
    """
    if name in SCANS:
        return Scan.read(os.path.join(scans, SCANS[name]), count or 60000)
    if name in EQUATIONS:
        return Shape(name, count or 40000)
    raise ValueError(f"{name}: no such object; expected one of {', '.join([*EQUATIONS, *SCANS])}")


def parser_of_object(description):
    """A parser of arguments, with the name of an object and the folder of scans."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--object", default="armadillo", help="name of known_objects.py, default %(default)s")
    parser.add_argument("--scans", default="../shared/data", help="folder of the objects' files")
    return parser


def numbers(text):
    """Whole numbers that are separated by commas."""
    return [int(number) for number in text.split(",")]
