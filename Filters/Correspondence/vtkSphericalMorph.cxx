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

// What all factors have in common, and what it was made of.
struct vtkSphericalMorph::Common
{
  std::vector<vtkMTimeType> Times; // of the surfaces
  conformal::ConsistentRemeshOptions Options;
  conformal::CoordinateFrame Frame;
  conformal::ConsistentMeshes Meshes;

  bool isOf(
    const std::vector<vtkMTimeType>& times, const conformal::ConsistentRemeshOptions& options) const
  {
    return this->Times == times && this->Options.Lattice == options.Lattice &&
      this->Options.Frequency == options.Frequency &&
      this->Options.NumberOfPoints == options.NumberOfPoints;
  }
};

namespace
{
std::vector<double> SharesOf(std::vector<double> weights, double factor, std::size_t size)
{
  if (weights.empty())
  {
    return conformal::morphWeights(factor, size);
  }
  if (weights.size() != size)
  {
    throw std::invalid_argument("there are " + std::to_string(weights.size()) + " weights for " +
      std::to_string(size) + " surfaces; add one for each, or remove all");
  }
  const double largest = *std::max_element(weights.begin(), weights.end());
  for (double& weight : weights)
  {
    if (!(weight >= 0.0) || !std::isfinite(weight) || largest <= 0.0)
    {
      throw std::invalid_argument("weights must be finite and at least 0, and not all of them 0");
    }
    weight /= largest;
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
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
    using Executive = vtkStreamingDemandDrivenPipeline;
    std::vector<double> steps(this->NumberOfTimeSteps);
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      steps[i] = static_cast<double>(i) / static_cast<double>(steps.size() - 1);
    }
    const double range[2] = { 0.0, 1.0 };
    vtkInformation* info = outputs->GetInformationObject(0);
    info->Set(Executive::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    info->Set(Executive::TIME_RANGE(), range, 2);
  }
  return 1;
}

//------------------------------------------------------------------------------
// The time asked for, if any.
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
  conformal::ConsistentRemeshOptions remesh;
  remesh.Lattice = static_cast<conformal::RemeshLattice>(this->Lattice);
  remesh.Frequency = this->Frequency;
  remesh.NumberOfPoints = this->NumberOfPoints;
  conformal::SphericalMorphOptions options;
  options.Path = static_cast<conformal::MorphPath>(this->Path);
  return glue::RunCore(this,
    [&]()
    {
      using namespace glue;
      Surfaces surfaces;
      AddSurfaces(inputVector[0], surfaces);
      AddSurfaces(inputVector[1], surfaces);
      const std::vector<vtkPolyData*> held = surfaces.pointers();
      const auto isEmpty = [](vtkPolyData* surface) { return surface->GetNumberOfPoints() == 0; };
      if (held.empty() || std::any_of(held.begin(), held.end(), isEmpty))
      {
        WarnOfEmptyInput(this, "a surface is empty; the output is empty");
        return;
      }
      if (held.size() < 2)
      {
        throw std::invalid_argument("two surfaces or more are needed: set the target of the morph, "
                                    "or give composite data of several surfaces");
      }
      const std::vector<double> shares = SharesOf(weights, factor, held.size());
      const bool isKept = this->Kept && this->Kept->isOf(surfaces.Times, remesh);
      const double size = surfaces.numberOfPoints();
      const auto count = static_cast<double>(held.size());
      const auto points = remesh.Lattice == conformal::RemeshLattice::Adaptive
        ? static_cast<double>(remesh.NumberOfPoints)
        : 10.0 * remesh.Frequency * remesh.Frequency;
      // The surfaces, the mesh that they have in common, the shape, the arrays and the output.
      conformal::Steps steps(RunOf(this),
        { isKept ? 0.0 : 150.0 * size,
          isKept ? 0.0 : conformal::workOfConsistentRemesh(size, count, remesh),
          conformal::workOfMorph(points, count, options.Path), 100.0 * count * points,
          NumberOfCarriedComponents(held.front()) * (20.0 * size + 100.0 * points),
          100.0 * points });
      const conformal::Run reading = steps.next();
      std::shared_ptr<const Common> common = this->Kept;
      if (!isKept)
      {
        auto made = std::make_shared<Common>();
        made->Times = surfaces.Times;
        made->Options = remesh;
        const std::vector<conformal::MappedMesh> meshes =
          ToMappedMeshes(surfaces, made->Frame, reading);
        made->Meshes = conformal::remeshConsistently(meshes, remesh, steps.next());
        common = std::move(made);
      }
      else
      {
        steps.next();
      }
      const conformal::ConsistentMeshes& meshes = common->Meshes;
      const conformal::Points shape =
        conformal::morphShapes(meshes.Sphere, meshes.Positions, shares, options, steps.next());
      steps.next();
      std::vector<const conformal::ResampleWeights*> parts;
      std::vector<conformal::Index> sizes;
      for (std::size_t s = 0; s < held.size(); ++s)
      {
        parts.push_back(&meshes.Weights[s]);
        sizes.push_back(held[s]->GetNumberOfPoints());
      }
      const conformal::ResampleWeights blend = conformal::blended(parts, sizes, shares);
      const vtkNew<vtkPolyData> result;
      SetSurface(result, shape, meshes.Sphere.Triangles, common->Frame);
      vtkPointData* data = result->GetPointData();
      CarryPointArrays(this, held, blend, data, steps.next());
      steps.next();
      if (vtkDataArray* scalars = held.front()->GetPointData()->GetScalars())
      {
        data->SetActiveScalars(scalars->GetName());
      }
      AddVectors(data, SpherePositionName(), meshes.Sphere.Positions);
      AddNumbers(result->GetFieldData(), "MorphWeights", shares);
      output->ShallowCopy(result);
      if (isTimed)
      {
        output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), factor);
      }
      this->Kept = common;
    });
}

//------------------------------------------------------------------------------
void vtkSphericalMorph::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const paths[] = { "Linear", "Rigid" };
  static const char* const lattices[] = { "Geodesic", "Adaptive" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MorphFactor: " << this->MorphFactor << "\n";
  os << indent << "NumberOfWeights: " << this->Weights.size() << "\n";
  os << indent << "Path: " << paths[this->Path] << "\n";
  os << indent << "Lattice: " << lattices[this->Lattice] << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n";
  os << indent << "GenerateTimeSteps: " << (this->GenerateTimeSteps ? "on" : "off") << "\n";
  os << indent << "NumberOfTimeSteps: " << this->NumberOfTimeSteps << "\n";
}
