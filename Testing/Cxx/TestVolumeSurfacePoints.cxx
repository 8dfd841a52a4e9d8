#include "vtkVolumeSurfacePoints.h"

#include "FilterContract.h"

#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkShortArray.h"

#include <cmath>

namespace
{
// A ball of radius 8 with the value 200, in an image of 24^3 voxels with the value 100.
template <typename Array>
vtkNew<vtkImageData> Ball()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(24, 24, 24);
  vtkNew<Array> values;
  values->SetName("Values");
  values->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    const bool isInBall = std::hypot(p[0] - 11.5, p[1] - 11.5, p[2] - 11.5) < 8.0;
    values->InsertNextTuple2(-7.0, isInBall ? 200.0 : 100.0);
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

class VolumeSurfacePoints : public contract::FilterTest<vtkVolumeSurfacePoints>
{
protected:
  VolumeSurfacePoints() { this->Filter->SetComponent(1); }
};
}

TEST_F(VolumeSurfacePoints, StatesWhyThereIsNoSurface)
{
  this->Filter->SetInputData(Ball<vtkDoubleArray>());
  this->Filter->SetLevelMethodToFixed();
  this->Filter->SetLevel(50.0);
  this->Run();
  this->Seen.ExpectWarning("all values exceed the level 50, so there is no surface");
  this->Filter->SetLevel(250.0);
  this->Run();
  this->Seen.ExpectWarning("no value exceeds the level 250, so there is no object");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  this->Filter->SetLevel(150.0);
  this->Run();
  this->Seen.ExpectWarning("");
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(VolumeSurfacePoints, DoesNotDependOnTheTypeOfTheVoxels)
{
  this->Filter->SetInputData(Ball<vtkDoubleArray>());
  this->Run();
  vtkNew<vtkPolyData> ofDoubles;
  ofDoubles->DeepCopy(this->Filter->GetOutput());
  ASSERT_GT(ofDoubles->GetNumberOfPoints(), 1000);
  this->Filter->SetInputData(Ball<vtkShortArray>());
  this->Run();
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), ofDoubles->GetNumberOfPoints());
  for (vtkIdType i = 0; i < ofDoubles->GetNumberOfPoints(); ++i)
  {
    const double* p = ofDoubles->GetPoint(i);
    const double* q = this->Filter->GetOutput()->GetPoint(i);
    ASSERT_TRUE(p[0] == q[0] && p[1] == q[1] && p[2] == q[2]) << i;
  }
}

TEST_F(VolumeSurfacePoints, ReportsWhileItReadsTheImage)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(150, 150, 150);
  image->AllocateScalars(VTK_SHORT, 2);
  image->GetPointData()->GetScalars()->Fill(3.0);
  this->Filter->SetInputData(image);
  vtkNew<vtkCallbackCommand> stop;
  int reports = 0;
  stop->SetClientData(&reports);
  stop->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(caller);
      const double progress = filter->GetProgress();
      *static_cast<int*>(client) += progress > 0.0 && progress < 0.05;
      filter->SetAbortExecute(progress >= 0.05);
    });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, stop);
  this->Run();
  EXPECT_GE(reports, 2);
  this->Seen.ExpectWarning("");
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(VolumeSurfacePoints, ValuesThatAreNotFiniteAreErrors)
{
  const auto image = Ball<vtkDoubleArray>();
  image->GetPointData()->GetScalars()->SetComponent(77, 1, std::nan(""));
  this->Filter->SetInputData(image);
  this->Run();
  this->Seen.ExpectError("the value of voxel 77 is not finite");
}
