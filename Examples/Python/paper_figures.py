#!/usr/bin/python3
"""Figures 7 to 11 of the paper, drawn by this project.

    paper_figures.py [--data DIR] [--output DIR] [--figures 7 8 9 10 11]

7 and 8: the meshes of CSM and GCM, the smooth surfaces of both, and the spherical parameterizations, with
the ears enlarged. 9 and 10: wood, checkerboard and a painted face. 11: a checkerboard by the map of Gu and
Yau on a mesh of obtuse triangles and on one of acute ones, and by CSM from nothing but the points.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from conformalsom import vtkSphericalTextureMap
from conformalsom.command import pictures
from conformalsom.command.steps import StepFailed

from helpers import opera_face, paper_models, textures

OUTPUT = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "..", "..", "build", "paper")
PANEL = (440, 480)  # pixels of a panel
ASPECT = PANEL[0] / PANEL[1]


def corners_of(mesh):
    return vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def points_of(mesh):
    return vtk_to_numpy(mesh.GetPoints().GetData()).astype(float)


def surface_of(points, corners):
    """A vtkPolyData of points and triangles."""
    surface, coordinates, cells = vtkPolyData(), vtkPoints(), vtkCellArray()
    coordinates.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    cells.SetData(3, numpy_to_vtkIdTypeArray(np.ascontiguousarray(corners, np.int64).ravel(), deep=True))
    surface.SetPoints(coordinates)
    surface.SetPolys(cells)
    return surface


def flat(mesh):
    """An actor of a mesh that shows its triangles."""
    actor = pictures.mesh_actor(mesh)
    actor.GetProperty().SetLineWidth(0.5)
    return actor


def painted(surface, image, view, up, **properties):
    """An actor of a surface with an image on it, seen from the direction view."""
    texture = vtkSphericalTextureMap()
    texture.SetInputData(surface)
    texture.SetViewDirection(view)
    texture.SetViewUp(up)
    texture.SplitSeamOn()
    for name, value in properties.items():
        getattr(texture, "Set" + name)(value)
    return pictures.textured_actor(paper_models.run(texture), image)


def on_the_sphere(mesh, around=None):
    """The mesh moved to its places on the sphere, with the normals it has in space, which show what
    is where. Enlarged so that the points of a list fill about the unit ball, if one is given."""
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SplittingOff()
    shaded = paper_models.run(normals)
    shading = vtk_to_numpy(shaded.GetPointData().GetNormals())
    sphere = vtk_to_numpy(mesh.GetPointData().GetArray("SpherePosition"))
    corners = corners_of(mesh)
    if around is not None:
        # In double precision, since floats cannot tell the ear's points apart.
        middle = sphere[around].mean(axis=0)
        middle /= np.linalg.norm(middle)
        size = np.quantile(np.linalg.norm(sphere[around] - middle, axis=1), 0.9)
        sphere = (sphere - middle) @ axes_at(middle) / size
        corners = corners[(np.abs(sphere[corners]) < 2.0).all(axis=(1, 2))]
        used, corners = np.unique(corners, return_inverse=True)
        sphere, shading = sphere[used], shading[used]
    result = surface_of(sphere, corners.reshape(-1, 3))
    result.GetPointData().SetNormals(numpy_to_vtk(np.ascontiguousarray(shading), deep=True))
    return result


def axes_at(place):
    """Columns east, north and outwards at a place of the sphere."""
    east = np.cross((0.02, 1.0, 0.01), place)
    east /= np.linalg.norm(east)
    return np.stack([east, np.cross(place, east), place], axis=1)


class Panels:
    """Panels of one figure, all showing the same model by the same camera but where said."""

    def __init__(self, model, view=None, up=None, **turn):
        self.view, self.up = view or model.view[0], up or model.view[1]
        self.camera = pictures.camera_on(
            model.mesh, self.view, self.up, ASPECT, **turn)
        self.scenes = []

    def add(self, actor, label, camera=None):
        letter = "abcdefgh"[len(self.scenes)]
        self.scenes.append(pictures.scene(actor, f"({letter}) {label}", camera or self.camera))

    def add_picture(self, image, label):
        letter = "abcdefgh"[len(self.scenes)]
        self.scenes.append(pictures.image_scene(image, f"({letter}) {label}", ASPECT))

    def write(self, folder, name, rows=1):
        path = os.path.join(folder, name + ".jpg")
        columns = len(self.scenes) // rows
        pictures.write_side_by_side(path, self.scenes, PANEL[0] * columns, PANEL[1] * rows, rows)
        print(os.path.relpath(path), flush=True)


class Gallery:
    """The models and, made once each, the surfaces of them."""

    def __init__(self, models):
        self.igea, self.bunny = models[0], models[-1]
        self.made = {}

    def make(self, name, what):
        if name not in self.made:
            self.made[name] = what()
        return self.made[name]

    def csm(self, model):
        """The learned mesh: geodesic as the paper's, but adaptive for the bunny, to have no web between the ears."""
        mesh_type = "Geodesic" if model is self.igea else "Adaptive"
        return self.make(("csm", model.name), lambda: paper_models.learned(model.more, mesh_type=mesh_type))

    def gcm(self, model):
        return self.make(("gcm", model.name), lambda: paper_models.mapped(model.few))

    def css(self, model):
        sampling = "Directions" if model is self.igea else "Network"
        return self.make(("css", model.name), lambda: paper_models.smooth(self.csm(model), sampling=sampling))

    def gcm_css(self, model):
        return self.make(("gcm css", model.name), lambda: paper_models.smooth(self.gcm(model)))

    def figure_7(self, folder):
        """Meshes and smooth surfaces of Igea."""
        panels = Panels(self.igea)
        panels.add(flat(self.csm(self.igea)), "CSM mesh")
        panels.add(flat(self.gcm(self.igea)), "GCM mesh")
        panels.add(pictures.actor_of(self.css(self.igea)), "CSS of the CSM mesh")
        panels.add(pictures.actor_of(self.gcm_css(self.igea)), "CSS of the GCM mesh")
        panels.write(folder, "figure_07")

    def figure_8(self, folder):
        """The bunny, and an ear of it on the sphere."""
        model = self.bunny
        panels = Panels(model)
        for mesh, css, name in ((self.csm(model), self.css(model), "CSM"),
                                (self.gcm(model), self.gcm_css(model), "GCM")):
            points = points_of(mesh)
            tip = points[(points @ np.array(model.view[1])).argmax()]
            ear = np.linalg.norm(points - tip, axis=1) < 0.25 * np.ptp(points, axis=0).max()
            place = vtk_to_numpy(mesh.GetPointData().GetArray("SpherePosition"))[ear].mean(axis=0)
            sphere, enlarged = on_the_sphere(mesh), on_the_sphere(mesh, ear)
            panels.add(flat(mesh), f"{name} mesh")
            panels.add(pictures.actor_of(css), f"CSS of the {name} mesh")
            panels.add(flat(sphere), f"{name} mesh on the sphere", pictures.camera_on(
                sphere, tuple(place), (0.02, 1, 0.01), ASPECT, azimuth=0, elevation=0))
            panels.add(flat(enlarged), "An ear there, enlarged", pictures.camera_on(
                enlarged, (0, 0, 1), (0, 1, 0), ASPECT, azimuth=0, elevation=0))
        panels.write(folder, "figure_08", rows=2)

    def figure_9(self, folder):
        """Wood, checkerboard and a painted face on the bunny."""
        model, css = self.bunny, self.css(self.bunny)
        panels = Panels(model)
        panels.add(painted(css, textures.wood(), *model.view, FieldOfView=240.0), "Wood")
        panels.add(painted(css, textures.checkerboard(), *model.view), "Checkerboard")
        self.add_face(panels, model, css)
        panels.write(folder, "figure_09")

    def figure_10(self, folder):
        """Checkerboard and a painted face on Igea."""
        model, css = self.igea, self.css(self.igea)
        panels = Panels(model)
        board = painted(css, textures.checkerboard(), *model.view)
        panels.add(board, "Checkerboard")
        panels.add(board, "Checkerboard, from the side", pictures.camera_on(
            model.mesh, model.view[0], model.view[1], ASPECT, azimuth=-50))
        self.add_face(panels, model, css)
        panels.write(folder, "figure_10")

    @staticmethod
    def add_face(panels, model, css):
        """A painted face by itself, and on the model's own."""
        image, face = opera_face.opera_face(), model.face
        panels.add_picture(image, "A painted face")
        actor = painted(css, image, face.view, model.view[1], UseViewPoint=True,
                        ViewPoint=face.middle, FieldOfView=face.field_of_view)
        panels.add(actor, "The face on the CSS", pictures.camera_on(
            model.mesh, face.view, model.view[1], ASPECT))

    def figure_11(self, folder):
        """A checkerboard by Gu and Yau's map on obtuse and acute triangles, and by CSM, on each model."""
        board = textures.checkerboard()
        models = list(dict.fromkeys((self.igea, self.bunny)))
        panels = Panels(self.igea)
        for model in models:
            camera = pictures.camera_on(model.mesh, model.view[0], model.view[1], ASPECT)
            for mesh, label in ((obtuse(model.few), "obtuse"), (self.csm(model), "acute")):
                panels.add(painted(paper_models.mapped(mesh, "GuYau"), board, *model.view),
                           f"GCM (Gu-Yau) of {label} triangles", camera)
            panels.add(painted(self.css(model), board, *model.view), "CSS of the CSM mesh", camera)
        panels.write(folder, "figure_11", rows=len(models))


