#include "vtkGenusZeroHull.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

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

TEST(GenusZeroHull, NoPointsAnywhereAreNoError)
{
  const vtkNew<vtkPolyData> nothing;
  auto filter = MakeFilter(nothing);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(observed.Warning(), clouds::Rank() == 0);
}
