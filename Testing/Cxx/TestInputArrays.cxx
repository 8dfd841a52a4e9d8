// Arrays whose length is not that of the points or cells: every filter and writer refuses them on
// every port, says which, and leaves nothing.
#include "../TemporaryFolder.h"
#include "FilterContract.h"
#include "InputCases.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"

#include <algorithm>

namespace
{
// What may be broken is read, and nothing is left.
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

void ExpectNames(const std::string& message, int port, const std::string& text)
{
  EXPECT_NE(message.find("input port " + std::to_string(port) + ": " + text), std::string::npos)
    << message;
}

// Ports that do not take tables, whose columns are no arrays of points or cells.
int NumberOfDataSetPorts(vtkAlgorithm* filter)
{
  int count = 0;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    const std::string type =
      filter->GetInputPortInformation(port)->Get(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), 0);
    count += type != "vtkTable" ? 1 : 0;
  }
  return count;
}

vtkSmartPointer<vtkPolyData> BrokenCells(const std::vector<vtkIdType>& offsets, vtkIdType id)
{
  const auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->ShallowCopy(inputs::Surface());
  surface->GetCellData()->Initialize();
  vtkNew<vtkIdTypeArray> places, ids;
  for (const vtkIdType offset : offsets)
  {
    places->InsertNextValue(offset);
  }
  for (const vtkIdType corner : { vtkIdType(0), vtkIdType(1), id })
  {
    ids->InsertNextValue(corner);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(places, ids);
  surface->SetPolys(polygons);
  return surface;
}
}

TEST(InputArrays, EveryFilterTakesThemWhereTheyFit)
{
  for (const inputs::Case& test : inputs::Filters())
  {
    SCOPED_TRACE(test.Name);
    const vtkSmartPointer<vtkAlgorithm> filter = test.With(-1, nullptr);
    ASSERT_EQ(NumberOfDataSetPorts(filter), static_cast<int>(test.Ports.size()));
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
    EXPECT_GT(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }
}

TEST(InputArrays, EveryFilterRefusesOtherLengthsOnEveryPort)
{
  int runs = 0;
  for (const inputs::Case& test : inputs::Filters())
  {
    for (int port = 0; port < static_cast<int>(test.Ports.size()); ++port)
    {
      for (const inputs::Fault& fault : inputs::ArrayFaults(test.Ports[port]()))
      {
        SCOPED_TRACE(test.Name + ", port " + std::to_string(port) + ", " + fault.Name);
        const vtkSmartPointer<vtkDataSet> broken = test.Ports[port]();
        fault.Make(broken);
        ExpectNames(RefusalOf(test.With(port, broken)), port, fault.Message);
        ++runs;
      }
    }
  }
  EXPECT_GT(runs, 500);
}

// An input without points is no error, but arrays that say otherwise are.
TEST(InputArrays, EveryFilterRefusesArraysWithoutPoints)
{
  for (const inputs::Case& test : inputs::Filters())
  {
    for (int port = 0; port < static_cast<int>(test.Ports.size()); ++port)
    {
      SCOPED_TRACE(test.Name + ", port " + std::to_string(port));
      const vtkSmartPointer<vtkDataSet> broken = test.Ports[port]();
      vtkNew<vtkPointData> arrays;
      arrays->ShallowCopy(broken->GetPointData());
      broken->Initialize();
      broken->GetPointData()->ShallowCopy(arrays);
      ExpectNames(RefusalOf(test.With(port, broken)), port, "the point array \"");
    }
  }
}

// Nothing was lost: what was wrong can be put right, and the filter runs.
TEST(InputArrays, EveryFilterRunsAfterTheInputIsMended)
{
  for (const inputs::Case& test : inputs::Filters())
  {
    SCOPED_TRACE(test.Name);
    const vtkSmartPointer<vtkDataSet> data = test.Ports[0]();
    const inputs::Fault fault = inputs::ArrayFaults(data).back();
    fault.Make(data);
    const vtkSmartPointer<vtkAlgorithm> filter = test.With(0, data);
    RefusalOf(filter);
    data->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    data->Modified();
    contract::Observed observed(filter);
    filter->Update();
    EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
    EXPECT_GT(filter->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::POINT), 0);
  }
}

TEST(InputArrays, EveryFilterRefusesCellsThatReadPastTheirIds)
{
  for (const inputs::Case& test : inputs::Filters())
  {
    for (int port = 0; port < static_cast<int>(test.Ports.size()); ++port)
    {
      if (!vtkPolyData::SafeDownCast(test.Ports[port]()))
      {
        continue;
      }
      SCOPED_TRACE(test.Name + ", port " + std::to_string(port));
      for (const std::vector<vtkIdType>& offsets :
        { std::vector<vtkIdType>{ 0, 1000000 }, { 0, 3, 1 }, { -1000000, 3 }, {} })
      {
        const auto broken = BrokenCells(offsets, 2);
        ExpectNames(RefusalOf(test.With(port, broken)), port, "the offsets of the polygons");
      }
    }
  }
}

