#include "vtkMapLabels.h"

#include "FilterContract.h"
#include "MeshFixtures.h"

#include "vtkImageData.h"
#include "vtkTable.h"

namespace
{
class MapLabels : public contract::FilterTest<vtkMapLabels>
{
};
}

// The first channel of a color picture is no label.
TEST_F(MapLabels, RejectsColorPictures)
{
  const auto withChannels = [&](int channels)
  {
    vtkNew<vtkImageData> picture;
    picture->SetDimensions(40, 20, 1);
    picture->AllocateScalars(VTK_UNSIGNED_CHAR, channels);
    picture->GetPointData()->GetScalars()->Fill(1.0);
    this->Filter->SetLabelsData(picture);
    this->Filter->Update();
  };
  this->Filter->SetInputData(fixtures::Head(6, 0.8));
  withChannels(1);
  EXPECT_EQ(this->Filter->GetMeasures()->GetNumberOfRows(), 1);
  this->Seen.ExpectWarning("");
  withChannels(3);
  this->Seen.ExpectError("3 components");
}
