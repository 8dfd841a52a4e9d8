"""The unit and the name of a body, as vtkPlateModelReader finds them in the label beside a file."""
from .plan import METERS


def value_of(data, name):
    """The only value of a field array, or None without such an array."""
    array = data.GetFieldData().GetAbstractArray(name)
    return array.GetVariantValue(0) if array and array.GetNumberOfValues() == 1 else None


def meters_of(data, unit, default, steps):
    """The length of the unit of coordinates in meters: of --unit if given, else of the label, else of a default.

    Warns if --unit is not the unit of the label.
    """
    value = value_of(data, "MetersPerUnit")
    labeled = value.ToDouble() if value else None
    if unit and labeled and METERS[unit] != labeled:
        steps.note("--unit", f"{unit} is used, but the label has {labeled:g} m per unit")
    return METERS[unit] if unit else labeled or METERS[default]


def target_of(data):
    """The name of the body, or an empty text."""
    value = value_of(data, "TargetName")
    return value.ToString() if value else ""
