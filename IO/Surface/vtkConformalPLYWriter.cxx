#include "vtkConformalPLYWriter.h"

#include "SurfaceBytes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalPLYWriter);

//------------------------------------------------------------------------------
std::string vtkConformalPLYWriter::MakeBytes(
  const conformal::SurfaceData& surface, const std::function<bool(double)>& progress)
{
  return conformal::makePLY(surface, progress);
}

//------------------------------------------------------------------------------
void vtkConformalPLYWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
