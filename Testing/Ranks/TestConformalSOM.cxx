#include "vtkConformalSOM.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

#include "vtkSMPTools.h"
#include "vtkTable.h"

#include <new>
#include <vector>

namespace
{
vtkSmartPointer<vtkConformalSOM> MakeFilter(vtkPolyData* cloud)
{
  auto filter = vtkSmartPointer<vtkConformalSOM>::New();
  filter->SetInputData(cloud);
  filter->SetNumberOfNeurons(642);
  filter->SetStartingShapeToSphere();
  filter->SetNumberOfEpochs(10);
  filter->SetSamplesPerEpoch(9000); // more than are drawn at a time
  return filter;
}

vtkTable* History(vtkConformalSOM* filter)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
}

using Change = std::function<void(vtkConformalSOM*)>;

// However the cloud is spread, and on any number of threads: what one process learns alone.
void ExpectSameAsAlone(vtkPolyData* cloud, const Change& change)
{
  auto alone = MakeFilter(cloud);
  change(alone);
  alone->SetController(nullptr);
  alone->Update();
  const vtkIdType size = cloud->GetNumberOfPoints();
  for (const int threads : { 1, 2 })
  {
    auto filter = MakeFilter(
      clouds::OwnPart(cloud, threads == 1 ? clouds::EvenCuts(size) : clouds::UnevenCuts(size)));
    change(filter);
    vtkSMPTools::LocalScope(
      vtkSMPTools::Config(threads, "STDThread", false), [&]() { filter->Update(); });
    clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
    const std::vector<const char*> names = { "AffineRank", "UnsupportedFraction",
      "UncoveredFraction", "InvertedFraction", "FoldedFraction", "UndersampledFraction",
      "AreaRatio", "NoiseLevel", "EffectiveDegreesOfFreedom", "LayerDistance", "StartedFromHull",
      "StartedFromMesh", "HullMethod", "NormalsUsed", "NumberOfStarts", "VertexShift" };
    for (const char* name : names)
    {
      clouds::ExpectSameBits(filter->GetOutput()->GetFieldData()->GetArray(name),
        alone->GetOutput()->GetFieldData()->GetArray(name));
    }
    ASSERT_EQ(History(filter)->GetNumberOfColumns(), 5);
    const vtkIdType rows = clouds::Rank() == 0 ? History(alone)->GetNumberOfRows() : 0;
    EXPECT_EQ(History(filter)->GetNumberOfRows(), rows);
  }
}

// What goes wrong on some processes is said by all, and leaves nothing on any of them.
void ExpectErrorEverywhere(vtkConformalSOM* filter, const std::string& message)
{
  contract::Observed observed(filter);
  filter->Modified(); // on all ranks, or some would not run
  filter->Update();
  EXPECT_TRUE(observed.Error());
  EXPECT_NE(observed.ErrorMessage().find(message), std::string::npos) << observed.ErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(History(filter)->GetNumberOfRows(), 0);
}
}

TEST(ConformalSOM, BatchLearnsTheSameBits)
{
  ExpectSameAsAlone(clouds::Ellipsoid(9001), [](vtkConformalSOM*) {});
}

TEST(ConformalSOM, OnlineLearnsTheSameBits)
{
  ExpectSameAsAlone(
    clouds::Ellipsoid(3000), [](vtkConformalSOM* filter) { filter->SetTrainingModeToOnline(); });
}

TEST(ConformalSOM, PrioritiesGiveTheSameBits)
{
  auto cloud = clouds::Ellipsoid(5000);
  clouds::AddPriorities(cloud);
  for (const int mode : { vtkConformalSOM::ONLINE, vtkConformalSOM::BATCH })
  {
    ExpectSameAsAlone(cloud,
      [=](vtkConformalSOM* filter)
      {
        filter->SetPriorityArrayName("Priority");
        filter->SetTrainingMode(mode);
      });
  }
}

TEST(ConformalSOM, OutliersAndBadPointsGiveTheSameBits)
{
  auto cloud = clouds::Ellipsoid(8000);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (vtkIdType i = 0; i < 8000; i += 500)
  {
    const double x = i % 1000 == 0 ? nan : static_cast<double>(i % 7) - 2.0;
    cloud->GetPoints()->SetPoint(i, x, 4.0, 1.0);
  }
  ExpectSameAsAlone(cloud, [](vtkConformalSOM*) {});
}

// The copies of a point are on other ranks than the point.
TEST(ConformalSOM, CopiesGiveTheSameBits)
{
  auto cloud = clouds::Ellipsoid(500);
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    double x[3];
    cloud->GetPoint(i % 500, x);
    cloud->GetPoints()->InsertNextPoint(x);
  }
  ExpectSameAsAlone(cloud, [](vtkConformalSOM*) {});
}

TEST(ConformalSOM, LimbsTakeTheHullOnAllRanks)
{
  auto cloud = clouds::Horseshoe(4000);
  ExpectSameAsAlone(cloud, [](vtkConformalSOM* filter) { filter->SetStartingShapeToAutomatic(); });
  auto filter = MakeFilter(clouds::OwnPart(cloud, clouds::EvenCuts(4000)));
  filter->SetStartingShapeToAutomatic();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("StartedFromHull")->GetTuple1(0), 1.0);
}

