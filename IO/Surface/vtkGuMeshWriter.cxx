#include "vtkGuMeshWriter.h"

#include "GuMesh/GuMeshWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGuMeshWriter);

//------------------------------------------------------------------------------
void vtkGuMeshWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  this->WriteSurface([&](const conformal::SurfaceData& surface)
    { return conformal::makeGuMesh(surface, progress); });
}

//------------------------------------------------------------------------------
void vtkGuMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
