#include "vtkGIFTIWriter.h"

#include "SurfaceBytes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGIFTIWriter);

//------------------------------------------------------------------------------
std::string vtkGIFTIWriter::MakeBytes(
  const conformal::SurfaceData& surface, const std::function<bool(double)>& progress)
{
  return conformal::makeGIFTI(surface, progress);
}

//------------------------------------------------------------------------------
void vtkGIFTIWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
