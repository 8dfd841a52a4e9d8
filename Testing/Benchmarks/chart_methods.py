"""Texture coordinates of a closed mesh: charts of xatlas, and images of the sphere by ConformalSOM.

Columns of the table: charts, connected parts of the texture; seams, the length of all seams on the surface, divided by
the square root of its area; K, mean ratio of the largest to the smallest stretch of a triangle; angles, mean change of
an angle in degrees; areas, standard deviation of the logarithm of the ratio of areas; flipped, triangles that have no
area in the texture, or the orientation that fewer triangles of the chart have (charts may be mirrored); filled,
fraction of the texture that triangles cover; added, points added; L2 and Linf, stretch of Sander et al. (2001), 1 is
the best; dB, peak signal-to-noise ratio of 50 views, of images with as many texels as one of 512 x 512 and 1024 x 1024,
that are baked and shown in the same way for all methods (chart_pictures.py), with gutters of 4 texels. Coincident points with equal texture coordinates are
no seam.
"""
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataEdgeConnectivityFilter

import conformalsom

import chart_pictures
from compare_smoothing import surface_of
from known_objects import facet_normals
from planar_distortion import planar_distortion, stretch
from separate_process import measured, missing, print_header, print_row, rounded

SIDES = (512, 1024)  # of images with as many texels
ASPECT = {"Octahedral": 1.0, "CubeMap": 1.5}  # width of the image divided by its height


def xatlas_charts(x, triangles):
    """Positions, triangles, texture coordinates in units of the image's height, and width divided by height."""
    import xatlas  # pylint: disable=import-outside-toplevel
    atlas, packing = xatlas.Atlas(), xatlas.PackOptions()
    atlas.add_mesh(x.astype(np.float32), triangles.astype(np.uint32))
    packing.padding, packing.resolution = chart_pictures.GUTTER, SIDES[-1]
    atlas.generate(pack_options=packing)
    ids, cut, texture = atlas[0]
    return x[ids], cut.astype(np.int64), texture * (atlas.width / atlas.height, 1.0), atlas.width / atlas.height


def sphere_charts(x, triangles, balance, projection):
    """Positions, triangles, texture coordinates in units of the image's height, and width divided by height."""
    painted = conformalsom.vtkSphericalTextureMap()
    painted.SetInputData(conformalsom.conformal_map((x, triangles), area_balance=balance).polydata)
    getattr(painted, "SetProjectionTo" + projection)()
    painted.SetMargin(chart_pictures.GUTTER / SIDES[-1])
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
                 "added", "L2", "Linf", *(f"dB {side}" for side in SIDES), "seconds", "MB")
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
            st, decibels = texture / (aspect, 1.0), []
            for side in SIDES:
                shape = round(side * aspect**0.5), round(side / aspect**0.5)
                pixels = chart_pictures.picture(points, cut, st, *shape, size)
                decibels.append(chart_pictures.signal_to_noise(points, cut, st, pixels, size))
            print_row(name, f"{len(triangles):,}", method, f"{charts.max() + 1:,}",
                      rounded(seams(joined, corners) / size), rounded(k), rounded(angles), rounded(areas), flipped,
                      f"{filled / aspect:.2f}", f"{len(points) - len(x):,}",
                      *map(rounded, stretch(points, cut, texture)), *(f"{value:.1f}" for value in decibels),
                      f"{seconds:.1f}", f"{memory:,.0f}")


LEVELS = 6


def print_seams(meshes):
    """Mean difference of colors at the two sides of seams, in [0, 255], at each level of a mipmap."""
    print_header("object", "method", "margin", *(f"level {level}" for level in range(LEVELS)))
    side = SIDES[-1]
    for name, x, triangles in meshes:
        size = np.sqrt(0.5 * facet_normals(x, triangles)[1].sum())
        if not missing(["xatlas"]):
            points, cut, texture, aspect = xatlas_charts(x, triangles)
            st, shape = texture / (aspect, 1.0), (round(side * aspect**0.5), round(side / aspect**0.5))
            pixels = chart_pictures.picture(points, cut, st, *shape, size, chart_pictures.SLOW_WAVES)
            steps = chart_pictures.seam_steps(points, st, pixels, LEVELS)
            print_row(name, "xatlas", f"{chart_pictures.GUTTER} texels", *(f"{step:.2f}" for step in steps))
        mapped = conformalsom.conformal_map((x, triangles), area_balance=0.5).polydata
        for margin in (0.0, 0.01, 0.03):
            painted = conformalsom.vtkSphericalTextureMap()
            painted.SetInputData(mapped)
            painted.SetProjectionToOctahedral()
            painted.SetMargin(margin)
            painted.SplitSeamOn()
            painted.Update()
            surface = painted.GetOutput()
            steps = chart_pictures.seam_steps(
                vtk_to_numpy(surface.GetPoints().GetData()), vtk_to_numpy(surface.GetPointData().GetTCoords()),
                chart_pictures.baked(surface, size, side), LEVELS)
            print_row(name, "ConformalSOM, Octahedral, AreaBalance 0.5", f"{margin * side:.0f} texels",
                      *(f"{step:.2f}" for step in steps))
