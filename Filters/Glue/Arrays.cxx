#include "Glue/Arrays.h"

#include "Glue/Run.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace
{
void Require(bool inRange, const std::string& what)
{
  if (!inRange)
  {
    throw std::overflow_error(what + " would leave the range of floating-point numbers: " +
      "coordinates or properties are too large or too small");
  }
}

// Throw std::overflow_error unless all values are finite. Every number that a filter writes is
// checked.
void RequireFinite(const double* values, conformal::Index size, const std::string& what)
{
  Require(Eigen::Map<const Eigen::VectorXd>(values, size).allFinite(), what);
}

// Add the rows of a matrix as tuples.
template <typename RowMatrix>
void AddRows(vtkFieldData* data, const char* name, const RowMatrix& rows)
{
  RequireFinite(rows.data(), rows.size(), name);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(rows.cols()));
  array->SetNumberOfTuples(rows.rows());
  std::copy_n(rows.data(), rows.size(), array->GetPointer(0));
  data->AddArray(array);
}
}

namespace glue
{
//------------------------------------------------------------------------------
void AddVectors(vtkFieldData* data, const char* name, const conformal::Points& vectors)
{
  AddRows(data, name, vectors);
}

//------------------------------------------------------------------------------
void AddPlanePositions(vtkFieldData* data, const char* name,
  const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>& positions)
{
  AddRows(data, name, positions);
}

//------------------------------------------------------------------------------
void AddNumbers(vtkFieldData* data, const char* name, const std::vector<double>& values)
{
  RequireFinite(values.data(), static_cast<conformal::Index>(values.size()), name);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

//------------------------------------------------------------------------------
void AddIntegers(vtkFieldData* data, const char* name, const std::vector<int>& values)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), values[i]);
  }
  data->AddArray(array);
}

//------------------------------------------------------------------------------
void AddLengths(vtkFieldData* data, const char* name, std::vector<double> lengths,
  const conformal::CoordinateFrame& frame)
{
  LengthsFromFrame(lengths.data(), static_cast<conformal::Index>(lengths.size()), frame, name);
  AddNumbers(data, name, lengths);
}

//------------------------------------------------------------------------------
void AddNumber(vtkFieldData* data, const char* name, double value)
{
  AddNumbers(data, name, { value });
}

//------------------------------------------------------------------------------
void AddNumber(vtkFieldData* data, const char* name, long long value)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  data->AddArray(array);
}

//------------------------------------------------------------------------------
void AddTuple(vtkFieldData* data, const char* name, const double* values, int components)
{
  RequireFinite(values, components, name);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->InsertNextTuple(values);
  data->AddArray(array);
}

//------------------------------------------------------------------------------
void LengthsFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what)
{
  Eigen::Map<Eigen::VectorXd>(values, size) *= frame.Unit;
  RequireFinite(values, size, what);
}

//------------------------------------------------------------------------------
void AreasFromFrame(
  double* values, conformal::Index size, const conformal::CoordinateFrame& frame, const char* what)
{
  constexpr double minimum = 0x1p-960; // below this unit of area, small areas would lose digits
  const double square = frame.Unit * frame.Unit;
  Require(square >= minimum, what);
  Eigen::Map<Eigen::VectorXd>(values, size) *= square;
  RequireFinite(values, size, what);
}

//------------------------------------------------------------------------------
void RemoveNormals(vtkPolyData* surface)
{
  surface->GetPointData()->SetNormals(nullptr);
  surface->GetCellData()->SetNormals(nullptr);
}

//------------------------------------------------------------------------------
void SetPoints(
  vtkPolyData* surface, const conformal::Points& points, const conformal::CoordinateFrame& frame)
{
  vtkNew<vtkPoints> copy;
  copy->SetDataTypeToDouble();
  copy->SetNumberOfPoints(points.rows());
  double* coordinates = vtkDoubleArray::SafeDownCast(copy->GetData())->GetPointer(0);
  std::copy_n(points.data(), points.size(), coordinates);
  LengthsFromFrame(coordinates, points.size(), frame, "coordinates of the result");
  surface->SetPoints(copy);
}

//------------------------------------------------------------------------------
void SetSurface(vtkPolyData* surface, const conformal::Points& points,
  const conformal::Triangles& triangles, const conformal::CoordinateFrame& frame)
{
  surface->Initialize();
  SetPoints(surface, points, frame);
  SetTriangles(surface, triangles);
}

//------------------------------------------------------------------------------
void SetTriangles(vtkPolyData* surface, const conformal::Triangles& triangles)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(triangles.size());
  vtkIdType* ids = connectivity->GetPointer(0);
  const conformal::Index blockSize = 65536;
  conformal::forBlocks(SMPRun(), triangles.size(), blockSize,
    [&](conformal::Index begin, conformal::Index end)
    { std::copy(triangles.data() + begin, triangles.data() + end, ids + begin); });
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, connectivity);
  surface->SetPolys(cells);
}
}
