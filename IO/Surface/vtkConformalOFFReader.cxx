#include "vtkConformalOFFReader.h"

#include "OFF/OFFParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalOFFReader);

//------------------------------------------------------------------------------
int vtkConformalOFFReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeOFF) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkConformalOFFReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  return conformal::parseOFF(input, {}, run);
}

//------------------------------------------------------------------------------
void vtkConformalOFFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
