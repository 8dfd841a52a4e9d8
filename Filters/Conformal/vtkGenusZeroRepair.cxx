#include "vtkGenusZeroRepair.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/CarriedArrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Mesh/MeshTopology.h"
#include "Register/ResampleWeights.h"
#include "Repair/GenusZeroRepair.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkGenusZeroRepair);

namespace
{
using Repaired = conformal::GenusZeroRepairResult;
using conformal::RepairLoopType;

void AddOriginalIds(vtkFieldData* data, const char* name, const std::vector<vtkIdType>& ids)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(ids.size()));
  std::copy(ids.begin(), ids.end(), array->GetPointer(0));
  data->AddArray(array);
}

// Compute the frame of the points that triangles use. Files mark unused points by huge coordinates.
conformal::CoordinateFrame FrameOfUsedPoints(
  vtkPolyData* surface, const conformal::Triangles& triangles)
{
  conformal::Points copy;
  const conformal::PointView points = glue::ViewPoints(surface->GetPoints(), {}, copy);
  const std::vector<int> ids = conformal::usedVertices(triangles, points.size());
  conformal::Points used(static_cast<conformal::Index>(ids.size()), 3);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    used.row(static_cast<conformal::Index>(i)) = points[ids[i]];
  }
  return conformal::frameOf({ used });
}

// Return whether the result equals the input. The number of points does not tell: an unused point
// is removed, and a separated point is duplicated.
bool IsAsBefore(const Repaired& repaired, vtkPolyData* surface)
{
  bool hasSamePoints =
    static_cast<vtkIdType>(repaired.PointIds.size()) == surface->GetNumberOfPoints();
  for (std::size_t i = 0; i < repaired.PointIds.size() && hasSamePoints; ++i)
  {
    hasSamePoints = repaired.PointIds[i] == static_cast<int>(i);
  }
  return hasSamePoints && repaired.Gluing.NumberOfNonManifoldEdges == 0 && repaired.Loops.empty() &&
    repaired.NumberOfTrianglesAdded == 0 && repaired.NumberOfPointsMerged == 0 &&
    repaired.NumberOfPartsJoined == 0 && repaired.Gluing.NumberOfTurnedTriangles == 0 &&
    repaired.Gluing.NumberOfRepeatedPoints == 0 && repaired.Gluing.NumberOfDuplicates == 0 &&
    repaired.Gluing.NumberOfPartsRemoved == 0 &&
    surface->GetNumberOfVerts() + surface->GetNumberOfLines() == 0;
}

// Copy the point arrays for remaining points. For added points, compute values from the points
// around them.
void CarryArrays(
  vtkObject* self, vtkPolyData* surface, const Repaired& repaired, vtkPolyData* output)
{
  conformal::ResampleWeights weights;
  for (const std::vector<int>& parents : repaired.Parents)
  {
    std::vector<std::pair<int, double>> parts;
    parts.reserve(parents.size());
    for (const int id : parents)
    {
      parts.emplace_back(id, 1.0);
    }
    weights.add(parts);
  }
  vtkNew<vtkPointData> added;
  glue::CarryPointArrays(self, { surface }, weights, added);
  const auto kept = static_cast<vtkIdType>(repaired.PointIds.size() - repaired.Parents.size());
  for (int i = 0; i < added->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* ofAdded = added->GetArray(i);
    vtkDataArray* before = surface->GetPointData()->GetArray(ofAdded->GetName());
    const auto array = vtkSmartPointer<vtkDataArray>::Take(before->NewInstance());
    array->SetName(before->GetName());
    array->SetNumberOfComponents(before->GetNumberOfComponents());
    array->CopyComponentNames(before);
    array->SetLookupTable(before->GetLookupTable());
    array->SetNumberOfTuples(output->GetNumberOfPoints());
    for (vtkIdType v = 0; v < kept; ++v)
    {
      array->SetTuple(v, repaired.PointIds[v], before);
    }
    array->InsertTuples(kept, ofAdded->GetNumberOfTuples(), 0, ofAdded);
    output->GetPointData()->AddArray(array);
    if (before == surface->GetPointData()->GetScalars())
    {
      output->GetPointData()->SetActiveScalars(array->GetName());
    }
  }
}

