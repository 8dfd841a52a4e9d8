"""A depth camera that looks at an object from several sides.

The images of the camera have quantized depth, and noise that grows with distance and angle. The formulas follow the
measurements of one camera by C. V. Nguyen, S. Izadi, D. Lovell, "Modeling Kinect sensor noise for improved 3D
reconstruction and tracking", 3DIMPVT (2012).
"""
import numpy as np
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonDataModel import vtkGenericCell

DISTANCE = 3.0  # from the camera to the object's center; the object's largest radius is 1
MOST_GRAZING = np.radians(80.0)  # angle of ray and normal above which a camera returns no depth
VIEWS = 8


def directions():
    """Unit vectors to the cameras: six around the object, alternately raised and lowered by 20 degrees; two on y."""
    around, raised = np.radians(60.0 * np.arange(6)), np.radians(20.0) * (-1.0) ** np.arange(6)
    ring = np.column_stack([np.cos(around) * np.cos(raised), np.sin(raised), np.sin(around) * np.cos(raised)])
    return np.vstack([ring, [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]]])


def pixels(view, pitch):
    """Directions of rays through an image of pixels whose edge is pitch at the center of the object."""
    across = np.cross(view, (1.0, 0.0, 0.0) if abs(view[0]) < 0.7 else (0.0, 0.0, 1.0))
    across /= np.linalg.norm(across)
    half = 1.0 / np.sqrt(1.0 - 1.0 / DISTANCE**2)  # the object's silhouette is inside of this radius
    steps = np.arange(-half, half, pitch) + 0.5 * pitch
    u, v = (grid.ravel()[:, None] for grid in np.meshgrid(steps, steps))
    rays = u * across + v * np.cross(view, across) - DISTANCE * view
    return rays[np.hypot(u, v)[:, 0] <= half] / DISTANCE


def image(locator, normals, view, pitch):
    """Rays that hit the object, their depths, the angles of ray and normal in radians, and the ids of triangles.

    A ray from the camera to depth z ends at DISTANCE * view + z * ray.
    """
    camera, rays = DISTANCE * view, pixels(view, pitch)
    hit, part, cell_id, cell = [0.0] * 3, [0.0] * 3, reference(0), vtkGenericCell()
    way, sub, kept, depths, angles, ids = reference(0.0), reference(0), [], [], [], []
    for ray in rays:
        if locator.IntersectWithLine(camera, camera + 2.0 * DISTANCE * ray, 1e-9, way, hit, part, sub, cell_id, cell):
            cosine = abs(float(normals[int(cell_id)] @ ray)) / np.linalg.norm(ray)
            kept.append(ray)
            depths.append(2.0 * DISTANCE * float(way))
            angles.append(np.arccos(min(cosine, 1.0)))
            ids.append(int(cell_id))
    angles = np.array(angles)
    seen = angles < MOST_GRAZING
    return np.array(kept)[seen], np.array(depths)[seen], angles[seen], np.array(ids)[seen]


def scanned(locator, normals, count, noise, random):
    """Count points of all images, their true positions, and the normals there.

    locator is a vtkStaticCellLocator of a closed triangle mesh around the origin with largest radius 1, and normals
    has the unit normal of each triangle. noise is the standard deviation of the depth at the distance of the center,
    for a ray along the normal. One quantization step is 2 noise at this distance, and grows with the squared distance.
    """
    views = directions()
    coarse = sum(len(image(locator, normals, view, 0.06)[1]) for view in views)
    pitch = 0.06 * np.sqrt(coarse / (1.04 * count))
    points, exact, there = [], [], []
    for view in views:
        rays, depths, angles, ids = image(locator, normals, view, pitch)
        deviation = noise * (depths / DISTANCE)**2 * (1.0 + 0.05 * angles**2 / (0.5 * np.pi - angles)**2)
        found = depths + deviation * random.standard_normal(len(depths))
        if noise > 0.0:
            step = 2.0 * noise / DISTANCE**2  # of the disparity, 1 / depth
            found = 1.0 / (step * np.round(1.0 / (step * found)))
        exact.append(DISTANCE * view + depths[:, None] * rays)
        points.append(DISTANCE * view + found[:, None] * rays)
        there.append(normals[ids])
    points, exact, there = map(np.vstack, (points, exact, there))
    kept = np.sort(random.permutation(len(points))[:count])
    return points[kept], exact[kept], there[kept]
