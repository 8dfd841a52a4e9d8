#include "Glue/SphereImages.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using glue::AddSphereImage;
using glue::ToSphereImage;

namespace
{
conformal::SphereImage someImage()
{
  conformal::SphereImage image;
  image.Projection = conformal::SphereProjection::CubeMap;
  image.View = { { 1, 0, 0 }, { 0, 0, 1 }, { 0, 1, 0 } };
  image.FieldOfView = 77.0;
  image.Scale = { 1.5, 0.25 };
  image.Margin = 0.125;
  return image;
}
}

TEST(SphereImages, GoThereAndBack)
{
  const conformal::SphereImage image = someImage();
  vtkNew<vtkFieldData> data;
  AddSphereImage(data, image);
  const conformal::SphereImage back = ToSphereImage(data);
  EXPECT_EQ(back.Projection, image.Projection);
  EXPECT_EQ(back.View.Pole, image.View.Pole);
  EXPECT_EQ(back.View.Up, image.View.Up);
  EXPECT_EQ(back.View.Right, image.View.Right);
  EXPECT_EQ(back.FieldOfView, image.FieldOfView);
  EXPECT_EQ(back.Scale, image.Scale);
  EXPECT_EQ(back.Margin, image.Margin);
}

TEST(SphereImages, RefuseWhatSaysNothing)
{
  vtkNew<vtkFieldData> complete;
  AddSphereImage(complete, someImage());
  for (const char* name : { "SpherePole", "SphereUp", "SphereRight", "TextureProjection",
         "TextureFieldOfView", "TextureScale", "TextureMargin" })
  {
    vtkNew<vtkFieldData> data;
    data->DeepCopy(complete);
    data->RemoveArray(name);
    EXPECT_THROW(ToSphereImage(data), std::invalid_argument) << name;
    data->DeepCopy(complete);
    vtkNew<vtkDoubleArray> broken;
    broken->DeepCopy(complete->GetArray(name));
    broken->SetName(name);
    data->AddArray(broken);
    for (double bad : { std::nan(""), std::numeric_limits<double>::infinity() })
    {
      broken->SetComponent(0, 0, bad);
      EXPECT_THROW(ToSphereImage(data), std::invalid_argument) << name;
    }
    const bool isDirection = broken->GetNumberOfComponents() == 3;
    for (double bad : { isDirection ? 0.7 : -1.0, 1e300 })
    {
      broken->SetComponent(0, 0, bad);
      EXPECT_THROW(ToSphereImage(data), std::invalid_argument) << name;
    }
    // Too few tuples, components or numbers.
    broken->DeepCopy(complete->GetArray(name));
    broken->SetNumberOfTuples(0);
    EXPECT_THROW(ToSphereImage(data), std::invalid_argument) << name;
    broken->SetNumberOfComponents(complete->GetArray(name)->GetNumberOfComponents() + 1);
    broken->SetNumberOfTuples(1);
    broken->Fill(1.0);
    EXPECT_THROW(ToSphereImage(data), std::invalid_argument) << name;
    vtkNew<vtkStringArray> words;
    words->SetName(name);
    words->InsertNextValue("1");
    data->AddArray(words);
    EXPECT_THROW(ToSphereImage(data), std::invalid_argument) << name;
  }
}

TEST(SphereImages, RefuseAxesThatAreNotOrthonormal)
{
  using conformal::Vector3;
  const auto read = [](const Vector3& pole, const Vector3& up, const Vector3& right)
  {
    conformal::SphereImage image = someImage();
    image.View = { pole, up, right };
    vtkNew<vtkFieldData> data;
    AddSphereImage(data, image);
    return ToSphereImage(data);
  };
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  EXPECT_NO_THROW(read(z, y, x));
  EXPECT_NO_THROW(read(z, y, -x)); // of a mirrored map
  const double s = std::sqrt(0.5);
  const auto single = [](const Vector3& v) { return Vector3(v.cast<float>().cast<double>()); };
  EXPECT_NO_THROW(read(single({ s, 0.5, 0.5 }), single({ -s, 0.5, 0.5 }), single({ 0, s, -s })));
  EXPECT_THROW(read(Vector3::Zero(), y, x), std::invalid_argument);
  EXPECT_THROW(read(z, Vector3::Zero(), x), std::invalid_argument);
  EXPECT_THROW(read(z, y, Vector3::Zero()), std::invalid_argument);
  EXPECT_THROW(read(2 * z, y, x), std::invalid_argument);
  EXPECT_THROW(read(z, 1.001 * y, x), std::invalid_argument);
  EXPECT_THROW(read(z, z, x), std::invalid_argument);
  EXPECT_THROW(read(z, y, y), std::invalid_argument);
  EXPECT_THROW(read(z, y, Vector3(s, 0, s)), std::invalid_argument);
  EXPECT_THROW(read(1e200 * z, y, x), std::invalid_argument);
}

TEST(SphereImages, RefuseAProjectionBetweenTwo)
{
  vtkNew<vtkFieldData> data;
  AddSphereImage(data, someImage());
  vtkNew<vtkDoubleArray> projection;
  projection->SetName("TextureProjection");
  projection->InsertNextValue(1.5);
  data->AddArray(projection);
  EXPECT_THROW(ToSphereImage(data), std::invalid_argument);
}

TEST(SphereImages, ImagesHaveCountablePixels)
{
  vtkNew<vtkInformation> info;
  for (const auto& size : { std::pair(0, 1), std::pair(1, -1), std::pair(1 << 16, 1 << 16) })
  {
    const int pixels[2] = { size.first, size.second };
    EXPECT_THROW(glue::SetImageInformation(info, pixels), std::invalid_argument);
  }
}

// Integers above 2^53 have no double, and infinity times 0 is not a number.
TEST(SphereImages, PixelsKeepValuesOfSinglePoints)
{
  constexpr vtkIdType large = 1LL << 53;
  vtkNew<vtkIdTypeArray> labels, labelPixels;
  vtkNew<vtkDoubleArray> heights, heightPixels;
  for (const vtkIdType label : { 1, 3, 5 })
  {
    labels->InsertNextValue(large + label);
    heights->InsertNextValue(label == 5 ? std::numeric_limits<double>::infinity() : 2.0 * label);
  }
  labelPixels->SetNumberOfValues(2);
  heightPixels->SetNumberOfValues(2);
  vtkNew<vtkUnsignedCharArray> holes;
  holes->SetNumberOfValues(2);
  const std::vector<conformal::SurfacePlace> places = { { { 1, 1, 1 }, { 1.0, 0.0, 0.0 } },
    { { 0, 1, 2 }, { 0.5, 0.5, 0.0 } } };
  glue::PixelPainter(labels, labelPixels, holes)(0, places);
  EXPECT_EQ(labelPixels->GetValue(0), large + 3);
  glue::PixelPainter(heights, heightPixels, holes)(0, places);
  EXPECT_EQ(heightPixels->GetValue(0), 6.0);
  EXPECT_EQ(heightPixels->GetValue(1), 4.0);
}
