#include "vtkGeodesicSphereSource.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Mesh/GeodesicSphere.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkGeodesicSphereSource);

//------------------------------------------------------------------------------
vtkGeodesicSphereSource::vtkGeodesicSphereSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int vtkGeodesicSphereSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const int frequency = this->Frequency;
  return glue::RunCore(this,
    [&]()
    {
      // Relative costs of the mesh, and of the points, triangles and two arrays of the output.
      conformal::Steps steps(glue::RunOf(this), { 0.26, 0.18, 0.21, 0.17, 0.18 });
      const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency, steps.next());
      steps.next();
      const vtkNew<vtkPolyData> result;
      glue::SetPoints(result, sphere.Positions, {});
      steps.next();
      glue::SetTriangles(result, sphere.Triangles);
      steps.next();
      vtkPointData* pointData = result->GetPointData();
      glue::AddVectors(pointData, glue::SpherePositionName(), sphere.Positions);
      steps.next();
      glue::AddVectors(pointData, "Normals", sphere.Positions);
      pointData->SetActiveNormals("Normals");
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkGeodesicSphereSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frequency: " << this->Frequency << "\n";
}
