#include "vtkMapOutlines.h"

#include "Base/Steps.h"
#include "Body/MapAreas.h"
#include "Body/MapOutlines.h"
#include "Glue/Arrays.h"
#include "Glue/Checks.h"
#include "Glue/MapImages.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMapOutlines);

namespace
{
// Outlines of input port 1, with the ids of their cells and points.
struct DrawnOutlines
{
  std::vector<conformal::MapOutline> Outlines;
  std::vector<int> Cells;
  std::vector<std::vector<int>> Points; // of each corner
};

void AddOutlines(vtkPolyData* drawn, vtkCellArray* cells, bool arePolygons, int firstCell,
  double height, bool isDown, DrawnOutlines& all)
{
  const vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    cells->GetCellAtId(i, ids);
    const vtkIdType size = ids->GetNumberOfIds();
    conformal::MapOutline outline;
    std::vector<int> points;
    for (vtkIdType k = 0; k < size; ++k)
    {
      double x[3];
      drawn->GetPoint(ids->GetId(k), x);
      outline.Corners.emplace_back(x[0], isDown ? height - x[1] : x[1]);
      points.push_back(static_cast<int>(ids->GetId(k)));
    }
    const auto& corners = outline.Corners;
    outline.IsClosed = arePolygons || (size > 3 && corners.front() == corners.back());
    all.Outlines.push_back(outline);
    all.Points.push_back(points);
    all.Cells.push_back(firstCell + static_cast<int>(i));
  }
}

DrawnOutlines ReadOutlines(vtkPolyData* drawn, double height, bool isDown)
{
  DrawnOutlines all;
  glue::RequireCellIds(drawn);
  if (drawn->GetNumberOfCells() > std::numeric_limits<int>::max() ||
    drawn->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    throw std::length_error("there are more outlines than 2147483647");
  }
  const int lines = static_cast<int>(drawn->GetNumberOfVerts()),
            polygons = lines + static_cast<int>(drawn->GetNumberOfLines());
  AddOutlines(drawn, drawn->GetLines(), false, lines, height, isDown, all);
  AddOutlines(drawn, drawn->GetPolys(), true, polygons, height, isDown, all);
  return all;
}

void FillOutlineLines(vtkPolyData* output, const DrawnOutlines& drawn,
  const std::vector<conformal::SurfaceOutline>& outlines, const conformal::CoordinateFrame& frame)
{
  conformal::Index size = 0;
  for (const auto& outline : outlines)
  {
    size += outline.Positions.rows();
  }
  conformal::Points points(size, 3);
  std::vector<int> corners, cells;
  std::vector<double> angles;
  const vtkNew<vtkCellArray> lines;
  conformal::Index first = 0;
  for (std::size_t i = 0; i < outlines.size(); ++i)
  {
    const conformal::SurfaceOutline& outline = outlines[i];
    const conformal::Index own = outline.Positions.rows();
    if (own == 0)
    {
      continue;
    }
    points.middleRows(first, own) = outline.Positions;
    lines->InsertNextCell(static_cast<int>(own));
    for (conformal::Index k = 0; k < own; ++k)
    {
      const int corner = outline.Corners[k];
      lines->InsertCellPoint(first + k);
      corners.push_back(corner >= 0 ? drawn.Points[i][corner] : -1);
      angles.push_back(outline.Angles[k]);
    }
    cells.push_back(drawn.Cells[i]);
    first += own;
  }
  glue::SetPoints(output, points, frame);
  output->SetLines(lines);
  glue::AddIntegers(output->GetPointData(), "Corner", corners);
  glue::AddNumbers(output->GetPointData(), "Angle", angles);
  glue::AddIntegers(output->GetCellData(), "Outline", cells);
}

