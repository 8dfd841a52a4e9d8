#include "vtkGIFTIWriter.h"

#include "GIFTI/GIFTIWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGIFTIWriter);

//------------------------------------------------------------------------------
void vtkGIFTIWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface)
    {
      switch (this->Content)
      {
        case GEOMETRY:
          return conformal::makeGIFTIGeometry(surface, this->AnatomicalStructure, progress);
        case SPHERE:
          return conformal::makeGIFTISphere(surface, this->AnatomicalStructure, progress);
        case SHAPE:
          return conformal::makeGIFTIShape(surface, this->AnatomicalStructure, progress);
        default:
          return conformal::makeGIFTISurface(surface, this->AnatomicalStructure, progress);
      }
    });
}

//------------------------------------------------------------------------------
void vtkGIFTIWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const contents[] = { "Surface", "Geometry", "Sphere", "Shape" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Content: " << contents[this->Content] << "\n";
  os << indent << "AnatomicalStructure: " << this->AnatomicalStructure << "\n";
}
