"""Draws what lies between closed models: steps of a morph, or the mean of them all.

Each model is mapped to the sphere, and the maps are made to correspond: those of two models by registering
the second with the first, those of many by registering all with their mean, by landmarks or by shape alone
(--automatic). With neither, they are only turned: the points that are farthest out in 26 directions come
together, for which the models must be posed alike. Steps have the first model's stripes fade into the second one's color.
Without models: a toy bear and a dancer, made by code.
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

from helpers import builtin_figure, mapped_models
from conformalsom import (
    vtkConsistentRemesh, vtkGlobalConformalMap, vtkSphericalMorph, vtkSphericalRegistration,
    vtkSphericalResample, vtkSphericalTemplate)
from conformalsom.command import pictures, scan_files

BUILTIN = {"bear": builtin_figure.bear, "dancer": builtin_figure.dancer}
CLAY, CREAM, SLATE = (204, 158, 117), (242, 230, 208), (92, 122, 158)
PANEL = 330, 330


def model_of(name):
    """A file's, or one made by code."""
    if name in BUILTIN:
        return builtin_figure.zero_set(BUILTIN[name])
    reader = scan_files.scan_reader(name)
    reader.Update()
    return reader.GetOutput()


def placed(data):
    """Its triangles, centered and of largest radius 1."""
    points = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    points = points - (points.min(axis=0) + points.max(axis=0)) / 2.0
    points /= np.linalg.norm(points, axis=1).max()
    model, moved = vtkPolyData(), vtkPoints()
    moved.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    model.SetPoints(moved)
    model.SetPolys(data.GetPolys())
    return model


def farthest_out(model):
    """Point ids of what is farthest out in 26 directions."""
    steps = np.array([(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)])
    directions = steps[np.any(steps != 0, axis=1)]
    points = vtk_to_numpy(model.GetPoints().GetData())
    return (points @ (directions / np.linalg.norm(directions, axis=1)[:, None]).T).argmax(axis=0).tolist()


def landmarks_of(paths, models):
    """For each model the point ids that a file says; they correspond from model to model."""
    lists = [mapped_models.read_landmarks(path, model) for path, model in zip(paths, models)]
    if len(set(map(len, lists))) > 1:
        raise ValueError("the models have different numbers of landmarks")
    return lists


def turn_to(model, landmarks, reference, others):
    """Turn the model so that its landmarks come closest to the others (Kabsch)."""
    points = vtk_to_numpy(model.GetPoints().GetData())
    first, second = points[landmarks], vtk_to_numpy(reference.GetPoints().GetData())[others]
    u, _, v = np.linalg.svd((first - first.mean(axis=0)).T @ (second - second.mean(axis=0)))
    points[:] = points @ (u @ np.diag([1.0, 1.0, np.sign(np.linalg.det(u @ v))]) @ v)


def mapped(model, balance):
    """The model with its map to the sphere."""
    conformal = vtkGlobalConformalMap()
    conformal.SetInputData(model)
    conformal.SetAreaBalance(balance)
    conformal.Update()
    return conformal.GetOutput()


def registered(moving, landmarks, fixed, others, is_rotation=False):
    """The first with its map deformed, or turned, until it corresponds to the second one's."""
    registration = vtkSphericalRegistration()
    registration.SetInputData(moving)
    registration.SetFixedData(fixed)
    if is_rotation:
        registration.SetSpaceOfTransformsToRotation()
    for point, other in zip(landmarks, others):
        registration.AddLandmark(point, other)
    registration.Update()
    return registration.GetOutput()


def registered_with_mean(models, landmarks):
    """All of them, their maps made to correspond."""
    template, blocks = vtkSphericalTemplate(), vtkMultiBlockDataSet()
    for i, (model, points) in enumerate(zip(models, landmarks)):
        if points:
            template.SetLandmarkArrayName(mapped_models.mark(model, points))
        blocks.SetBlock(i, model)
    template.SetInputDataObject(blocks)
    template.SetAlignmentToSimilarity()
    template.Update()
    return [template.GetOutput().GetBlock(i) for i in range(len(models))]


