#include "vtkSurfaceFileWriter.h"

#include "Bytes/ParseStatus.h"
#include "Bytes/SurfaceData.h"
#include "Glue/Compatibility.h"
#include "Glue/Checks.h"
#include "vtkSurfaceConversions.h"

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkPolyData.h"

#include <exception>

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
  this->SetErrorCode(vtkErrorCode::UnknownError); // stays if the pipeline fails before WriteData
  const int isWritten = this->Superclass::Write();
  return isWritten && this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkSurfaceFileWriter::WriteData()
{
  try
  {
    if (!this->FileName || !this->FileName[0])
    {
      throw vtkSurfaceConversions::WriteError(vtkErrorCode::NoFileNameError, "FileName is not set");
    }
    glue::RequireConsistentInputs(this);
    if (auto* surface = vtkPolyData::SafeDownCast(this->GetInput(0)))
    {
      glue::RequireCellIds(surface);
    }
    this->WriteFiles(
      [this](double fraction)
      {
        this->UpdateProgress(fraction);
        return !glue::IsAbortWanted(this);
      });
    this->SetErrorCode(vtkErrorCode::NoError);
  }
  catch (const conformal::ParseError&) // asked to abort: nothing was written
  {
    this->SetErrorCode(AbortedError);
  }
  catch (const vtkSurfaceConversions::WriteError& e)
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
void vtkSurfaceFileWriter::WriteSurface(
  const std::function<std::string(const conformal::SurfaceData&)>& make)
{
  const std::string path = this->FileName; // observers of the progress may set another
  const std::string bytes =
    make(vtkSurfaceConversions::ToSurfaceData(vtkPolyData::SafeDownCast(this->GetInput(0))));
  vtkSurfaceConversions::WriteTogether({ { path, bytes } });
}

//------------------------------------------------------------------------------
void vtkSurfaceFileWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
