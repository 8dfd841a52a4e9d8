#include "vtkSphericalTextureBlend.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkSphericalTextureImage.h"
#include "vtkSphericalTextureMap.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
vtkSmartPointer<vtkImageData> Plain(int components, double value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(6, 4, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int c = 0; c < components; ++c)
  {
    image->GetPointData()->GetScalars()->FillComponent(c, value);
  }
  return image;
}

class SphericalTextureBlend : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Sphere->SetFrequency(16);
    this->Map->SetInputConnection(this->Sphere->GetOutputPort());
    this->Map->SetProjection(vtkSphericalTextureMap::LONGITUDE_LATITUDE);
    this->Filter->SetInputConnection(this->Map->GetOutputPort());
    this->Filter->SetFrontData(Plain(3, 200));
    this->Filter->SetBackData(Plain(3, 100));
    this->Filter->SetImageSize(64, 33);
  }
  double At(int column, int row)
  {
    return this->Filter->GetOutput()->GetScalarComponentAsDouble(column, row, 0, 0);
  }
  void ExpectError(const std::string& text)
  {
    contract::Observed observed(this->Filter);
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_NE(observed.ErrorMessage().find(text), std::string::npos) << observed.ErrorMessage();
  }

  vtkNew<vtkGeodesicSphereSource> Sphere;
  vtkNew<vtkSphericalTextureMap> Map;
  vtkNew<vtkSphericalTextureBlend> Filter;
};
}

TEST_F(SphericalTextureBlend, FadesFromTheFrontToTheBack)
{
  this->Filter->Update();
  vtkImageData* image = this->Filter->GetOutput();
  EXPECT_EQ(image->GetNumberOfPoints(), 64 * 33);
  contract::ExpectArray(image->GetPointData(), "ImageScalars", VTK_UNSIGNED_CHAR, 3, 64 * 33);
  EXPECT_EQ(this->At(32, 16), 200.0); // the middle is the pole
  EXPECT_EQ(this->At(0, 16), 100.0);
  EXPECT_NEAR(this->At(47, 16) + this->At(48, 16), 300.0, 2.0); // 90 degrees to the right
  EXPECT_EQ(this->At(40, 16), 200.0);
  EXPECT_EQ(this->At(55, 16), 100.0);
}

// Directions outside of a picture show its border, with a share of 0.
TEST_F(SphericalTextureBlend, PixelsWithoutWeightDoNotCount)
{
  const auto picture = [](double value, double border)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(20, 20, 1);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (int i = 0; i < 400; ++i)
    {
      const int column = i % 20, row = i / 20;
      const bool isBorder = column == 0 || column == 19 || row == 0 || row == 19;
      image->GetPointData()->GetScalars()->SetComponent(i, 0, isBorder ? border : value);
    }
    return image;
  };
  this->Filter->SetFrontData(picture(1.0, std::numeric_limits<double>::quiet_NaN()));
  this->Filter->SetBackData(picture(2.0, 2.0));
  this->Filter->SetBlendAngle(0.0);
  this->Filter->Update();
  EXPECT_EQ(this->At(32, 16), 1.0);
  EXPECT_EQ(this->At(0, 16), 2.0);
  EXPECT_EQ(this->At(8, 16), 2.0);
}

// Pictures taken of a colored object from both sides give back its colors all around.
TEST_F(SphericalTextureBlend, TwoViewsShowAllOfTheObject)
{
  this->Filter->SetFieldOfView(240);
  this->Filter->SetImageSize(256, 128);
  vtkNew<vtkSphericalTextureMap> view[2];
  vtkNew<vtkSphericalTextureImage> picture[2];
  for (int side = 0; side < 2; ++side)
  {
    view[side]->SetInputConnection(this->Sphere->GetOutputPort());
    view[side]->SetViewDirection(0, 0, side == 0 ? 1 : -1);
    view[side]->SetFieldOfView(240);
    picture[side]->SetInputConnection(view[side]->GetOutputPort());
    picture[side]->SetArrayName("SpherePosition");
    picture[side]->SetImageSize(400, 400);
    this->Filter->SetInputConnection(1 + side, picture[side]->GetOutputPort());
  }
  this->Filter->Update();
  vtkNew<vtkSphericalTextureImage> direct;
  direct->SetInputConnection(this->Map->GetOutputPort());
  direct->SetArrayName("SpherePosition");
  direct->SetImageSize(256, 128);
  direct->Update();
  vtkDataArray* blended = this->Filter->GetOutput()->GetPointData()->GetScalars();
  vtkDataArray* expected = direct->GetOutput()->GetPointData()->GetScalars();
  EXPECT_EQ(blended->GetDataType(), VTK_DOUBLE);
  for (vtkIdType i = 0; i < blended->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(blended->GetComponent(i, c), expected->GetComponent(i, c), 0.003);
    }
  }
}

TEST_F(SphericalTextureBlend, RefusesWhatCannotBeBlended)
{
  this->Filter->SetInputDataObject(2, Plain(4, 0));
  this->ExpectError("must have the same number of components");
  vtkNew<vtkImageData> none;
  this->Filter->SetInputDataObject(2, none);
  this->ExpectError("an image of one slice");
  this->Filter->SetInputDataObject(2, Plain(3, 0));
  this->Filter->SetBackViewDirection(0, 0, 0);
  this->ExpectError("ViewDirection must be finite and not zero");
  this->Filter->SetBackViewDirection(0, 0, -1);
  this->Filter->SetBlendAngle(std::numeric_limits<double>::quiet_NaN());
  this->ExpectError("BlendAngle must lie between");
  this->Filter->SetBlendAngle(20);
  this->Filter->SetFieldOfView(std::numeric_limits<double>::quiet_NaN());
  this->ExpectError("FieldOfView must lie between");
  this->Filter->SetFieldOfView(200);
  this->Filter->SetInputConnection(this->Sphere->GetOutputPort());
  this->ExpectError("no field data SpherePole of vtkSphericalTextureMap");
  this->Filter->SetImageSize(1, -1);
  this->ExpectError("ImageSize must be at least");
}

TEST_F(SphericalTextureBlend, WarnsOfAnEmptySurface)
{
  contract::Observed observed(this->Filter);
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetInputData(nothing);
  this->Filter->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_FALSE(observed.Error());
}

TEST_F(SphericalTextureBlend, LeavesItsInputsAlone)
{
  this->Map->Update();
  const vtkMTimeType before = this->Map->GetOutput()->GetMTime();
  const auto picture = Plain(3, 7);
  this->Filter->SetInputDataObject(1, picture);
  const vtkMTimeType pictureBefore = picture->GetMTime();
  this->Filter->Update();
  EXPECT_EQ(this->Map->GetOutput()->GetMTime(), before);
  EXPECT_EQ(picture->GetMTime(), pictureBefore);
}

TEST_F(SphericalTextureBlend, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetBlendAngle(7); });
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetBackViewUp(1, 0, 0); });
  for (const char* property :
    { "BackViewDirection", "BackViewUp", "FieldOfView", "BlendAngle", "ImageSize" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
}

TEST_F(SphericalTextureBlend, StopsWhenAsked)
{
  contract::ExpectStopsWhenAsked(this->Filter);
}
