#!/usr/bin/python3
"""vtkDeformationTransfer in figures: the tables of Documentation/Correspondence.md.

    measure_poses.py [--kinds animals heads] [--pairs 4] [--seed 2] [--automatic] [--scan SCAN.off] ...

Animals and heads are made by code, and registered in pairs by landmarks, or by shape alone (--automatic). Each pose of
the source, or expression, is transferred to the target. The true pose is that of the target's own skeleton with the
same angles. The error is the root mean square distance of the vertices from it, after the best rigid motion, over
the square root of the area. "turned" is a source whose map is turned by 90 degrees, so that it does not correspond. Rivals are the displacements of the source (plain), and the morph half way between the
target at rest and the pose of the source. Folds are edges with an angle of more than 90 degrees between the normals.
Feet of animals that crouch rest on the source; "slide" is the root mean square motion of the target's, in the same unit,
without contacts and with them. With --scan, poses of the animals are transferred to a scan, registered by shape alone, which has no true pose.
"""
import argparse
import os
import sys
import time

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData, vtkStaticCellLocator

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "Examples", "Python"))
from compare_lattices import triangulated  # pylint: disable=wrong-import-position
from helpers import bodies, paper_models, poses  # pylint: disable=wrong-import-position
from helpers.clouds import points_of, vtk_points  # pylint: disable=wrong-import-position
from conformalsom import (  # pylint: disable=wrong-import-position
    vtkDeformationTransfer, vtkGenusZeroCheck, vtkGlobalConformalMap, vtkSphericalMorph, vtkSphericalRegistration)
from conformalsom.command import scan_files  # pylint: disable=wrong-import-position

MORPH_FREQUENCY = 60


class Model:
    """A mapped body with its poses, or a scan without."""

    def __init__(self, body, mesh, moved=None, kinds=()):
        self.body, self.kinds, self.moved = body, kinds, moved
        conformal = vtkGlobalConformalMap()
        conformal.SetAreaBalance(0.5)
        conformal.SetInputData(mesh)
        self.mapped = paper_models.run(conformal)
        self.points = points_of(self.mapped).astype(float)
        self.mapped.SetPoints(vtk_points(self.points))
        self.triangles = vtk_to_numpy(self.mapped.GetPolys().GetConnectivityArray()).reshape(-1, 3).copy()
        self.areas = areas_of(self.points, self.triangles)
        self.crossings = crossings_of(self.points, self.triangles)

    def landmarks(self):
        return self.body.landmarks(self.mapped)

    def pose(self, kind, share=1.0):
        """Points in a pose of its own skeleton."""
        return self.moved(self.points, self.body, self.kinds[kind], share)


def areas_of(points, triangles):
    """Of the vertices."""
    a, b, c = points[triangles.T]
    double = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return np.bincount(triangles.ravel(), np.repeat(double / 6, 3), len(points))


def with_points(surface, points):
    result = vtkPolyData()
    result.ShallowCopy(surface)
    result.SetPoints(vtk_points(points))
    return result


def volume_of(points, triangles):
    a, b, c = points[triangles.T]
    return abs(np.einsum("ij,ij->i", a, np.cross(b, c)).sum()) / 6


def folds_of(points, triangles):
    """Number of edges with an angle of more than 90 degrees between the normals."""
    a, b, c = points[triangles.T]
    normals = np.cross(b - a, c - a)
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    owners = np.tile(np.arange(len(triangles)), 3)
    order = np.lexsort(np.sort(edges, axis=1).T)
    first, second = owners[order[0::2]], owners[order[1::2]]
    return int((np.einsum("ij,ij->i", normals[first], normals[second]) < 0).sum())


def crossings_of(points, triangles):
    """Number of edges that cross a triangle without common vertices."""
    surface, locator, found = vtkPolyData(), vtkStaticCellLocator(), vtkIdList()
    surface.SetPoints(vtk_points(points))
    cells = vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(triangles.astype(np.int64).ravel(), deep=True))
    surface.SetPolys(cells)
    locator.SetDataSet(surface)
    locator.BuildLocator()
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    edges = edges[edges[:, 0] < edges[:, 1]]
    pairs = []
    for i, (p, q) in enumerate(edges):
        locator.FindCellsAlongLine(points[p], points[q], 0.0, found)
        pairs += [(i, found.GetId(k)) for k in range(found.GetNumberOfIds())]
    pairs = np.array(pairs)
    ends, corners = edges[pairs[:, 0]], triangles[pairs[:, 1]]
    apart = (ends[:, :, None] != corners[:, None, :]).all(axis=(1, 2))
    (p, q), (a, b, c) = points[ends[apart].T], points[corners[apart].T]

    def volume(x, y, z):
        return np.einsum("ij,ij->i", np.cross(x - p, y - p), z - p)

    normal = np.cross(b - a, c - a)
    sides = np.einsum("ij,ij->i", normal, p - a) * np.einsum("ij,ij->i", normal, q - a)
    signs = np.sign([volume(a, b, q), volume(b, c, q), volume(c, a, q)])
    return int(((sides < 0) & (np.abs(signs.sum(axis=0)) == 3)).sum())


