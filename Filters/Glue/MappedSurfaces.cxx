#include "Glue/MappedSurfaces.h"

#include "Glue/Meshes.h"
#include "Glue/Points.h"
#include "Glue/Run.h"

#include "vtkAlgorithm.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace glue
{
//------------------------------------------------------------------------------
void AcceptSurfaces(vtkInformation* portInformation)
{
  portInformation->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  // The composite type must be first. Otherwise, the executive would pass blocks one by one.
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
}

//------------------------------------------------------------------------------
std::vector<vtkPolyData*> Surfaces::pointers() const
{
  return { this->Held.begin(), this->Held.end() };
}

//------------------------------------------------------------------------------
double Surfaces::numberOfPoints() const
{
  double size = 0.0;
  for (const auto& surface : this->Held)
  {
    size += static_cast<double>(surface->GetNumberOfPoints());
  }
  return size;
}

//------------------------------------------------------------------------------
void AddSurfaces(vtkInformationVector* inputs, Surfaces& surfaces, MissingBlocks missing)
{
  const auto add = [&](vtkDataObject* data, const std::string& name)
  {
    auto* surface = vtkPolyData::SafeDownCast(data);
    if (!surface)
    {
      throw std::invalid_argument(
        "a block is a " + std::string(data->GetClassName()) + " instead of a vtkPolyData");
    }
    surfaces.Held.push_back(Held(surface));
    surfaces.Names.push_back(name);
    surfaces.Times.push_back(surface->GetMTime());
  };
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkDataObject* data = vtkDataObject::GetData(inputs, i);
    auto* blocks = vtkCompositeDataSet::SafeDownCast(data);
    if (!blocks)
    {
      add(data, "");
      continue;
    }
    const auto each = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    each->SetSkipEmptyNodes(missing == MissingBlocks::LeftOut);
    for (each->InitTraversal(); !each->IsDoneWithTraversal(); each->GoToNextItem())
    {
      const bool hasName =
        each->HasCurrentMetaData() && each->GetCurrentMetaData()->Has(vtkCompositeDataSet::NAME());
      const vtkNew<vtkPolyData> empty;
      vtkDataObject* block = each->GetCurrentDataObject();
      add(block ? block : empty.Get(),
        hasName ? each->GetCurrentMetaData()->Get(vtkCompositeDataSet::NAME()) : "");
    }
  }
}

//------------------------------------------------------------------------------
std::vector<conformal::MappedMesh> ToMappedMeshes(
  const Surfaces& surfaces, conformal::CoordinateFrame& frame, const conformal::Run& run)
{
  if (surfaces.numberOfPoints() > std::numeric_limits<int>::max())
  {
    throw std::length_error("the surfaces have more points together than fit into an int");
  }
  std::vector<vtkPointSet*> sets(surfaces.Held.begin(), surfaces.Held.end());
  frame = FrameOf(sets);
  std::vector<conformal::MappedMesh> meshes;
  for (vtkPolyData* surface : surfaces.pointers())
  {
    const std::string name = "surface " + std::to_string(meshes.size()) + ": ";
    try
    {
      meshes.push_back(CopyMapped(surface, frame));
      RequireFiniteTriangles(meshes.back());
    }
    catch (const std::invalid_argument& error)
    {
      throw std::invalid_argument(name + error.what());
    }
    run.report(static_cast<double>(meshes.size()) / static_cast<double>(sets.size()));
  }
  return meshes;
}

//------------------------------------------------------------------------------
std::vector<double> TimeStepsOf(vtkInformationVector* inputs)
{
  using Executive = vtkStreamingDemandDrivenPipeline;
  std::vector<double> times;
  if (inputs->GetNumberOfInformationObjects() == 1)
  {
    vtkInformation* info = inputs->GetInformationObject(0);
    if (info->Has(Executive::TIME_STEPS()) && info->Length(Executive::TIME_STEPS()) > 1)
    {
      const double* first = info->Get(Executive::TIME_STEPS());
      times.assign(first, first + info->Length(Executive::TIME_STEPS()));
    }
  }
  return times;
}

//------------------------------------------------------------------------------
std::vector<double> CountedTimes(std::size_t count, double interval)
{
  std::vector<double> times(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    times[i] = interval * static_cast<double>(i);
  }
  return times;
}

//------------------------------------------------------------------------------
void SetTimeSteps(vtkInformation* outputInformation, const std::vector<double>& times)
{
  using Executive = vtkStreamingDemandDrivenPipeline;
  const double range[2] = { times.front(), times.back() };
  outputInformation->Set(Executive::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  outputInformation->Set(Executive::TIME_RANGE(), range, 2);
}

//------------------------------------------------------------------------------
void SetNamedBlock(
  vtkMultiBlockDataSet* blocks, const Surfaces& surfaces, std::size_t number, vtkPolyData* block)
{
  const auto place = static_cast<unsigned int>(number);
  blocks->SetBlock(place, block);
  if (!surfaces.Names[number].empty())
  {
    blocks->GetMetaData(place)->Set(vtkCompositeDataSet::NAME(), surfaces.Names[number].c_str());
  }
}

//------------------------------------------------------------------------------
bool HasEmpty(vtkObject* self, const Surfaces& surfaces)
{
  const bool hasEmpty = surfaces.Held.empty() ||
    std::any_of(surfaces.Held.begin(), surfaces.Held.end(),
      [](vtkPolyData* surface) { return surface->GetNumberOfPoints() == 0; });
  if (hasEmpty)
  {
    WarnOfEmptyInput(self, "a surface is empty; the output is empty");
  }
  return hasEmpty;
}
}
