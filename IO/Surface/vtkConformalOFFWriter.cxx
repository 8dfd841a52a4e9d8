#include "vtkConformalOFFWriter.h"

#include "OFF/OFFWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkConformalOFFWriter);

//------------------------------------------------------------------------------
void vtkConformalOFFWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface) { return conformal::makeOFF(surface, progress); });
}

//------------------------------------------------------------------------------
void vtkConformalOFFWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
