#include "vtkConformalPLYWriter.h"

#include "PLY/PLYWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalPLYWriter);

//------------------------------------------------------------------------------
void vtkConformalPLYWriter::WriteFiles(const conformal::Run& run)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface) { return conformal::makePLY(surface, run); });
}

//------------------------------------------------------------------------------
void vtkConformalPLYWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
