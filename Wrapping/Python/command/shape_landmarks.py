"""Landmarks of shapes: points with equal names on all scans, at which the registered maps agree."""
import math

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPointLocator

from . import scan_files
from .scan_tables import rows_of

COLUMNS = ("scan", "name", "x", "y", "z")
POSITIONS = "LandmarkPositions"  # field data of a mean: #landmarks by 3 coordinates
FARTHEST = 0.05  # of the diagonal of the surface: a landmark at a larger distance belongs to another scan


def read_landmarks(path, names):
    """Landmarks of all scans: for each name of a scan #landmarks coordinates, sorted by the names of the landmarks.

    The file is a table with the columns scan, name, x, y and z. A scan may be called by its name or its file. Raises
    ValueError for an unsuitable table.
    """
    found = {name: {} for name in names}
    for number, name, (scan, landmark, *texts) in rows_of(path, COLUMNS, names):
        if not landmark:
            raise ValueError(f"{path}: row {number} has no name of a landmark")
        if landmark in found[name]:
            raise ValueError(f"{path}: {scan} has two rows of the landmark {landmark}")
        found[name][landmark] = position_of(path, number, texts)
    landmarks = sorted({landmark for positions in found.values() for landmark in positions})
    if not landmarks:
        raise ValueError(f"{path}: there are no landmarks")
    for name in names:
        missing = [landmark for landmark in landmarks if landmark not in found[name]]
        if missing:
            raise ValueError(f"{path}: {name} has no landmark {', '.join(missing[:5])}" +
                             (" and others" if missing[5:] else "") + "; all scans must have the same landmarks")
    return [tuple(found[name][landmark] for landmark in landmarks) for name in names]


def position_of(path, number, texts):
    """Three finite numbers of a row."""
    try:
        position = tuple(float(text) for text in texts)
    except ValueError:
        position = (math.nan,)
    if not all(map(math.isfinite, position)):
        raise ValueError(f"{path}: row {number}: x, y and z must be finite numbers, not {', '.join(texts)}")
    return position


def positions_on(surface, landmarks):
    """Landmarks of a scan's file in coordinates of its surface, from which a reader may have subtracted a vector."""
    return (np.array(landmarks) - scan_files.shift_of(surface)).tolist()


def nearest_points(surface, landmarks, scan, called="the surface"):
    """Ids of the points nearest to landmarks; raises ValueError for a landmark that is far from the surface."""
    locator = vtkPointLocator()
    locator.SetDataSet(surface)
    moved = positions_on(surface, landmarks)
    ids = [locator.FindClosestPoint(position) for position in moved]
    for position, place, point in zip(landmarks, moved, ids):
        distance = math.dist(place, surface.GetPoint(point))
        if distance > FARTHEST * surface.GetLength():
            raise ValueError(f"{scan}: the landmark at {position[0]:.9g}, {position[1]:.9g}, {position[2]:.9g} is {distance:.3g} "
                             f"from {called}; landmarks must have the coordinates of the scan's file")
    return ids


def add_to(registration, moving, fixed, step):
    """Give the landmarks of a step to a registration: of both surfaces, or of a surface and the mean."""
    of_moving, *of_fixed = step.landmarks
    nearest_points(moving, of_moving, step.scan)
    if of_fixed:
        nearest_points(fixed, of_fixed[0], step.scan, "the surface with which the scan is registered")
        targets = positions_on(fixed, of_fixed[0])
    else:
        targets = vtk_to_numpy(fixed.GetFieldData().GetArray(POSITIONS)).tolist()
    for position, target in zip(positions_on(moving, of_moving), targets):
        registration.AddLandmarkPosition(*position, *target)


def mean_positions(shape, surfaces, step, sphere):
    """The array of the landmarks' coordinates on the mean: where the maps of registered surfaces have them on average."""
    directions = sum(vtk_to_numpy(surface.GetPointData().GetArray(sphere))[nearest_points(surface, landmarks, step.scan)]
                     for surface, landmarks in zip(surfaces, step.landmarks))
    mapped = vtk_to_numpy(shape.GetPointData().GetArray(sphere))
    points = vtk_to_numpy(shape.GetPoints().GetData()).astype(float)
    array = numpy_to_vtk(points[np.argmax(directions @ mapped.T, axis=1)], deep=True)
    array.SetName(POSITIONS)
    return array
