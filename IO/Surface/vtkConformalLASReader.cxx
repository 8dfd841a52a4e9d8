#include "vtkConformalLASReader.h"

#include "LAS/LASParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalLASReader);

//------------------------------------------------------------------------------
int vtkConformalLASReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeLAS) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkConformalLASReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  conformal::LASOptions options;
  options.ShiftCoordinates = this->ShiftCoordinates;
  return conformal::parseLAS(input, options, {}, run);
}

//------------------------------------------------------------------------------
void vtkConformalLASReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ShiftCoordinates: " << (this->ShiftCoordinates ? "On" : "Off") << "\n";
}
