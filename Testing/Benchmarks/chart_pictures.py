"""Pictures on texture coordinates: how exactly an image of a given number of texels shows a color that is a function of
the position, and how much colors differ at the two sides of a seam."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkProbeFilter

import conformalsom

from compare_smoothing import surface_of
from measure_textures import hits, shown

WAVES_ACROSS = 64  # periods along the square root of the area: 8 texels each in 512 x 512 texels without waste
SLOW_WAVES = 2  # periods that levels of 16 x 16 texels can show
GUTTER = 4  # texels around charts


def waves(points, size, across=WAVES_ACROSS):
    """Colors of points, in [0, 255]: waves along three axes."""
    axes = np.array(((1.0, 0.3, -0.5), (-0.4, 1.0, 0.6), (0.5, -0.6, 1.0)))
    axes /= np.linalg.norm(axes, axis=1)[:, None]
    return 127.5 + 110.0 * np.sin(2.0 * np.pi * across / size * (points @ axes.T))


def spread(count):
    """Directions spread evenly over the sphere, on a Fibonacci spiral."""
    z = 1.0 - (2.0 * np.arange(count) + 1.0) / count
    angle = np.pi * (3.0 - np.sqrt(5.0)) * np.arange(count)
    radius = np.sqrt(1.0 - z * z)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), z])


def texels(x, triangles, st, columns, rows):
    """Positions that the texels of an image show, and whether they show any. st is in [0, 1]."""
    flat = surface_of(np.column_stack([st, np.zeros(len(st))]), triangles)
    place = numpy_to_vtk(np.ascontiguousarray(x), deep=True)
    place.SetName("Place")
    flat.GetPointData().AddArray(place)
    grid = vtkImageData()
    grid.SetDimensions(columns, rows, 1)
    grid.SetSpacing(1.0 / columns, 1.0 / rows, 1.0)
    grid.SetOrigin(0.5 / columns, 0.5 / rows, 0.0)
    probe = vtkProbeFilter()
    probe.SetInputData(grid)
    probe.SetSourceData(flat)
    probe.SetCellLocatorPrototype(vtkStaticCellLocator())
    probe.ComputeToleranceOff()
    probe.SetTolerance(1e-12)
    probe.Update()
    data = probe.GetOutput().GetPointData()
    shows = vtk_to_numpy(data.GetArray(probe.GetValidPointMaskArrayName())).astype(bool)
    return (vtk_to_numpy(data.GetArray("Place")).reshape(rows, columns, 3), shows.reshape(rows, columns))


def with_gutter(pixels, shows):
    """Colors that continue around charts: means of the neighbors that have one."""
    pixels, shows = np.where(shows[..., None], pixels, 0.0), shows.copy()
    for _ in range(GUTTER):
        sums, counts = np.zeros_like(pixels), np.zeros(shows.shape)
        for axis, step in ((0, 1), (0, -1), (1, 1), (1, -1)):
            sums += np.roll(pixels * shows[..., None], step, axis)
            counts += np.roll(shows, step, axis)
        new = ~shows & (counts > 0)
        pixels[new] = sums[new] / counts[new][:, None]
        shows |= new
    return pixels


def picture(x, triangles, st, columns, rows, size, across=WAVES_ACROSS):
    """An image of the waves."""
    place, shows = texels(x, triangles, st, columns, rows)
    return with_gutter(waves(place.reshape(-1, 3), size, across).reshape(place.shape), shows)


def signal_to_noise(x, triangles, st, pixels, size, views=50, across=48):
    """Peak signal-to-noise ratio of views of the picture, bilinear [dB]."""
    place, triangle, weights = hits(surface_of(x, triangles), spread(views), across)
    found = shown(pixels, np.einsum("ik,ikj->ij", weights, st[triangles[triangle]]))
    return 10.0 * np.log10(255.0**2 / ((found - waves(place, size)) ** 2).mean())


def halved(pixels):
    """The next level of a mipmap: means of 2 x 2 texels."""
    rows, columns = pixels.shape[0] // 2 * 2, pixels.shape[1] // 2 * 2
    return pixels[:rows, :columns].reshape(rows // 2, 2, columns // 2, 2, 3).mean(axis=(1, 3))


def seam_steps(x, st, pixels, levels):
    """Mean difference of colors at the two sides of seams, for each level of the mipmap, in [0, 255]."""
    _, ids, counts = np.unique(np.round(x, 9), axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(ids.ravel(), kind="stable")
    ends = np.cumsum(counts)
    pairs = np.array([(order[end - 2], order[end - 1]) for end, count in zip(ends, counts) if count > 1])
    apart = np.linalg.norm(st[pairs[:, 0]] - st[pairs[:, 1]], axis=1) > 1e-6
    one, other = pairs[apart].T
    steps = []
    for _ in range(levels):
        steps.append(np.abs(shown(pixels, st[one]) - shown(pixels, st[other])).mean())
        pixels = halved(pixels)
    return steps


def baked(painted, size, side):
    """An image of slow waves by vtkSphericalTextureImage, whose margin shows what is beyond the seam."""
    surface = vtkPolyData()
    surface.ShallowCopy(painted)
    colors = numpy_to_vtk(waves(vtk_to_numpy(painted.GetPoints().GetData()), size, SLOW_WAVES), deep=True)
    colors.SetName("Waves")
    surface.GetPointData().SetScalars(colors)
    image = conformalsom.vtkSphericalTextureImage()
    image.SetInputData(surface)
    image.SetImageSize(side, side)
    image.Update()
    return vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).reshape(side, side, 3)
