#include "vtkSurfaceShape.h"

#include "Base/Steps.h"
#include "Measure/SurfaceShape.h"
#include "vtkConformalConversions.h"
#include "vtkMeshConversions.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <vector>

vtkStandardNewMacro(vtkSurfaceShape);

namespace
{
std::vector<double> ToVector(const Eigen::VectorXd& values)
{
  return { values.begin(), values.end() };
}

void AddShape(
  vtkPointData* data, const conformal::SurfaceShape& shape, const conformal::CoordinateFrame& frame)
{
  // A frame whose lengths are one by a length.
  const conformal::CoordinateFrame inverse = { 1.0 / frame.Unit };
  vtkConformalConversions::AddLengths(
    data, "MeanCurvature", ToVector(shape.MeanCurvature), inverse);
  std::vector<double> gaussian = ToVector(shape.GaussianCurvature);
  vtkConformalConversions::AreasFromFrame(
    gaussian.data(), static_cast<conformal::Index>(gaussian.size()), inverse, "GaussianCurvature");
  vtkConformalConversions::AddNumbers(data, "GaussianCurvature", gaussian);
  vtkConformalConversions::AddLengths(data, "SulcalDepth", ToVector(shape.SulcalDepth), frame);
}
}

//------------------------------------------------------------------------------
int vtkSurfaceShape::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = vtkConformalConversions::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  conformal::SurfaceShapeOptions options;
  options.CurvatureScale = this->CurvatureScale;
  options.DepthScale = this->DepthScale;
  return vtkConformalConversions::RunCore(this,
    [&]()
    {
      if (surface->GetNumberOfPoints() == 0)
      {
        vtkConformalConversions::WarnOfEmptyInput(
          this, "the surface is empty; the output is empty");
        return;
      }
      const conformal::CoordinateFrame frame = vtkConformalConversions::FrameOf({ surface });
      conformal::Steps steps(
        vtkConformalConversions::RunOf(this), { 560.0, 4000.0, 40.0 }); // for each point
      const auto mesh = vtkConformalConversions::ToClosedMesh(this, surface, frame, steps.next());
      const conformal::Mesh outward = vtkConformalConversions::Outward(mesh);
      const conformal::SurfaceShape shape =
        conformal::measureSurfaceShape(outward, options, steps.next());
      steps.next();
      const vtkNew<vtkPolyData> result;
      vtkConformalConversions::PassClosedMesh(surface, mesh, frame, result);
      AddShape(result->GetPointData(), shape, frame);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkSurfaceShape::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CurvatureScale: " << this->CurvatureScale << "\n";
  os << indent << "DepthScale: " << this->DepthScale << "\n";
}
