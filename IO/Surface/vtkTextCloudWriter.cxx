#include "vtkTextCloudWriter.h"

#include "TextCloud/TextCloudWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkTextCloudWriter);

//------------------------------------------------------------------------------
void vtkTextCloudWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  this->WriteSurface([&](const conformal::SurfaceData& surface)
    { return conformal::makeTextCloud(surface, progress); });
}

//------------------------------------------------------------------------------
void vtkTextCloudWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
