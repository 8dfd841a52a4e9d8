#include "vtkGeodesicSphereSource.h"

#include "Base/Steps.h"
#include "Mesh/GeodesicSphere.h"
#include "vtkConformalConversions.h"

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
  return vtkConformalConversions::RunCore(this,
    [&]()
    {
      // For each vertex: the mesh, then points, triangles and two arrays of the output.
      conformal::Steps steps(
        vtkConformalConversions::RunOf(this), { 31.0, 22.0, 25.0, 20.0, 22.0 });
      const conformal::Mesh sphere = conformal::makeGeodesicSphere(frequency, steps.next());
      steps.next();
      const vtkNew<vtkPolyData> result;
      vtkConformalConversions::SetPoints(result, sphere.Positions, {});
      steps.next();
      vtkConformalConversions::SetTriangles(result, sphere.Triangles);
      steps.next();
      vtkPointData* pointData = result->GetPointData();
      vtkConformalConversions::AddVectors(
        pointData, vtkConformalConversions::SpherePositionName(), sphere.Positions);
      steps.next();
      vtkConformalConversions::AddVectors(pointData, "Normals", sphere.Positions);
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