def distance(points, truth, weights):
    """Root mean square distance, after the best rigid motion (Kabsch)."""
    weights = weights / weights.sum()
    x, y = points - weights @ points, truth - weights @ truth
    u, _, v = np.linalg.svd((x * weights[:, None]).T @ y)
    x = x @ (u @ np.diag([1, 1, np.sign(np.linalg.det(u @ v))]) @ v)
    return np.sqrt(weights @ ((x - y)**2).sum(axis=1))


def registered(moving, fixed, by_landmarks):
    """The first with its map made to correspond to that of the second."""
    registration = vtkSphericalRegistration()
    registration.SetInputData(moving.mapped)
    registration.SetFixedData(fixed.mapped)
    if by_landmarks:
        for own, other in zip(moving.landmarks(), fixed.landmarks()):
            registration.AddLandmark(own, other)
    return paper_models.run(registration)


def transferred(source, target, pose, contacts=None, align=True):
    """The target in a pose of the source."""
    transfer = vtkDeformationTransfer()
    if contacts is not None:
        array = numpy_to_vtk(contacts.astype(np.uint8), deep=True)
        array.SetName("Contact")
        target = with_points(target, points_of(target))
        target.GetPointData().AddArray(array)
        transfer.SetContactArrayName("Contact")
    transfer.SetAlignRotation(align)
    transfer.SetInputData(target)
    transfer.SetSourceData(source)
    transfer.SetPoseData(with_points(source, pose))
    return paper_models.run(transfer)


def residual_of(surface):
    return surface.GetFieldData().GetArray("TransferResidual").GetValue(0)


def with_turned_map(surface):
    """A surface whose map does not correspond to any other: turned by 90 degrees."""
    result = with_points(surface, points_of(surface))
    turned = vtk_to_numpy(surface.GetPointData().GetArray("SpherePosition")) @ poses.rotation(poses.X, np.pi / 2).T
    array = numpy_to_vtk(np.ascontiguousarray(turned), deep=True)
    array.SetName("SpherePosition")
    result.GetPointData().AddArray(array)
    return result


def morphed(first, second, factor):
    morph = vtkSphericalMorph()
    morph.SetInputData(first)
    morph.SetTargetData(second)
    morph.SetMeshTypeToGeodesic()
    morph.SetFrequency(MORPH_FREQUENCY)
    morph.SetMorphFactor(factor)
    return paper_models.run(morph)


def measure_contacts(rows, source, target, args):
    """How far the target's feet slide, as those of the source rest, with and without contacts."""
    moved_map = registered(source, target, not args.automatic)
    feet = poses.feet(target.points)
    pose = poses.crouched(source.points)
    for name, contacts in (("free", None), ("contacts", feet)):
        found = transferred(moved_map, target.mapped, pose, contacts, align=False)
        slides = np.linalg.norm(points_of(found)[feet] - target.points[feet], axis=1) / np.sqrt(target.areas.sum())
        rows.add(name, slide=np.sqrt((slides**2).mean()), **figures_of(found, target))


class Rows:
    """Figures of each method, over all poses of all pairs."""

    def __init__(self):
        self.rows = {}

    def add(self, method, **figures):
        self.rows.setdefault(method, []).append(figures)

    def write(self, title):
        print(f"{title}, {len(next(iter(self.rows.values())))} poses")
        print(f"{'':<10}{'error':>9}{'largest':>9}{'folds':>9}{'at rest':>9}{'crossings':>11}{'at rest':>9}"
              f"{'volume':>16}{'residual':>10}{'slide':>9}")
        for method, rows in self.rows.items():
            def of(name, reduce, form):
                values = [row[name] for row in rows if name in row]
                return format(reduce(values), form) if values else "-"
            lowest, highest = of("volume", min, ".3f"), of("volume", max, ".3f")
            volume = "-" if lowest == "-" else f"{lowest} to {highest}"
            print(f"{method:<10}{of('error', np.mean, '.4f'):>9}{of('error', max, '.4f'):>9}"
                  f"{of('folds', np.mean, '.1f'):>9}{of('rest_folds', np.mean, '.1f'):>9}"
                  f"{of('crossings', np.mean, '.1f'):>11}{of('rest_crossings', np.mean, '.1f'):>9}{volume:>16}"
                  f"{of('residual', np.mean, '.3f'):>10}{of('slide', np.mean, '.4f'):>9}")


