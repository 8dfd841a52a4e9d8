#include "vtkSphericalTemplate.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/MappedSurfaces.h"
#include "Glue/Points.h"
#include "Glue/RegisteredSurfaces.h"
#include "Glue/Run.h"
#include "Register/SphericalTemplate.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkSphericalTemplate);

namespace
{
// Return the vertices sorted by landmark number. All surfaces must have the numbers of the first
// surface.
std::vector<int> Ordered(
  const std::map<double, int>& landmarks, const std::map<double, int>& ofFirst)
{
  std::vector<int> vertices;
  for (const auto& [number, vertex] : landmarks)
  {
    if (ofFirst.count(number) == 0)
    {
      throw std::invalid_argument("it has the landmark " + vtkVariant(number).ToString() +
        ", but the first surface does not");
    }
    vertices.push_back(vertex);
  }
  for (const auto& [number, vertex] : ofFirst)
  {
    if (landmarks.count(number) == 0)
    {
      throw std::invalid_argument(
        "it has no landmark " + vtkVariant(number).ToString() + ", but the first surface does");
    }
  }
  return vertices;
}

// Surfaces to register, which are those that are not empty.
struct UsedSurfaces
{
  glue::Surfaces All;
  std::vector<std::size_t> Numbers; // index in All of each surface that is not empty
  conformal::CoordinateFrame Frame;
};

UsedSurfaces UsedSurfacesOf(vtkInformationVector* inputs)
{
  UsedSurfaces used;
  glue::AddSurfaces(inputs, used.All);
  std::vector<vtkPointSet*> sets;
  for (std::size_t s = 0; s < used.All.Held.size(); ++s)
  {
    if (used.All.Held[s]->GetNumberOfPoints() > 0)
    {
      used.Numbers.push_back(s);
      sets.push_back(used.All.Held[s]);
    }
  }
  used.Frame = glue::FrameOf(sets);
  return used;
}

// Surfaces as read from the input, and the same surfaces as input of the registration.
struct ReadSurfaces
{
  std::vector<glue::SurfaceToRegister> Registered;
  std::vector<conformal::TemplateInput> Core;
};

ReadSurfaces ReadInputs(vtkObject* self, const UsedSurfaces& surfaces,
  const glue::FeatureList& features, const std::string& landmarkArrayName, conformal::Steps& steps)
{
  ReadSurfaces inputs;
  std::map<double, int> ofFirst;
  for (const std::size_t s : surfaces.Numbers)
  {
    vtkPolyData* surface = surfaces.All.Held[s];
    conformal::TemplateInput input;
    input.Name = "surface " + std::to_string(s);
    if (!surfaces.All.Names[s].empty())
    {
      input.Name += " (\"" + surfaces.All.Names[s] + "\")";
    }
    try
    {
      inputs.Registered.push_back(
        glue::ToSurfaceToRegister(self, surface, features, surfaces.Frame, steps.next()));
      if (!landmarkArrayName.empty())
      {
        const std::map<double, int> landmarks =
          glue::LandmarksOf(surface, inputs.Registered.back(), landmarkArrayName);
        ofFirst = inputs.Core.empty() ? landmarks : ofFirst;
        input.Landmarks = Ordered(landmarks, ofFirst);
      }
    }
    catch (const std::invalid_argument& error)
    {
      throw std::invalid_argument(input.Name + ": " + error.what());
    }
    input.Surface = inputs.Registered.back().Core;
    inputs.Core.push_back(std::move(input));
  }
  return inputs;
}

// Return all surfaces as blocks. Surfaces that were registered have their new maps.
vtkNew<vtkMultiBlockDataSet> BlocksOf(const UsedSurfaces& surfaces, const ReadSurfaces& inputs,
  const conformal::SphericalTemplateResult& result)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (std::size_t s = 0, k = 0; s < surfaces.All.Held.size(); ++s)
  {
    const vtkNew<vtkPolyData> block;
    block->ShallowCopy(surfaces.All.Held[s]);
    if (k < surfaces.Numbers.size() && surfaces.Numbers[k] == s)
    {
      const conformal::SphericalRegistrationResult& registration = result.Registrations[k];
      glue::SetRegistration(
        block, glue::PlacesOfAll(inputs.Registered[k], registration.SpherePositions), registration);
      ++k;
    }
    glue::SetNamedBlock(blocks, surfaces.All, s, block);
  }
  return blocks;
}

vtkNew<vtkPolyData> MeanOf(
  const UsedSurfaces& surfaces, const conformal::SphericalTemplateResult& result)
{
  vtkNew<vtkPolyData> mean;
  glue::SetSurface(mean, result.Mean.Positions, result.Mean.Triangles, surfaces.Frame);
  glue::AddVectors(mean->GetPointData(), glue::SpherePositionName(), result.Mean.SpherePositions);
  if (!result.Changes.empty())
  {
    glue::AddNumbers(mean->GetFieldData(), "TemplateChange", result.Changes);
  }
  glue::AddNumber(mean->GetFieldData(), "TemplateStart",
    static_cast<long long>(surfaces.Numbers[static_cast<std::size_t>(result.Start)]));
  return mean;
}

