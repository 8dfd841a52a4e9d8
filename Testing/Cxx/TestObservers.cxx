// A run is that of the inputs and properties it began with, whatever observers of its progress do:
// they may set every property to another value, empty the inputs and empty the outputs, and the
// result has the same bits.
#include "../Cases/Case.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{
using cases::Algorithm;
using cases::Case;
using cases::Mode;
using Bytes = std::map<std::string, std::string>;
using Disturbance = std::function<void(vtkAlgorithm*)>;

// Large enough for reports on the way.
constexpr int Frequency = 12;

void AddBytes(Bytes& bytes, const std::string& name, vtkDataArray* array)
{
  if (array)
  {
    const auto size = static_cast<std::size_t>(array->GetNumberOfValues()) *
      static_cast<std::size_t>(array->GetDataTypeSize());
    bytes[name] = size > 0 ? std::string(static_cast<const char*>(array->GetVoidPointer(0)), size)
                           : std::string();
  }
}

void AddData(Bytes& bytes, const std::string& name, vtkDataObject* data)
{
  for (int kind = 0; kind < vtkDataObject::NUMBER_OF_ATTRIBUTE_TYPES; ++kind)
  {
    vtkFieldData* fields = data->GetAttributesAsFieldData(kind);
    for (int i = 0; fields && i < fields->GetNumberOfArrays(); ++i)
    {
      const char* array = fields->GetAbstractArray(i)->GetName();
      AddBytes(
        bytes, name + "/" + std::to_string(kind) + "/" + (array ? array : ""), fields->GetArray(i));
    }
  }
  auto* points = vtkPointSet::SafeDownCast(data);
  if (points && points->GetPoints())
  {
    AddBytes(bytes, name + " points", points->GetPoints()->GetData());
  }
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    AddBytes(bytes, name + " polygons", surface->GetPolys()->GetConnectivityArray());
  }
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    bytes[name + " size"] =
      std::to_string(image->GetDimensions()[0]) + " " + std::to_string(image->GetDimensions()[1]);
  }
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(data);
  for (unsigned int i = 0; blocks && i < blocks->GetNumberOfBlocks(); ++i)
  {
    AddData(bytes, name + " block " + std::to_string(i), blocks->GetBlock(i));
  }
}

// All that the outputs hold, by name.
Bytes OutputsOf(vtkAlgorithm* filter)
{
  Bytes bytes;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    AddData(bytes, std::to_string(port), filter->GetOutputDataObject(port));
  }
  return bytes;
}

// Without the input's field data, which the executive passes to outputs before a run.
Bytes WithoutPassedFields(const Bytes& bytes)
{
  const auto input = cases::Ellipsoid();
  const std::string field = "/" + std::to_string(vtkDataObject::FIELD) + "/";
  Bytes own;
  for (const auto& [name, content] : bytes)
  {
    const std::size_t at = name.find(field);
    const bool isPassed = at != std::string::npos &&
      input->GetFieldData()->HasArray(name.substr(at + field.size()).c_str());
    if (!isPassed)
    {
      own[name] = content;
    }
  }
  return own;
}

std::string PrintOf(vtkAlgorithm* filter)
{
  std::ostringstream text;
  filter->Print(text);
  const std::string whole = text.str();
  const std::size_t time = whole.find("Modified Time");
  return whole.substr(0, time) + whole.substr(whole.find('\n', time));
}

// Set every property of every mode of the class to another value. Returns how many changed.
int ChangeProperties(const Case& of, vtkAlgorithm* filter)
{
  int changed = 0;
  for (const Mode& mode : of.Modes)
  {
    for (const cases::Property& property : mode.Properties)
    {
      const std::string before = PrintOf(filter);
      for (const auto& [text, set] : property.Values)
      {
        if (PrintOf(filter) == before)
        {
          set(filter);
        }
      }
      changed += PrintOf(filter) != before;
    }
  }
  return changed;
}

void EmptyInputs(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    if (filter->GetNumberOfInputConnections(port) > 0)
    {
      filter->GetInputDataObject(port, 0)->Initialize();
    }
  }
}

