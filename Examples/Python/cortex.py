#!/usr/bin/python3
"""From two cortical surfaces to corresponding spheres, without FreeSurfer.

The surfaces are closed and without handles, of FreeSurfer (lh.white), GIFTI (.surf.gii) or any format that
quickstart.py opens; without any, two folded hemispheres are made by code, whose corresponding points are known.
Their curvatures and the depth of their folds are measured, both are mapped to the sphere, the first one's map is
deformed until the folds of both agree, and an array of the second is carried to the first. Printed is how well
they agree before and after. Each surface is written as GIFTI that Connectome Workbench reads, or as FreeSurfer's:
itself, its sphere of radius 100, its values, and of the first the sphere that corresponds (sphere.reg).
"""
import argparse
import os
import sys

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals

from conformalsom import (
    vtkFreeSurferReader, vtkFreeSurferWriter, vtkGIFTIReader, vtkGIFTIWriter, vtkGlobalConformalMap,
    vtkSphericalRegistration, vtkSphericalResample, vtkSurfaceShape)
from conformalsom.command import pictures, scan_files
from conformalsom.command.steps import StepFailed, Steps

from helpers import hemispheres

SHAPES = "SulcalDepth", "MeanCurvature"
CARRIED = "Carried"
GYRUS, MIDDLE, SULCUS = np.array([196, 88, 62]), np.array([236, 232, 224]), np.array([44, 84, 148])
PANEL = 400, 340
VIEW, UP = (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0)


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("surfaces", nargs="*", help="two closed surfaces; default: hemispheres made by code")
    parser.add_argument("--structure", default="CortexLeft",
                        help="AnatomicalStructurePrimary in GIFTI files, default CortexLeft")
    parser.add_argument("--balance", type=float, default=0.5,
                        help="AreaBalance of the maps; 0 keeps angles, default 0.5")
    parser.add_argument("--frequency", type=int, default=24,
                        help="of the finest sphere that registration deforms, default 24")
    parser.add_argument("--values", metavar="FILE",
                        help="of the second surface (lh.thickness, .shape.gii), to carry to the first")
    parser.add_argument("--array", help="of the second surface, to carry to the first; default: the first of "
                        "--values, else SulcalDepth")
    parser.add_argument("--size", type=int, default=60,
                        help="of surfaces made by code: of 10 SIZE^2 + 2 points, default 60")
    parser.add_argument("--format", choices=("gifti", "freesurfer"), default="gifti", help="default gifti")
    parser.add_argument("--output", metavar="FOLDER", default="cortex", help="made anew, default cortex")
    parser.add_argument("--picture", metavar="FILE", help="to draw what was found, PNG or JPEG")
    args = parser.parse_args()
    if args.picture and not pictures.can_draw():
        parser.error("--picture needs a display: put xvfb-run before the command")
    if len(args.surfaces) not in (0, 2):
        parser.error("expected two surfaces, or none")
    if args.values and not args.surfaces:
        parser.error("--values belongs to a surface of yours")
    if args.size < 8:
        parser.error("--size must be at least 8")
    for path in (args.output, args.picture):
        if path and os.path.lexists(path):
            parser.error(f"{path} already exists")
    return args


def array(surface, name):
    return vtk_to_numpy(surface.GetPointData().GetArray(name)).astype(float)


def add(surface, name, values):
    added = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
    added.SetName(name)
    surface.GetPointData().AddArray(added)


def set_values(reader, path):
    """The name of the file with numbers at the surface's points."""
    if isinstance(reader, vtkFreeSurferReader):
        reader.SetCurvatureFileName(path)
    elif isinstance(reader, vtkGIFTIReader):
        reader.SetShapeFileName(path)
    else:
        raise ValueError(f"{path}: values are read beside surfaces of FreeSurfer and GIFTI only")


