#include "vtkSphericalMorph.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/CarriedArrays.h"
#include "Glue/MappedSurfaces.h"
#include "Glue/Points.h"
#include "Glue/Run.h"
#include "Register/ConsistentRemesh.h"
#include "Register/SphericalMorph.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSphericalMorph);

// Surfaces sampled on a common mesh, which does not depend on the morph factor. The inputs and
// options are stored, so that the mesh is made again only after a change.
struct vtkSphericalMorph::Common
{
  static std::shared_ptr<const Common> of(const glue::Surfaces& surfaces,
    const conformal::ConsistentRemeshOptions& options, conformal::Steps& steps)
  {
    auto made = std::make_shared<Common>();
    made->Times = surfaces.Times;
    made->Options = options;
    const std::vector<conformal::MappedMesh> meshes =
      glue::ToMappedMeshes(surfaces, made->Frame, steps.next());
    made->Meshes = conformal::remeshConsistently(meshes, options, steps.next());
    return made;
  }

  std::vector<vtkMTimeType> Times; // modification times of the surfaces
  conformal::ConsistentRemeshOptions Options;
  conformal::CoordinateFrame Frame;
  conformal::ConsistentMeshes Meshes;

  bool isOf(
    const std::vector<vtkMTimeType>& times, const conformal::ConsistentRemeshOptions& options) const
  {
    return this->Times == times && this->Options.MeshType == options.MeshType &&
      this->Options.Frequency == options.Frequency &&
      this->Options.NumberOfPoints == options.NumberOfPoints;
  }
};