def figures_of(surface, target, truth=None):
    """Figures of a deformed target."""
    points = points_of(surface).astype(float)
    figures = {"folds": folds_of(points, target.triangles), "rest_folds": folds_of(target.points, target.triangles),
               "crossings": crossings_of(points, target.triangles), "rest_crossings": target.crossings,
               "volume": volume_of(points, target.triangles) / volume_of(target.points, target.triangles)}
    if truth is not None:
        figures["error"] = distance(points, truth, target.areas) / np.sqrt(target.areas.sum())
    if surface.GetFieldData().HasArray("TransferResidual"):
        figures["residual"] = residual_of(surface)
    return figures


def measure_pair(rows, source, target, args):
    """All poses of a pair. A scan has no landmarks that correspond."""
    moved_map = registered(source, target, target.body is not None and not args.automatic)
    for kind in source.kinds:
        pose = source.pose(kind)
        truth = target.pose(kind) if target.kinds else None
        rows.add("transfer", **figures_of(transferred(moved_map, target.mapped, pose, align=not args.aligned), target, truth))
        wrong = transferred(with_turned_map(moved_map), target.mapped, pose, align=not args.aligned)
        rows.add("turned", residual=residual_of(wrong))
        every = np.ones(len(target.points))
        plain = transferred(moved_map, target.mapped, pose, every, not args.aligned)
        plain.GetFieldData().RemoveArray("TransferResidual")
        rows.add("plain", **figures_of(plain, target, truth))
        if truth is not None:
            own = figures_of(with_points(target.mapped, truth), target)
            rows.add("true", **own)
            half = points_of(morphed(target.mapped, with_points(moved_map, pose), 0.5)).astype(float)
            true = morphed(with_points(target.mapped, truth), target.mapped, 0.0)
            triangles = vtk_to_numpy(true.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            weights = areas_of(points_of(true).astype(float), triangles)
            rows.add("morph", error=distance(half, points_of(true).astype(float), weights)
                     / np.sqrt(target.areas.sum()), volume=volume_of(half, triangles)
                     / volume_of(target.points, target.triangles))


def genus_zero(mesh):
    """The checked mesh, or None."""
    check = vtkGenusZeroCheck()
    check.SetInputData(mesh)
    checked = paper_models.run(check)
    return checked if checked.GetFieldData().GetArray("IsGenusZero").GetValue(0) == 1 else None


def models_of(kind, number, seed, sizes):
    """Bodies of genus zero with their poses, each as source and as target."""
    make, moved, kinds = {"animals": (bodies.animal, poses.posed, poses.POSES),
                          "heads": (bodies.head, poses.expressed, poses.EXPRESSIONS)}[kind]
    random = np.random.default_rng([seed, len(kind)])
    models = []
    while len(models) < number:
        body = make(random, 0.0)
        meshes = [genus_zero(body.mesh(size)) for size in sorted(set(sizes))]
        if all(meshes):
            made = {size: Model(body, mesh, moved, kinds) for size, mesh in zip(sorted(set(sizes)), meshes)}
            models.append([made[size] for size in sizes])
    return models


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kinds", nargs="+", choices=("animals", "heads"), default=["animals", "heads"])
    parser.add_argument("--pairs", type=int, default=4, help="of each kind, default 4")
    parser.add_argument("--seed", type=int, default=2, help="of the bodies, default 2")
    parser.add_argument("--size", type=int, default=90, help="cells of the grid along the longest side, default 90")
    parser.add_argument("--target-size", type=int, help="of targets, default as --size")
    parser.add_argument("--automatic", action="store_true", help="register by shape alone")
    parser.add_argument("--aligned", action="store_true", help="AlignRotation off: all bodies face the same way")
    parser.add_argument("--scan", nargs="*", default=[], help="closed surfaces to which poses of animals are transferred")
    args = parser.parse_args()
    for kind in args.kinds:
        models = models_of(kind, args.pairs + 1, args.seed, (args.size, args.target_size or args.size))
        rows = Rows()
        for (source, _), (_, target) in zip(models, models[1:]):
            measure_pair(rows, source, target, args)
        rows.write(kind)
        if kind == "animals":
            rows = Rows()
            for (source, _), (_, target) in zip(models, models[1:]):
                measure_contacts(rows, source, target, args)
            rows.write("feet")
            for path in args.scan:
                reader = scan_files.scan_reader(path)
                reader.Update()
                scan = Model(None, triangulated(reader.GetOutput()))
                rows = Rows()
                measure_pair(rows, models[0][0], scan, args)
                rows.write(os.path.basename(path))


if __name__ == "__main__":
    begin = time.process_time()
    try:
        main()
    except (ValueError, OSError, paper_models.StepFailed) as error:
        sys.exit(f"measure_poses: {error}")
    print(f"{time.process_time() - begin:.0f} s of CPU time")
