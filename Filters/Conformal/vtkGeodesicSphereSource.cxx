#include "vtkGeodesicSphereSource.h"

#include "GeodesicSphere.h"
#include "vtkConformalConversions.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
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
  return vtkConformalConversions::RunCore(this,
    [&]()
    {
      const conformal::GeodesicSphere sphere =
        conformal::makeGeodesicSphere(this->Frequency, vtkConformalConversions::SMPFor());
      vtkConformalConversions::SetSurface(output, sphere.Positions, sphere.Faces);
      vtkPointData* pointData = output->GetPointData();
      vtkConformalConversions::AddVectors(
        pointData, vtkConformalConversions::SpherePositionName(), sphere.Positions);
      vtkConformalConversions::AddVectors(pointData, "Normals", sphere.Positions);
      pointData->SetActiveNormals("Normals");
    });
}

//------------------------------------------------------------------------------
void vtkGeodesicSphereSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Frequency: " << this->Frequency << "\n";
}
