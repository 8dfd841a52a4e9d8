#include "vtkTextCloudWriter.h"

#include "TextCloud/TextCloudWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTextCloudWriter);

//------------------------------------------------------------------------------
void vtkTextCloudWriter::WriteFiles(const conformal::Run& run)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface) { return conformal::makeTextCloud(surface, run); });
}

//------------------------------------------------------------------------------
void vtkTextCloudWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
