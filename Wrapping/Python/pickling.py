"""Data of VTK as dictionaries of arrays of NumPy, which can be pickled."""
import typing

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkStringArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData

CELLS = ("Verts", "Lines", "Polys", "Strips")
ATTRIBUTES = ("PointData", "CellData", "FieldData")
State = typing.Dict[str, typing.Any]


def dumps(data: vtkPolyData) -> State:
    """Return points, cells and all arrays of a surface."""
    state: State = {"Points": dumped(data.GetPoints().GetData()) if data.GetPoints() else None}
    for name in CELLS:
        cells = getattr(data, "Get" + name)()
        state[name] = [dumped(cells.GetOffsetsArray()), dumped(cells.GetConnectivityArray())]
    for name in ATTRIBUTES:
        attributes = getattr(data, "Get" + name)()
        state[name] = [dumped(attributes.GetAbstractArray(i)) for i in range(attributes.GetNumberOfArrays())]
        if name != "FieldData":
            active = [attributes.GetAbstractAttribute(i) for i in range(vtkDataSetAttributes.NUM_ATTRIBUTES)]
            state["Active" + name] = {i: array.GetName() for i, array in enumerate(active) if array is not None}
    return state


def loads(state: State) -> vtkPolyData:
    """Return the surface that dumps() described."""
    data = vtkPolyData()
    if state["Points"] is not None:
        points = vtkPoints()
        points.SetData(loaded(state["Points"]))
        data.SetPoints(points)
    for name in CELLS:
        cells = vtkCellArray()
        cells.SetData(*map(loaded, state[name]))
        getattr(data, "Set" + name)(cells)
    for name in ATTRIBUTES:
        attributes = getattr(data, "Get" + name)()
        for array in state[name]:
            attributes.AddArray(loaded(array))
        for attribute, array_name in state.get("Active" + name, {}).items():
            attributes.SetActiveAttribute(array_name, attribute)
    return data


def dumped(array: typing.Any) -> State:
    """Return name, type and values of an array of numbers or texts."""
    texts = isinstance(array, vtkStringArray)
    values = [array.GetValue(i) for i in range(array.GetNumberOfValues())] if texts else np.array(vtk_to_numpy(array))
    return {"Name": array.GetName(), "Type": array.GetDataType(), "Values": values}


def loaded(state: State) -> typing.Any:
    """Return the array that dumped() described."""
    values = state["Values"]
    if isinstance(values, np.ndarray):
        array = numpy_to_vtk(values, deep=True, array_type=state["Type"])
    else:
        array = vtkStringArray()
        for value in values:
            array.InsertNextValue(value)
    if state["Name"]:
        array.SetName(state["Name"])
    return array
