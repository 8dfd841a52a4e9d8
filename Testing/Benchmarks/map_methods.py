"""Maps of a closed mesh: to the sphere by ConformalSOM, to the plane by libigl and potpourri3d.

libigl's maps are those of the mesh without its most equilateral triangle, whose corners have fixed positions in the
plane. With this boundary, harmonic and least-squares conformal maps (lscm) minimize the same energy. If only two points
were fixed, lscm would be far from conformal. An inverse stereographic projection takes the plane to the sphere.
potpourri3d's logarithmic map preserves distances from one point; it is not a conformal map.

Columns of the table: K, mean ratio of the largest to the smallest stretch of a triangle; angles, mean change of an
angle in degrees; areas, standard deviation of the logarithm of the ratio of areas; flipped, triangles that are flipped
or have no area. Those of the plane are measured in the plane, those of the sphere by vtkConformalDistortion.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk

import conformalsom

from compare_smoothing import surface_of
from known_objects import field_value
from planar_distortion import corner_angles, planar_distortion
from separate_process import measured, missing, print_header, print_row, rounded


def sphere_map(x, triangles, balance):
    return conformalsom.conformal_map((x, triangles), area_balance=balance).sphere.copy()


def without_one(x, triangles):
    """The other triangles, the corners of the most equilateral triangle, and positions of its corners in the plane."""
    a, b, c = (x[triangles[:, k]] for k in range(3))
    chosen = np.abs(corner_angles(a, b, c) - 60.0).max(axis=1).argmin()
    at = np.array([[0.0, 0.0], [1.0, 0.0], [0.5, -np.sqrt(0.75)]])  # clockwise: the others are inside
    return np.delete(triangles, chosen, axis=0), triangles[chosen], at


def harmonic_map(x, triangles):
    import igl  # pylint: disable=import-outside-toplevel
    others, corners, at = without_one(x, triangles)
    return igl.harmonic(x, others, corners, at, 1)


def least_squares_conformal_map(x, triangles):
    import igl  # pylint: disable=import-outside-toplevel
    others, corners, at = without_one(x, triangles)
    return igl.lscm(x, others, corners, at)[0]


def logarithmic_map(x, triangles):
    import potpourri3d  # pylint: disable=import-outside-toplevel
    return potpourri3d.MeshVectorHeatSolver(x, triangles).compute_log_map(0)


def stereographic(plane):
    """Positions on the sphere. Half of all points are on each hemisphere."""
    plane = plane - np.median(plane, axis=0)
    z = plane / np.median(np.linalg.norm(plane, axis=1))
    squares = (z**2).sum(axis=1)[:, None]
    return np.hstack([2.0 * z, squares - 1.0]) / (squares + 1.0)


def mapped(x, triangles, sphere):
    """A vtkPolyData with a map to the sphere."""
    surface, array = surface_of(x, triangles), numpy_to_vtk(np.ascontiguousarray(sphere), deep=True)
    array.SetName("SpherePosition")
    surface.GetPointData().AddArray(array)
    return surface


def spherical_distortion(x, triangles, sphere):
    """The measures of planar_distortion() on the sphere."""
    distortion = conformalsom.vtkConformalDistortion()
    distortion.SetInputData(mapped(x, triangles, sphere))
    distortion.Update()
    return [field_value(distortion.GetOutput(), name) for name in (
        "MeanQuasiConformalError", "MeanAngleDistortion", "AreaDistortionDeviation", "NumberOfFlippedTriangles")]


def methods():
    """Name, library, function, further arguments, and whether the map is to the sphere, of each method."""
    for balance in (0.0, 0.5):
        yield f"ConformalSOM, AreaBalance {balance:g}", "conformalsom", sphere_map, (balance,), True
    yield "libigl, harmonic", "igl", harmonic_map, (), False
    yield "libigl, lscm", "igl", least_squares_conformal_map, (), False
    yield "potpourri3d, logarithmic map", "potpourri3d", logarithmic_map, (), False


def print_table(meshes):
    print_header("object", "triangles", "method", "onto", "K", "angles", "areas", "flipped", "seconds", "MB")
    for name, x, triangles in meshes:
        for method, library, function, further, spherical in methods():
            if missing([library]):
                continue
            found, seconds, memory = measured(library, function, x, triangles, *further)
            measures = {"sphere": spherical_distortion(x, triangles, found)} if spherical else {
                "plane": planar_distortion(x, triangles, found)}
            if library == "igl":
                measures = {"plane": planar_distortion(x, without_one(x, triangles)[0], found),
                            "sphere": spherical_distortion(x, triangles, stereographic(found))}
            for onto, (k, angles, areas, flipped) in measures.items():
                print_row(name, f"{len(triangles):,}", method, onto, rounded(k), rounded(angles), rounded(areas),
                          int(flipped), f"{seconds:.2f}", f"{memory:,.0f}")