void EmptyOutputs(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    filter->GetOutputDataObject(port)->Initialize();
  }
}

// Disturbs a filter at its first report of such a progress. The first report of all and that of 1
// may be the executive's, before and after the run.
class Disturber
{
public:
  Disturber(vtkAlgorithm* filter, double at, Disturbance disturb)
    : At(at)
    , Disturb(std::move(disturb))
  {
    filter->AddObserver(vtkCommand::ProgressEvent, this, &Disturber::Hear);
  }
  bool isDone() const { return this->IsDone; }

private:
  void Hear(vtkObject* caller, unsigned long, void*)
  {
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    const double progress = filter->GetProgress();
    if (++this->Count > 1 && !this->IsDone && progress >= this->At && progress < 1.0)
    {
      this->IsDone = true;
      this->Disturb(filter);
    }
  }

  double At;
  Disturbance Disturb;
  int Count = 0;
  bool IsDone = false;
};

// Stops a filter at its last report.
class LateStopper
{
public:
  explicit LateStopper(vtkAlgorithm* filter)
  {
    filter->AddObserver(vtkCommand::ProgressEvent, this, &LateStopper::Hear);
  }

private:
  void Hear(vtkObject* caller, unsigned long, void*)
  {
    auto* filter = static_cast<vtkAlgorithm*>(caller);
    if (filter->GetProgress() == 1.0)
    {
      filter->SetAbortExecute(1);
    }
  }
};

Algorithm MakeLarge(const Case& of, const Mode& mode)
{
  return of.make(mode, -1, nullptr, 1.0, Frequency);
}

std::vector<const Case*> Filters()
{
  std::vector<const Case*> filters;
  for (const Case& of : cases::All())
  {
    if (!of.isWriter() && !of.IsProbe)
    {
      filters.push_back(&of);
    }
  }
  return filters;
}

class Observers : public testing::TestWithParam<const Case*>
{
};
}

TEST_P(Observers, PropertiesAreFound)
{
  const Case& of = *GetParam();
  int properties = 0;
  for (const Mode& mode : of.Modes)
  {
    properties += static_cast<int>(mode.Properties.size());
  }
  EXPECT_GE(2 * ChangeProperties(of, of.Make()), properties);
}

TEST_P(Observers, FiltersKeepWhatTheyBeganWith)
{
  const Case& of = *GetParam();
  for (const Mode& mode : of.Modes)
  {
    const Algorithm reference = MakeLarge(of, mode);
    reference->Update();
    const Bytes expected = WithoutPassedFields(OutputsOf(reference));
    ASSERT_FALSE(expected.empty());
    for (const double at : { 0.0, 0.4, 0.8 })
    {
      SCOPED_TRACE(of.name(mode) + " at " + std::to_string(at));
      const Algorithm filter = MakeLarge(of, mode);
      const Disturber disturber(filter, at,
        [&](vtkAlgorithm* disturbed)
        {
          ChangeProperties(of, disturbed);
          EmptyInputs(disturbed);
          EmptyOutputs(disturbed);
        });
      filter->Update();
      EXPECT_TRUE(disturber.isDone() || at > 0.0);
      const Bytes found = WithoutPassedFields(OutputsOf(filter));
      for (const auto& [name, bytes] : expected)
      {
        EXPECT_TRUE(found.count(name) > 0 && found.at(name) == bytes) << name;
      }
      EXPECT_EQ(found.size(), expected.size());
    }
  }
}

TEST_P(Observers, AWishToStopIsHeardWithTheReportOf1)
{
  const Case& of = *GetParam();
  for (const Mode& mode : of.Modes)
  {
    SCOPED_TRACE(of.name(mode));
    const Algorithm filter = MakeLarge(of, mode);
    const LateStopper stopper(filter);
    filter->Update();
    EXPECT_EQ(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(
  , Observers, testing::ValuesIn(Filters()), [](const auto& info) { return info.param->Class; });
