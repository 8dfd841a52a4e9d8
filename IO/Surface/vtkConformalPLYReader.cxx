#include "vtkConformalPLYReader.h"

#include "PLY/PLYHeader.h"
#include "PLY/PLYParser.h"

#include "vtkObjectFactory.h"

#include <cmath>
#include <stdexcept>

vtkStandardNewMacro(vtkConformalPLYReader);

//------------------------------------------------------------------------------
int vtkConformalPLYReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikePLY) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkConformalPLYReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece& piece, const conformal::Run& run)
{
  if (!std::isfinite(this->MaximumEdgeLength))
  {
    throw std::invalid_argument("MaximumEdgeLength is not finite");
  }
  conformal::PLYOptions options;
  options.MaximumEdgeLength = this->MaximumEdgeLength;
  options.Piece = piece;
  return conformal::parsePLY(input, options, {}, run);
}

//------------------------------------------------------------------------------
void vtkConformalPLYReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n";
}
