"""Surfaces from points, by ConformalSOM and by other libraries.

Each function takes points and normals, n by 3, and further options. Where normals is None, the library estimates them.
Each returns positions and triangles of a surface.
"""
import numpy as np

import conformalsom

NEIGHBORS = 30  # from which normals are estimated


def learned(points, _normals):
    surface = conformalsom.learn(points)
    return surface.points.copy(), surface.faces.copy()


def learned_with_neurons(points, _normals, neurons):
    surface = conformalsom.learn(points, number_of_neurons=neurons)
    return surface.points.copy(), surface.faces.copy()


def learned_and_smoothed(points, _normals):
    surface = conformalsom.learn(points).smooth()
    return surface.points.copy(), surface.faces.copy()


def open3d_cloud(points, normals):
    import open3d  # pylint: disable=import-outside-toplevel
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    if normals is None:
        cloud.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(NEIGHBORS))
        cloud.orient_normals_consistent_tangent_plane(NEIGHBORS)
    else:
        cloud.normals = open3d.utility.Vector3dVector(normals)
    return cloud


def arrays_of(mesh):
    return np.array(mesh.vertices), np.array(mesh.triangles)


def open3d_poisson(points, normals, depth):
    import open3d  # pylint: disable=import-outside-toplevel
    cloud = open3d_cloud(points, normals)
    return arrays_of(open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(cloud, depth=depth)[0])


def open3d_ball_pivoting(points, normals):
    """Radii are 3 and 6 mean distances of nearest neighbors."""
    import open3d  # pylint: disable=import-outside-toplevel
    cloud = open3d_cloud(points, normals)
    radius = 3.0 * np.mean(cloud.compute_nearest_neighbor_distance())
    radii = open3d.utility.DoubleVector([radius, 2.0 * radius])
    return arrays_of(open3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, radii))


def pymeshlab_set(points, normals):
    """The cloud in pymeshlab. Where normals are estimated, the normal of the highest point is outward."""
    import pymeshlab  # pylint: disable=import-outside-toplevel
    meshes = pymeshlab.MeshSet()
    if normals is None:
        meshes.add_mesh(pymeshlab.Mesh(vertex_matrix=points))
        meshes.compute_normal_for_point_clouds(k=NEIGHBORS)
        normals = meshes.current_mesh().vertex_normal_matrix()
        normals = normals * (np.sign(normals[points[:, 2].argmax(), 2]) or 1.0)
        meshes.clear()
    meshes.add_mesh(pymeshlab.Mesh(vertex_matrix=points, v_normals_matrix=normals))
    return meshes


def pymeshlab_filter(points, normals, name, options):
    meshes = pymeshlab_set(points, normals)
    getattr(meshes, name)(**options)
    return meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()


def pymeshlab_poisson(points, normals, depth):
    """On one thread: threads that wait would count as time of the processor."""
    return pymeshlab_filter(points, normals, "generate_surface_reconstruction_screened_poisson",
                            {"depth": depth, "threads": 1})


def methods(depths):
    """Name, library, function, further arguments, and whether the method has normals, of each method."""
    yield "ConformalSOM, learn", "conformalsom", learned, (), False
    yield "ConformalSOM, learn and smooth", "conformalsom", learned_and_smoothed, (), False
    for depth in depths:
        yield f"Open3D, Poisson, depth {depth}", "open3d", open3d_poisson, (depth,), True
    yield "Open3D, ball pivoting", "open3d", open3d_ball_pivoting, (), True
    for depth in depths:
        yield f"pymeshlab, Poisson, depth {depth}", "pymeshlab", pymeshlab_poisson, (depth,), True
    for title, name in (("RIMLS", "generate_marching_cubes_rimls"), ("APSS", "generate_marching_cubes_apss")):
        yield f"pymeshlab, {title}", "pymeshlab", pymeshlab_filter, (name, {}), True
    yield ("pymeshlab, ball pivoting", "pymeshlab", pymeshlab_filter,
           ("generate_surface_reconstruction_ball_pivoting", {}), True)
