#include "vtkGuMeshWriter.h"

#include "SurfaceBytes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGuMeshWriter);

//------------------------------------------------------------------------------
std::string vtkGuMeshWriter::MakeBytes(
  const conformal::SurfaceData& surface, const std::function<bool(double)>& progress)
{
  return conformal::makeGuMesh(surface, progress);
}

//------------------------------------------------------------------------------
void vtkGuMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
