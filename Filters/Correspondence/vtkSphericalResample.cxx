#include "vtkSphericalResample.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/CarriedArrays.h"
#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Register/SphericalResample.h"

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkSphericalResample);

namespace
{
// Return the array "SpherePosition" or, without this array, the points, which must be on a sphere
// around the origin.
conformal::Points SpherePositionsOf(
  vtkPolyData* surface, const conformal::Points& positions, const char* what)
{
  if (surface->GetPointData()->GetArray(glue::SpherePositionName()))
  {
    return glue::ToSpherePositions(surface);
  }
  constexpr double tolerance = 1e-3;
  const Eigen::VectorXd radii = positions.rowwise().norm();
  if (!(radii.maxCoeff() - radii.minCoeff() <= tolerance * radii.minCoeff()))
  {
    throw std::invalid_argument(std::string("the ") + what + " has no point array " +
      glue::SpherePositionName() + ", and its points do not lie on a sphere around the origin");
  }
  conformal::Points map = positions;
  conformal::normalizeRows(map);
  return map;
}

conformal::MappedMesh ToMapped(vtkPolyData* surface, const char* what)
{
  conformal::MappedMesh mesh;
  mesh.Triangles = glue::ToTriangles(surface);
  mesh.Positions = glue::ToPoints(surface->GetPoints(), glue::FrameOf({ surface }));
  if (!mesh.Positions.allFinite())
  {
    throw std::invalid_argument(std::string("some points of the ") + what + " are not finite");
  }
  mesh.SpherePositions = SpherePositionsOf(surface, mesh.Positions, what);
  return mesh;
}

void RequireTriangles(const conformal::Mesh& mesh, const std::string& complaint)
{
  if (mesh.Triangles.rows() == 0)
  {
    throw std::invalid_argument(complaint);
  }
}

std::vector<char> MaskOf(vtkPolyData* source, const std::string& name)
{
  vtkDataArray* array = source->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the source has no point array \"" + name +
      "\" of 1 component; set MaskArrayName to the name of one, or to an empty one");
  }
  std::vector<char> mask(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    mask[i] = array->GetComponent(i, 0) != 0.0;
  }
  return mask;
}

void AddMask(vtkPointData* data, const conformal::ResampleWeights& weights)
{
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("ResampleMask");
  mask->SetNumberOfValues(weights.size());
  for (vtkIdType i = 0; i < weights.size(); ++i)
  {
    mask->SetValue(i, weights.Offsets[i] < weights.Offsets[i + 1] ? 1 : 0);
  }
  data->AddArray(mask);
}

void WarnOfFolds(vtkObject* self, conformal::Index numberOfFolds)
{
  if (numberOfFolds > 0)
  {
    vtkWarningWithObjectMacro(self,
      << numberOfFolds
      << " triangles of the source's map to the sphere are folded: values are discontinuous there");
  }
}

// Return a copy of the target with the resampled arrays of the source.
vtkNew<vtkPolyData> Resampled(vtkObject* self, vtkPolyData* target, vtkPolyData* source,
  const conformal::ResampleWeights& weights, bool isMasked, const conformal::Run& run)
{
  vtkNew<vtkPolyData> result;
  result->ShallowCopy(target);
  glue::CarryPointArrays(self, { source }, weights, result->GetPointData(), run);
  glue::ActivateScalarsOf(source, result);
  if (isMasked)
  {
    AddMask(result->GetPointData(), weights);
  }
  return result;
}
}

//------------------------------------------------------------------------------
vtkSphericalResample::vtkSphericalResample()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSphericalResample::SetSourceConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkSphericalResample::SetSourceData(vtkPolyData* source)
{
  this->SetInputData(1, source);
}

//------------------------------------------------------------------------------
int vtkSphericalResample::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto target = glue::Held(vtkPolyData::GetData(inputVector[0]));
  const auto source = glue::Held(vtkPolyData::GetData(inputVector[1]));
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const std::string maskName = this->MaskArrayName;
  conformal::SphericalResampleOptions options;
  options.Method = static_cast<conformal::ResampleMethod>(this->Method);
  return glue::RunCore(this,
    [&]()
    {
      if (glue::IsEmptyInput(this, target, "the target is empty; the output is empty") ||
        glue::IsEmptyInput(this, source, "the source is empty; the output is empty"))
      {
        return;
      }
      const bool isAdaptive = options.Method == conformal::ResampleMethod::AreaAdaptive;
      const bool isMasked = !maskName.empty();
      // Relative costs of source, target, weights, mask and arrays.
      conformal::Steps steps(glue::RunOf(this), { 0.04, 0.04, 0.82, isMasked ? 0.02 : 0.0, 0.1 });
      steps.next();
      const conformal::MappedMesh from = ToMapped(source, "source");
      RequireTriangles(from, "the source has no triangles");
      steps.next();
      const conformal::MappedMesh to = ToMapped(target, "target");
      if (isAdaptive)
      {
        RequireTriangles(to, "the target has no triangles; set Method to BARYCENTRIC");
      }
      conformal::SphericalResampling resampling =
        conformal::resampleSurface(from, to, options, steps.next());
      steps.next();
      if (isMasked)
      {
        resampling.Weights = conformal::restrictedTo(resampling.Weights, MaskOf(source, maskName));
      }
      const auto result =
        Resampled(this, target, source, resampling.Weights, isMasked, steps.next());
      WarnOfFolds(this, resampling.NumberOfFolds);
      output->ShallowCopy(result);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalResample::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const methods[] = { "Barycentric", "AreaAdaptive" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << methods[this->Method] << "\n";
  os << indent << "MaskArrayName: " << this->MaskArrayName << "\n";
}
