"""Texture coordinates of a closed mesh: charts of xatlas, and images of the sphere by ConformalSOM.

Columns of the table: charts, connected parts of the texture; seams, the length of all seams on the surface, divided by
the square root of its area; K, mean ratio of the largest to the smallest stretch of a triangle; angles, mean change of
an angle in degrees; areas, standard deviation of the logarithm of the ratio of areas; flipped, triangles that have no
area in the texture, or the orientation that fewer triangles of the chart have (charts may be mirrored); filled,
fraction of the texture that triangles cover; added, points added. Coincident points with equal texture coordinates are
no seam.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataEdgeConnectivityFilter

import conformalsom

from compare_smoothing import surface_of
from known_objects import facet_normals
from planar_distortion import planar_distortion
from separate_process import measured, missing, print_header, print_row, rounded

ASPECT = {"Octahedral": 1.0, "CubeMap": 1.5}  # width of the image divided by its height


def xatlas_charts(x, triangles):
    """Positions, triangles, texture coordinates in units of the image's height, and width divided by height."""
    import xatlas  # pylint: disable=import-outside-toplevel
    atlas = xatlas.Atlas()
    atlas.add_mesh(x.astype(np.float32), triangles.astype(np.uint32))
    atlas.generate()
    ids, cut, texture = atlas[0]
    return x[ids], cut.astype(np.int64), texture * (atlas.width / atlas.height, 1.0), atlas.width / atlas.height


def sphere_charts(x, triangles, balance, projection):
    """Positions, triangles, texture coordinates in units of the image's height, and width divided by height."""
    painted = conformalsom.vtkSphericalTextureMap()
    painted.SetInputData(conformalsom.conformal_map((x, triangles), area_balance=balance).polydata)
    getattr(painted, "SetProjectionTo" + projection)()
    painted.SplitSeamOn()
    painted.Update()
    surface = conformalsom.Surface(painted.GetOutput())
    texture = vtk_to_numpy(painted.GetOutput().GetPointData().GetTCoords())
    return surface.points.copy(), surface.faces.copy(), texture * (ASPECT[projection], 1.0), ASPECT[projection]


def charts_of(x, triangles):
    """For each triangle, the part connected by edges that it belongs to, an integer from 0 on."""
    parts = vtkPolyDataEdgeConnectivityFilter()
    parts.SetInputData(surface_of(x, triangles))
    parts.SetExtractionModeToAllRegions()
    parts.ColorRegionsOn()
    parts.Update()
    return vtk_to_numpy(parts.GetOutput().GetCellData().GetArray("RegionId"))


def welded(x, triangles, texture):
    """The same with each point once where several agree in position and in the texture, both to 1e-3."""
    for shift in (0.0, 0.5):  # twice, since equal numbers may be rounded to two neighbors
        keys = np.floor(1e3 * np.hstack([x, texture]) + shift + 0.25)
        _, first, ids = np.unique(keys, axis=0, return_index=True, return_inverse=True)
        x, triangles, texture = x[first], ids.ravel()[triangles], texture[first]
    return x, triangles, texture


def seams(x, triangles):
    """Half the length of all boundaries."""
    check = conformalsom.vtkGenusZeroCheck()
    check.SetInputData(surface_of(x, triangles))
    check.Update()
    one, other = vtk_to_numpy(check.GetOutput().GetFieldData().GetArray("BoundaryEdges")).T
    return 0.5 * np.linalg.norm(x[one] - x[other], axis=1).sum()


def methods():
    yield "xatlas", "xatlas", xatlas_charts, ()
    for projection in ASPECT:
        for balance in (0.0, 0.5, 1.0):
            yield (f"ConformalSOM, {projection}, AreaBalance {balance:g}", "conformalsom", sphere_charts,
                   (balance, projection))


def print_table(meshes):
    print_header("object", "triangles", "method", "charts", "seams", "K", "angles", "areas", "flipped", "filled",
                 "added", "seconds", "MB")
    for name, x, triangles in meshes:
        size = np.sqrt(0.5 * facet_normals(x, triangles)[1].sum())
        for method, library, function, further in methods():
            if missing([library]):
                continue
            (points, cut, texture, aspect), seconds, memory = measured(library, function, x, triangles, *further)
            joined, corners, _ = welded(points, cut, texture)
            charts = charts_of(joined, corners)
            k, angles, areas, flipped = planar_distortion(points, cut, texture, charts)
            u, v, w = (texture[cut[:, i]] for i in range(3))
            filled = 0.5 * np.abs(np.linalg.det(np.stack([v - u, w - u], axis=1))).sum()
            print_row(name, f"{len(triangles):,}", method, f"{charts.max() + 1:,}",
                      rounded(seams(joined, corners) / size), rounded(k), rounded(angles), rounded(areas), flipped,
                      f"{filled / aspect:.2f}", f"{len(points) - len(x):,}", f"{seconds:.1f}", f"{memory:,.0f}")
