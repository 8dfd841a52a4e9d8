#!/usr/bin/python3
"""What does an adaptive lattice make of an object's limbs that the geodesic one does not?

Spreads points over closed models (in any format that quickstart.py opens; default: a toy bear made
by code), learns each with both lattices, of as many neurons, and prints how well the meshes fit the
model and how good their triangles are. The conformal map of both is measured.
"""
import argparse
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from conformalsom import (
    vtkConformalDistortion, vtkConformalSOM, vtkCurvedSeamlessSurface, vtkGlobalConformalMap, vtkSurfaceMismatch)
from conformalsom.command import scan_files

from helpers import builtin_figure, clouds

LATTICES = ("Geodesic", "Adaptive")
COLUMNS = ("p2s", "s2p", "web %", "Hausdorff", "folds", "angle", "obtuse %", "K")
CUTS = (2, 3, 4)
OTHER_POINTS = 60000
OF_SURFACE = ("CSS p2s", "CSS s2p") + tuple(f"k = {k}" for k in CUTS) + tuple(f"others {k}" for k in CUTS)


def triangulated(model):
    triangles = vtkTriangleFilter()
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.SetInputData(model)
    triangles.Update()
    return triangles.GetOutput()


def spread(model, count, noise=0.0, seed=1):
    """Points evenly over the model's area, or its vertices for a count of 0; with Gaussian noise along
    each axis, whose standard deviation is a share of the model's largest radius."""
    random = np.random.RandomState(seed)
    vertices = vtk_to_numpy(model.GetPoints().GetData()).astype(float)
    points = builtin_figure.even_samples(model, count, random) if count else vertices
    if noise > 0.0:
        radius = np.linalg.norm(vertices - vertices.mean(axis=0), axis=1).max()
        points = points + noise * radius * random.standard_normal(points.shape)
    return clouds.cloud_of(points)


def learned(cloud, lattice, frequency):
    """The mesh in its conformal map, and the seconds it took."""
    network = vtkConformalSOM()
    network.SetInputData(cloud)
    getattr(network, "SetMeshTypeTo" + lattice)()
    network.SetNumberOfNeurons(10 * frequency**2 + 2)
    begin = time.perf_counter()
    network.Update()
    conformal = vtkGlobalConformalMap()
    conformal.SetInputConnection(network.GetOutputPort())
    conformal.Update()
    return conformal.GetOutput(), time.perf_counter() - begin


def mean_angle_and_obtuse(mesh):
    """Mean smallest angle in degrees, and the share of triangles with an angle above 90."""
    corners = corner_positions(mesh)
    angles = []
    for k in range(3):
        u = corners[:, (k + 1) % 3] - corners[:, k]
        v = corners[:, (k + 2) % 3] - corners[:, k]
        angles.append(np.arctan2(np.linalg.norm(np.cross(u, v), axis=1), (u * v).sum(axis=1)))
    degrees = np.degrees(angles)
    return degrees.min(axis=0).mean(), (degrees.max(axis=0) > 90.0).mean()


def fold_fraction(mesh):
    """Share of edges at which the normals of both triangles are more than 90 degrees apart."""
    triangles = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    corners = corner_positions(mesh)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    edges = np.sort(np.concatenate([triangles[:, [k, (k + 1) % 3]] for k in range(3)]), axis=1)
    order = np.lexsort((edges[:, 1], edges[:, 0])) % len(triangles)  # both sides of each edge
    return ((normals[order[::2]] * normals[order[1::2]]).sum(axis=1) < 0.0).mean()


def corner_positions(mesh):
    points = vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)
    return points[vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)]


def measured(mesh, model):
    """The columns by name."""
    mismatch = vtkSurfaceMismatch()
    mismatch.SetInputData(0, mesh)
    mismatch.SetInputData(1, model)
    mismatch.Update()
    distortion = vtkConformalDistortion()
    distortion.SetInputData(mesh)
    distortion.Update()

    def figure(measure, name):
        return measure.GetOutput().GetFieldData().GetArray(name).GetValue(0)

    angle, obtuse = mean_angle_and_obtuse(mesh)
    return dict(zip(COLUMNS, (
        figure(mismatch, "MeanSquarePointToSurface"), figure(mismatch, "MeanSquareSurfaceToPoint"),
        100.0 * figure(mismatch, "WebFraction"), figure(mismatch, "HausdorffDistance"),
        fold_fraction(mesh), angle, 100.0 * obtuse, figure(distortion, "MeanQuasiConformalError"))))


