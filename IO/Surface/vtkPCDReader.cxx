#include "vtkPCDReader.h"

#include "PCD/PCDHeader.h"
#include "PCD/PCDParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkPCDReader);

//------------------------------------------------------------------------------
int vtkPCDReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikePCD) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkPCDReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece& piece, const conformal::Run& run)
{
  return conformal::parsePCD(input, piece, {}, run);
}

//------------------------------------------------------------------------------
void vtkPCDReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