// Filters of points take the points of a mesh whatever its cells name.
TEST(InputArrays, EveryFilterOfCellsRefusesIdsThatNoPointHas)
{
  const auto readsCells = [](const std::string& name, int port)
  {
    return name != "vtkGenusZeroHull" && !(name == "vtkConformalSOM" && port == 0) &&
      !(name == "vtkCurvedSeamlessSurface" && port == 2) &&
      !(name == "vtkSphericalAlignment, landmarks" && port == 1);
  };
  for (const inputs::Case& test : inputs::Filters())
  {
    for (int port = 0; port < static_cast<int>(test.Ports.size()); ++port)
    {
      if (!vtkPolyData::SafeDownCast(test.Ports[port]()))
      {
        continue;
      }
      for (const vtkIdType id : { vtkIdType(-1), vtkIdType(162), vtkIdType(1) << 40 })
      {
        SCOPED_TRACE(test.Name + ", port " + std::to_string(port) + ", id " + std::to_string(id));
        const vtkSmartPointer<vtkAlgorithm> filter = test.With(port, BrokenCells({ 0, 3 }, id));
        if (readsCells(test.Name, port))
        {
          EXPECT_NE(
            RefusalOf(filter).find("cell 0 refers to point " + std::to_string(id) + " of 162"),
            std::string::npos);
        }
        else
        {
          contract::Observed observed(filter);
          filter->Update();
          EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
        }
      }
    }
  }
}

// Blocks are looked at one by one, as the filter gets them.
TEST(InputArrays, BlocksAreChecked)
{
  const vtkSmartPointer<vtkDataSet> broken = inputs::Surface();
  broken->GetPointData()->GetArray("SpherePosition")->SetNumberOfTuples(161);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, inputs::Surface());
  blocks->SetBlock(1, broken);
  vtkNew<vtkConformalDistortion> filter;
  filter->SetInputDataObject(blocks);
  contract::Observed observed(filter);
  filter->Update();
  observed.ExpectError("\"SpherePosition\" has 161 tuples for 162 points");
}

TEST(InputArrays, EveryWriterRefusesOtherLengthsOnEveryPortAndWritesNothing)
{
  const TemporaryFolder folder;
  int runs = 0;
  for (const inputs::Case& test : inputs::Writers())
  {
    for (int port = 0; port < static_cast<int>(test.Ports.size()); ++port)
    {
      for (const inputs::Fault& fault : inputs::ArrayFaults(test.Ports[port]()))
      {
        SCOPED_TRACE(test.Name + ", port " + std::to_string(port) + ", " + fault.Name);
        const vtkSmartPointer<vtkDataSet> broken = test.Ports[port]();
        fault.Make(broken);
        const vtkSmartPointer<vtkAlgorithm> algorithm = test.With(port, broken);
        auto* writer = vtkSurfaceFileWriter::SafeDownCast(algorithm);
        writer->SetFileName(folder.file("a.glb").c_str());
        contract::Observed observed(writer);
        EXPECT_EQ(writer->Write(), 0);
        EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
        ExpectNames(observed.ErrorMessage(), port, fault.Message);
        EXPECT_EQ(folder.numberOfFiles(), 0u);
        ++runs;
      }
    }
  }
  EXPECT_GT(runs, 150);
}

TEST(InputArrays, EveryWriterRefusesBrokenCellsAndWritesNothing)
{
  const TemporaryFolder folder;
  for (const inputs::Case& test : inputs::Writers())
  {
    SCOPED_TRACE(test.Name);
    const auto refuse = [&](vtkPolyData* broken, const std::string& text)
    {
      const vtkSmartPointer<vtkAlgorithm> algorithm = test.With(0, broken);
      auto* writer = vtkSurfaceFileWriter::SafeDownCast(algorithm);
      writer->SetFileName(folder.file("a.glb").c_str());
      contract::Observed observed(writer);
      EXPECT_EQ(writer->Write(), 0);
      EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::UserError));
      observed.ExpectError(text);
      EXPECT_EQ(folder.numberOfFiles(), 0u);
    };
    refuse(BrokenCells({ 0, 1000000 }, 2), "the offsets of the polygons");
    refuse(BrokenCells({ 0, 3 }, 1000000), "cell 0 refers to point 1000000 of 162");
    // Strips, which are cut up first.
    const auto strips = BrokenCells({ 0, 3 }, 1000000);
    strips->SetStrips(strips->GetPolys());
    strips->SetPolys(nullptr);
    refuse(strips, "cell 0 refers to point 1000000 of 162");
  }
}

TEST(InputArrays, EveryWriterWritesThemWhereTheyFit)
{
  const TemporaryFolder folder;
  for (const inputs::Case& test : inputs::Writers())
  {
    SCOPED_TRACE(test.Name);
    const vtkSmartPointer<vtkAlgorithm> algorithm = test.With(-1, nullptr);
    auto* writer = vtkSurfaceFileWriter::SafeDownCast(algorithm);
    writer->SetFileName(folder.file("a.glb").c_str());
    EXPECT_EQ(writer->Write(), 1);
  }
}

// Information is asked for before the inputs are up to date, and does not look at them.
TEST(InputArrays, InformationDoesNotLookAtThem)
{
  for (const inputs::Case& test : inputs::Filters())
  {
    SCOPED_TRACE(test.Name);
    const vtkSmartPointer<vtkDataSet> broken = test.Ports[0]();
    inputs::ArrayFaults(broken).front().Make(broken);
    const vtkSmartPointer<vtkAlgorithm> filter = test.With(0, broken);
    contract::Observed observed(filter);
    filter->UpdateInformation();
    EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
  }
}