void FillOutlineTable(vtkTable* table, const DrawnOutlines& drawn,
  const std::vector<conformal::SurfaceOutline>& outlines, const conformal::CoordinateFrame& frame)
{
  std::vector<int> onMap, closed;
  std::vector<double> lengths, areas, pictureLengths, pictureAreas;
  for (std::size_t i = 0; i < outlines.size(); ++i)
  {
    onMap.push_back(outlines[i].IsOnMap);
    closed.push_back(drawn.Outlines[i].IsClosed);
    lengths.push_back(outlines[i].Length);
    areas.push_back(outlines[i].Area);
    pictureLengths.push_back(outlines[i].PictureLength);
    pictureAreas.push_back(outlines[i].PictureArea);
  }
  vtkFieldData* rows = table->GetRowData();
  glue::AddIntegers(rows, "Outline", drawn.Cells);
  glue::AddIntegers(rows, "OnMap", onMap);
  glue::AddIntegers(rows, "Closed", closed);
  glue::AddLengths(rows, "Length", lengths, frame);
  glue::AreasFromFrame(
    areas.data(), static_cast<conformal::Index>(areas.size()), frame, "the areas");
  glue::AddNumbers(rows, "Area", areas);
  glue::AddNumbers(rows, "PictureLength", pictureLengths);
  glue::AddNumbers(rows, "PictureArea", pictureAreas);
}

void WarnOfMissing(vtkObject* self, const std::vector<conformal::SurfaceOutline>& outlines,
  const std::vector<int>& cells)
{
  if (outlines.empty())
  {
    glue::WarnOfEmptyInput(
      self, "there are no lines or polygons at input port 1; the output is empty");
  }
  int count = 0, first = -1;
  for (std::size_t i = outlines.size(); i-- > 0;)
  {
    if (!outlines[i].IsOnMap)
    {
      ++count;
      first = cells[i];
    }
  }
  if (count > 0)
  {
    vtkWarningWithObjectMacro(
      self, << count
            << " outlines leave the map or have no two corners, and are not "
               "measured. The first is cell "
            << first << ". Check Projection, ImageSize and YAxis");
  }
}
}

//------------------------------------------------------------------------------
vtkMapOutlines::vtkMapOutlines()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkMapOutlines::SetOutlinesConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkMapOutlines::SetOutlinesData(vtkPolyData* outlines)
{
  this->SetInputData(1, outlines);
}

//------------------------------------------------------------------------------
vtkTable* vtkMapOutlines::GetMeasures()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkMapOutlines::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMapOutlines::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMapOutlines::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto drawn = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  conformal::MapImage map{ static_cast<conformal::MapProjection>(this->Projection),
    this->CentralLongitude, { this->ImageSize[0], this->ImageSize[1] }, this->CapsuleAspect };
  const bool isDown = this->YAxis == DOWN;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      glue::RequireMap(map);
      conformal::Steps steps(glue::RunOf(this), { 0.05, 0.95 }); // reading, measuring
      steps.next();
      const DrawnOutlines read = ReadOutlines(drawn, double(map.Grid.Height), isDown);
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      const conformal::MappedMesh body = glue::CopyMapped(surface, frame);
      map.CapsuleAspect = conformal::capsuleAspectOf(body, map.Projection, map.CapsuleAspect);
      const std::vector<conformal::SurfaceOutline> measured =
        conformal::measureMapOutlines(body, map, read.Outlines, steps.next());
      const vtkNew<vtkPolyData> lines;
      FillOutlineLines(lines, read, measured, frame);
      const vtkNew<vtkTable> rows;
      FillOutlineTable(rows, read, measured, frame);
      WarnOfMissing(this, measured, read.Cells);
      output->ShallowCopy(lines);
      table->ShallowCopy(rows);
    });
}

//------------------------------------------------------------------------------
void vtkMapOutlines::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const projections[] = { "Equirectangular", "LambertAzimuthal", "Mollweide",
    "PeirceQuincuncial", "Mercator", "Capsule" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Projection: " << projections[this->Projection] << "\n";
  os << indent << "CentralLongitude: " << this->CentralLongitude << "\n";
  os << indent << "CapsuleAspect: " << this->CapsuleAspect << "\n";
  os << indent << "ImageSize: (" << this->ImageSize[0] << ", " << this->ImageSize[1] << ")\n";
  os << indent << "YAxis: " << (this->YAxis == DOWN ? "Down" : "Up") << "\n";
}
