#include "vtkGIFTIWriter.h"

#include "GIFTI/GIFTIWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGIFTIWriter);

//------------------------------------------------------------------------------
void vtkGIFTIWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface) { return conformal::makeGIFTI(surface, progress); });
}

//------------------------------------------------------------------------------
void vtkGIFTIWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
