#include "vtkGenusZeroCheck.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Mesh/GenusZeroCheck.h"

#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <string>
#include <vector>

vtkStandardNewMacro(vtkGenusZeroCheck);

namespace
{
void AddCount(vtkFieldData* data, const char* name, conformal::Index value)
{
  glue::AddNumber(data, name, static_cast<long long>(value));
}

// Add an array of the ids of faults, and an array with their number.
void AddFaults(
  vtkFieldData* data, const char* countName, const char* name, const std::vector<vtkIdType>& ids)
{
  AddCount(data, countName, static_cast<conformal::Index>(ids.size()));
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  for (vtkIdType id : ids)
  {
    array->InsertNextValue(id);
  }
  data->AddArray(array);
}

void AddFaults(vtkFieldData* data, const char* countName, const char* name,
  const std::vector<conformal::Edge>& edges)
{
  AddCount(data, countName, static_cast<conformal::Index>(edges.size()));
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(2);
  for (const auto& [from, to] : edges)
  {
    array->InsertNextTuple2(from, to);
  }
  data->AddArray(array);
}

void AddLines(vtkFieldData* data, const char* name, const std::vector<std::string>& lines)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& line : lines)
  {
    array->InsertNextValue(line);
  }
  data->AddArray(array);
}

std::vector<vtkIdType> IdsOf(const std::vector<int>& ids)
{
  return { ids.begin(), ids.end() };
}

// Add the report as field data.
// @param[in] cellIds  cell of each triangle
void AddReport(vtkFieldData* data, const conformal::GenusZeroReport& report,
  const std::vector<vtkIdType>& cellIds)
{
  AddCount(data, "IsGenusZero", report.isGenusZero());
  AddCount(data, "EulerNumber", report.EulerNumber);
  AddCount(data, "NumberOfBoundaryLoops", report.NumberOfBoundaryLoops);
  AddCount(data, "NumberOfComponents", report.NumberOfComponents);
  AddCount(data, "IsInsideOut", report.InsideOut);
  AddCount(
    data, "NumberOfNonFinitePoints", static_cast<conformal::Index>(report.NonFinitePoints.size()));
  AddFaults(data, "NumberOfBoundaryEdges", "BoundaryEdges", report.BoundaryEdges);
  AddFaults(data, "NumberOfNonManifoldEdges", "NonManifoldEdges", report.NonManifoldEdges);
  AddFaults(data, "NumberOfInconsistentEdges", "InconsistentEdges", report.InconsistentEdges);
  AddFaults(
    data, "NumberOfNonManifoldVertices", "NonManifoldVertices", IdsOf(report.NonManifoldVertices));
  AddFaults(data, "NumberOfIsolatedPoints", "IsolatedPoints", IdsOf(report.IsolatedPoints));
  std::vector<vtkIdType> degenerate;
  for (int r : report.DegenerateTriangles)
  {
    degenerate.push_back(cellIds[r]);
  }
  AddFaults(data, "NumberOfDegenerateTriangles", "DegenerateTriangles", degenerate);
  AddLines(data, "GenusZeroReport", conformal::describe(report));
}
}

//------------------------------------------------------------------------------
int vtkGenusZeroCheck::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto input = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  return glue::RunCore(this,
    [&]()
    {
      if (input->GetNumberOfPoints() == 0)
      {
        glue::WarnOfEmptyInput(this, "the surface is empty; it is not of genus zero");
      }
      // Relative costs of reading, points and check.
      conformal::Steps steps(glue::RunOf(this), { 0.09, 0.01, 0.9 });
      steps.next();
      std::vector<vtkIdType> cellIds;
      const conformal::Triangles triangles = glue::ToTriangles(input, cellIds);
      steps.next();
      const conformal::Points points = glue::ToPoints(input->GetPoints(), glue::FrameOf({ input }));
      const conformal::GenusZeroReport report =
        conformal::checkGenusZero(triangles, points.rows(), points, steps.next());

      output->ShallowCopy(input);
      AddReport(output->GetFieldData(), report, cellIds);
    });
}

//------------------------------------------------------------------------------
void vtkGenusZeroCheck::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
