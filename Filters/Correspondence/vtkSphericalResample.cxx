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
// The array, or else the points, if they lie on a sphere around the origin.
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
      using namespace glue;
      if (target->GetNumberOfPoints() == 0 || source->GetNumberOfPoints() == 0)
      {
        WarnOfEmptyInput(this,
          target->GetNumberOfPoints() == 0 ? "the target is empty; the output is empty"
                                           : "the source is empty; the output is empty");
        return;
      }
      const auto targetSize = static_cast<double>(target->GetNumberOfPoints());
      const auto sourceSize = static_cast<double>(source->GetNumberOfPoints());
      const bool isAdaptive = options.Method == conformal::ResampleMethod::AreaAdaptive;
      const auto components = static_cast<double>(NumberOfCarriedComponents(source));
      // The surfaces, the weights, the mask, and the arrays.
      conformal::Steps steps(RunOf(this),
        { 150.0 * sourceSize, 150.0 * targetSize,
          (isAdaptive ? 2500.0 : 1200.0) * (sourceSize + targetSize),
          maskName.empty() ? 0.0 : 50.0 * targetSize,
          components * (20.0 * sourceSize + 100.0 * targetSize) });
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
      if (!maskName.empty())
      {
        resampling.Weights = conformal::restrictedTo(resampling.Weights, MaskOf(source, maskName));
      }
      const vtkNew<vtkPolyData> result;
      result->ShallowCopy(target);
      vtkPointData* data = result->GetPointData();
      CarryPointArrays(this, { source }, resampling.Weights, data, steps.next());
      if (vtkDataArray* scalars = source->GetPointData()->GetScalars())
      {
        data->SetActiveScalars(scalars->GetName());
      }
      if (!maskName.empty())
      {
        AddMask(data, resampling.Weights);
      }
      if (resampling.NumberOfFolds > 0)
      {
        vtkWarningMacro(<< resampling.NumberOfFolds
                        << " triangles of the source's map to the sphere are folded: values jump "
                           "there");
      }
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
