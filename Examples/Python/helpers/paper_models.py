"""The models of the paper's Section 4, and the surfaces made of them.

Igea and the bunny are read from a folder with igea.ply and stanford-bunny-closed.ply (or
stanford-bunny.obj, whose holes are then filled); where they are missing, the built-in bear stands in.
"""
import os

from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkFiltersCore import (
    vtkCleanPolyData, vtkPolyDataNormals, vtkQuadricDecimation, vtkTriangleFilter)
from vtkmodules.vtkFiltersModeling import vtkFillHolesFilter
from vtkmodules.vtkIOGeometry import vtkOBJReader

import conformalsom
from conformalsom import vtkConformalPLYReader, vtkConformalSOM, vtkCurvedSeamlessSurface
from conformalsom.command.steps import StepFailed
from . import builtin_figure, clouds

DATA = os.environ.get("CONFORMALSOM_SCAN_DIR", os.curdir)

FREQUENCY, SURFACE_FREQUENCY = 36, 80  # 12,962 and 64,002 points, as in Table 1
FEW = 25922                            # triangles of X_few, 12,963 points


def run(*filters):
    """Run filters one into the other; the output of the last. An error becomes an exception.

    Warnings are not shown: they tell what the tables show anyway.
    """
    messages = []

    @calldata_type(VTK_STRING)
    def keep(_, event, text):
        if event == "ErrorEvent":
            messages.append(text.split("): ", 1)[-1].strip().partition("\n")[0])

    for before, after in zip(filters, filters[1:]):
        after.SetInputConnection(before.GetOutputPort())
    for algorithm in filters:
        for source in (algorithm, algorithm.GetExecutive()):
            source.AddObserver("ErrorEvent", keep)
            source.AddObserver("WarningEvent", keep)
    filters[-1].Update()
    if messages:
        raise StepFailed(messages[0])
    return filters[-1].GetOutput()


def read(path):
    """A model's triangles from a PLY or OBJ file."""
    reader = vtkOBJReader() if path.endswith(".obj") else vtkConformalPLYReader()
    reader.SetFileName(path)
    return run(reader)


def closed(mesh):
    """The mesh without unused points and with its holes filled."""
    source, clean = vtkTriangleFilter(), vtkCleanPolyData()
    source.SetInputData(mesh)
    holes, normals = vtkFillHolesFilter(), vtkPolyDataNormals()
    holes.SetHoleSize(1e30)
    normals.SplittingOff()
    normals.ComputePointNormalsOff()
    return run(source, clean, holes, normals)


def decimated(mesh, triangles):
    """The mesh thinned to so many triangles, its vertices put where they keep its shape best."""
    decimation = vtkQuadricDecimation()
    decimation.SetInputData(mesh)
    decimation.SetTargetReduction(max(0.0, 1.0 - triangles / mesh.GetNumberOfPolys()))
    return run(decimation)


class Face:
    """Where a model has its face: what the middle of a painted one touches, seen from where."""

    def __init__(self, middle, view, field_of_view):
        self.middle, self.view, self.field_of_view = middle, view, field_of_view


class Model:
    """A scan: X_more, its closed mesh, and X_few, which the paper's methods learn from."""

    view = (0, 0, 1), (0, 1, 0)  # from the model to the viewer, and up

    def __init__(self, name, more, mesh, face):
        self.name, self.more, self.mesh, self.face = name, more, mesh, face
        self.published = PUBLISHED.get(name, {})
        self.few = decimated(mesh, FEW)


# What the paper prints, by the names of the rows below.
PUBLISHED = {
    "Igea": {"X_few": 8.0370e-5, "CSM": 1.4169e-5, "GCM": 1.4860e-5},
    "bunny": {"X_few": 1.089e-4, "CSM": 5.2631e-5, "GCM": 0.0128},
}


def models(folder):
    """Igea and the bunny from a folder; the bear for what is not there."""
    found = []
    igea = os.path.join(folder, "igea.ply")
    if os.path.isfile(igea):
        scan = read(igea)
        found.append(Model("Igea", scan, scan, Face((0.002, -0.005, 0.048), (0, 0, 1), 150.0)))
    bunny = os.path.join(folder, "stanford-bunny.obj")
    if os.path.isfile(bunny):
        scan = read(bunny)
        whole = os.path.join(folder, "stanford-bunny-closed.ply")
        mesh = read(whole) if os.path.isfile(whole) else closed(scan)
        found.append(Model("bunny", scan, mesh, Face((-0.091, 0.133, 0.0187), (-1, 0, 0.4), 90.0)))
    if not found:
        print(f"No igea.ply or stanford-bunny.obj in {folder}: the built-in bear stands in.\n")
        mesh = builtin_figure.figure_surface()
        found.append(Model("bear", mesh, mesh, Face((0.0, 0.55, 0.6), (0, 0, 1), 120.0)))
    return found


def learned(points, mode="Batch", reference="Automatic", mesh_type="Geodesic", frequency=FREQUENCY):
    """A mesh learned from points by CSM, or by the plain SOM where reference is Winner."""
    network = vtkConformalSOM()
    network.SetInputData(clouds.only_points_of(points))
    getattr(network, f"SetMeshTypeTo{mesh_type}")()
    network.SetNumberOfNeurons(10 * frequency**2 + 2)
    getattr(network, f"SetTrainingModeTo{mode}")()
    getattr(network, f"SetReferencePointTo{reference}")()
    return run(network)


def mapped(mesh, method="Robust"):
    """A closed mesh with its global conformal map, by Gu and Yau's descent or our robust method."""
    if not hasattr(conformalsom, "vtkGlobalConformalMap"):
        raise StepFailed("this build has no vtkGlobalConformalMap")
    gcm = conformalsom.vtkGlobalConformalMap()
    gcm.SetInputData(mesh)
    getattr(gcm, f"SetMethodTo{method}")()
    return run(gcm)


def smooth(mesh, as_published=False, sampling="Directions", frequency=SURFACE_FREQUENCY):
    """The curved seamless surface of a mapped mesh, by default in even directions as the paper's."""
    surface = vtkCurvedSeamlessSurface()
    surface.SetInputData(mesh)
    getattr(surface, f"SetSamplingTo{sampling}")()
    surface.SetFrequency(frequency)
    if as_published:
        surface.SetSeamModeToPerTriangle()
        surface.SetDomeHeightToPublished()
    return run(surface)
