#include "vtkSurfaceFileReader.h"

#include "Bytes/ByteReader.h"
#include "Bytes/FilePiece.h"
#include "Bytes/SurfaceData.h"
#include "Glue/FailedRequests.h"
#include "Glue/FileErrors.h"
#include "Glue/Run.h"
#include "Glue/SurfaceConversions.h"

#include "vtkCommunicator.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkMultiProcessStream.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace
{
constexpr std::size_t FirstLines = std::size_t(1) << 14; ///< bytes by which formats are recognized

conformal::FilePiece PieceOf(vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int number = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const int count = info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES());
  return { static_cast<std::uint64_t>(std::max(number, 0)),
    static_cast<std::uint64_t>(std::max(count, 1)) };
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
  return name &&
    conformal::startsLike(name, FirstLines,
      [looksRight](std::string_view first, std::uint64_t) { return looksRight(first); });
}

//------------------------------------------------------------------------------
bool vtkSurfaceFileReader::StartsLike(
  const char* name, bool (*looksRight)(std::string_view, std::uint64_t))
{
  return name && conformal::startsLike(name, FirstLines, looksRight);
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
  // Copies of properties, since observers of the progress may change them for the next run.
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
    return glue::FailedRequest(this);
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
      const conformal::ParseStatus status =
        conformal::statusOf([&]() { result = this->Parse(input, piece, glue::RunOf(this)); });
      if (!status.ok()) // of what follows the parsers
      {
        result = {};
        result.Status = status;
      }
    }
    catch (const std::invalid_argument& e)
    {
      return { vtkErrorCode::UserError, false, e.what() };
    }
  }
  if (result.Status.ok())
  {
    result.Status = conformal::statusOf([&]() { glue::SetSurfaceData(output, result.Data); });
  }
  return { glue::ErrorCodeOf(result.Status.Code),
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
