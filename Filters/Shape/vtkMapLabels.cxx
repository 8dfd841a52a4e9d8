#include "vtkMapLabels.h"

#include "Base/Steps.h"
#include "Body/MapAreas.h"
#include "Body/MapLabels.h"
#include "Glue/Arrays.h"
#include "Glue/MapImages.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Glue/Volumes.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

vtkStandardNewMacro(vtkMapLabels);

namespace
{
using Measures = std::vector<conformal::LabelMeasure>;

std::vector<int> ReadLabels(vtkImageData* image, const std::string& name)
{
  if (image->GetDimensions()[2] > 1)
  {
    throw std::invalid_argument("the labels are a volume; they must be one picture of a map");
  }
  vtkDataArray* array = name.empty() ? image->GetPointData()->GetScalars()
                                     : image->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    throw std::invalid_argument(name.empty()
        ? "the image of labels has no active point scalars; set ArrayName"
        : "the image of labels has no point array " + name);
  }
  if (array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the array of labels has " +
      std::to_string(array->GetNumberOfComponents()) +
      " components, as a color picture; save the labels as a picture of one channel, or set "
      "ArrayName to an array with one component");
  }
  std::vector<int> labels(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!(std::abs(value) <= std::numeric_limits<int>::max()) || value != std::floor(value))
    {
      throw std::invalid_argument("label " + std::to_string(value) + " of pixel " +
        std::to_string(i) + " is no whole number in the range of int");
    }
    labels[i] = static_cast<int>(value);
  }
  return labels;
}

// Return one number of each label.
template <typename Number>
std::vector<Number> Column(
  const Measures& measures, const std::function<Number(const conformal::LabelMeasure&)>& number)
{
  std::vector<Number> column;
  for (const conformal::LabelMeasure& measure : measures)
  {
    column.push_back(number(measure));
  }
  return column;
}

void FillTable(vtkTable* table, const Measures& measures, const conformal::CoordinateFrame& frame)
{
  using Measure = conformal::LabelMeasure;
  vtkFieldData* rows = table->GetRowData();
  glue::AddIntegers(rows, "Label", Column<int>(measures, [](const Measure& m) { return m.Label; }));
  glue::AddIntegers(rows, "NumberOfPixels",
    Column<int>(measures, [](const Measure& m) { return static_cast<int>(m.NumberOfPixels); }));
  std::vector<double> areas = Column<double>(measures, [](const Measure& m) { return m.Area; });
  glue::AreasFromFrame(
    areas.data(), static_cast<conformal::Index>(areas.size()), frame, "the areas");
  glue::AddNumbers(rows, "Area", areas);
  glue::AddLengths(rows, "Perimeter",
    Column<double>(measures, [](const Measure& m) { return m.Perimeter; }), frame);
  const char* const centroid[] = { "CentroidX", "CentroidY", "CentroidZ" };
  const char* const axis[] = { "LongAxisX", "LongAxisY", "LongAxisZ" };
  for (int k = 0; k < 3; ++k)
  {
    glue::AddLengths(rows, centroid[k],
      Column<double>(measures, [k](const Measure& m) { return m.Centroid[k]; }), frame);
  }
  glue::AddNumbers(
    rows, "Elongation", Column<double>(measures, [](const Measure& m) { return m.Elongation; }));
  for (int k = 0; k < 3; ++k)
  {
    glue::AddNumbers(
      rows, axis[k], Column<double>(measures, [k](const Measure& m) { return m.LongAxis[k]; }));
  }
  glue::AddIntegers(rows, "NumberOfNeighbors",
    Column<int>(measures, [](const Measure& m) { return m.NumberOfNeighbors; }));
}
}

//------------------------------------------------------------------------------
vtkMapLabels::vtkMapLabels()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkMapLabels::SetLabelsConnection(vtkAlgorithmOutput* algOutput)
{
  this->SetInputConnection(1, algOutput);
}

//------------------------------------------------------------------------------
void vtkMapLabels::SetLabelsData(vtkImageData* labels)
{
  this->SetInputData(1, labels);
}

//------------------------------------------------------------------------------
vtkTable* vtkMapLabels::GetMeasures()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkMapLabels::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMapLabels::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkTable");
  return 1;
}

//------------------------------------------------------------------------------
int vtkMapLabels::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  glue::RequestWholeImage(inputVector[1]->GetInformationObject(0));
  return 1;
}

//------------------------------------------------------------------------------
int vtkMapLabels::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto image = glue::Held(vtkImageData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  vtkTable* table = vtkTable::GetData(outputVector, 1);
  conformal::MapImage map{ static_cast<conformal::MapProjection>(this->Projection),
    this->CentralLongitude, {}, this->CapsuleAspect };
  const std::string name = this->ArrayName;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      conformal::Steps steps(glue::RunOf(this), { 0.05, 0.95 }); // reading, measuring
      steps.next();
      const std::vector<int> labels = ReadLabels(image, name);
      map.Grid = { image->GetDimensions()[0], image->GetDimensions()[1] };
      glue::RequireMap(map);
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      const conformal::MappedMesh body = glue::CopyMapped(surface, frame);
      map.CapsuleAspect = conformal::capsuleAspectOf(body, map.Projection, map.CapsuleAspect);
      const conformal::MapLabels measured =
        conformal::measureMapLabels(body, map, labels, steps.next());
      const vtkNew<vtkPolyData> result;
      result->ShallowCopy(surface);
      glue::AddIntegers(result->GetPointData(), "Label", measured.VertexLabels);
      const vtkNew<vtkTable> rows;
      FillTable(rows, measured.Measures, frame);
      output->ShallowCopy(result);
      table->ShallowCopy(rows);
    });
}

//------------------------------------------------------------------------------
void vtkMapLabels::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const projections[] = { "Equirectangular", "LambertAzimuthal", "Mollweide",
    "PeirceQuincuncial", "Mercator", "Capsule" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ArrayName: " << this->ArrayName << "\n";
  os << indent << "Projection: " << projections[this->Projection] << "\n";
  os << indent << "CentralLongitude: " << this->CentralLongitude << "\n";
  os << indent << "CapsuleAspect: " << this->CapsuleAspect << "\n";
}
