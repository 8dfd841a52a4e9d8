#include "vtkSphericalTextureMap.h"

#include "SphericalTexture.h"
#include "vtkConformalConversions.h"
#include "vtkMeshConversions.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkSphericalTextureMap);

//------------------------------------------------------------------------------
int vtkSphericalTextureMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (input->GetNumberOfPoints() == 0)
  {
    vtkWarningMacro(<< "the surface is empty, there is nothing to lay an image on");
    return 1;
  }
  conformal::SphericalTextureOptions options;
  options.ViewDirection = conformal::Vector3(this->ViewDirection);
  options.ViewUp = conformal::Vector3(this->ViewUp);
  options.FieldOfView = this->FieldOfView;
  return vtkConformalConversions::RunCore(this,
    [&]()
    {
      conformal::Points copy;
      const conformal::SphericalTexture texture = conformal::makeSphericalTexture(
        vtkConformalConversions::ViewPoints(input->GetPoints(), copy),
        vtkConformalConversions::ToTriangles(input),
        vtkConformalConversions::ToSpherePositions(input), options,
        vtkConformalConversions::SMPFor(), vtkConformalConversions::ProgressOf(this));

      output->ShallowCopy(input);
      vtkNew<vtkFloatArray> coordinates;
      coordinates->SetName("Texture Coordinates");
      coordinates->SetNumberOfComponents(2);
      coordinates->SetNumberOfTuples(texture.Coordinates.rows());
      std::transform(texture.Coordinates.data(),
        texture.Coordinates.data() + texture.Coordinates.size(), coordinates->GetPointer(0),
        [](double value) { return static_cast<float>(value); });
      output->GetPointData()->SetTCoords(coordinates);

      vtkNew<vtkUnsignedCharArray> outside;
      outside->SetName("OutsideImage");
      outside->SetNumberOfValues(static_cast<vtkIdType>(texture.OutsideImage.size()));
      std::copy(texture.OutsideImage.begin(), texture.OutsideImage.end(), outside->GetPointer(0));
      output->GetPointData()->AddArray(outside);

      const auto addDirection = [&](const char* name, const conformal::Vector3& direction)
      {
        vtkConformalConversions::AddVectors(
          output->GetFieldData(), name, conformal::Points(direction.transpose()));
      };
      addDirection("SpherePole", texture.View.Pole);
      addDirection("SphereUp", texture.View.Up);
      addDirection("SphereRight", texture.View.Right);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalTextureMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ViewDirection: (" << this->ViewDirection[0] << ", " << this->ViewDirection[1]
     << ", " << this->ViewDirection[2] << ")\n";
  os << indent << "ViewUp: (" << this->ViewUp[0] << ", " << this->ViewUp[1] << ", "
     << this->ViewUp[2] << ")\n";
  os << indent << "FieldOfView: " << this->FieldOfView << "\n";
}
