#include "vtkConformalPLYWriter.h"

#include "PLY/PLYWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalPLYWriter);

//------------------------------------------------------------------------------
void vtkConformalPLYWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface) { return conformal::makePLY(surface, progress); });
}

//------------------------------------------------------------------------------
void vtkConformalPLYWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
