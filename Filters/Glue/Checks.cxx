#include "Glue/Checks.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace
{
// Return a text with a number of things, such as "2 tuples".
std::string Count(vtkIdType count, const std::string& thing)
{
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

// Check all arrays of points or cells.
void RequireArrays(
  vtkDataSetAttributes* data, vtkIdType size, const std::string& thing, const std::string& what)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    const std::string name = array->GetName() ? array->GetName() : "";
    const std::string title = what + ": the " + thing + " array " +
      (name.empty() ? std::to_string(i) + " (without a name)" : "\"" + name + "\"");
    if (array->GetNumberOfTuples() != size)
    {
      throw std::invalid_argument(title + " has " + Count(array->GetNumberOfTuples(), "tuple") +
        " for " + Count(size, thing) + ". Give it a tuple for each " + thing + ", or remove it.");
    }
    if (name == vtkDataSetAttributes::GhostArrayName() &&
      (!vtkUnsignedCharArray::SafeDownCast(array) || array->GetNumberOfComponents() != 1))
    {
      throw std::invalid_argument(title + " is a " + array->GetClassName() + " of " +
        Count(array->GetNumberOfComponents(), "component") +
        ", but ghosts are marked by a vtkUnsignedCharArray of 1 component. Convert it, or remove "
        "it.");
    }
  }
  vtkDataArray* normals = data->GetNormals();
  if (normals && normals->GetNumberOfComponents() != 3)
  {
    throw std::invalid_argument(what + ": the active normals of the " + thing + "s have " +
      Count(normals->GetNumberOfComponents(), "component") +
      " instead of 3. Convert them, or remove them.");
  }
}

// Check the offsets of all cells. Call this function before cells are counted.
void RequireOffsets(vtkPolyData* surface, const std::string& what)
{
  const std::pair<vtkCellArray*, const char*> kinds[] = { { surface->GetVerts(), "vertices" },
    { surface->GetLines(), "lines" }, { surface->GetPolys(), "polygons" },
    { surface->GetStrips(), "strips" } };
  for (const auto& [cells, name] : kinds)
  {
    if (!cells->IsValid())
    {
      throw std::invalid_argument(what + ": the offsets of the " + name +
        " do not fit their point ids (see vtkCellArray::IsValid). Rebuild the cells.");
    }
  }
}

void RequireIds(vtkCellArray* cells, vtkIdType firstCellId, vtkIdType numberOfPoints)
{
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      if (ids[k] < 0 || ids[k] >= numberOfPoints)
      {
        throw std::invalid_argument("cell " + std::to_string(firstCellId + i) +
          " refers to point " + std::to_string(ids[k]) + " of " + std::to_string(numberOfPoints));
      }
    }
  }
}
}

namespace glue
{
//------------------------------------------------------------------------------
void RequireConsistentInputs(vtkAlgorithm* self)
{
  for (int port = 0; port < self->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < self->GetNumberOfInputConnections(port); ++i)
    {
      RequireConsistentData(
        self->GetInputDataObject(port, i), "input port " + std::to_string(port));
    }
  }
}

//------------------------------------------------------------------------------
void RequireConsistentData(vtkDataObject* data, const std::string& what)
{
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    vtkIdType number = 0;
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem(), ++number)
    {
      RequireConsistentData(
        each->GetCurrentDataObject(), what + ", block " + std::to_string(number));
    }
  }
  auto* dataSet = vtkDataSet::SafeDownCast(data);
  if (!dataSet)
  {
    return;
  }
  if (auto* surface = vtkPolyData::SafeDownCast(dataSet))
  {
    RequireOffsets(surface, what);
  }
  if (auto* pointSet = vtkPointSet::SafeDownCast(dataSet))
  {
    const int components =
      pointSet->GetPoints() ? pointSet->GetPoints()->GetData()->GetNumberOfComponents() : 3;
    if (components != 3)
    {
      throw std::invalid_argument(what + ": the points have " + Count(components, "component") +
        " instead of 3. Convert them.");
    }
  }
  RequireArrays(dataSet->GetPointData(), dataSet->GetNumberOfPoints(), "point", what);
  RequireArrays(dataSet->GetCellData(), dataSet->GetNumberOfCells(), "cell", what);
}

//------------------------------------------------------------------------------
void RequireCellIds(vtkPolyData* surface)
{
  vtkIdType firstCellId = 0;
  for (vtkCellArray* cells :
    { surface->GetVerts(), surface->GetLines(), surface->GetPolys(), surface->GetStrips() })
  {
    RequireIds(cells, firstCellId, surface->GetNumberOfPoints());
    firstCellId += cells->GetNumberOfCells();
  }
}
}
