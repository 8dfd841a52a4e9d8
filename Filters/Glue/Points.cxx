#include "Glue/Points.h"

#include "Glue/Run.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>
#include <string>

namespace
{
// Copy the vectors of the array. The array has one vector for each point, since the inputs were
// checked.
void ReadSpherePositions(vtkDataArray* array, conformal::Points& positions)
{
  if (!glue::ToVectors(array, positions))
  {
    throw std::invalid_argument(std::string("the point array ") + glue::SpherePositionName() +
      " has " + std::to_string(array->GetNumberOfComponents()) + " components instead of 3");
  }
}
}

namespace glue
{
//------------------------------------------------------------------------------
conformal::PointView ViewVectors(vtkDataArray* array, const char* what, conformal::Points& copy,
  const conformal::CoordinateFrame& frame)
{
  if (!array || array->GetNumberOfComponents() != 3)
  {
    throw std::invalid_argument(std::string(what) + " must be an array of 3 components");
  }
  if (auto* floats = vtkFloatArray::SafeDownCast(array))
  {
    return { floats->GetPointer(0), floats->GetNumberOfTuples(), frame.Unit };
  }
  if (auto* doubles = vtkDoubleArray::SafeDownCast(array))
  {
    return { doubles->GetPointer(0), doubles->GetNumberOfTuples(), frame.Unit };
  }
  ToVectors(array, copy);
  return { copy.data(), copy.rows(), frame.Unit };
}

//------------------------------------------------------------------------------
conformal::PointView ViewPoints(
  vtkPoints* points, const conformal::CoordinateFrame& frame, conformal::Points& copy)
{
  return points ? ViewVectors(points->GetData(), "points", copy, frame) : conformal::PointView();
}

//------------------------------------------------------------------------------
conformal::CoordinateFrame FrameOf(
  const std::vector<vtkPointSet*>& data, const conformal::Reduce& reduce)
{
  std::vector<conformal::Points> copies(data.size());
  std::vector<conformal::PointView> views;
  for (vtkPointSet* points : data)
  {
    if (points)
    {
      views.push_back(ViewPoints(points->GetPoints(), {}, copies[views.size()]));
    }
  }
  return conformal::frameOf(views, reduce, SMPRun());
}

//------------------------------------------------------------------------------
conformal::NumberView ViewNumbers(vtkDataArray* array, std::vector<double>& copy)
{
  if (auto* floats = vtkFloatArray::SafeDownCast(array))
  {
    return { floats->GetPointer(0), floats->GetNumberOfTuples() };
  }
  if (auto* doubles = vtkDoubleArray::SafeDownCast(array))
  {
    return { doubles->GetPointer(0), doubles->GetNumberOfTuples() };
  }
  copy.resize(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < copy.size(); ++i)
  {
    copy[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return copy;
}

//------------------------------------------------------------------------------
std::function<bool(conformal::Index)> GhostTest(vtkPointSet* input)
{
  vtkUnsignedCharArray* ghosts = input->GetPointGhostArray();
  if (!ghosts)
  {
    return {};
  }
  return [ghosts](conformal::Index i)
  {
    return (ghosts->GetValue(i) &
             (vtkDataSetAttributes::HIDDENPOINT | vtkDataSetAttributes::DUPLICATEPOINT)) != 0;
  };
}

//------------------------------------------------------------------------------
conformal::Points ToPoints(vtkPoints* points, const conformal::CoordinateFrame& frame)
{
  conformal::Points copy;
  const conformal::PointView view = ViewPoints(points, frame, copy);
  conformal::Points result(view.size(), 3);
  for (conformal::Index i = 0; i < result.rows(); ++i)
  {
    result.row(i) = view[i];
  }
  return result;
}

//------------------------------------------------------------------------------
bool ToVectors(vtkDataArray* array, conformal::Points& vectors)
{
  if (!array || array->GetNumberOfComponents() != 3)
  {
    return false;
  }
  vectors.resize(array->GetNumberOfTuples(), 3);
  for (vtkIdType i = 0; i < vectors.rows(); ++i)
  {
    array->GetTuple(i, vectors.row(i).data());
  }
  return true;
}

//------------------------------------------------------------------------------
conformal::Points ToSpherePositions(vtkPolyData* surface)
{
  const std::string name = SpherePositionName();
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    const std::string why = surface->GetPointData()->HasArray(TorusPositionName())
      ? ": it is mapped to a flat torus, and this filter needs a map to the sphere"
      : "; map a closed surface without handles by vtkGlobalConformalMap";
    throw std::invalid_argument("the surface has no point array " + name + why);
  }
  conformal::Points positions;
  ReadSpherePositions(array, positions);
  const conformal::Index bad = conformal::normalizeRows(positions);
  if (bad > 0)
  {
    throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(positions.rows()) +
      " vectors of " + name + " are zero or not finite");
  }
  return positions;
}

//------------------------------------------------------------------------------
bool FindSpherePositions(vtkPolyData* surface, conformal::Points& positions)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(SpherePositionName());
  if (!array)
  {
    return false;
  }
  ReadSpherePositions(array, positions);
  return true;
}

//------------------------------------------------------------------------------
conformal::TorusPositions ToTorusPositions(vtkPolyData* surface)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(TorusPositionName());
  if (!array)
  {
    throw std::invalid_argument(std::string("the surface has no point array ") +
      TorusPositionName() + "; vtkGlobalConformalMap writes it for a surface of genus 1");
  }
  if (array->GetNumberOfComponents() != 2)
  {
    throw std::invalid_argument(std::string(TorusPositionName()) + " must have 2 components, not " +
      std::to_string(array->GetNumberOfComponents()));
  }
  conformal::TorusPositions positions(array->GetNumberOfTuples(), 2);
  for (vtkIdType i = 0; i < positions.rows(); ++i)
  {
    array->GetTuple(i, positions.row(i).data());
  }
  const auto bad = positions.rows() - positions.array().isFinite().rowwise().all().count();
  if (bad > 0)
  {
    throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(positions.rows()) +
      " positions of " + TorusPositionName() + " are not finite");
  }
  return positions;
}
}