TEST(ConformalSOM, StartsFromTheMeshOfOneRank)
{
  auto cloud = clouds::Ellipsoid(1500);
  auto first = MakeFilter(cloud);
  first->SetController(nullptr);
  first->Update();
  const bool hasMesh = clouds::Rank() + 1 == clouds::NumberOfRanks();
  const vtkNew<vtkPolyData> nothing;
  vtkPolyData* const others[] = { nothing, nullptr }; // connected on all ranks, or only on the last
  for (vtkPolyData* other : others)
  {
    const Change start = [&](vtkConformalSOM* filter)
    {
      const bool isAlone = filter->GetInput() == cloud;
      filter->SetStartData(isAlone || hasMesh ? first->GetOutput() : other);
    };
    ExpectSameAsAlone(cloud, start);
  }
}

TEST(ConformalSOM, StartsFromThePolygonsOfTheRankThatHasAll)
{
  auto mesh = clouds::Learned(clouds::Ellipsoid(4000));
  auto alone = MakeFilter(mesh);
  alone->SetController(nullptr);
  alone->SetStartingShapeToAutomatic();
  alone->Update();
  EXPECT_EQ(alone->GetOutput()->GetFieldData()->GetArray("StartedFromMesh")->GetTuple1(0), 1.0);
  const vtkNew<vtkPolyData> nothing;
  auto filter =
    MakeFilter(clouds::Rank() + 1 == clouds::NumberOfRanks() ? mesh.Get() : nothing.Get());
  filter->SetStartingShapeToAutomatic();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("StartedFromMesh")->GetTuple1(0), 1.0);
  clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
}

// Nobody has all of the surface: its points are learned alone, and a warning says so.
TEST(ConformalSOM, PolygonsInPiecesAreNotStartedFrom)
{
  auto soup = clouds::Soup(clouds::Learned(clouds::Ellipsoid(4000)));
  auto alone = MakeFilter(soup); // has no polygons yet
  alone->SetController(nullptr);
  alone->SetStartingShapeToAutomatic();
  alone->Update();
  std::vector<vtkIdType> ends = clouds::EvenCuts(soup->GetNumberOfPoints() / 3);
  std::transform(ends.begin(), ends.end(), ends.begin(), [](vtkIdType end) { return 3 * end; });
  auto part = clouds::OwnPart(soup, ends);
  clouds::AddSoupTriangles(part);
  auto filter = MakeFilter(part);
  filter->SetStartingShapeToAutomatic();
  contract::Observed observed(filter);
  filter->Update();
  const bool inPieces = clouds::NumberOfRanks() > 1;
  EXPECT_EQ(
    filter->GetOutput()->GetFieldData()->GetArray("StartedFromMesh")->GetTuple1(0), !inPieces);
  if (inPieces)
  {
    clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
    EXPECT_EQ(observed.WarningMessage().find("several processes") != std::string::npos,
      clouds::Rank() == 0);
    filter->SetStartingShapeToMesh();
    ExpectErrorEverywhere(filter, "several processes");
  }
}

TEST(ConformalSOM, WhatNobodySawIsMarkedOnAnyNumberOfRanks)
{
  auto whole = clouds::Ellipsoid(6000), cloud = clouds::WithoutTop(whole);
  auto start = clouds::Learned(whole); // goes on over what is missing
  const Change change = [&](vtkConformalSOM* filter) { filter->SetStartData(start); };
  auto alone = MakeFilter(cloud);
  change(alone);
  alone->SetController(nullptr);
  alone->Update();
  double range[2];
  alone->GetOutput()->GetPointData()->GetArray("Supported")->GetRange(range);
  EXPECT_LT(range[0], 0.1);
  EXPECT_EQ(range[1], 1.0);
  ExpectSameAsAlone(cloud, change); // all point arrays
}

TEST(ConformalSOM, PiecesOfTheOutputMakeTheWhole)
{
  auto cloud = clouds::Ellipsoid(4000);
  auto alone = MakeFilter(cloud);
  alone->SetController(nullptr);
  alone->Update();
  auto filter = MakeFilter(clouds::OwnPart(cloud, clouds::UnevenCuts(4000)));
  filter->DistributeOutputOn();
  filter->Update();
  clouds::ExpectInPieces(filter->GetOutput(), alone->GetOutput());
}

TEST(ConformalSOM, CountsAreThoseOfAllAndSaidOnce)
{
  auto cloud = clouds::Ellipsoid(1000);
  for (const vtkIdType i : { 0, 500, 999 })
  {
    cloud->GetPoints()->SetPoint(i, std::numeric_limits<double>::infinity(), 0.0, 0.0);
  }
  auto filter = MakeFilter(clouds::OwnPart(cloud, clouds::EvenCuts(1000)));
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_EQ(observed.Warning(), clouds::Rank() == 0);
  if (clouds::Rank() == 0)
  {
    EXPECT_NE(observed.WarningMessage().find("3 points are not finite"), std::string::npos);
  }
}