def surface_over(mesh, cuts=0):
    """The curved seamless surface over a mesh: its default, or every triangle cut into cuts x cuts."""
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputData(mesh)
    if cuts:
        surface.SetSamplingToNetwork()
        surface.SetSubdivisions(cuts)
    surface.Update()
    return surface.GetOutput()


def distances(surface, model):
    """p2s and s2p."""
    mismatch = vtkSurfaceMismatch()
    mismatch.SetInputData(0, surface)
    mismatch.SetInputData(1, model)
    mismatch.Update()
    data = mismatch.GetOutput().GetFieldData()
    return [data.GetArray(name).GetValue(0) for name in
            ("MeanSquarePointToSurface", "MeanSquareSurfaceToPoint")]


def measured_surfaces(mesh, model):
    """The columns of the surfaces over a mesh by name."""
    others = spread(model, OTHER_POINTS, seed=2)
    of_mesh, of_others = distances(mesh, model)[0], distances(mesh, others)[0]
    cut = {k: surface_over(mesh, k) for k in CUTS}
    return dict(zip(OF_SURFACE, distances(surface_over(mesh), model)
                    + [distances(cut[k], model)[0] / of_mesh for k in CUTS]
                    + [distances(cut[k], others)[0] / of_others for k in CUTS]))


def compared(model, frequency=36, count=40000, noise=0.0, surfaces=False):
    """The columns of both lattices, and the ratio of the seconds of Adaptive and Geodesic."""
    model = triangulated(model)
    cloud = spread(model, count, noise)
    rows, seconds = {}, []
    for lattice in LATTICES:
        mesh, taken = learned(cloud, lattice, frequency)
        rows[lattice] = measured(mesh, model)
        if surfaces:
            rows[lattice].update(measured_surfaces(mesh, model))
        seconds.append(taken)
    return rows, seconds[1] / seconds[0]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="*", help="closed models, default: a toy bear made by code")
    parser.add_argument("--frequency", type=int, default=36,
                        help="of the geodesic lattice, default 36; the other has as many neurons")
    parser.add_argument("--points", type=int, default=40000,
                        help="to learn from, default 40000; 0 for the model's vertices")
    parser.add_argument("--noise", type=float, default=0.0,
                        help="of the points: standard deviation along each axis, as a share of the "
                             "model's largest radius; default 0")
    parser.add_argument("--surfaces", action="store_true",
                        help="also measure the curved seamless surface over each mesh")
    args = parser.parse_args()
    if not 0.0 <= args.noise < 1.0:
        parser.error("--noise must be at least 0 and less than 1")
    models = scan_files.read_models(args.model)
    columns = COLUMNS + (OF_SURFACE if args.surfaces else ()) + (("of noise",) if args.noise > 0.0 else ())
    print(f"{'object':<24}{'mesh type':<10}" + "".join(f"{column:>11}" for column in columns))
    for name, model in (models or {"bear": builtin_figure.figure_surface()}).items():
        rows, ratio = compared(model, args.frequency, args.points, args.noise, args.surfaces)
        for lattice, row in rows.items():
            if args.noise > 0.0:
                row["of noise"] = np.sqrt(row["p2s"]) / args.noise
            print(f"{name:<24}{lattice:<10}" + "".join(f"{value:>11.3g}" for value in row.values()))
        print(f"{'':<24}Adaptive takes {ratio:.2f} of Geodesic's time")
    print("Lengths: the model's largest radius is 1. p2s, s2p: mean square distances of the model's\n"
          "vertices to the mesh, and of the mesh to the model. angle: mean smallest, in degrees. K: of\n"
          "the conformal map, 1 if angles are kept. of noise: the root of p2s, as a share of the noise.\n"
          "CSS: of the surface over the mesh; k: p2s over the mesh's, each triangle cut into k x k;\n"
          "others k: the same, of points even over the model's area that were not learned.")


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError) as error:
        sys.exit(f"compare_lattices: {error}")
