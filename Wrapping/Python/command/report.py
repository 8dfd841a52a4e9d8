"""How good a result is: distance to the scan and distortion of the map, as numbers and as a table."""
import math

from conformalsom import vtkConformalDistortion, vtkSurfaceMismatch

FIGURES = ("MeanSquarePointToSurface", "MeanSquarePointToVertex", "MeanSquareSurfaceToPoint",
           "WebFraction", "MeanAngleDistortion")


def measured(steps, name, surface, scan):
    """The surface with its distance to the scan and its map's distortion."""
    mismatch = vtkSurfaceMismatch()
    mismatch.SetInputConnection(0, surface.GetOutputPort())
    mismatch.SetInputConnection(1, scan.GetOutputPort())
    distortion = vtkConformalDistortion()
    distortion.SetInputConnection(mismatch.GetOutputPort())
    steps.run(f"Measure the {name}", mismatch)
    steps.run(f"Distortion of the {name}", distortion)
    return distortion


def figures_of(data):
    """Sizes, and every field array of one number by its name; null for one that is not finite."""
    figures = {"NumberOfPoints": data.GetNumberOfPoints(), "NumberOfTriangles": data.GetNumberOfPolys()}
    fields = data.GetFieldData()
    for array in map(fields.GetArray, range(fields.GetNumberOfArrays())):
        if array is not None and array.GetNumberOfValues() == 1:
            value = array.GetVariantValue(0).ToDouble()
            whole = array.GetDataTypeAsString() not in ("float", "double")
            figures[array.GetName()] = (
                int(value) if whole else value if math.isfinite(value) else None)
    return figures


def print_table(scan, mesh, surface, seconds):
    """Seconds of every step; sizes, errors and distortion of every stage."""
    print("\nseconds")
    for step, time in seconds.items():
        print(f"  {step:<28}{time:8.2f}")
    print(f"  {'all of them':<28}{sum(seconds.values()):8.2f}")
    print(f"\n{'':<16}{'points':>10}{'triangles':>11}{'p2s':>10}{'nv':>10}{'s2p':>10}{'web':>8}{'angle':>8}")
    print(f"{'scan':<16}{scan.GetNumberOfPoints():>10,}{scan.GetNumberOfPolys():>11,}")
    for name, model in (("learned mesh", mesh), ("smooth surface", surface)):
        p2s, nv, s2p, web, angle = (model.GetFieldData().GetArray(figure).GetValue(0)
                               for figure in FIGURES)
        print(f"{name:<16}{model.GetNumberOfPoints():>10,}{model.GetNumberOfPolys():>11,}"
              f"{p2s:>10.2e}{nv:>10.2e}{s2p:>10.2e}{web:>8.2%}{angle:>8.2f}")
    print("p2s, nv, s2p: mean square distance from the scan's points to the model, from them to its\n"
          "nearest vertex, and from the model to the scan; the scan's largest radius is 1.\n"
          "web: share of the model's area that is farther than 0.02 from the scan, also between points that are sparse.\n"
          "angle: mean change of an angle on the way to the sphere, in degrees.")
