#!/usr/bin/python3
"""vtkGlobalConformalMap in figures: the rows of Documentation/GlobalConformalMap.md that are of this project.

    measure_maps.py [MESH ...]

For each closed mesh, by each AreaBalance, the seconds, mean K, mean change of an angle, deviation of the logarithm of
areas, flipped triangles, and tier. Without meshes: shapes that are hard to map, made by code, for which the flipped
triangles count. PYTHONPATH is that of the build.
"""
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from compare_lattices import triangulated  # pylint: disable=wrong-import-position
from helpers import builtin_figure, paper_models  # pylint: disable=wrong-import-position
from conformalsom import (  # pylint: disable=wrong-import-position
    vtkConformalDistortion, vtkGeodesicSphereSource, vtkGlobalConformalMap)
from conformalsom.command import scan_files  # pylint: disable=wrong-import-position


def field(data, name):
    return data.GetFieldData().GetArray(name).GetValue(0)


def print_row(name, mesh, balance=0.0):
    """@return the flipped triangles."""
    gcm, distortion = vtkGlobalConformalMap(), vtkConformalDistortion()
    gcm.SetInputData(mesh)
    gcm.SetAreaBalance(balance)
    begin = time.perf_counter()
    mapped = paper_models.run(gcm)
    seconds = time.perf_counter() - begin
    distortion.SetInputData(mapped)
    measured = paper_models.run(distortion)
    flipped = field(measured, "NumberOfFlippedTriangles")
    print(f"{name:<44}{mesh.GetNumberOfPoints():>9,}{balance:>6g}{seconds:>9.3f}"
          f"{field(measured, 'MeanQuasiConformalError'):>10.4f}{field(measured, 'MeanAngleDistortion'):>9.3f}"
          f"{field(measured, 'AreaDistortionDeviation'):>8.3f}{flipped:>8}{field(mapped, 'SphereMapTier'):>6}",
          flush=True)
    return flipped


def sphere(frequency, place):
    """A geodesic sphere with its points put elsewhere; place takes and gives #P by 3."""
    source = vtkGeodesicSphereSource()
    source.SetFrequency(frequency)
    source.Update()
    mesh = vtkPolyData()
    mesh.DeepCopy(source.GetOutput())
    directions = vtk_to_numpy(mesh.GetPointData().GetArray("SpherePosition")).astype(float)
    mesh.GetPoints().SetData(numpy_to_vtk(np.ascontiguousarray(place(directions)), deep=True))
    mesh.GetPointData().Initialize()
    return mesh


def hard_shapes():
    random = np.random.RandomState(1)
    for noise in (0.01, 0.03, 0.1, 0.3):
        for frequency in (10, 20, 40):
            yield f"radial noise of {noise:g}", sphere(
                frequency, lambda n, s=noise: n * np.exp(s * random.standard_normal((len(n), 1))))
    for neck in (0.3, 0.1, 0.01, 0.001):
        yield f"neck of {neck:g} of the width", sphere(
            30, lambda n, w=neck: n * np.stack([w + n[:, 2]**2, w + n[:, 2]**2, np.ones(len(n))], axis=1))
    for length in (3, 10, 30):
        yield f"stretched {length} times", sphere(30, lambda n, k=length: n * (1.0, 1.0, k))
        yield f"flattened to 1 / {length}", sphere(30, lambda n, k=length: n * (1.0, 1.0, 1.0 / k))
    for limbs in (4, 10, 22):
        for length in (1.0, 3.0):
            at = random.standard_normal((limbs, 3))
            at /= np.linalg.norm(at, axis=1)[:, None]
            yield f"{limbs} limbs of length {length:g}", sphere(
                30, lambda n, a=at, l=length: n * (1.0 + l * np.exp(80.0 * (n @ a.T - 1.0)).sum(axis=1))[:, None])
    for turns in (1.0, 3.0, 10.0):
        def twisted(n, turns=turns):
            angle = turns * n[:, 2]
            x, y = n[:, 0], 0.4 * n[:, 1]
            return np.stack([np.cos(angle) * x - np.sin(angle) * y, np.sin(angle) * x + np.cos(angle) * y,
                             n[:, 2]], axis=1)
        yield f"twisted by {turns:g}", sphere(30, twisted)
    for frequency in (4, 8, 16, 32):
        yield "without a shape", sphere(frequency, lambda n: random.standard_normal(n.shape))
    for triangles in (20000, 5000, 1000, 300):
        yield f"bear thinned to {triangles:,} triangles", paper_models.decimated(
            triangulated(builtin_figure.figure_surface()), triangles)


def main():
    print(f"{'':<44}{'points':>9}{'areas':>6}{'seconds':>9}{'K':>10}{'angles':>9}{'area':>8}{'flips':>8}{'tier':>6}")
    for path in sys.argv[1:]:
        reader = scan_files.scan_reader(path)
        reader.Update()
        for balance in (0.0, 0.1, 0.25, 0.5, 0.75, 1.0):
            print_row(os.path.basename(path), triangulated(reader.GetOutput()), balance)
    if len(sys.argv) == 1:
        flips = [print_row(name, mesh) for name, mesh in hard_shapes()]
        print(f"{len(flips)} meshes, {sum(flips)} flipped triangles")


if __name__ == "__main__":
    main()