void SetRepaired(vtkObject* self, vtkPolyData* surface, const std::vector<vtkIdType>& cellIds,
  const Repaired& repaired, const conformal::CoordinateFrame& frame, vtkPolyData* output)
{
  std::vector<vtkIdType> points(repaired.PointIds.begin(), repaired.PointIds.end()), cells;
  if (IsAsBefore(repaired, surface))
  {
    output->ShallowCopy(surface);
    cells.resize(surface->GetNumberOfCells());
    std::iota(cells.begin(), cells.end(), vtkIdType(0));
  }
  else
  {
    glue::SetSurface(output, repaired.Positions, repaired.Triangles, frame);
    output->GetFieldData()->PassData(surface->GetFieldData());
    CarryArrays(self, surface, repaired, output);
    for (const int triangle : repaired.TriangleIds)
    {
      cells.push_back(triangle < 0 ? -1 : cellIds[triangle]);
    }
  }
  AddOriginalIds(output->GetPointData(), "OriginalPointIds", points);
  AddOriginalIds(output->GetCellData(), "OriginalCellIds", cells);
}

void SetLoops(const Repaired& repaired, const conformal::CoordinateFrame& frame, vtkPolyData* loops)
{
  conformal::Index size = 0;
  for (const conformal::RepairLoop& loop : repaired.Loops)
  {
    size += loop.Positions.rows();
  }
  conformal::Points points(size, 3);
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> types;
  types->SetName("LoopType");
  std::vector<double> lengths, areas;
  conformal::Index first = 0;
  for (const conformal::RepairLoop& loop : repaired.Loops)
  {
    const conformal::Index count = loop.Positions.rows();
    points.middleRows(first, count) = loop.Positions;
    lines->InsertNextCell(static_cast<int>(count) + 1);
    double length = 0.0;
    for (conformal::Index i = 0; i <= count; ++i)
    {
      lines->InsertCellPoint(first + i % count);
      length +=
        (loop.Positions.row((i + 1) % count) - loop.Positions.row(i % count)).norm() * (i < count);
    }
    types->InsertNextValue(static_cast<vtkIdType>(loop.Type));
    lengths.push_back(length);
    areas.push_back(loop.AreaFraction);
    first += count;
  }
  glue::SetPoints(loops, points, frame);
  loops->SetLines(lines);
  loops->GetCellData()->AddArray(types);
  glue::AddLengths(loops->GetCellData(), "LoopLength", lengths, frame);
  glue::AddNumbers(loops->GetCellData(), "LoopAreaFraction", areas);
}

// Writer of field data: adds numbers, and a report with one line for each number that is not 0.
class Report
{
public:
  explicit Report(vtkFieldData* data)
    : Data(data)
  {
  }

  void Add(const char* name, conformal::Index value, const std::string& words)
  {
    glue::AddNumber(this->Data, name, static_cast<long long>(value));
    if (value > 0 && !words.empty())
    {
      this->Lines->InsertNextValue(std::to_string(value) + " " + words);
    }
  }

  void Close(const std::string& verdict)
  {
    this->Lines->InsertNextValue(verdict);
    this->Lines->SetName("RepairReport");
    this->Data->AddArray(this->Lines);
  }

private:
  vtkFieldData* Data;
  vtkNew<vtkStringArray> Lines;
};

