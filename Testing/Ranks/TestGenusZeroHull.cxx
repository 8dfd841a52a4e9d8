#include "vtkGenusZeroHull.h"

#include "../Cxx/FilterContract.h"
#include "Clouds.h"

#include "vtkDataSetAttributes.h"
#include "vtkImageAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeSurfacePoints.h"

namespace
{
// A volume with a ball, of which a process makes only the part that is requested, as readers do.
class BallSource : public vtkImageAlgorithm
{
public:
  static BallSource* New();
  vtkTypeMacro(BallSource, vtkImageAlgorithm);

protected:
  BallSource() { this->SetNumberOfInputPorts(0); }
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* info = outputs->GetInformationObject(0);
    const int extent[] = { 0, 23, 0, 23, 0, 23 };
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_DOUBLE, 1);
    return 1;
  }
  void ExecuteDataWithInformation(vtkDataObject* output, vtkInformation* info) override
  {
    vtkImageData* image = this->AllocateOutputData(output, info);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double* x = image->GetPoint(i);
      const double radius = std::hypot(x[0] - 11.5, x[1] - 11.5, x[2] - 11.5);
      image->GetPointData()->GetScalars()->SetTuple1(i, 8.0 - radius);
    }
  }
};
vtkStandardNewMacro(BallSource);

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

// Each process would close its part of the volume by a plane.
TEST(GenusZeroHull, PointsOfAVolumeAreThoseOfTheWholeVolume)
{
  const auto hullOf = [](vtkMultiProcessController* controller)
  {
    const vtkNew<BallSource> volume;
    const vtkNew<vtkVolumeSurfacePoints> points;
    points->SetInputConnection(volume->GetOutputPort());
    auto hull = vtkSmartPointer<vtkGenusZeroHull>::New();
    hull->SetController(controller);
    hull->SetSpacing(0.05);
    hull->SetInputConnection(points->GetOutputPort());
    hull->Update();
    return hull;
  };
  auto alone = hullOf(nullptr), shared = hullOf(clouds::Controller());
  clouds::ExpectOnFirstRank(shared->GetOutput(), alone->GetOutput());
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
