"""Data of VTK as dictionaries of arrays of NumPy, which can be pickled."""
import typing

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkConstants import VTK_BIT, VTK_UNSIGNED_CHAR
from vtkmodules.vtkCommonCore import vtkBitArray, vtkDataArray, vtkPoints, vtkStringArray, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkDataSetAttributes, vtkPolyData

CELLS = ("Verts", "Lines", "Polys", "Strips")
ATTRIBUTES = ("PointData", "CellData", "FieldData")
State = typing.Dict[str, typing.Any]


def dumps(data: vtkPolyData) -> State:
    """Return points, cells and all arrays of a surface. Raises TypeError for arrays of neither numbers nor texts."""
    state: State = {"Points": dumped(data.GetPoints().GetData()) if data.GetPoints() else None}
    for name in CELLS:
        cells = getattr(data, "Get" + name)()
        state[name] = [dumped(cells.GetOffsetsArray()), dumped(cells.GetConnectivityArray())]
    for name in ATTRIBUTES:
        attributes = getattr(data, "Get" + name)()
        state[name] = [dumped(attributes.GetAbstractArray(i)) for i in range(attributes.GetNumberOfArrays())]
        if name != "FieldData":
            indices = [-1] * vtkDataSetAttributes.NUM_ATTRIBUTES
            attributes.GetAttributeIndices(indices)
            state["Active" + name] = {i: index for i, index in enumerate(indices) if index >= 0}
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
        for attribute, index in state.get("Active" + name, {}).items():
            attributes.SetActiveAttribute(index, attribute)
    return data


def dumped(array: typing.Any) -> State:
    """Return name, type, components and values of an array of numbers or texts."""
    values: typing.Any
    if isinstance(array, vtkStringArray):
        values = [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    elif isinstance(array, vtkDataArray):
        values = np.array(numbers_of(array))
    else:
        raise TypeError(f"the array {array.GetName()!r} cannot be pickled or copied, since it is a "
                        f"{array.GetClassName()}: remove it, or replace it by an array of numbers or texts")
    components = [array.GetComponentName(i) for i in range(array.GetNumberOfComponents())]
    return {"Name": array.GetName(), "Type": array.GetDataType(), "Components": components, "Values": values}


def numbers_of(array: typing.Any) -> typing.Any:
    """Return numbers as an array of NumPy over the same memory. Bits are copied to bytes, 0 or 1."""
    if isinstance(array, vtkBitArray):
        bits, array = array, vtkUnsignedCharArray()
        array.DeepCopy(bits)
    return vtk_to_numpy(array)


def loaded(state: State) -> typing.Any:
    """Return the array that dumped() described."""
    values, components = state["Values"], state["Components"]
    if isinstance(values, np.ndarray):
        is_bits = state["Type"] == VTK_BIT
        array = numpy_to_vtk(values, deep=True, array_type=VTK_UNSIGNED_CHAR if is_bits else state["Type"])
        if is_bits:
            array, numbers = vtkBitArray(), array
            array.DeepCopy(numbers)
    else:
        array = vtkStringArray()
        array.SetNumberOfComponents(len(components))
        for value in values:
            array.InsertNextValue(value)
    for i, name in enumerate(components):
        if name is not None:
            array.SetComponentName(i, name)
    if state["Name"]:
        array.SetName(state["Name"])
    return array