void AddFigures(vtkFieldData* data, const Repaired& repaired, conformal::Index numberOfTriangles)
{
  const conformal::GluingReport& gluing = repaired.Gluing;
  Report report(data);
  report.Add("NumberOfPointsMerged", repaired.NumberOfPointsMerged,
    "coincident points of open edges were merged");
  report.Add("NumberOfTrianglesDropped", gluing.NumberOfRepeatedPoints + gluing.NumberOfDuplicates,
    "triangles with a repeated point, or duplicates of others, were dropped");
  report.Add("NumberOfEdgesSeparated", gluing.NumberOfNonManifoldEdges,
    "edges of more than two triangles were separated");
  report.Add("NumberOfPointsSeparated", gluing.NumberOfSeparatedPoints,
    "points were duplicated, since their triangles do not form one fan");
  report.Add("NumberOfPartsJoined", repaired.NumberOfPartsJoined,
    "parts that overlap others were joined with them");
  report.Add("NumberOfPartsRemoved", gluing.NumberOfPartsRemoved,
    "parts other than the largest were left out");
  report.Add("NumberOfTrianglesRemoved", gluing.NumberOfTrianglesRemoved,
    "triangles belonged to these parts");
  report.Add("NumberOfTrianglesTurned", gluing.NumberOfTurnedTriangles,
    "triangles were reversed for a consistent orientation");
  report.Add(
    "NumberOfBoundariesFilled", repaired.count(RepairLoopType::FilledHole), "holes were filled");
  report.Add("NumberOfBoundariesLeft", repaired.count(RepairLoopType::OpenHole),
    "holes were left open: they are too large");
  report.Add(
    "NumberOfHandlesCut", repaired.count(RepairLoopType::CutHandle), "handles were cut through");
  report.Add(
    "NumberOfTunnelsFilled", repaired.count(RepairLoopType::FilledTunnel), "tunnels were filled");
  report.Add("NumberOfTrianglesAdded", repaired.NumberOfTrianglesAdded, "triangles were added");
  report.Add("IsGenusZero", repaired.IsGenusZero, "");
  report.Close(repaired.IsGenusZero ? "the result is a closed surface of genus zero"
                                    : "the result is not closed");
  using glue::AddNumber;
  AddNumber(data, "EulerNumber", static_cast<long long>(repaired.EulerNumber));
  AddNumber(data, "RemovedAreaFraction", gluing.AreaRemoved);
  AddNumber(data, "UntouchedFraction",
    static_cast<double>(repaired.NumberOfTrianglesUntouched) /
      static_cast<double>(numberOfTriangles));
}

void WarnOfRepairs(vtkObject* self, const Repaired& repaired)
{
  const conformal::GluingReport& gluing = repaired.Gluing;
  const conformal::Index open = repaired.count(RepairLoopType::OpenHole),
                         dropped = gluing.NumberOfRepeatedPoints + gluing.NumberOfDuplicates;
  if (dropped > 0)
  {
    vtkWarningWithObjectMacro(
      self, << dropped << " triangles were dropped: they have a repeated point, or are duplicates");
  }
  if (gluing.NumberOfNonManifoldEdges > 0)
  {
    vtkWarningWithObjectMacro(self,
      << gluing.NumberOfNonManifoldEdges << " edges of more than two triangles were separated");
  }
  if (gluing.NumberOfSeparatedPoints > 0)
  {
    vtkWarningWithObjectMacro(
      self, << gluing.NumberOfSeparatedPoints
            << " points were duplicated, since their triangles do not form one fan");
  }
  if (gluing.NumberOfPartsRemoved > 0)
  {
    vtkWarningWithObjectMacro(self, << gluing.NumberOfPartsRemoved
                                    << " parts other than the largest were left out, with "
                                    << 100.0 * gluing.AreaRemoved << " % of the area");
  }
  if (open > 0)
  {
    vtkWarningWithObjectMacro(self, << open
                                    << " holes were left open, since their area is more than "
                                       "MaximumHoleArea of that of the surface");
  }
}
}

//------------------------------------------------------------------------------
vtkGenusZeroRepair::vtkGenusZeroRepair()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
int vtkGenusZeroRepair::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkPolyData* loops = vtkPolyData::GetData(outputVector, 1);
  conformal::GenusZeroRepairOptions options;
  options.MaximumHoleArea = this->MaximumHoleArea;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      // Relative costs of reading, repair and output.
      conformal::Steps steps(glue::RunOf(this), { 0.04, 0.9, 0.06 });
      steps.next();
      std::vector<vtkIdType> cellIds;
      const conformal::Triangles triangles = glue::ToTriangles(surface, cellIds);
      const conformal::CoordinateFrame frame = FrameOfUsedPoints(surface, triangles);
      conformal::Points copy;
      const Repaired repaired = conformal::repairGenusZero(
        glue::ViewPoints(surface->GetPoints(), frame, copy), triangles, options, steps.next());
      steps.next();
      WarnOfRepairs(this, repaired);
      SetLoops(repaired, frame, loops);
      loops->GetFieldData()->PassData(surface->GetFieldData()); // as VTK does before a run
      SetRepaired(this, surface, cellIds, repaired, frame, output);
      AddFigures(output->GetFieldData(), repaired, triangles.rows());
    });
}

//------------------------------------------------------------------------------
void vtkGenusZeroRepair::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumHoleArea: " << this->MaximumHoleArea << "\n";
}
