#include "vtkSurfaceFileWriter.h"

#include "Bytes/SurfaceData.h"
#include "Files/WriteFiles.h"
#include "Glue/Checks.h"
#include "Glue/FileErrors.h"
#include "Glue/Run.h"
#include "Glue/SurfaceConversions.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <exception>
#include <filesystem>
#include <system_error>

namespace
{
using NamedBytes = std::vector<std::pair<std::string, std::string_view>>;

// If the surface's file does not exist, return the names of its other files that exist. They may
// have been written by another program.
std::string ForeignFiles(const NamedBytes& files)
{
  namespace fs = std::filesystem;
  std::error_code ignored; // errors are reported later, when files are written
  std::string names;
  if (fs::exists(fs::u8path(files.back().first), ignored))
  {
    return names;
  }
  for (std::size_t i = 0; i + 1 < files.size(); ++i)
  {
    if (fs::exists(fs::u8path(files[i].first), ignored))
    {
      names += (names.empty() ? "" : " and ") + files[i].first;
    }
  }
  return names;
}
}

//------------------------------------------------------------------------------
vtkSurfaceFileWriter::~vtkSurfaceFileWriter()
{
  delete[] this->FileName;
}

//------------------------------------------------------------------------------
int vtkSurfaceFileWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceFileWriter::Write()
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    const bool isOptional =
      this->GetInputPortInformation(port)->Has(vtkAlgorithm::INPUT_IS_OPTIONAL()) != 0;
    if (!isOptional && this->GetNumberOfInputConnections(port) == 0)
    {
      this->SetErrorCode(vtkErrorCode::UserError);
      vtkErrorMacro(<< "input port " << port << " has no data to write: set them before Write()");
      return 0;
    }
  }
  this->SetErrorCode(vtkErrorCode::UnknownError); // kept if the pipeline fails before WriteData
  const vtkMTimeType before = this->WriteTime;
  const int isWritten = this->Superclass::Write();
  if (this->WriteTime == before && this->GetErrorCode() == vtkErrorCode::NoError)
  {
    this->SetErrorCode(vtkErrorCode::UnknownError); // the superclass had no input to write
  }
  return isWritten && this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkSurfaceFileWriter::WriteData()
{
  try
  {
    if (!this->FileName || !this->FileName[0])
    {
      throw glue::WriteError(vtkErrorCode::NoFileNameError, "FileName is not set");
    }
    glue::RequireConsistentInputs(this);
    for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
    {
      for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
      {
        if (auto* surface = vtkPolyData::SafeDownCast(this->GetInputDataObject(port, i)))
        {
          glue::RequireCellIds(surface);
        }
      }
    }
    this->WriteFiles(glue::RunOf(this));
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  catch (const conformal::Aborted&) // by the user: nothing was written
  {
    this->SetErrorCode(AbortedError);
  }
  catch (const glue::WriteError& e)
  {
    this->SetErrorCode(e.Code);
    vtkErrorMacro(<< e.what());
  }
  catch (const std::invalid_argument& e)
  {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< e.what());
  }
  catch (const std::exception& e)
  {
    this->SetErrorCode(vtkErrorCode::UnknownError);
    vtkErrorMacro(<< e.what());
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceFileWriter::WriteTogether(const NamedBytes& files)
{
  const std::string foreign = ForeignFiles(files);
  const conformal::WriteStatus status = conformal::writeFiles(files);
  if (!status.ok())
  {
    throw glue::WriteError(glue::ErrorCodeOf(status.Code), status.Message);
  }
  if (!foreign.empty())
  {
    vtkWarningMacro(<< "replaced " << foreign << ", though " << files.back().first
                    << " did not exist before: files beside a surface have its name");
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceFileWriter::WriteSurface(
  const std::function<std::string(const conformal::SurfaceData&)>& make)
{
  const std::string path = this->FileName; // a copy: observers may change it
  const std::string bytes = make(glue::ToSurfaceData(vtkPolyData::SafeDownCast(this->GetInput(0))));
  this->WriteTogether({ { path, bytes } });
}

//------------------------------------------------------------------------------
void vtkSurfaceFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
