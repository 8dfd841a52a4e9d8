#include "vtkE57Reader.h"

#include "E57/E57Parser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkE57Reader);

//------------------------------------------------------------------------------
int vtkE57Reader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeE57) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkE57Reader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  conformal::E57Options options;
  options.ScanId = this->ScanId;
  options.ShiftCoordinates = this->ShiftCoordinates;
  return conformal::parseE57(input, options, {}, run);
}

//------------------------------------------------------------------------------
void vtkE57Reader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScanId: " << this->ScanId << "\n";
  os << indent << "ShiftCoordinates: " << (this->ShiftCoordinates ? "On" : "Off") << "\n";
}
