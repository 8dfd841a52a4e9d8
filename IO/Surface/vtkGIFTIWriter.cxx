#include "vtkGIFTIWriter.h"

#include "GIFTI/GIFTIWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGIFTIWriter);

//------------------------------------------------------------------------------
void vtkGIFTIWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  const int content = this->Content; // observers of the progress may set others
  const std::string structure = this->AnatomicalStructure;
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface)
    {
      switch (content)
      {
        case GEOMETRY:
          return conformal::makeGIFTIGeometry(surface, structure, progress);
        case SPHERE:
          return conformal::makeGIFTISphere(surface, structure, progress);
        case SHAPE:
          return conformal::makeGIFTIShape(surface, structure, progress);
        default:
          return conformal::makeGIFTISurface(surface, structure, progress);
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
