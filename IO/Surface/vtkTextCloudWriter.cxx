#include "vtkTextCloudWriter.h"

#include "SurfaceBytes.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTextCloudWriter);

//------------------------------------------------------------------------------
std::string vtkTextCloudWriter::MakeBytes(
  const conformal::SurfaceData& surface, const std::function<bool(double)>& progress)
{
  return conformal::makeTextCloud(surface, progress);
}

//------------------------------------------------------------------------------
void vtkTextCloudWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