TEST(ConformalSOM, NoPointsAnywhereAreNoError)
{
  const vtkNew<vtkPolyData> nothing;
  auto filter = MakeFilter(nothing);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(observed.Warning(), clouds::Rank() == 0);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(ConformalSOM, AnErrorOnOneRankIsOneOfAll)
{
  auto cloud = clouds::Ellipsoid(2000);
  clouds::AddPriorities(cloud);
  const int last = clouds::NumberOfRanks() - 1;
  auto part = clouds::OwnPart(cloud, clouds::EvenCuts(2000));
  if (clouds::Rank() == last)
  {
    part->GetPointData()->RemoveArray("Priority");
  }
  auto filter = MakeFilter(part);
  filter->SetPriorityArrayName("Priority");
  ExpectErrorEverywhere(filter, "no point array \"Priority\"");
  if (last > 0)
  {
    ExpectErrorEverywhere(filter, "on process " + std::to_string(last) + ": ");
  }

  // They can go on afterwards.
  filter->SetPriorityArrayName(nullptr);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints() > 0, clouds::Rank() == 0);
}

TEST(ConformalSOM, BadPropertiesAndStartsAreErrorsOfAll)
{
  auto part = clouds::OwnPart(clouds::Ellipsoid(2000), clouds::EvenCuts(2000));
  auto filter = MakeFilter(part);
  filter->SetSmoothness(-1.0);
  ExpectErrorEverywhere(filter, "Smoothness");
  filter->SetSmoothness(clouds::Rank() == 0 ? 1.0 : -1.0); // they never agreed on it
  if (clouds::NumberOfRanks() > 1)
  {
    ExpectErrorEverywhere(filter, ": Smoothness"); // of the process that is first to report it
  }
  filter->SetSmoothness(1.0);
  filter->SetStartData(part); // no mesh
  ExpectErrorEverywhere(filter, "");
}

TEST(ConformalSOM, PrioritiesNeedToBePositiveSomewhere)
{
  auto cloud = clouds::Ellipsoid(2000);
  clouds::AddPriorities(cloud);
  auto part = clouds::OwnPart(cloud, clouds::EvenCuts(2000));
  auto* priorities = part->GetPointData()->GetArray("Priority");
  auto filter = MakeFilter(part);
  filter->SetPriorityArrayName("Priority");
  if (clouds::Rank() > 0)
  {
    priorities->Fill(0.0);
  }
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints() > 0, clouds::Rank() == 0);
  priorities->Fill(0.0);
  ExpectErrorEverywhere(filter, "no point has a positive priority");
}

TEST(ConformalSOM, AbortOnOneRankStopsAll)
{
  auto cloud = clouds::Horseshoe(4000);
  for (const int mode : { vtkConformalSOM::ONLINE, vtkConformalSOM::BATCH })
  {
    for (const double when : { 0.0, 0.1, 0.3, 0.65, 1.0 })
    {
      auto filter = MakeFilter(clouds::OwnPart(cloud, clouds::EvenCuts(4000)));
      filter->SetTrainingMode(mode);
      filter->SetStartingShapeToAutomatic();
      vtkNew<vtkCallbackCommand> stop;
      stop->SetClientData(const_cast<double*>(&when));
      stop->SetCallback(
        [](vtkObject* caller, unsigned long, void* data, void*)
        {
          auto* algorithm = static_cast<vtkAlgorithm*>(caller);
          algorithm->SetAbortExecute(algorithm->GetProgress() >= *static_cast<double*>(data));
        });
      if (clouds::Rank() + 1 == clouds::NumberOfRanks())
      {
        filter->AddObserver(vtkCommand::ProgressEvent, stop);
      }
      contract::Observed observed(filter);
      filter->Update();
      EXPECT_FALSE(observed.Error());
      EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0) << when;
      EXPECT_EQ(History(filter)->GetNumberOfRows(), 0);
    }
  }
}

TEST(ConformalSOM, RunningOutOfMemoryOnOneRankIsAnErrorOfAll)
{
  const int last = clouds::NumberOfRanks() - 1;
  auto cloud = clouds::Ellipsoid(4000);
  auto filter = MakeFilter(clouds::OwnPart(cloud, clouds::EvenCuts(4000)));
  vtkNew<vtkCallbackCommand> fail;
  fail->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      const double progress = static_cast<vtkAlgorithm*>(caller)->GetProgress();
      if (progress > 0.3 && progress < 1.0) // the executive ends with 1
      {
        throw std::bad_alloc();
      }
    });
  if (clouds::Rank() == last)
  {
    filter->AddObserver(vtkCommand::ProgressEvent, fail);
  }
  ExpectErrorEverywhere(
    filter, last > 0 ? "on process " + std::to_string(last) + ": out of memory" : "out of memory");
}

TEST(ConformalSOM, WithoutControllerEachRankLearnsItsOwn)
{
  auto cloud = clouds::Ellipsoid(1000 + 100 * clouds::Rank());
  auto filter = MakeFilter(cloud);
  filter->SetController(nullptr);
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 642);
}