def obtuse(mesh):
    """Every triangle cut into three at its middle, where they have angles of about 120 degrees."""
    points, corners = points_of(mesh), corners_of(mesh)
    middle = len(points) + np.arange(len(corners))
    parts = [np.stack([corners[:, k], corners[:, (k + 1) % 3], middle], axis=1) for k in range(3)]
    return surface_of(np.vstack([points, points[corners].mean(axis=1)]), np.vstack(parts))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", metavar="DIR", default=paper_models.DATA,
                        help="folder with igea.ply and stanford-bunny.obj; default: the variable "
                             "CONFORMALSOM_SCAN_DIR, else the current folder")
    parser.add_argument("--output", metavar="DIR", default=OUTPUT,
                        help="folder for the pictures, default build/paper")
    parser.add_argument("--figures", type=int, nargs="+", choices=range(7, 12),
                        default=range(7, 12), help="which to draw, default all")
    arguments = parser.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    gallery = Gallery(paper_models.models(arguments.data))
    failed = []
    for number in arguments.figures:
        try:
            getattr(gallery, f"figure_{number}")(arguments.output)
        except StepFailed as error:
            failed.append(f"figure {number}: {error}")
    if failed:
        raise StepFailed("; ".join(failed))


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, ValueError, OSError) as error:
        sys.exit(f"paper_figures: {error}")
