#include "vtkSphericalTemplate.h"

#include "Base/CoordinateFrame.h"
#include "Base/Steps.h"
#include "Glue/Arrays.h"
#include "Glue/MappedSurfaces.h"
#include "Glue/Points.h"
#include "Glue/RegisteredSurfaces.h"
#include "Glue/Run.h"
#include "Register/SphericalTemplate.h"

#include "vtkCompositeDataSet.h"
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
#include <vector>

vtkStandardNewMacro(vtkSphericalTemplate);

namespace
{
// The vertices that an array has numbers above 0 for.
std::map<double, int> LandmarksOf(
  vtkPolyData* surface, const glue::SurfaceToRegister& registered, const std::string& arrayName)
{
  vtkDataArray* array = surface->GetPointData()->GetArray(arrayName.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("there is no point array \"" + arrayName +
      "\" of 1 component; set LandmarkArrayName to the name of one, or to an empty one");
  }
  const std::vector<int> vertices = registered.vertices();
  std::map<double, int> landmarks;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double number = array->GetComponent(i, 0);
    if (!std::isfinite(number))
    {
      throw std::invalid_argument("the landmark array is not finite at point " + std::to_string(i));
    }
    if (number <= 0.0)
    {
      continue;
    }
    if (vertices[i] < 0)
    {
      throw std::invalid_argument("the landmark at point " + std::to_string(i) +
        " belongs to no triangle; a landmark must be a point of one");
    }
    if (!landmarks.emplace(number, vertices[i]).second)
    {
      throw std::invalid_argument("two points are the landmark " + vtkVariant(number).ToString() +
        ", the second of them point " + std::to_string(i));
    }
  }
  return landmarks;
}

// The vertices, in the order of the numbers that all surfaces must have.
std::vector<int> Ordered(
  const std::map<double, int>& landmarks, const std::map<double, int>& ofFirst)
{
  std::vector<int> vertices;
  for (const auto& [number, vertex] : landmarks)
  {
    if (ofFirst.count(number) == 0)
    {
      throw std::invalid_argument("the first surface has no landmark " +
        vtkVariant(number).ToString() + ", which this one has");
    }
    vertices.push_back(vertex);
  }
  for (const auto& [number, vertex] : ofFirst)
  {
    if (landmarks.count(number) == 0)
    {
      throw std::invalid_argument(
        "there is no landmark " + vtkVariant(number).ToString() + ", which the first surface has");
    }
  }
  return vertices;
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
      using namespace glue;
      Surfaces surfaces;
      AddSurfaces(inputVector[0], surfaces);
      std::vector<std::size_t> used; // those that are not empty
      std::vector<vtkPointSet*> sets;
      for (std::size_t s = 0; s < surfaces.Held.size(); ++s)
      {
        if (surfaces.Held[s]->GetNumberOfPoints() > 0)
        {
          used.push_back(s);
          sets.push_back(surfaces.Held[s]);
        }
      }
      if (used.empty())
      {
        WarnOfEmptyInput(this, "there is no surface that is not empty; the output is empty");
        return;
      }
      const std::vector<double> weights = WeightsOf(features);
      const double size = surfaces.numberOfPoints();
      const auto count = static_cast<double>(used.size());
      std::vector<double> work;
      work.reserve(used.size() + 1);
      for (const std::size_t s : used)
      {
        work.push_back(800.0 * static_cast<double>(surfaces.Held[s]->GetNumberOfPoints()));
      }
      work.push_back(conformal::workOfSphericalTemplate(size, count, options));
      conformal::Steps steps(RunOf(this), work);
      const conformal::CoordinateFrame frame = FrameOf(sets);
      std::vector<SurfaceToRegister> registered;
      std::vector<conformal::TemplateInput> inputs;
      std::map<double, int> ofFirst;
      for (const std::size_t s : used)
      {
        conformal::TemplateInput input;
        input.Name = "surface " + std::to_string(s);
        if (!surfaces.Names[s].empty())
        {
          input.Name += " (\"" + surfaces.Names[s] + "\")";
        }
        try
        {
          registered.push_back(
            ToSurfaceToRegister(this, surfaces.Held[s], features, frame, steps.next()));
          if (!landmarkArrayName.empty())
          {
            const std::map<double, int> landmarks =
              LandmarksOf(surfaces.Held[s], registered.back(), landmarkArrayName);
            ofFirst = s == used.front() ? landmarks : ofFirst;
            input.Landmarks = Ordered(landmarks, ofFirst);
          }
        }
        catch (const std::invalid_argument& error)
        {
          throw std::invalid_argument(input.Name + ": " + error.what());
        }
        input.Surface = registered.back().Core;
        inputs.push_back(std::move(input));
      }
      const conformal::SphericalTemplateResult result =
        conformal::findSphericalTemplate(inputs, weights, options, steps.next());

      const vtkNew<vtkMultiBlockDataSet> blocks;
      conformal::Index unmet = 0;
      for (std::size_t s = 0, k = 0; s < surfaces.Held.size(); ++s)
      {
        const auto number = static_cast<unsigned int>(s);
        const vtkNew<vtkPolyData> block;
        block->ShallowCopy(surfaces.Held[s]);
        if (k < used.size() && used[k] == s)
        {
          const conformal::SphericalRegistrationResult& registration = result.Registrations[k];
          SetRegistration(
            block, PlacesOfAll(registered[k], registration.SpherePositions), registration);
          unmet += registration.NumberOfUnmetLandmarks;
          ++k;
        }
        blocks->SetBlock(number, block);
        if (!surfaces.Names[s].empty())
        {
          blocks->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), surfaces.Names[s].c_str());
        }
      }
      const vtkNew<vtkPolyData> mean;
      SetSurface(mean, result.Mean.Positions, result.Mean.Triangles, frame);
      AddVectors(mean->GetPointData(), SpherePositionName(), result.Mean.SpherePositions);
      if (!result.Changes.empty())
      {
        AddNumbers(mean->GetFieldData(), "TemplateChange", result.Changes);
      }
      AddNumber(mean->GetFieldData(), "TemplateStart",
        static_cast<long long>(used[static_cast<std::size_t>(result.Start)]));
      if (used.size() < surfaces.Held.size())
      {
        vtkWarningMacro(<< surfaces.Held.size() - used.size() << " of " << surfaces.Held.size()
                        << " surfaces are empty; they stay so");
      }
      if (unmet > 0)
      {
        vtkWarningMacro(<< unmet << " of "
                        << result.Registrations.size() * inputs.front().Landmarks.size()
                        << " landmarks cannot be met without folding a map");
      }
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
