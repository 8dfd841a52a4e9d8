"""Leave out what VTK's readers take from files and its filters do not expect: points that are not finite, and cells of
too few points, at which some of its filters crash.
"""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from .steps import StepFailed

LEAST = {"Verts": 1, "Lines": 2, "Polys": 3, "Strips": 3}  # points of a cell; in the order of cell data


def flags_of(data):
    """For each point of a point set, whether its coordinates are finite."""
    if data.GetNumberOfPoints() == 0:
        return np.ones(0, dtype=bool)
    return np.isfinite(vtk_to_numpy(data.GetPoints().GetData())).all(axis=1)


def wrong_id(data):
    """A text about the first cell of a surface that refers to a point that is not there; empty if there is none."""
    count, before = data.GetNumberOfPoints(), 0
    for name in LEAST:
        cells = getattr(data, "Get" + name)()
        ids = vtk_to_numpy(cells.GetConnectivityArray())
        if ids.min(initial=0) < 0 or ids.max(initial=-1) >= count:
            place = np.argmax((ids < 0) | (ids >= count))
            cell = np.searchsorted(vtk_to_numpy(cells.GetOffsetsArray()), place, side="right") - 1
            return f"cell {before + cell} refers to point {ids[place]} of {count}"
        before += cells.GetNumberOfCells()
    return ""


def number_of_short_cells(data):
    """The number of cells of a surface that have too few points."""
    return sum(count_short(getattr(data, "Get" + name)(), least) for name, least in LEAST.items())


def count_short(cells, least):
    """The number of cells with fewer points."""
    size = cells.IsHomogeneous()  # of all cells; 0 without cells, and -1 if sizes differ
    if size >= 0:
        return cells.GetNumberOfCells() if size < least else 0
    return int(np.count_nonzero(np.diff(vtk_to_numpy(cells.GetOffsetsArray())) < least))


def kept(data, steps, label="Read the scan"):
    """The data itself if all of its points are finite and all cells of a surface have enough points. Else a copy without
    the others, and without cells at them; notes state how many are left out.

    Raises StepFailed if a cell refers to a point that is not there.
    """
    if not isinstance(data, vtkPolyData):
        return data
    try:
        data, text = with_whole_cells(data)
    except ValueError as error:
        raise StepFailed(f"{label}: {error}") from None
    if text:
        steps.note(label, text)
    finite = flags_of(data)
    if finite.all():
        return data
    steps.note(label, f"{np.count_nonzero(~finite):,} of {len(finite):,} points are not finite, and are left out")
    return with_points(data, finite)


def with_whole_cells(data):
    """A surface without its cells of too few points, and a warning with their number; empty if there are none.

    Nothing is left out if a cell array has not a tuple for each cell, which filters report. Raises ValueError if a cell
    refers to a point that is not there.
    """
    wrong, number = wrong_id(data), number_of_short_cells(data)
    if wrong:
        raise ValueError(wrong)
    fields = data.GetCellData()
    arrays = (fields.GetAbstractArray(i) for i in range(fields.GetNumberOfArrays()))
    if number == 0 or any(array.GetNumberOfTuples() != data.GetNumberOfCells() for array in arrays):
        return data, ""
    have, are = ("cells have", "are") if number > 1 else ("cell has", "is")
    return without_short_cells(data), f"{number:,} {have} too few points, and {are} left out"


def without_short_cells(data):
    """A copy of a surface without cells of too few points."""
    fields, whole = data.GetCellData(), []
    result = data.NewInstance()
    result.ShallowCopy(data)
    for name, least in LEAST.items():
        corners, sizes = corners_and_sizes(getattr(data, "Get" + name)())
        whole.append(sizes >= least)
        getattr(result, "Set" + name)(cells_of(sizes[whole[-1]], corners[np.repeat(whole[-1], sizes)]))
    result.GetCellData().Initialize()
    copy_tuples(fields, result.GetCellData(), np.concatenate(whole))
    return result


def with_points(data, chosen):
    """A copy of a surface or cloud with the points for which the flag is set, cells of only these, and all arrays."""
    result, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(data.GetPoints().GetData())[chosen], deep=True))
    result.SetPoints(points)
    copy_tuples(data.GetPointData(), result.GetPointData(), chosen)
    ids = np.where(chosen, np.cumsum(chosen) - 1, -1)
    whole = []
    for name in LEAST:
        cells, flags = with_ids(getattr(data, "Get" + name)(), ids)
        getattr(result, "Set" + name)(cells)
        whole.append(flags)
    copy_tuples(data.GetCellData(), result.GetCellData(), np.concatenate(whole))
    result.SetFieldData(data.GetFieldData())
    return result


def with_ids(cells, ids):
    """Cells with other ids of points, without those of which one is -1; and for each cell whether it is kept."""
    corners, sizes = corners_and_sizes(cells)
    owners = np.repeat(np.arange(len(sizes)), sizes)
    whole = np.ones(len(sizes), dtype=bool)
    whole[owners[ids[corners] < 0]] = False
    return cells_of(sizes[whole], ids[corners[whole[owners]]]), whole


def corners_and_sizes(cells):
    """The ids of points of all cells, and the number of points of each."""
    return vtk_to_numpy(cells.GetConnectivityArray()), np.diff(vtk_to_numpy(cells.GetOffsetsArray()))


def cells_of(sizes, corners):
    """Cells with these numbers of corners, from the ids of all corners."""
    offsets = np.zeros(len(sizes) + 1, dtype=np.int64)
    np.cumsum(sizes, out=offsets[1:])
    cells = vtkCellArray()
    cells.SetData(numpy_to_vtkIdTypeArray(offsets, deep=True),
                  numpy_to_vtkIdTypeArray(corners.astype(np.int64), deep=True))
    return cells


def copy_tuples(source, target, chosen):
    """Copy the tuples of all arrays for which a flag is set; active arrays stay active."""
    target.CopyAllOn()
    target.CopyAllocate(source, int(np.count_nonzero(chosen)))
    ends = np.flatnonzero(np.diff(np.concatenate(([0], chosen.astype(np.int8), [0])))).tolist()
    count = 0
    for start, end in zip(ends[::2], ends[1::2]):  # runs of chosen tuples
        target.CopyData(source, count, end - start, start)
        count += end - start
