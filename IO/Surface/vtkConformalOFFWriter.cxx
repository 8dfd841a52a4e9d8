#include "vtkConformalOFFWriter.h"

#include "OFF/OFFWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalOFFWriter);

//------------------------------------------------------------------------------
void vtkConformalOFFWriter::WriteFiles(const conformal::Run& run)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface) { return conformal::makeOFF(surface, run); });
}

//------------------------------------------------------------------------------
void vtkConformalOFFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
