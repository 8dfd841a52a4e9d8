#include "vtkSurfaceFileReader.h"

#include "ByteReader.h"
#include "SurfaceData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <limits>
#include <numeric>
#include <stdexcept>

namespace
{
unsigned long ErrorCodeOf(conformal::ParseCode code)
{
  switch (code)
  {
    case conformal::ParseCode::Ok:
    case conformal::ParseCode::Aborted:
      return vtkErrorCode::NoError;
    case conformal::ParseCode::FileNotFound:
      return vtkErrorCode::FileNotFoundError;
    case conformal::ParseCode::CannotOpen:
      return vtkErrorCode::CannotOpenFileError;
    case conformal::ParseCode::UnrecognizedType:
      return vtkErrorCode::UnrecognizedFileTypeError;
    case conformal::ParseCode::PrematureEnd:
      return vtkErrorCode::PrematureEndOfFileError;
    case conformal::ParseCode::Malformed:
      return vtkErrorCode::FileFormatError;
    case conformal::ParseCode::OutOfMemory:
      break;
  }
  return vtkErrorCode::UnknownError;
}

int VTKTypeOf(conformal::ScalarType type)
{
  switch (type)
  {
    case conformal::ScalarType::Int8:
      return VTK_SIGNED_CHAR;
    case conformal::ScalarType::UInt8:
      return VTK_UNSIGNED_CHAR;
    case conformal::ScalarType::Int16:
      return VTK_SHORT;
    case conformal::ScalarType::UInt16:
      return VTK_UNSIGNED_SHORT;
    case conformal::ScalarType::Int32:
      return VTK_INT;
    case conformal::ScalarType::UInt32:
      return VTK_UNSIGNED_INT;
    case conformal::ScalarType::Float32:
      return VTK_FLOAT;
    case conformal::ScalarType::Int64:
      return VTK_TYPE_INT64;
    case conformal::ScalarType::UInt64:
      return VTK_TYPE_UINT64;
    case conformal::ScalarType::Float64:
      break;
  }
  return VTK_DOUBLE;
}

// The arrays take over the parser's memory.
vtkSmartPointer<vtkDataArray> ToArray(conformal::NamedArray& values)
{
  auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTKTypeOf(values.Type)));
  array->SetName(values.Name.c_str());
  array->SetNumberOfComponents(static_cast<int>(values.Components));
  if (const std::size_t count = values.numberOfTuples() * values.Components)
  {
    array->SetVoidArray(values.Values.release(), static_cast<vtkIdType>(count), 0,
      vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  }
  return array;
}

