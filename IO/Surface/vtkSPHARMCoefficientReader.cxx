#include "vtkSPHARMCoefficientReader.h"

#include "Bytes/ByteReader.h"
#include "Glue/FailedRequests.h"
#include "Glue/FileErrors.h"
#include "Glue/HarmonicTables.h"
#include "Glue/Run.h"
#include "SPHARM/SPHARMCoefficients.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <string>

vtkStandardNewMacro(vtkSPHARMCoefficientReader);

namespace
{
void RequireOk(const conformal::ParseStatus& status)
{
  if (!status.ok())
  {
    throw conformal::ParseError(status);
  }
}

void ReadTable(const std::string& name, vtkTable* output, const conformal::Run& run)
{
  conformal::ByteReader input;
  RequireOk(conformal::openFile(name, input));
  const conformal::SurfaceResult result = conformal::parseSPHARMCoefficients(input, {}, run);
  RequireOk(result.Status);
  using Tuples = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  const conformal::NamedArray& read = result.Data.PointArrays.front();
  const auto size = static_cast<conformal::Index>(read.numberOfTuples());
  const vtkNew<vtkTable> table;
  glue::ToTable(
    { Eigen::Map<const Tuples>(reinterpret_cast<const double*>(read.Values.data()), size, 3), {} },
    table);
  output->ShallowCopy(table);
}
}

//------------------------------------------------------------------------------
vtkSPHARMCoefficientReader::vtkSPHARMCoefficientReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkSPHARMCoefficientReader::~vtkSPHARMCoefficientReader()
{
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
int vtkSPHARMCoefficientReader::CanReadFile(const char* name)
{
  constexpr std::size_t firstBytes = 4096;
  return name &&
      conformal::startsLike(name, firstBytes,
        [](std::string_view first, std::uint64_t)
        { return conformal::looksLikeSPHARMCoefficients(first); })
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
int vtkSPHARMCoefficientReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkTable* output = vtkTable::GetData(outputVector);
  output->Initialize();
  const glue::ReadOutcome outcome = glue::ReadFile(
    this->FileName, [&](const std::string& name) { ReadTable(name, output, glue::RunOf(this)); });
  this->SetErrorCode(outcome.Code);
  if (outcome.Error.empty())
  {
    return 1;
  }
  vtkErrorMacro(<< outcome.Error);
  return glue::FailedRequest(this);
}

//------------------------------------------------------------------------------
void vtkSPHARMCoefficientReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