void Warn(vtkObject* self, const UsedSurfaces& surfaces, const ReadSurfaces& inputs,
  const conformal::SphericalTemplateResult& result)
{
  const std::size_t all = surfaces.All.Held.size(), empty = all - surfaces.Numbers.size();
  if (empty > 0)
  {
    vtkWarningWithObjectMacro(
      self, << empty << " of " << all << " surfaces are empty; their blocks stay empty");
  }
  conformal::Index unmet = 0;
  std::string ambiguous;
  for (std::size_t s = 0; s < result.Registrations.size(); ++s)
  {
    unmet += result.Registrations[s].NumberOfUnmetLandmarks;
    if (result.Registrations[s].IsAmbiguous)
    {
      ambiguous += (ambiguous.empty() ? "" : ", ") + inputs.Core[s].Name;
    }
  }
  if (!ambiguous.empty())
  {
    vtkWarningWithObjectMacro(
      self, << "two correspondences with the mean are about equally good, such as head and tail of "
               "similar shape, for "
            << ambiguous << "; inspect the surfaces, or add landmarks");
  }
  if (unmet > 0)
  {
    vtkWarningWithObjectMacro(self, << unmet << " of "
                                    << inputs.Core.size() * inputs.Core.front().Landmarks.size()
                                    << " landmarks cannot be matched without folds of a map. Check "
                                       "that equal numbers are at corresponding points");
  }
}
}

//------------------------------------------------------------------------------
vtkSphericalTemplate::vtkSphericalTemplate()
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
void vtkSphericalTemplate::AddFeature(const char* name, double weight)
{
  this->Features.emplace_back(name ? name : "", weight);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkSphericalTemplate::RemoveAllFeatures()
{
  if (!this->Features.empty())
  {
    this->Features.clear();
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkSphericalTemplate::GetMeanSurface()
{
  return vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
}

//------------------------------------------------------------------------------
int vtkSphericalTemplate::FillInputPortInformation(int, vtkInformation* info)
{
  glue::AcceptSurfaces(info);
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTemplate::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkMultiBlockDataSet" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkSphericalTemplate::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkMultiBlockDataSet* output = vtkMultiBlockDataSet::GetData(outputVector, 0);
  vtkPolyData* meanOutput = vtkPolyData::GetData(outputVector, 1);
  const auto features = this->Features;
  const std::string landmarkArrayName = this->LandmarkArrayName;
  conformal::SphericalTemplateOptions options;
  options.Registration.ShapeWeight = this->ShapeWeight;
  options.Registration.StretchWeight = this->StretchWeight;
  options.Registration.Frequency = this->Frequency;
  options.Alignment = static_cast<conformal::ShapeAlignment>(this->Alignment);
  options.MeanFrequency = this->MeanFrequency;
  options.MaximumNumberOfRounds = this->MaximumNumberOfRounds;
  options.Tolerance = this->Tolerance;
  return glue::RunCore(this,
    [&]()
    {
      const UsedSurfaces surfaces = UsedSurfacesOf(inputVector[0]);
      if (surfaces.Numbers.empty())
      {
        glue::WarnOfEmptyInput(this, "all surfaces are empty; the output is empty");
        return;
      }
      const std::vector<double> weights = glue::WeightsOf(features);
      std::vector<double> shares(
        surfaces.Numbers.size(), 0.02 / static_cast<double>(surfaces.Numbers.size()));
      shares.push_back(0.98);
      // Relative costs of reading each surface and template.
      conformal::Steps steps(glue::RunOf(this), shares);
      const ReadSurfaces inputs = ReadInputs(this, surfaces, features, landmarkArrayName, steps);
      const conformal::SphericalTemplateResult result =
        conformal::findSphericalTemplate(inputs.Core, weights, options, steps.next());
      const auto blocks = BlocksOf(surfaces, inputs, result);
      const auto mean = MeanOf(surfaces, result);
      Warn(this, surfaces, inputs, result);
      output->ShallowCopy(blocks);
      meanOutput->ShallowCopy(mean);
    });
}

//------------------------------------------------------------------------------
void vtkSphericalTemplate::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const alignments[] = { "None", "Rigid", "Similarity" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumNumberOfRounds: " << this->MaximumNumberOfRounds << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "Alignment: " << alignments[this->Alignment] << "\n";
  os << indent << "MeanFrequency: " << this->MeanFrequency << "\n";
  os << indent << "ShapeWeight: " << this->ShapeWeight << "\n";
  os << indent << "StretchWeight: " << this->StretchWeight << "\n";
  os << indent << "Frequency: " << this->Frequency << "\n";
  os << indent << "LandmarkArrayName: " << this->LandmarkArrayName << "\n";
  os << indent << "NumberOfFeatures: " << this->Features.size() << "\n";
}
