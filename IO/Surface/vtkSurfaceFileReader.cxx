#include "vtkSurfaceFileReader.h"

#include "Bytes/ByteReader.h"
#include "Bytes/FilePiece.h"
#include "Bytes/SurfaceData.h"
#include "Glue/Compatibility.h"
#include "vtkSurfaceConversions.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace
{
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

// Arrays in a row. vtkFieldData::AddArray compares the name of each with those of all before it,
// which takes a minute for 60,000; no two of a parser's arrays have the same.
class ArrayList : public vtkDataSetAttributes
{
public:
  static ArrayList* New() { VTK_STANDARD_NEW_BODY(ArrayList); }
  vtkTypeMacro(ArrayList, vtkDataSetAttributes);

  int Append(vtkAbstractArray* array)
  {
    const int index = this->NumberOfActiveArrays++;
    this->SetArray(index, array);
    return index;
  }
};

// A single column may have a name of VTK's; only whole ones become what VTK means.
void AddArrays(std::vector<conformal::NamedArray>& arrays, vtkDataSetAttributes* data)
{
  vtkNew<ArrayList> list;
  list->AllocateArrays(static_cast<int>(arrays.size()));
  for (conformal::NamedArray& values : arrays)
  {
    const bool isBytes = values.Type == conformal::ScalarType::UInt8;
    const int index = list->Append(ToArray(values));
    if (values.Name == "Normals" && values.Components == 3)
    {
      list->SetActiveAttribute(index, vtkDataSetAttributes::NORMALS);
    }
    else if (values.Name == "TCoords" && values.Components == 2)
    {
      list->SetActiveAttribute(index, vtkDataSetAttributes::TCOORDS);
    }
    else if (isBytes && values.Name == (values.Components == 4 ? "RGBA" : "RGB"))
    {
      list->SetActiveAttribute(index, vtkDataSetAttributes::SCALARS);
    }
  }
  // A data set looks for an array of ghosts whenever one is added: once is enough.
  vtkNew<vtkCallbackCommand> quiet;
  quiet->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  quiet->AbortFlagOnExecuteOn();
  const unsigned long tag = data->AddObserver(vtkCommand::ModifiedEvent, quiet, 1.0F);
  data->ShallowCopy(list);
  data->RemoveObserver(tag);
  data->Modified();
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

conformal::FilePiece PieceOf(vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int number = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int count = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  return { static_cast<std::uint64_t>(std::max(number, 0)),
    static_cast<std::uint64_t>(std::max(count, 1)) };
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

vtkCxxSetObjectMacro(vtkSurfaceFileReader, Controller, vtkMultiProcessController);

//------------------------------------------------------------------------------
vtkSurfaceFileReader::vtkSurfaceFileReader()
{
  this->SetNumberOfInputPorts(0);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

//------------------------------------------------------------------------------
vtkSurfaceFileReader::~vtkSurfaceFileReader()
{
  this->SetController(nullptr);
}

//------------------------------------------------------------------------------
vtkStringArray* vtkSurfaceFileReader::GetReadFileNames()
{
  this->ReadFileNames->Reset();
  if (this->FileName && this->FileName[0])
  {
    this->ReadFileNames->InsertNextValue(this->FileName);
    for (const std::string& name : this->FilesReadToo())
    {
      if (!name.empty())
      {
        this->ReadFileNames->InsertNextValue(name);
      }
    }
  }
  return this->ReadFileNames;
}

//------------------------------------------------------------------------------
bool vtkSurfaceFileReader::StartsLike(const char* name, bool (*looksRight)(std::string_view))
{
  constexpr std::size_t firstLines = std::size_t(1) << 14;
  conformal::ByteReader input;
  return name && conformal::openFile(name, input).ok() && looksRight(input.peek(firstLines));
}

//------------------------------------------------------------------------------
int vtkSurfaceFileReader::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

//------------------------------------------------------------------------------
int vtkSurfaceFileReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const conformal::FilePiece piece = PieceOf(outputVector->GetInformationObject(0));
  // Observers of the progress may set others for the next run.
  const std::string fileName = this->FileName ? this->FileName : "";
  const vtkSmartPointer<vtkMultiProcessController> controller = this->Controller;
  conformal::SurfaceResult result;
  const Outcome outcome =
    vtkSurfaceFileReader::Share(this->Read(fileName, piece, output, result), piece, controller);
  this->SetErrorCode(outcome.ErrorCode);
  if (outcome.Aborted || outcome.ErrorCode != vtkErrorCode::NoError)
  {
    output->Initialize();
  }
  if (outcome.ErrorCode != vtkErrorCode::NoError)
  {
    vtkErrorMacro(<< outcome.Message);
    return 0;
  }
  this->WarnOfAll(fileName, result.Data, output);
  return 1;
}

//------------------------------------------------------------------------------
vtkSurfaceFileReader::Outcome vtkSurfaceFileReader::Read(const std::string& fileName,
  const conformal::FilePiece& piece, vtkPolyData* output, conformal::SurfaceResult& result)
{
  if (fileName.empty())
  {
    return { vtkErrorCode::NoFileNameError, false, "FileName is not set" };
  }
  if (!piece.isFirst() && !this->CutsFiles())
  {
    return {};
  }
  conformal::ByteReader input;
  result.Status = conformal::openFile(fileName, input);
  if (result.Status.ok())
  {
    try
    {
      result = this->Parse(input, piece,
        [this](double fraction)
        {
          this->UpdateProgress(fraction);
          return !glue::IsAbortWanted(this);
        });
    }
    catch (const std::invalid_argument& e)
    {
      return { vtkErrorCode::UserError, false, e.what() };
    }
  }
  if (result.Status.ok())
  {
    result.Status = conformal::statusOf([&]() { Fill(output, result.Data); });
  }
  return { vtkSurfaceConversions::ErrorCodeOf(result.Status.Code),
    result.Status.Code == conformal::ParseCode::Aborted, fileName + ": " + result.Status.text() };
}

//------------------------------------------------------------------------------
vtkSurfaceFileReader::Outcome vtkSurfaceFileReader::Share(
  const Outcome& own, const conformal::FilePiece& piece, vtkMultiProcessController* controller)
{
  const int rank = controller ? controller->GetLocalProcessId() : 0;
  const int size = controller ? controller->GetNumberOfProcesses() : 1;
  const bool together = size > 1 && piece.Count == static_cast<std::uint64_t>(size) &&
    piece.Number == static_cast<std::uint64_t>(rank);
  if (!together)
  {
    return own;
  }
  const bool isGood = own.ErrorCode == vtkErrorCode::NoError && !own.Aborted;
  const int ownVote = isGood ? size : rank;
  int first = size;
  controller->AllReduce(&ownVote, &first, 1, vtkCommunicator::MIN_OP);
  if (first == size)
  {
    return own;
  }
  vtkMultiProcessStream stream;
  stream << static_cast<int>(own.ErrorCode) << static_cast<int>(own.Aborted) << own.Message;
  controller->Broadcast(stream, first);
  int code = 0, aborted = 0;
  std::string message;
  stream >> code >> aborted >> message;
  return { static_cast<unsigned long>(code), aborted != 0,
    "on process " + std::to_string(first) + ": " + message };
}

//------------------------------------------------------------------------------
void vtkSurfaceFileReader::WarnOfAll(
  const std::string& fileName, const conformal::SurfaceData& data, vtkPolyData* output)
{
  const auto warn = [&](const char* name, vtkTypeUInt64 count, const char* message)
  {
    if (count == 0)
    {
      return;
    }
    vtkNew<vtkIdTypeArray> number;
    number->SetName(name);
    number->InsertNextValue(static_cast<vtkIdType>(count));
    output->GetFieldData()->AddArray(number);
    vtkWarningMacro(<< fileName << ": " << count << " " << message);
  };
  warn("NumberOfDroppedPoints", data.DroppedPoints, "points dropped: a coordinate is not finite");
  warn("NumberOfDroppedPolygons", data.DroppedPolygons,
    "polygons dropped: fewer than 3 ids, or a repeated id");
  warn("NumberOfReplacedValues", data.ReplacedValues, "values that are not finite replaced by 0");
  warn("NumberOfSkippedLines", data.SkippedLines, "lines without a valid point skipped");
  warn("NumberOfUnreadBytes", data.UnreadBytes,
    "bytes after the data that the header declares not read; the header or the file is wrong");
  warn("NumberOfMissingScans", data.MissingScans,
    "scans that the file lists do not exist and are left out");
}

//------------------------------------------------------------------------------
void vtkSurfaceFileReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}
