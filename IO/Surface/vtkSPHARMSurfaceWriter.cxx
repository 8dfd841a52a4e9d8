#include "vtkSPHARMSurfaceWriter.h"

#include "SPHARM/SPHARMMesh.h"
#include "vtkSurfaceConversions.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkSPHARMSurfaceWriter);

//------------------------------------------------------------------------------
void vtkSPHARMSurfaceWriter::WriteFiles(const std::function<bool(double)>& progress)
{
  const std::string path = this->FileName; // observers of the progress may set another
  const conformal::SurfaceData surface =
    vtkSurfaceConversions::ToSurfaceData(vtkPolyData::SafeDownCast(this->GetInput(0)));
  const auto half = [&](double begin)
  { return [=](double done) { return progress(begin + 0.5 * done); }; };
  const std::string sphere = conformal::makeSPHARMSphere(surface, half(0.0));
  const std::string own = conformal::makeSPHARMSurface(surface, half(0.5));
  this->WriteTogether({ { conformal::sphereNameOf(path), sphere }, { path, own } });
}

//------------------------------------------------------------------------------
void vtkSPHARMSurfaceWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
