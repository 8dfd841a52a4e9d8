#include "vtkGenusZeroHull.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

#include "vtkDataSetAttributes.h"
#include "vtkUnsignedCharArray.h"

namespace
{
vtkSmartPointer<vtkGenusZeroHull> MakeFilter(vtkPolyData* cloud)
{
  auto filter = vtkSmartPointer<vtkGenusZeroHull>::New();
  filter->SetInputData(cloud);
  filter->SetSpacing(0.05);
  return filter;
}
}

TEST(GenusZeroHull, IsThatOfOneProcessAlone)
{
  auto cloud = clouds::Horseshoe(6000);
  auto alone = MakeFilter(cloud);
  alone->SetController(nullptr);
  alone->Update();
  for (const std::vector<vtkIdType>& cuts : { clouds::EvenCuts(6000), clouds::UnevenCuts(6000) })
  {
    auto part = clouds::OwnPart(cloud, cuts);
    auto filter = MakeFilter(part);
    filter->Update();
    clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
    EXPECT_EQ(filter->GetOutput()->GetFieldData()->GetArray("HoleDepth")->GetTuple1(0),
      alone->GetOutput()->GetFieldData()->GetArray("HoleDepth")->GetTuple1(0));
    filter->DistributeOutputOn();
    filter->Update();
    clouds::ExpectInPieces(filter->GetOutput(), alone->GetOutput());
  }
}

TEST(GenusZeroHull, ByWindingNumbersIsThatOfOneProcessAlone)
{
  auto cloud = clouds::Horseshoe(6000);
  auto alone = MakeFilter(cloud);
  alone->SetMethodToWindingNumbers();
  alone->SetController(nullptr);
  alone->Update();
  for (const std::vector<vtkIdType>& cuts : { clouds::EvenCuts(6000), clouds::UnevenCuts(6000) })
  {
    auto filter = MakeFilter(clouds::OwnPart(cloud, cuts));
    filter->SetMethodToWindingNumbers();
    filter->Update();
    clouds::ExpectOnFirstRank(filter->GetOutput(), alone->GetOutput());
  }
}

TEST(GenusZeroHull, AbortOnOneRankStopsAll)
{
  auto filter = MakeFilter(clouds::OwnPart(clouds::Horseshoe(6000), clouds::EvenCuts(6000)));
  vtkNew<vtkCallbackCommand> stop;
  stop->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1); });
  if (clouds::Rank() == 0)
  {
    filter->AddObserver(vtkCommand::ProgressEvent, stop);
  }
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

// Arrays that do not fit the points of one rank are an error of all, and none waits for it.
TEST(GenusZeroHull, AWrongLengthOnOneRankIsAnErrorOfAll)
{
  auto part = clouds::OwnPart(clouds::Horseshoe(6000), clouds::EvenCuts(6000));
  const int last = clouds::NumberOfRanks() - 1;
  if (clouds::Rank() == last)
  {
    vtkNew<vtkUnsignedCharArray> ghosts;
    ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
    part->GetPointData()->AddArray(ghosts);
  }
  auto filter = MakeFilter(part);
  contract::Observed observed(filter);
  filter->Update();
  observed.ExpectError("input port 0: the point array \"vtkGhostType\" has 0 tuples");
  if (last > 0)
  {
    observed.ExpectError("on process " + std::to_string(last) + ": ");
  }
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);

  // They can go on afterwards.
  part->GetPointData()->Initialize();
  filter->Modified(); // on all ranks, or some would not run
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints() > 0, clouds::Rank() == 0);
}

TEST(GenusZeroHull, NoPointsAnywhereAreNoError)
{
  const vtkNew<vtkPolyData> nothing;
  auto filter = MakeFilter(nothing);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(observed.Warning(), clouds::Rank() == 0);
}