vtkSmartPointer<vtkTypeInt64Array> ToArray(conformal::OwnedArray<std::int64_t>& values)
{
  auto array = vtkSmartPointer<vtkTypeInt64Array>::New();
  const auto count = static_cast<vtkIdType>(values.size());
  array->SetArray(reinterpret_cast<vtkTypeInt64*>(values.release()), count, 0,
    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

// A single column may have a name of VTK's; only whole ones become what VTK means.
void AddArrays(std::vector<conformal::NamedArray>& arrays, vtkDataSetAttributes* data)
{
  for (conformal::NamedArray& values : arrays)
  {
    const vtkSmartPointer<vtkDataArray> array = ToArray(values);
    const bool isBytes = values.Type == conformal::ScalarType::UInt8;
    if (values.Name == "Normals" && values.Components == 3)
    {
      data->SetNormals(array);
    }
    else if (values.Name == "TCoords" && values.Components == 2)
    {
      data->SetTCoords(array);
    }
    else if (isBytes && values.Name == (values.Components == 4 ? "RGBA" : "RGB"))
    {
      data->SetScalars(array);
    }
    else
    {
      data->AddArray(array);
    }
  }
}

// Ids of 4 bytes where they suffice: for a large cloud they would else be most of its memory.
template <typename Ids>
vtkSmartPointer<vtkCellArray> VertexOfEachPoint(vtkIdType count)
{
  const auto countUp = [](vtkIdType end)
  {
    auto numbers = vtkSmartPointer<Ids>::New();
    numbers->SetNumberOfValues(end);
    std::iota(numbers->GetPointer(0), numbers->GetPointer(0) + end, 0);
    return numbers;
  };
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(countUp(count + 1), countUp(count));
  return cells;
}

vtkSmartPointer<vtkCellArray> VertexOfEachPoint(vtkIdType count)
{
  return count < std::numeric_limits<vtkTypeInt32>::max()
    ? VertexOfEachPoint<vtkTypeInt32Array>(count)
    : VertexOfEachPoint<vtkTypeInt64Array>(count);
}

void Fill(vtkPolyData* output, conformal::SurfaceData& data)
{
  const bool isCloud = data.PolygonIds.size() == 0;
  vtkNew<vtkPoints> points;
  points->SetData(ToArray(data.Points));
  output->SetPoints(points);
  AddArrays(data.PointArrays, output->GetPointData());
  if (isCloud)
  {
    output->SetVerts(VertexOfEachPoint(points->GetNumberOfPoints()));
    return;
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(ToArray(data.PolygonOffsets), ToArray(data.PolygonIds));
  output->SetPolys(polygons);
  AddArrays(data.PolygonArrays, output->GetCellData());
}
}

//------------------------------------------------------------------------------
vtkSurfaceFileReader::vtkSurfaceFileReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
bool vtkSurfaceFileReader::StartsLike(const char* name, bool (*looksRight)(std::string_view))
{
  constexpr std::size_t firstLines = std::size_t(1) << 14;
  conformal::ByteReader input;
  return name && conformal::openFile(name, input).ok() && looksRight(input.peek(firstLines));
}

//------------------------------------------------------------------------------
int vtkSurfaceFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->FileName || !this->FileName[0])
  {
    this->SetErrorCode(vtkErrorCode::NoFileNameError);
    vtkErrorMacro(<< "FileName is not set");
    return 0;
  }
  conformal::ByteReader input;
  conformal::SurfaceResult result;
  result.Status = conformal::openFile(this->FileName, input);
  if (result.Status.ok())
  {
    try
    {
      result = this->Parse(input,
        [this](double fraction)
        {
          this->UpdateProgress(fraction);
          return this->GetAbortExecute() == 0;
        });
    }
    catch (const std::invalid_argument& e)
    {
      this->SetErrorCode(vtkErrorCode::UserError);
      vtkErrorMacro(<< e.what());
      return 0;
    }
  }
  if (result.Status.Code == conformal::ParseCode::Aborted)
  {
    return 1;
  }
  if (result.Status.ok())
  {
    result.Status = conformal::statusOf([&]() { Fill(output, result.Data); });
  }
  if (!result.Status.ok())
  {
    output->Initialize();
    this->SetErrorCode(ErrorCodeOf(result.Status.Code));
    vtkErrorMacro(<< this->FileName << ": " << result.Status.text());
    return 0;
  }
  this->Warn(output, "NumberOfDroppedPoints", result.Data.DroppedPoints,
    "points dropped whose coordinates are not finite");
  this->Warn(output, "NumberOfDroppedPolygons", result.Data.DroppedPolygons,
    "polygons dropped that have fewer than 3 ids or one of them twice");
  this->Warn(output, "NumberOfReplacedValues", result.Data.ReplacedValues,
    "values replaced by 0 that are not finite");
  this->Warn(
    output, "NumberOfSkippedLines", result.Data.SkippedLines, "lines skipped that are no points");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceFileReader::Warn(
  vtkPolyData* output, const char* name, vtkTypeUInt64 count, const char* message)
{
  if (count == 0)
  {
    return;
  }
  vtkNew<vtkIdTypeArray> number;
  number->SetName(name);
  number->InsertNextValue(static_cast<vtkIdType>(count));
  output->GetFieldData()->AddArray(number);
  vtkWarningMacro(<< this->FileName << ": " << count << " " << message);
}
