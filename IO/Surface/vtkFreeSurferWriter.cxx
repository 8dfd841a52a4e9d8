#include "vtkFreeSurferWriter.h"

#include "Bytes/SurfaceWalk.h"
#include "FreeSurfer/FreeSurferWriter.h"

#include "vtkObjectFactory.h"

#include <stdexcept>

vtkStandardNewMacro(vtkFreeSurferWriter);

namespace
{
const conformal::NamedArray& Find(const conformal::SurfaceData& surface, const std::string& name)
{
  const conformal::NamedArray* array =
    conformal::findArray(surface.PointArrays, name, 1, [](conformal::ScalarType) { return true; });
  if (!array)
  {
    throw std::invalid_argument("the surface has no point array \"" + name + "\" of 1 component");
  }
  return *array;
}
}

//------------------------------------------------------------------------------
void vtkFreeSurferWriter::WriteFiles(const conformal::Run& run)
{
  const int content = this->Content; // a copy: observers may change it
  const std::string name = this->ArrayName;
  this->WriteSurface(
    [&](const conformal::SurfaceData& surface)
    {
      if (content == CURVATURE)
      {
        return conformal::makeFreeSurferCurv(
          Find(surface, name), conformal::numberOfPolygons(surface), run);
      }
      if (content == SPHERE)
      {
        return conformal::makeFreeSurferSphere(surface, run);
      }
      return conformal::makeFreeSurferSurface(surface, run);
    });
}

//------------------------------------------------------------------------------
void vtkFreeSurferWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const contents[] = { "Surface", "Sphere", "Curvature" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Content: " << contents[this->Content] << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
}
