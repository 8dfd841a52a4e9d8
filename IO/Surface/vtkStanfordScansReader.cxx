#include "vtkStanfordScansReader.h"

#include "StanfordScans/AlignedScans.h"
#include "StanfordScans/ScanFolder.h"

#include "vtkObjectFactory.h"

#include <filesystem>

vtkStandardNewMacro(vtkStanfordScansReader);

//------------------------------------------------------------------------------
int vtkStanfordScansReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeAlignedScans) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkStanfordScansReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  conformal::AlignedScansOptions options;
  options.InvertRotation = this->InvertRotation;
  options.AllowExternalFiles = this->AllowExternalFiles;
  options.RequireAllScans = this->RequireAllScans;
  const auto folder = std::filesystem::u8path(this->FileName).parent_path();
  return conformal::parseAlignedScans(
    input, conformal::openScansIn(folder.u8string(), this->AllowExternalFiles), options, {}, run);
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkStanfordScansReader::FilesReadToo()
{
  conformal::ByteReader input;
  if (!conformal::openFile(this->FileName, input).ok())
  {
    return {};
  }
  const auto folder = std::filesystem::u8path(this->FileName).parent_path();
  std::vector<std::string> names = conformal::namesOfAlignedScans(input);
  for (std::string& name : names)
  {
    name = (folder / std::filesystem::u8path(name)).u8string();
  }
  return names;
}

//------------------------------------------------------------------------------
void vtkStanfordScansReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "InvertRotation: " << (this->InvertRotation ? "On" : "Off") << "\n";
  os << indent << "AllowExternalFiles: " << (this->AllowExternalFiles ? "On" : "Off") << "\n";
  os << indent << "RequireAllScans: " << (this->RequireAllScans ? "On" : "Off") << "\n";
}
