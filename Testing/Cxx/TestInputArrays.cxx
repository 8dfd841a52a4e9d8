// Inconsistent inputs: every filter and writer refuses them on every port, names what is wrong, and
// leaves nothing.
#include "../Cases/Case.h"
#include "../TemporaryFolder.h"
#include "FilterContract.h"

#include "vtkConformalDistortion.h"
#include "vtkSurfaceFileWriter.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <functional>
#include <set>

namespace
{
using cases::Case;
using cases::Input;
using cases::Mode;

// What is inconsistent is not read, and nothing is left.
void ExpectEmptyOutputs(vtkAlgorithm* filter)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    for (const int type : { vtkDataObject::POINT, vtkDataObject::CELL, vtkDataObject::ROW })
    {
      EXPECT_EQ(filter->GetOutputDataObject(port)->GetNumberOfElements(type), 0);
    }
  }
}

// The text of the error, and nothing is left.
std::string RefusalOf(vtkAlgorithm* filter)
{
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_TRUE(observed.Error());
  ExpectEmptyOutputs(filter);
  return observed.ErrorMessage();
}

void ExpectRuns(vtkAlgorithm* filter)
{
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
  EXPECT_GT(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
}

void ExpectNames(const std::string& message, int port, const std::string& text)
{
  EXPECT_NE(message.find("input port " + std::to_string(port) + ": " + text), std::string::npos)
    << message;
}

// Ports that do not take tables, whose columns are no arrays of points or cells.
std::set<int> DataSetPorts(vtkAlgorithm* filter)
{
  std::set<int> ports;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    const std::string type =
      filter->GetInputPortInformation(port)->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), 0);
    if (type != "vtkTable")
    {
      ports.insert(port);
    }
  }
  return ports;
}

// Ports on which inputs are tried, but for those that other modes read in the same way.
std::vector<int> TriedPorts(const Mode& mode)
{
  std::vector<int> ports;
  for (int port = 0; port < static_cast<int>(mode.Ports.size()); ++port)
  {
    if (mode.Ports[port].IsTried && !mode.Ports[port].IsVariant)
    {
      ports.push_back(port);
    }
  }
  return ports;
}

using Visit = std::function<void(const Case&, const Mode&, int port)>;

// Every port on which inputs are tried, of all filters or of all writers.
void ForEveryPort(bool isOfWriters, const Visit& visit)
{
  for (const Case& of : cases::All())
  {
    for (const Mode& mode : of.Modes)
    {
      for (const int port :
        of.isWriter() == isOfWriters && !of.IsProbe ? TriedPorts(mode) : std::vector<int>())
      {
        SCOPED_TRACE(of.name(mode, port) + ", port " + std::to_string(port));
        visit(of, mode, port);
      }
    }
  }
}

// What is tried on a port; the first of them is valid.
std::vector<Input> InputsOf(const cases::Port& port)
{
  return port.Takes == cases::Data::Picture ? cases::Pictures() : cases::Surfaces();
}

// Inputs that classes must refuse, with what they must report.
std::vector<Input> RefusedInputs(const cases::Port& port, unsigned int fault)
{
  std::vector<Input> refused;
  for (const Input& input : InputsOf(port))
  {
    if ((input.Faults & fault) != 0 && !input.Message.empty())
    {
      refused.push_back(input);
    }
  }
  return refused;
}

// The writer's attempt fails with this error, and there is no file.
void ExpectWritesNothing(vtkAlgorithm* algorithm, const std::string& ending,
  const TemporaryFolder& folder, const std::string& text)
{
  auto* writer = vtkSurfaceFileWriter::SafeDownCast(algorithm);
  writer->SetFileName(folder.file("a" + ending).c_str());
  contract::Observed observed(writer);
  EXPECT_EQ(writer->Write(), 0);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
  observed.ExpectError(text);
  EXPECT_EQ(folder.numberOfFiles(), 0u);
}

vtkSmartPointer<vtkDataSet> WithWrongGhosts()
{
  for (const Input& input : cases::Arrays())
  {
    if (input.Name == "ghosts of another type")
    {
      return vtkDataSet::SafeDownCast(input.Make());
    }
  }
  return nullptr;
}
}

TEST(InputArrays, EveryModeRunsOnWhatFits)
{
  for (const Case& of : cases::All())
  {
    std::set<int> tried;
    for (const Mode& mode : of.isWriter() ? std::vector<Mode>() : of.Modes)
    {
      SCOPED_TRACE(of.name(mode));
      ExpectRuns(of.make(mode));
      for (int port = 0; port < static_cast<int>(mode.Ports.size()); ++port)
      {
        if (mode.Ports[port].IsTried)
        {
          tried.insert(port);
        }
      }
    }
    EXPECT_TRUE(of.isWriter() || of.HasOwnInputs || tried == DataSetPorts(of.Make())) << of.Class;
  }
}

TEST(InputArrays, EveryFilterRefusesWhatIsInconsistentOnEveryPort)
{
  int runs = 0;
  ForEveryPort(false,
    [&](const Case& of, const Mode& mode, int port)
    {
      for (const Input& input : RefusedInputs(mode.Ports[port], cases::Inconsistent))
      {
        SCOPED_TRACE(input.Name);
        ExpectNames(RefusalOf(of.make(mode, port, input.Make())), port, input.Message);
        ++runs;
      }
    });
  EXPECT_GT(runs, 2000);
}