namespace
{
conformal::ConsistentRemeshOptions RemeshOptionsOf(vtkSphericalMorph* self)
{
  conformal::ConsistentRemeshOptions options;
  options.MeshType = static_cast<conformal::RemeshMeshType>(self->GetMeshType());
  options.Frequency = self->GetFrequency();
  options.NumberOfPoints = self->GetNumberOfPoints();
  return options;
}

// Return the weights of the surfaces, with the sum 1: the given weights or, without any, those of
// the morph factor.
std::vector<double> SharesOf(std::vector<double> weights, double factor, std::size_t size)
{
  if (size < 2)
  {
    throw std::invalid_argument("two surfaces or more are needed: set the target of the morph, "
                                "or give composite data of several surfaces");
  }
  if (weights.empty())
  {
    return conformal::morphWeights(factor, size);
  }
  if (weights.size() != size)
  {
    throw std::invalid_argument("there are " + std::to_string(weights.size()) + " weights for " +
      std::to_string(size) + " surfaces; add one for each, or remove all");
  }
  const double maximum = *std::max_element(weights.begin(), weights.end());
  for (double& weight : weights)
  {
    if (!(weight >= 0.0) || !std::isfinite(weight) || maximum <= 0.0)
    {
      throw std::invalid_argument("weights must be finite and at least 0, and not all of them 0");
    }
    weight /= maximum;
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}

void SetTime(vtkPolyData* output, bool isTimed, double time)
{
  if (isTimed)
  {
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  }
}

// Return relative costs of the steps: surfaces and common mesh, unless the mesh is kept, then
// shape, weights, arrays and output.
std::vector<double> SharesOf(bool isKept, conformal::MorphPath path)
{
  std::vector<double> shares;
  if (!isKept)
  {
    shares = { 0.06, 0.6 };
  }
  shares.insert(
    shares.end(), { path == conformal::MorphPath::Rigid ? 0.24 : 0.01, 0.02, 0.05, 0.03 });
  return shares;
}
}

//------------------------------------------------------------------------------
vtkSphericalMorph::vtkSphericalMorph()
{
  this->SetNumberOfInputPorts(2);
}

//------------------------------------------------------------------------------
vtkSphericalMorph::~vtkSphericalMorph() = default;

//------------------------------------------------------------------------------
void vtkSphericalMorph::SetTargetConnection(vtkAlgorithmOutput* output)
{
  this->SetInputConnection(1, output);
}

//------------------------------------------------------------------------------
void vtkSphericalMorph::SetTargetData(vtkDataObject* target)
{
  this->SetInputDataObject(1, target);
}

//------------------------------------------------------------------------------
void vtkSphericalMorph::AddWeight(double weight)
{
  this->Weights.push_back(weight);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalMorph::RemoveAllWeights()
{
  if (!this->Weights.empty())
  {
    this->Weights.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkSphericalMorph::FillInputPortInformation(int port, vtkInformation* info)
{
  glue::AcceptSurfaces(info);
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), port > 0);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalMorph::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  if (this->GenerateTimeSteps)
  {
    std::vector<double> steps(this->NumberOfTimeSteps);
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      steps[i] = static_cast<double>(i) / static_cast<double>(steps.size() - 1);
    }
    glue::SetTimeSteps(outputs->GetInformationObject(0), steps);
  }
  return 1;
}

//------------------------------------------------------------------------------
// Return the requested time, or MorphFactor if no time is requested.
double vtkSphericalMorph::FactorOf(vtkInformation* outputInformation) const
{
  using Executive = vtkStreamingDemandDrivenPipeline;
  if (!this->GenerateTimeSteps || !outputInformation->Has(Executive::UPDATE_TIME_STEP()))
  {
    return this->MorphFactor;
  }
  const double time = outputInformation->Get(Executive::UPDATE_TIME_STEP());
  return std::isfinite(time) ? std::clamp(time, 0.0, 1.0) : this->MorphFactor;
}

//------------------------------------------------------------------------------
int vtkSphericalMorph::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  const double factor = this->FactorOf(outputVector->GetInformationObject(0));
  const bool isTimed = this->GenerateTimeSteps;
  const std::vector<double> weights = this->Weights;
  const conformal::ConsistentRemeshOptions remesh = RemeshOptionsOf(this);
  conformal::SphericalMorphOptions options;
  options.Path = static_cast<conformal::MorphPath>(this->Path);
  return glue::RunCore(this,
    [&]()
    {
      glue::Surfaces surfaces;
      glue::AddSurfaces(inputVector[0], surfaces);
      glue::AddSurfaces(inputVector[1], surfaces);
      const std::vector<vtkPolyData*> held = surfaces.pointers();
      if (glue::HasEmpty(this, surfaces))
      {
        return;
      }
      const std::vector<double> shares = SharesOf(weights, factor, held.size());
      const bool isKept = this->Kept && this->Kept->isOf(surfaces.Times, remesh);
      conformal::Steps steps(glue::RunOf(this), SharesOf(isKept, options.Path));
      const auto common = isKept ? this->Kept : Common::of(surfaces, remesh, steps);
      const conformal::ConsistentMeshes& meshes = common->Meshes;
      const vtkNew<vtkPolyData> result;
      glue::SetSurface(result,
        conformal::morphShapes(meshes.Sphere, meshes.Positions, shares, options, steps.next()),
        meshes.Sphere.Triangles, common->Frame);
      steps.next();
      const conformal::ResampleWeights blend = glue::BlendedWeights(meshes.Weights, held, shares);
      glue::CarryPointArrays(this, held, blend, result->GetPointData(), steps.next());
      steps.next();
      glue::ActivateScalarsOf(held.front(), result);
      glue::AddVectors(result->GetPointData(), glue::SpherePositionName(), meshes.Sphere.Positions);
      glue::AddNumbers(result->GetFieldData(), "MorphWeights", shares);
      output->ShallowCopy(result);
      SetTime(output, isTimed, factor);
      this->Kept = common;
    });
}

//------------------------------------------------------------------------------
void vtkSphericalMorph::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const paths[] = { "Linear", "Rigid" };
  static const char* const meshTypes[] = { "Geodesic", "Adaptive" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MorphFactor: " << this->MorphFactor << "\n";
  os << indent << "NumberOfWeights: " << this->Weights.size() << "\n";
  os << indent << "Path: " << paths[this->Path] << "\n";
  os << indent << "MeshType: " << meshTypes[this->MeshType] << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "GenerateTimeSteps: " << (this->GenerateTimeSteps ? "on" : "off") << "\n";
  os << indent << "NumberOfTimeSteps: " << this->NumberOfTimeSteps << "\n";
}
