#include "vtkSPHARMSurfaceWriter.h"

#include "Glue/SurfaceConversions.h"
#include "SPHARM/SPHARMMesh.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <string>

vtkStandardNewMacro(vtkSPHARMSurfaceWriter);

//------------------------------------------------------------------------------
void vtkSPHARMSurfaceWriter::WriteFiles(const conformal::Run& run)
{
  const std::string path = this->FileName; // a copy: observers may change it
  const conformal::SurfaceData surface =
    glue::ToSurfaceData(vtkPolyData::SafeDownCast(this->GetInput(0)));
  const std::string sphere = conformal::makeSPHARMSphere(surface, run.part(0.0, 0.5));
  const std::string own = conformal::makeSPHARMSurface(surface, run.part(0.5, 1.0));
  this->WriteTogether({ { conformal::sphereNameOf(path), sphere }, { path, own } });
}

//------------------------------------------------------------------------------
void vtkSPHARMSurfaceWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