def paint(surface, color, stripes=None):
    """Colors of the points, in stripes across the longest axis if there is a second color."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    colors = np.tile(np.array(color, dtype=np.uint8), (len(points), 1))
    if stripes:
        along = points[:, np.ptp(points, axis=0).argmax()]
        colors[np.floor(9.0 * along).astype(int) % 2 == 0] = stripes
    array = numpy_to_vtk(colors, deep=True)
    array.SetName("Colors")
    surface.GetPointData().SetScalars(array)


def colored_actor(surface):
    actor = pictures.actor_of(surface)
    actor.GetMapper().ScalarVisibilityOn()
    actor.GetProperty().SetColor(1.0, 1.0, 1.0)
    return actor


def scene_of(surface, label, args, colors=True):
    """Seen by itself, since a morph moves."""
    camera = pictures.camera_on(surface, args.view, args.up, PANEL[0] / PANEL[1], args.turn)
    actor = colored_actor(surface) if colors else pictures.actor_of(surface)
    return pictures.scene(actor, label, camera)


def morphed(first, second, factor, args):
    morph = vtkSphericalMorph()
    morph.SetInputData(first)
    morph.SetTargetData(second)
    morph.SetNumberOfPoints(args.points)
    morph.SetPath(args.path == "rigid")
    morph.SetMorphFactor(factor)
    morph.Update()
    return morph.GetOutput()


def carried(source, target):
    """The target with the colors of the source."""
    resample = vtkSphericalResample()
    resample.SetInputData(target)
    resample.SetSourceData(source)
    resample.Update()
    return resample.GetOutput()


def draw_steps(first, second, args):
    """From the first to the second, and the second in the colors of the first."""
    paint(first, CREAM, CLAY)
    paint(second, SLATE)
    factors = np.linspace(0.0, 1.0, args.steps)
    scenes = [scene_of(morphed(first, second, factor, args), f"{factor:g}", args) for factor in factors]
    scenes.append(scene_of(carried(first, second), "colors of the first", args))
    pictures.write_side_by_side(args.output, scenes, PANEL[0] * len(scenes), PANEL[1])


def varied(mean, factor):
    """The mean plus so many standard deviations of its first mode."""
    points = vtk_to_numpy(mean.GetPoints().GetData())
    mode = vtk_to_numpy(mean.GetPointData().GetArray("ShapeMode1"))
    shape, placed = vtkPolyData(), vtkPoints()
    placed.SetData(numpy_to_vtk(np.ascontiguousarray(points + factor * mode), deep=True))
    shape.SetPoints(placed)
    shape.SetPolys(mean.GetPolys())
    return shape


def draw_mean(models, args):
    """The models on one mesh, their mean, and two standard deviations of the first mode."""
    remesh = vtkConsistentRemesh()
    for model in models:
        remesh.AddInputDataObject(model)
    remesh.SetNumberOfPoints(args.points)
    remesh.SetAlignmentToSimilarity()
    remesh.AlignBlocksOff()  # models stay as they are placed
    remesh.Update()
    mean = remesh.GetMeanSurface()
    shapes = [(remesh.GetOutput().GetBlock(i), f"model {i + 1}") for i in range(len(models))]
    shapes += [(varied(mean, -2.0), "mean - 2 modes"), (mean, "mean"), (varied(mean, 2.0), "mean + 2 modes")]
    if len(shapes) % 2:
        shapes.insert(-1, (varied(mean, 1.0), "mean + 1 mode"))
    scenes = [scene_of(shape, label, args, colors=False) for shape, label in shapes]
    columns = len(scenes) // 2
    pictures.write_side_by_side(args.output, scenes, PANEL[0] * columns, 2 * PANEL[1], rows=2)
    explained = vtk_to_numpy(mean.GetFieldData().GetArray("ExplainedVariance"))
    print("explained variance:", " ".join(f"{share:.3f}" for share in explained))
    for i in range(len(models)):
        field = remesh.GetOutput().GetBlock(i).GetFieldData()
        print(f"model {i + 1}: p2s {field.GetArray('MeanSquarePointToSurface').GetValue(0):.2e}")


def corresponding(models, landmarks, args):
    """The models, their maps made to correspond."""
    first = models[0]
    if not args.landmarks and not args.automatic:
        far = farthest_out(first)
        pairs = [dict(zip(farthest_out(model), far)) for model in models[1:]]  # each point once
        return [first] + [registered(model, list(of_model), first, of_model.values(), is_rotation=True)
                          for model, of_model in zip(models[1:], pairs)]
    if args.mean:
        return registered_with_mean(models, landmarks)
    return [first, registered(models[-1], landmarks[-1], first, landmarks[0])]


def draw(names, args):
    models = [model_of(name) for name in names]
    landmarks = landmarks_of(args.landmarks, models) or [[] for _ in models]
    models = [mapped(placed(model), args.balance) for model in models]
    models = corresponding(models, landmarks, args)
    for model, points in zip(models[1:], landmarks[1:] if args.mean else landmarks[-1:]):
        if points:
            turn_to(model, points, models[0], landmarks[0])
    if args.mean:
        draw_mean(models, args)
    else:
        draw_steps(models[0], models[-1], args)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="*", help="closed models, bear or dancer; default: both of these")
    parser.add_argument("--landmarks", nargs="+", default=[], help="for each model a file of point ids or coordinates, one landmark a line")
    parser.add_argument("--automatic", action="store_true", help="without landmarks, by shape alone")
    parser.add_argument("--mean", action="store_true", help="draw the mean of all models")
    parser.add_argument("--path", choices=("linear", "rigid"), default="linear", help="of the morph")
    parser.add_argument("--steps", type=int, default=5, help="of the morph, default 5")
    parser.add_argument("--points", type=int, default=20000, help="of the common mesh, default 20000")
    parser.add_argument("--balance", type=float, default=0.5, help="AreaBalance of maps, default 0.5")
    parser.add_argument("--view", nargs=3, type=float, default=(0, 0, 1), help="where to look from")
    parser.add_argument("--up", nargs=3, type=float, default=(0, 1, 0), help="what is up")
    parser.add_argument("--turn", type=float, default=18.0, help="to the side, in degrees, default 18")
    parser.add_argument("--output", default="morph.png", help="picture, .png or .jpg")
    args = parser.parse_args()
    names = args.model or ["bear", "dancer"]
    if len(names) < 2:
        parser.error("two models or more are needed")
    if args.landmarks and len(args.landmarks) != len(names):
        parser.error("--landmarks needs a file for each model")
    if args.landmarks and args.automatic:
        parser.error("--automatic is without --landmarks")
    if args.steps < 2:
        parser.error("--steps must be at least 2")
    draw(names, args)
    print("wrote", os.path.abspath(args.output))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError) as error:
        sys.exit(f"morph: {error}")
