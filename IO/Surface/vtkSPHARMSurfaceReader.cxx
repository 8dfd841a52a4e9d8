#include "vtkSPHARMSurfaceReader.h"

#include "Base/Steps.h"
#include "Bytes/SurfacePairing.h"
#include "SPHARM/SPHARMMesh.h"

#include "vtkObjectFactory.h"

#include <string>

vtkStandardNewMacro(vtkSPHARMSurfaceReader);

namespace
{
bool HasText(const char* name)
{
  return name && name[0];
}

// Return the name of the sphere that belongs to a surface. The name is empty if there is no such
// file.
std::string SphereBeside(const char* surface)
{
  const std::string path = conformal::sphereNameOf(surface);
  conformal::ByteReader input;
  return conformal::openFile(path, input).ok() ? path : "";
}
}

//------------------------------------------------------------------------------
vtkSPHARMSurfaceReader::~vtkSPHARMSurfaceReader()
{
  delete[] this->SphereFileName;
}

//------------------------------------------------------------------------------
int vtkSPHARMSurfaceReader::CanReadFile(const char* name)
{
  return Superclass::StartsLike(name, conformal::looksLikeSPHARMMesh) && !SphereBeside(name).empty()
    ? 1
    : 0;
}

//------------------------------------------------------------------------------
conformal::SurfaceResult vtkSPHARMSurfaceReader::Parse(
  conformal::ByteReader& input, const conformal::FilePiece&, const conformal::Run& run)
{
  const std::string sphere =
    HasText(this->SphereFileName) ? this->SphereFileName : SphereBeside(this->FileName);
  conformal::Steps steps(run, { 0.5, 0.5 }); // surface, sphere
  conformal::SurfaceResult result = conformal::parseSPHARMMesh(input, {}, steps.next());
  const conformal::Run ofSphere = steps.next();
  conformal::addSphere(result, sphere,
    [&](conformal::ByteReader& file) { return conformal::parseSPHARMMesh(file, {}, ofSphere); });
  return result;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkSPHARMSurfaceReader::FilesReadToo()
{
  return { HasText(this->SphereFileName) ? this->SphereFileName
                                         : conformal::sphereNameOf(this->FileName) };
}

//------------------------------------------------------------------------------
void vtkSPHARMSurfaceReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SphereFileName: " << (this->SphereFileName ? this->SphereFileName : "(none)")
     << "\n";
}