def surfaces_of(args, steps):
    """The surfaces by their names."""
    if not args.surfaces:
        return {"first": hemispheres.hemisphere(args.size, 0.0, 2),
                "second": hemispheres.hemisphere(args.size + 3, 0.15, 3)}
    found = {}
    for label, path, values in zip(("first", "second"), args.surfaces, (None, args.values)):
        reader = scan_files.scan_reader(path)
        if values:
            set_values(reader, values)
        steps.run(f"Read {path}", reader)
        found[label] = reader.GetOutput()
    return found


def mapped(surface, name, balance, steps):
    """The surface with its shape and its map."""
    shape, conformal = vtkSurfaceShape(), vtkGlobalConformalMap()
    shape.SetInputData(surface)
    steps.run(f"Measure the {name} surface", shape)
    conformal.SetInputConnection(shape.GetOutputPort())
    conformal.SetAreaBalance(balance)
    steps.run("Map it to the sphere", conformal)
    return conformal.GetOutput()


def carried(source, names, target):
    """Arrays of the source at the corresponding points of the target, as numbers."""
    chosen = vtkPolyData()
    chosen.CopyStructure(source)
    for name in ["SpherePosition", *names]:
        chosen.GetPointData().AddArray(source.GetPointData().GetArray(name))
    resample = vtkSphericalResample()
    resample.SetInputData(target)
    resample.SetSourceData(chosen)
    resample.Update()
    return {name: array(resample.GetOutput(), name) for name in names}


def agreement(first, second):
    """Correlations of the shapes and, where places in common are known, the degrees between them."""
    names = [*SHAPES, *([hemispheres.PLACE] if second.GetPointData().HasArray(hemispheres.PLACE) else [])]
    found = carried(second, names, first)
    result = [np.corrcoef(found[name], array(first, name))[0, 1] for name in SHAPES]
    if hemispheres.PLACE in found:
        cosines = (hemispheres.unit(found[hemispheres.PLACE]) * array(first, hemispheres.PLACE)).sum(axis=1)
        angles = np.degrees(np.arccos(np.clip(cosines, -1.0, 1.0)))
        result += [np.mean(angles), np.percentile(angles, 95)]
    return result


def register(first, second, frequency, steps):
    registration = vtkSphericalRegistration()
    registration.SetInputData(first)
    registration.SetFixedData(second)
    registration.SetFrequency(frequency)
    registration.AddFeature("SulcalDepth", 1.0)
    steps.run("Register the folds", registration)
    return registration.GetOutput()


def array_to_carry(args, surface):
    """Its name; arrays of files stand before those that were measured."""
    data = surface.GetPointData()
    names = [data.GetArrayName(i) for i in range(data.GetNumberOfArrays())
             if data.GetArray(i) and data.GetArray(i).GetNumberOfComponents() == 1]
    name = args.array or (names[0] if args.values else "SulcalDepth")
    if name not in names:
        raise ValueError(f"the second surface has no array {name} of 1 component")
    return name


def plain(surface, values):
    """The surface with these values alone, in single precision."""
    result = vtkPolyData()
    result.CopyStructure(surface)
    result.GetPointData().AddArray(surface.GetPointData().GetArray("SpherePosition"))
    for name, numbers in values.items():
        add(result, name, numbers.astype(np.float32))
    return result


def write(writer, path, content, **properties):
    writer.SetFileName(path)
    getattr(writer, f"SetContentTo{content}")()
    for name, value in properties.items():
        getattr(writer, f"Set{name}")(value)
    if writer.Write() != 1:
        raise StepFailed(f"{path} was not written")


def write_gifti(surface, prefix, values, structure):
    writer = vtkGIFTIWriter()
    writer.SetInputData(plain(surface, values))
    writer.SetAnatomicalStructure(structure)
    write(writer, prefix + ".surf.gii", "Geometry")
    write(writer, prefix + ".sphere.surf.gii", "Sphere")
    write(writer, prefix + ".shape.gii", "Shape")


