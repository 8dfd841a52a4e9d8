"""Leave out points that are not finite, which VTK's readers take from files."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

CELLS = ("Verts", "Lines", "Polys", "Strips")  # in the order of cell data


def flags_of(data):
    """For each point of a point set, whether its coordinates are finite."""
    if data.GetNumberOfPoints() == 0:
        return np.ones(0, dtype=bool)
    return np.isfinite(vtk_to_numpy(data.GetPoints().GetData())).all(axis=1)


def kept(data, steps, label="Read the scan"):
    """The data itself if all of its points are finite. Else a copy without the others and without cells at them; a note
    states how many points are left out.
    """
    finite = flags_of(data)
    if finite.all() or not isinstance(data, vtkPolyData):
        return data
    steps.note(label, f"{np.count_nonzero(~finite):,} of {len(finite):,} points are not finite, and are left out")
    return with_points(data, finite)


def with_points(data, chosen):
    """A copy of a surface or cloud with the points for which the flag is set, cells of only these, and all arrays."""
    result, points = vtkPolyData(), vtkPoints()
    points.SetData(numpy_to_vtk(vtk_to_numpy(data.GetPoints().GetData())[chosen], deep=True))
    result.SetPoints(points)
    copy_tuples(data.GetPointData(), result.GetPointData(), chosen)
    ids = np.where(chosen, np.cumsum(chosen) - 1, -1)
    whole = []
    for name in CELLS:
        cells, flags = with_ids(getattr(data, "Get" + name)(), ids)
        getattr(result, "Set" + name)(cells)
        whole.append(flags)
    copy_tuples(data.GetCellData(), result.GetCellData(), np.concatenate(whole))
    result.SetFieldData(data.GetFieldData())
    return result


def with_ids(cells, ids):
    """Cells with other ids of points, without those of which one is -1; and for each cell whether it is kept."""
    corners = vtk_to_numpy(cells.GetConnectivityArray())
    sizes = np.diff(vtk_to_numpy(cells.GetOffsetsArray()))
    owners = np.repeat(np.arange(len(sizes)), sizes)
    whole = np.ones(len(sizes), dtype=bool)
    whole[owners[ids[corners] < 0]] = False
    return cells_of(sizes[whole], ids[corners[whole[owners]]]), whole


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
