#include "vtkGuMeshWriter.h"

#include "GuMesh/GuMeshWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGuMeshWriter);

//------------------------------------------------------------------------------
void vtkGuMeshWriter::WriteFiles(const conformal::Run& run)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface) { return conformal::makeGuMesh(surface, run); });
}

//------------------------------------------------------------------------------
void vtkGuMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
