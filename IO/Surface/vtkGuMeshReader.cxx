#include "vtkGuMeshReader.h"

#include "GuMesh/GuMeshParser.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGuMeshReader);

//------------------------------------------------------------------------------
int vtkGuMeshReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeGuMesh) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkGuMeshReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  return conformal::parseGuMesh(input, {}, run);
}

//------------------------------------------------------------------------------
void vtkGuMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
