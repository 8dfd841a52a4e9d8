#!/usr/bin/python3
"""How much maps and harmonics depend on the triangles of a surface: a table of Documentation/GlobalConformalMap.md.

    measure_mesh_dependence.py MESH ...

For each closed mesh and each AreaBalance, the mean and the largest angle in degrees between the sphere positions of a
mesh and of its subdivision, in which each triangle is divided into four; the largest relative change of HarmonicPower up
to degree 12 between both; and the largest relative change of HarmonicPower if surface and map are rotated. PYTHONPATH
is that of the build.
"""
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersModeling import vtkLinearSubdivisionFilter

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from conformalsom import conformal_map, vtkSurfaceHarmonics  # pylint: disable=wrong-import-position
from conformalsom.command import scan_files  # pylint: disable=wrong-import-position

from known_objects import facet_normals, points_of, triangles_of  # pylint: disable=wrong-import-position

DEGREE = 12


def mapped(mesh, balance):
    return conformal_map(mesh, area_balance=balance).polydata


def sphere_of(surface):
    return vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition"))


def vertex_areas(x, triangles):
    areas = np.zeros(len(x))
    for k in range(3):
        np.add.at(areas, triangles[:, k], facet_normals(x, triangles)[1] / 6.0)
    return areas


def difference(surface, other):
    """Mean and largest angle between the maps of the points of a surface, which are the first of the other."""
    x, p = points_of(surface).astype(float), sphere_of(surface)
    q, areas = sphere_of(other)[:len(p)], vertex_areas(x, triangles_of(surface))
    u, _, v = np.linalg.svd((areas[:, None] * p).T @ q)
    rotation = u @ np.diag([1.0, 1.0, np.linalg.det(u @ v)]) @ v
    angles = np.degrees(np.arctan2(np.linalg.norm(np.cross(p @ rotation, q), axis=1), (p @ rotation * q).sum(axis=1)))
    return (areas * angles).sum() / areas.sum(), angles.max()


def power(surface):
    harmonics = vtkSurfaceHarmonics()
    harmonics.SetInputData(surface)
    harmonics.SetDegree(DEGREE)
    harmonics.Update()
    return vtk_to_numpy(harmonics.GetOutput().GetFieldData().GetArray("HarmonicPower"))[1:]


def rotated(surface):
    result = vtkPolyData()
    result.DeepCopy(surface)
    turn = np.linalg.qr(np.random.default_rng(1).standard_normal((2, 3, 3)))[0]
    result.GetPoints().SetData(numpy_to_vtk(points_of(surface).astype(float) @ turn[0], deep=True))
    sphere = numpy_to_vtk(sphere_of(surface) @ turn[1], deep=True)
    sphere.SetName("SpherePosition")
    result.GetPointData().AddArray(sphere)
    return result


def main():
    print("| mesh | points | AreaBalance | mean angle | largest angle | power | rotated |\n"
          "|---|---|---|---|---|---|---|")
    for path in sys.argv[1:]:
        reader = scan_files.scan_reader(path)
        reader.Update()
        mesh, divided = reader.GetOutput(), vtkLinearSubdivisionFilter()
        mesh.GetPoints().SetData(numpy_to_vtk(points_of(mesh).astype(float), deep=True))
        divided.SetInputData(mesh)
        divided.Update()
        for balance in (0.0, 0.25, 0.5, 1.0):
            one, other = mapped(mesh, balance), mapped(divided.GetOutput(), balance)
            mean, largest = difference(one, other)
            own = power(one)
            print(f"| {os.path.splitext(os.path.basename(path))[0]} | {mesh.GetNumberOfPoints():,} | {balance:g} | "
                  f"{mean:.2f} | {largest:.1f} | {np.abs(power(other) / own - 1.0).max():.4f} | "
                  f"{np.abs(power(rotated(one)) / own - 1.0).max():.0e} |", flush=True)


if __name__ == "__main__":
    main()
