#include "vtkGIFTIReader.h"

#include "Base/Steps.h"
#include "Bytes/SurfacePairing.h"
#include "GIFTI/GIFTIFile.h"
#include "GIFTI/GIFTIParser.h"

#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkGIFTIReader);

//------------------------------------------------------------------------------
vtkGIFTIReader::~vtkGIFTIReader()
{
  delete[] this->SphereFileName;
  delete[] this->ShapeFileName;
}

//------------------------------------------------------------------------------
int vtkGIFTIReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeGIFTI) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkGIFTIReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  // Names are copied, since observers of the progress may change them.
  const std::string sphereName = this->SphereFileName ? this->SphereFileName : "";
  const std::string shapeName = this->ShapeFileName ? this->ShapeFileName : "";
  conformal::Steps steps(run, { 0.5, 0.4, 0.1 }); // surface, sphere, arrays
  conformal::SurfaceResult result = conformal::parseGIFTISurface(input, {}, steps.next());
  const conformal::Run ofSphere = steps.next(), ofShape = steps.next();
  conformal::addSphere(result, sphereName,
    [&](conformal::ByteReader& sphere)
    { return conformal::parseGIFTISurface(sphere, {}, ofSphere); });
  conformal::addPointArrays(result, shapeName,
    [&](conformal::ByteReader& shape) { return conformal::parseGIFTIArrays(shape, {}, ofShape); });
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkGIFTIReader::FilesReadToo()
{
  return { this->SphereFileName ? this->SphereFileName : "",
    this->ShapeFileName ? this->ShapeFileName : "" };
}

//------------------------------------------------------------------------------
void vtkGIFTIReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SphereFileName: " << (this->SphereFileName ? this->SphereFileName : "(none)")
     << "\n";
  os << indent << "ShapeFileName: " << (this->ShapeFileName ? this->ShapeFileName : "(none)")
     << "\n";
}
