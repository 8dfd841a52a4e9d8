#include "vtkConformalOFFWriter.h"

#include "SurfaceBytes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalOFFWriter);

//------------------------------------------------------------------------------
std::string vtkConformalOFFWriter::MakeBytes(
  const conformal::SurfaceData& surface, const std::function<bool(double)>& progress)
{
  return conformal::makeOFF(surface, progress);
}

//------------------------------------------------------------------------------
void vtkConformalOFFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
