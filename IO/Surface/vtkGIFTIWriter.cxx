#include "vtkGIFTIWriter.h"

#include "GIFTI/GIFTIWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGIFTIWriter);

//------------------------------------------------------------------------------
void vtkGIFTIWriter::WriteFiles(const conformal::Run& run)
{
  const int content = this->Content; // a copy: observers may change it
  const std::string structure = this->AnatomicalStructure;
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface)
    {
      switch (content)
      {
        case GEOMETRY:
          return conformal::makeGIFTIGeometry(surface, structure, run);
        case SPHERE:
          return conformal::makeGIFTISphere(surface, structure, run);
        case SHAPE:
          return conformal::makeGIFTIShape(surface, structure, run);
        default:
          return conformal::makeGIFTISurface(surface, structure, run);
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
