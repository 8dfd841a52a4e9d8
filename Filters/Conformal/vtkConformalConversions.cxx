#include "Glue/Arrays.h"
#include "Glue/Points.h"
#include "Glue/Run.h"

#include "Glue/Checks.h"
#include "Glue/Compatibility.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace
{
// Its vectors, which are one for each point since the input was checked.
void ReadSpherePositions(vtkDataArray* array, conformal::Points& positions)
{
  if (!glue::ToVectors(array, positions))
  {
    throw std::invalid_argument(std::string("the point array ") + glue::SpherePositionName() +
      " has " + std::to_string(array->GetNumberOfComponents()) + " components instead of 3");
  }
}

void EmptyOutputs(vtkAlgorithm* self)
{
  for (int port = 0; port < self->GetNumberOfOutputPorts(); ++port)
  {
    if (vtkDataObject* output = self->GetOutputDataObject(port))
    {
      output->Initialize();
    }
  }
}

void Require(bool inRange, const std::string& what)
{
  if (!inRange)
  {
    throw std::overflow_error(what + " would leave the range of floating-point numbers: " +
      "coordinates or properties are too large or too small");
  }
}

// Whatever a filter writes passes here.
void RequireFinite(const double* values, conformal::Index size, const std::string& what)
{
  Require(Eigen::Map<const Eigen::VectorXd>(values, size).allFinite(), what);
}
}

namespace glue
{
//------------------------------------------------------------------------------
conformal::Run SMPRun()
{
  const conformal::ParallelFor threads =
    [](conformal::Index count, const std::function<void(conformal::Index)>& body)
  {
    vtkSMPTools::For(0, count, 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          body(i);
        }
      });
  };
  return { threads };
}

//------------------------------------------------------------------------------
conformal::Progress ProgressOf(vtkAlgorithm* self)
{
  // Observers may draw, and may abort: they are told of every visible step, and of a slow
  // run every 50 ms, or every thousandth of its time so far, which bounds their number.
  constexpr double minimumStep = 0.002;
  using Clock = std::chrono::steady_clock;
  struct State
  {
    Clock::time_point Start = Clock::now(), Last = Start;
    double Reached = 0.0, Next = 0.0;
  };
  // One of all copies, which parts of the progress hold.
  const auto state = std::make_shared<State>();
  return [=](double reached)
  {
    const Clock::time_point now = Clock::now();
    const Clock::duration longest =
      std::max<Clock::duration>(std::chrono::milliseconds(50), (now - state->Start) / 1000);
    if (reached >= state->Next || reached == 1.0 || now - state->Last >= longest)
    {
      state->Reached = std::max(state->Reached, reached);
      state->Next = state->Reached + minimumStep;
      state->Last = now;
      self->UpdateProgress(state->Reached);
    }
    return !glue::IsAbortWanted(self);
  };
}

//------------------------------------------------------------------------------
conformal::Run RunOf(vtkAlgorithm* self)
{
  return SMPRun().watchedBy(ProgressOf(self));
}

//------------------------------------------------------------------------------
std::string MessageOf(const std::exception& error)
{
  return dynamic_cast<const std::bad_alloc*>(&error) ? "out of memory" : error.what();
}

//------------------------------------------------------------------------------
bool ReportErrors(vtkObject* self, const std::function<void()>& core)
{
  try
  {
    core();
    return true;
  }
  catch (const std::exception& e)
  {
    vtkErrorWithObjectMacro(self, << MessageOf(e));
  }
  return false;
}

//------------------------------------------------------------------------------
int RunCore(vtkAlgorithm* self, const std::function<void()>& core)
{
  return RunRequest(self,
    [&]()
    {
      glue::RequireConsistentInputs(self);
      core();
      RunOf(self).report(1.0); // the last time that a request to stop is noticed
    });
}

//------------------------------------------------------------------------------
int RunRequest(vtkAlgorithm* self, const std::function<void()>& request)
{
  bool whole = true;
  const bool good = ReportErrors(self,
    [&]()
    {
      try
      {
        request();
      }
      catch (const conformal::Aborted&)
      {
        whole = false;
      }
    });
  if (!good || !whole)
  {
    EmptyOutputs(self);
  }
  return good;
}

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
void WarnOfEmptyInput(vtkObject* self, const char* message)
{
  vtkMultiProcessController* processes = vtkMultiProcessController::GetGlobalController();
  if (!processes || processes->GetLocalProcessId() == 0)
  {
    vtkWarningWithObjectMacro(self, << message);
  }
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
    throw std::invalid_argument("the surface has no point array " + name);
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
void AddVectors(vtkFieldData* data, const char* name, const conformal::Points& vectors)
{
  RequireFinite(vectors.data(), vectors.size(), name);
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(vectors.rows());
  std::copy_n(vectors.data(), vectors.size(), array->GetPointer(0));
  data->AddArray(array);
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
  constexpr double least = 0x1p-960; // smaller areas beside would lose digits
  const double square = frame.Unit * frame.Unit;
  Require(square >= least, what);
  Eigen::Map<Eigen::VectorXd>(values, size) *= square;
  RequireFinite(values, size, what);
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
