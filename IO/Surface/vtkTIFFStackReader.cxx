#include "vtkTIFFStackReader.h"

#include "Bytes/ByteReader.h"
#include "Glue/FailedRequests.h"
#include "Glue/FileErrors.h"
#include "Glue/Run.h"
#include "Glue/StackConversions.h"
#include "TIFF/TIFFStackParser.h"

#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkTIFFStackReader);

namespace
{
conformal::TIFFStack ReadStack(const std::string& name, const conformal::TIFFStackOptions& options,
  const conformal::Run& run = {})
{
  conformal::TIFFStackResult result = conformal::parseTIFFStack([&](conformal::ByteReader& input)
    { return conformal::openFile(name, input); },
    options, {}, run);
  if (!result.Status.ok())
  {
    throw conformal::ParseError(result.Status);
  }
  constexpr std::size_t largest = std::numeric_limits<int>::max();
  const conformal::TIFFStackInfo& info = result.Stack.Info;
  if (std::max({ info.Slices, info.Channels, info.Frames }) > largest)
  {
    throw std::length_error("the stack has more than 2147483647 slices");
  }
  return std::move(result.Stack);
}

void SetStackInformation(vtkInformation* info, const conformal::TIFFStackInfo& stack)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int extent[6] = { 0, static_cast<int>(stack.Width) - 1, 0,
    static_cast<int>(stack.Height) - 1, 0, static_cast<int>(stack.Slices) - 1 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  info->Set(Pipeline::WHOLE_EXTENT(), extent, 6);
  info->Set(vtkDataObject::SPACING(), stack.Spacing.data(), 3);
  info->Set(vtkDataObject::ORIGIN(), origin, 3);
  info->Remove(Pipeline::TIME_STEPS());
  info->Remove(Pipeline::TIME_RANGE());
  if (stack.Frames > 1)
  {
    std::vector<double> times(stack.Frames);
    for (std::size_t i = 0; i < times.size(); ++i)
    {
      times[i] = static_cast<double>(i) * stack.FrameInterval;
    }
    const double range[2] = { times.front(), times.back() };
    info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
}

// Return the number of the last time step that is not after the requested time.
std::size_t FrameOf(vtkInformation* info)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!info->Has(Pipeline::UPDATE_TIME_STEP()) || !info->Has(Pipeline::TIME_STEPS()))
  {
    return 0;
  }
  const double* times = info->Get(Pipeline::TIME_STEPS());
  const double* end = times + info->Length(Pipeline::TIME_STEPS());
  const double time = info->Get(Pipeline::UPDATE_TIME_STEP());
  const auto after = std::upper_bound(times, end, time);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - times - 1, 0));
}
}

//------------------------------------------------------------------------------
vtkTIFFStackReader::vtkTIFFStackReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkTIFFStackReader::~vtkTIFFStackReader()
{
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
int vtkTIFFStackReader::CanReadFile(const char* name)
{
  constexpr std::size_t firstBytes = 4;
  return name &&
      conformal::startsLike(name, firstBytes,
        [](std::string_view first, std::uint64_t) { return conformal::looksLikeTIFF(first); })
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
int vtkTIFFStackReader::Report(const std::function<void(const std::string&)>& read)
{
  const glue::ReadOutcome outcome = glue::ReadFile(this->FileName, read);
  this->SetErrorCode(outcome.Code);
  if (outcome.Error.empty())
  {
    return 1;
  }
  vtkErrorMacro(<< outcome.Error);
  return glue::FailedRequest(this);
}

//------------------------------------------------------------------------------
int vtkTIFFStackReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return this->Report(
    [&](const std::string& name)
    {
      conformal::TIFFStackOptions options;
      options.HeaderOnly = true;
      SetStackInformation(outputVector->GetInformationObject(0), ReadStack(name, options).Info);
    });
}

//------------------------------------------------------------------------------
int vtkTIFFStackReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  return this->Report(
    [&](const std::string& name)
    {
      conformal::TIFFStackOptions options;
      options.Frame = FrameOf(outputVector->GetInformationObject(0));
      options.FirstRowUp = this->YAxis == UP;
      conformal::TIFFStack stack = ReadStack(name, options, glue::RunOf(this));
      const vtkNew<vtkImageData> result;
      const vtkIdType replaced = glue::SetStack(result, stack);
      if (replaced > 0)
      {
        vtkWarningMacro(<< replaced << " values that are not finite were replaced by 0");
      }
      output->ShallowCopy(result);
      vtkInformation* info = outputVector->GetInformationObject(0);
      if (info->Has(vtkStreamingDemandDrivenPipeline::TIME_STEPS()))
      {
        output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
          info->Get(vtkStreamingDemandDrivenPipeline::TIME_STEPS())[options.Frame]);
      }
    });
}

//------------------------------------------------------------------------------
void vtkTIFFStackReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "YAxis: " << (this->YAxis == UP ? "Up" : "Down") << "\n";
}