def write_freesurfer(surface, prefix, values):
    writer = vtkFreeSurferWriter()
    curv = {"curv": -values["MeanCurvature"], "sulc": values["SulcalDepth"]}  # with the signs of FreeSurfer
    names = {**curv, **({"carried": values[CARRIED]} if CARRIED in values else {})}
    writer.SetInputData(plain(surface, names))
    write(writer, prefix + ".white", "Surface")
    write(writer, prefix + ".sphere", "Sphere")
    for name in names:
        write(writer, f"{prefix}.{name}", "Curvature", ArrayName=name)


def write_files(args, first, registered, second):
    os.mkdir(args.output)
    for label, surface in (("first", first), ("second", second)):
        prefix = os.path.join(args.output, label)
        values = {name: array(surface, name) for name in (*SHAPES, "GaussianCurvature")}
        if surface is first:
            values[CARRIED] = array(registered, CARRIED)
        if args.format == "gifti":
            write_gifti(surface, prefix, values, args.structure)
        else:
            write_freesurfer(surface, prefix, values)
    prefix = os.path.join(args.output, "first.sphere.reg")
    if args.format == "gifti":
        writer = vtkGIFTIWriter()
        writer.SetInputData(plain(registered, {}))
        write(writer, prefix + ".surf.gii", "Sphere", AnatomicalStructure=args.structure)
    else:
        writer = vtkFreeSurferWriter()
        writer.SetInputData(plain(registered, {}))
        write(writer, prefix, "Sphere")


def scene(surface, values, label, on_sphere=False):
    """The surface, or its sphere, with low values in red and high ones in blue."""
    shown = vtkPolyData()
    shown.CopyStructure(surface)
    if on_sphere:
        points = vtkPoints()
        points.SetData(surface.GetPointData().GetArray("SpherePosition"))
        shown.SetPoints(points)
    share = np.clip((values - values.mean()) / (2.0 * max(values.std(), 1e-30)), -1.0, 1.0)[:, None]
    colors = np.where(share > 0, MIDDLE + share * (SULCUS - MIDDLE), MIDDLE - share * (GYRUS - MIDDLE))
    shown.GetPointData().SetScalars(numpy_to_vtk(colors.astype(np.uint8), deep=True))
    normals = vtkPolyDataNormals()
    normals.SetInputData(shown)
    normals.SplittingOff()
    normals.Update()
    actor = pictures.actor_of(normals.GetOutput())
    actor.GetMapper().ScalarVisibilityOn()
    return pictures.scene(actor, label, pictures.camera_on(shown, VIEW, UP, PANEL[0] / PANEL[1]))


def main():
    args = arguments()
    steps = Steps()
    first, second = (mapped(surface, label, args.balance, steps)
                     for label, surface in surfaces_of(args, steps).items())
    name = array_to_carry(args, second)
    before = agreement(first, second)
    registered = register(first, second, args.frequency, steps)
    after = agreement(registered, second)
    add(registered, CARRIED, carried(second, [name], registered)[name])
    write_files(args, first, registered, second)
    rows = "correlation of sulcal depth", "correlation of curvature", "mean error, degrees", "95 % below, degrees"
    print(f"\n{'':<30}{'before':>8}{'after':>8}")
    for row, *figures in zip(rows, before, after):
        print(f"{row:<30}{figures[0]:8.3f}{figures[1]:8.3f}")
    folds = registered.GetFieldData().GetArray("NumberOfFolds").GetTuple1(0)
    print(f"{'folds':<30}{'':8}{folds:8.0f}\nwrote {args.output}")
    if args.picture:
        pictures.write_side_by_side(args.picture, [
            scene(first, array(first, "SulcalDepth"), "first: how deep its folds are"),
            scene(first, array(first, "SulcalDepth"), "on its sphere", on_sphere=True),
            scene(second, array(second, "SulcalDepth"), "second"),
            scene(first, array(registered, CARRIED), f"the second's {name}, carried to the first"),
        ], 4 * PANEL[0], PANEL[1])
        print(f"wrote {args.picture}")


if __name__ == "__main__":
    try:
        main()
    except (StepFailed, OSError, ValueError) as error:
        sys.exit(f"cortex: {error}")
