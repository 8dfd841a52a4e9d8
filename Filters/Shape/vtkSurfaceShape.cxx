#include "vtkSurfaceShape.h"

#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Measure/SurfaceShape.h"

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
  // Curvature has the unit 1 / length. A frame with the inverse unit converts it like a length.
  const conformal::CoordinateFrame inverse = { 1.0 / frame.Unit };
  glue::AddLengths(data, "MeanCurvature", ToVector(shape.MeanCurvature), inverse);
  std::vector<double> gaussian = ToVector(shape.GaussianCurvature);
  glue::AreasFromFrame(
    gaussian.data(), static_cast<conformal::Index>(gaussian.size()), inverse, "GaussianCurvature");
  glue::AddNumbers(data, "GaussianCurvature", gaussian);
  glue::AddLengths(data, "SulcalDepth", ToVector(shape.SulcalDepth), frame);
}
}

//------------------------------------------------------------------------------
int vtkSurfaceShape::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto surface = glue::Held(vtkPolyData::GetData(inputVector[0]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  conformal::SurfaceShapeOptions options;
  options.CurvatureScale = this->CurvatureScale;
  options.DepthScale = this->DepthScale;
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, surface, "the surface is empty; the output is empty"))
      {
        return;
      }
      const conformal::CoordinateFrame frame = glue::FrameOf({ surface });
      // Relative costs of mesh, shape and output.
      conformal::Steps steps(glue::RunOf(this), { 0.12, 0.87, 0.01 });
      const auto mesh = glue::ToClosedMesh(this, surface, frame, steps.next());
      const conformal::Mesh outward = glue::Outward(mesh);
      const conformal::SurfaceShape shape =
        conformal::measureSurfaceShape(outward, options, steps.next());
      steps.next();
      const vtkNew<vtkPolyData> result;
      glue::PassClosedMesh(surface, mesh, frame, result);
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
