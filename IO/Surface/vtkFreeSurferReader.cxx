#include "vtkFreeSurferReader.h"

#include "Base/Steps.h"
#include "Bytes/SurfacePairing.h"
#include "FreeSurfer/FreeSurferParser.h"

#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkFreeSurferReader);

//------------------------------------------------------------------------------
vtkFreeSurferReader::~vtkFreeSurferReader()
{
  delete[] this->SphereFileName;
  delete[] this->CurvatureFileName;
}

//------------------------------------------------------------------------------
int vtkFreeSurferReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeFreeSurferSurface) ? 1 : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkFreeSurferReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  // Names are copied, since observers of the progress may change them.
  const std::string sphereName = this->SphereFileName ? this->SphereFileName : "";
  const std::string curvatureName = this->CurvatureFileName ? this->CurvatureFileName : "";
  conformal::Steps steps(run, { 0.5, 0.4, 0.1 }); // surface, sphere, values
  conformal::SurfaceResult result = conformal::parseFreeSurferSurface(input, {}, steps.next());
  const conformal::Run ofSphere = steps.next(), ofCurvature = steps.next();
  conformal::addSphere(result, sphereName,
    [&](conformal::ByteReader& sphere)
    { return conformal::parseFreeSurferSurface(sphere, {}, ofSphere); });
  conformal::addPointArrays(result, curvatureName,
    [&](conformal::ByteReader& curvature)
    { return conformal::parseFreeSurferCurv(curvature, {}, ofCurvature); });
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkFreeSurferReader::FilesReadToo()
{
  return { this->SphereFileName ? this->SphereFileName : "",
    this->CurvatureFileName ? this->CurvatureFileName : "" };
}

//------------------------------------------------------------------------------
void vtkFreeSurferReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SphereFileName: " << (this->SphereFileName ? this->SphereFileName : "(none)")
     << "\n";
  os << indent
     << "CurvatureFileName: " << (this->CurvatureFileName ? this->CurvatureFileName : "(none)")
     << "\n";
}
