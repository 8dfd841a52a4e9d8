"""Names of arrays for VTK's writers of XML files, which do not escape them, so that VTK cannot read such a file."""
import re

from vtkmodules.vtkCommonCore import vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataObject

ESCAPED = {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\t": "&#9;", "\n": "&#10;", "\r": "&#13;"}
NAMELESS = "array"  # readers refuse an empty name


def escaped(name):
    """A name as the value of an attribute in XML. Characters that XML does not have become "_"."""
    text = re.sub("[\0-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]", "_", name or NAMELESS)
    return "".join(ESCAPED.get(character, character) for character in text)


def escape_input(writer):
    """Replace the input of a writer by one whose arrays and components have escaped names, if some differ."""
    connection = writer.GetInputConnection(0, 0)
    connection.GetProducer().Update(connection.GetIndex())
    data = writer.GetInputDataObject(0, 0)
    result = data.NewInstance()
    result.ShallowCopy(data)
    is_changed = False
    for kind in (vtkDataObject.POINT, vtkDataObject.CELL, vtkDataObject.FIELD):
        fields = data.GetAttributesAsFieldData(kind)
        if any(names_of(array) != [escaped(name) for name in names_of(array)] for array in arrays_of(fields)):
            result.GetAttributesAsFieldData(kind).ShallowCopy(with_escaped_names(fields))
            is_changed = True
    if is_changed:
        writer.SetInputData(result)


def arrays_of(fields):
    """All arrays, also those of text."""
    return [fields.GetAbstractArray(i) for i in range(fields.GetNumberOfArrays())]


def names_of(array):
    """The name of an array, and those of its components that have one."""
    components = (array.GetComponentName(i) for i in range(array.GetNumberOfComponents()))
    return [array.GetName(), *(name for name in components if name is not None)]


def with_escaped_names(fields):
    """A copy of field data with other names; active arrays stay active."""
    result = fields.NewInstance()
    for i, array in enumerate(arrays_of(fields)):
        copy = array.NewInstance()
        if isinstance(array, vtkDataArray):
            copy.ShallowCopy(array)
        else:
            copy.DeepCopy(array)
        copy.SetName(escaped(array.GetName()))
        for component in range(array.GetNumberOfComponents()):
            name = array.GetComponentName(component)
            if name is not None:
                copy.SetComponentName(component, escaped(name))
        index = result.AddArray(copy)
        if hasattr(fields, "IsArrayAnAttribute") and fields.IsArrayAnAttribute(i) >= 0:
            result.SetActiveAttribute(index, fields.IsArrayAnAttribute(i))
    return result