// An input without points is no error, but arrays that claim some are.
TEST(InputArrays, EveryFilterRefusesArraysWithoutPoints)
{
  ForEveryPort(false,
    [](const Case& of, const Mode& mode, int port)
    {
      const vtkSmartPointer<vtkDataObject> whole = InputsOf(mode.Ports[port]).front().Make();
      auto* broken = vtkDataSet::SafeDownCast(whole);
      vtkNew<vtkPointData> arrays;
      arrays->ShallowCopy(broken->GetPointData());
      broken->Initialize();
      broken->GetPointData()->ShallowCopy(arrays);
      ExpectNames(RefusalOf(of.make(mode, port, broken)), port, "the point array \"");
    });
}

// Nothing was lost: what was wrong can be corrected, and the filter runs.
TEST(InputArrays, EveryFilterRunsAfterTheInputIsMended)
{
  ForEveryPort(false,
    [](const Case& of, const Mode& mode, int port)
    {
      if (port > 0 || mode.Ports[port].Takes == cases::Data::Picture)
      {
        return;
      }
      const vtkSmartPointer<vtkDataSet> data = WithWrongGhosts();
      const vtkSmartPointer<vtkAlgorithm> filter = of.make(mode, 0, data);
      RefusalOf(filter);
      data->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      data->Modified();
      ExpectRuns(filter);
    });
}

// Filters of points take the points of a mesh whatever its cells name.
TEST(InputArrays, EveryFilterOfCellsRefusesIdsThatNoPointHas)
{
  ForEveryPort(false,
    [](const Case& of, const Mode& mode, int port)
    {
      for (const Input& input : RefusedInputs(mode.Ports[port], cases::BadIds))
      {
        SCOPED_TRACE(input.Name);
        const vtkSmartPointer<vtkAlgorithm> filter = of.make(mode, port, input.Make());
        if ((mode.Ports[port].Reads & cases::BadIds) != 0)
        {
          EXPECT_NE(RefusalOf(filter).find(input.Message), std::string::npos);
        }
        else
        {
          ExpectRuns(filter);
        }
      }
    });
}

// Blocks are looked at one by one, as the filter gets them.
TEST(InputArrays, BlocksAreChecked)
{
  const auto broken = cases::Ellipsoid();
  broken->GetPointData()->GetArray("SpherePosition")->SetNumberOfTuples(161);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, cases::Ellipsoid());
  blocks->SetBlock(1, broken);
  vtkNew<vtkConformalDistortion> filter;
  filter->SetInputDataObject(blocks);
  contract::Observed observed(filter);
  filter->Update();
  observed.ExpectError("\"SpherePosition\" has 161 tuples for 162 points");
}

TEST(InputArrays, EveryWriterRefusesWhatIsInconsistentAndWritesNothing)
{
  const TemporaryFolder folder;
  int runs = 0;
  ForEveryPort(true,
    [&](const Case& of, const Mode& mode, int port)
    {
      for (const Input& input : RefusedInputs(mode.Ports[port], cases::Inconsistent))
      {
        SCOPED_TRACE(input.Name);
        ExpectWritesNothing(of.make(mode, port, input.Make()), mode.File.Ending, folder,
          "input port " + std::to_string(port) + ": " + input.Message);
        ++runs;
      }
    });
  EXPECT_GT(runs, 600);
}

TEST(InputArrays, EveryWriterRefusesBrokenCellsAndWritesNothing)
{
  const TemporaryFolder folder;
  ForEveryPort(true,
    [&](const Case& of, const Mode& mode, int port)
    {
      for (const Input& input : RefusedInputs(mode.Ports[port], cases::BadIds))
      {
        SCOPED_TRACE(input.Name);
        const vtkSmartPointer<vtkDataObject> broken = input.Make();
        ExpectWritesNothing(of.make(mode, port, broken), mode.File.Ending, folder, input.Message);
        // Strips, which are cut up first.
        auto* strips = vtkPolyData::SafeDownCast(broken);
        strips->SetStrips(strips->GetPolys());
        strips->SetPolys(nullptr);
        ExpectWritesNothing(of.make(mode, port, strips), mode.File.Ending, folder, input.Message);
      }
    });
}

TEST(InputArrays, EveryWriterWritesWhatFits)
{
  const TemporaryFolder folder;
  for (const Case& of : cases::All())
  {
    for (const Mode& mode : of.isWriter() ? of.Modes : std::vector<Mode>())
    {
      SCOPED_TRACE(of.name(mode));
      const vtkSmartPointer<vtkAlgorithm> made = of.make(mode);
      auto* writer = vtkSurfaceFileWriter::SafeDownCast(made);
      writer->SetFileName(folder.file("a" + mode.File.Ending).c_str());
      EXPECT_EQ(writer->Write(), 1);
    }
  }
}

// Information is asked for before the inputs are up to date, and does not look at them.
TEST(InputArrays, InformationDoesNotLookAtThem)
{
  ForEveryPort(false,
    [](const Case& of, const Mode& mode, int port)
    {
      const vtkSmartPointer<vtkAlgorithm> filter =
        of.make(mode, port, RefusedInputs(mode.Ports[port], cases::Inconsistent).front().Make());
      contract::Observed observed(filter);
      filter->UpdateInformation();
      EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
    });
}
