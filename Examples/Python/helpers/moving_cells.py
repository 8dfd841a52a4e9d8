"""A body that grows and turns, with cells of known brightness: volumes made by code, and where each cell is."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkStaticCellLocator

TURN = np.radians(4.0)  # of the body between two frames
GROWTH = 1.03  # of the body between two frames
RADII = np.array([15.0, 12.0, 10.0])  # in voxels
SIZE = 44, 36, 32
SPACING = 0.5, 0.5, 1.0


def rotation(step):
    """The rotation of the body at a time step, about an axis that is none of its own."""
    axis = np.array([0.3, 0.5, 0.8]) / np.linalg.norm([0.3, 0.5, 0.8])
    c = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(step * TURN) * c + (1.0 - np.cos(step * TURN)) * c @ c


def reach(directions):
    """Distance of the body's outside from that of an ellipsoid, as a factor: three lobes."""
    lobes = np.array([[0.9, 0.3, 0.3], [-0.6, 0.7, -0.4], [-0.2, -0.8, 0.5]])
    lobes /= np.linalg.norm(lobes, axis=1)[:, None]
    return 0.85 + 0.3 * np.exp((directions @ lobes.T - 1.0) / 0.08).sum(axis=1)


def cells(number=60):
    """Positions of cells on the body at the start, in voxels from its center."""
    directions = np.random.default_rng(4).normal(size=(number, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return RADII * directions * reach(directions)[:, None]


def positions_of_cells(step):
    """Coordinates of the cells at a time step, in the unit of the volume."""
    moved = GROWTH**step * cells() @ rotation(step).T + 0.5 * (np.array(SIZE) - 1.0)
    return moved * SPACING


def frame_of(step, channels=1):
    """A volume: cells of known brightness on an ellipsoid that grows and turns. slices x rows x columns x channels."""
    k, j, i = np.meshgrid(*(np.arange(n) for n in SIZE[::-1]), indexing="ij")
    positions = np.column_stack([i.ravel(), j.ravel(), k.ravel()]) - 0.5 * (np.array(SIZE) - 1.0)
    body = positions @ rotation(step) / GROWTH**step / RADII
    directions = body / np.linalg.norm(body, axis=1)[:, None].clip(1e-9)
    length = np.linalg.norm(body, axis=1) / reach(directions)
    places = cells() / RADII
    nearest = (directions @ (places / np.linalg.norm(places, axis=1)[:, None]).T).argmax(axis=1)
    brightness = 120.0 + 2.0 * nearest
    values = brightness / (1.0 + np.exp((length - 1.0) * RADII.min() * 2.0))
    values = values.reshape(SIZE[::-1]).astype(np.uint8)[..., None]
    return np.concatenate([values, *(channel * np.ones_like(values) for channel in range(1, channels))], axis=3)


def image_of(values, spacing=SPACING):
    """An image of slices x rows x columns x channels."""
    image = vtkImageData()
    image.SetDimensions(*values.shape[2::-1])
    image.SetSpacing(*spacing)
    image.GetPointData().SetScalars(numpy_to_vtk(values.reshape(-1, values.shape[3]), deep=True))
    image.GetPointData().GetScalars().SetName("Intensity")
    return image


def angles(a, b):
    """Angles between unit vectors."""
    return 2.0 * np.arcsin(np.clip(0.5 * np.linalg.norm(a - b, axis=1), 0.0, 1.0))


def sphere_positions(surface, positions):
    """Where the closest points of a surface are mapped to."""
    locator, found = vtkStaticCellLocator(), []
    locator.SetDataSet(surface.polydata)
    locator.BuildLocator()
    for position in positions:
        closest, cell = [0.0, 0.0, 0.0], reference(0)
        locator.FindClosestPoint(position, closest, cell, reference(0), reference(0.0))
        corners = surface.faces[int(cell)]
        a, b, c = surface.points[corners].astype(float)
        second, third = np.linalg.lstsq(np.column_stack([b - a, c - a]), closest - a, rcond=None)[0]
        found.append([1.0 - second - third, second, third] @ surface.sphere[corners])
    return np.array(found) / np.linalg.norm(found, axis=1)[:, None]
