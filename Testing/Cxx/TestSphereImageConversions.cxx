#include "vtkSphereImageConversions.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

using vtkConformalConversions::AddSphereImage;
using vtkConformalConversions::ToSphereImage;

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

TEST(SphereImageConversions, GoThereAndBack)
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

TEST(SphereImageConversions, RefuseWhatSaysNothing)
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
    broken->SetComponent(0, 0, -1.0);
    const bool isDirection = broken->GetNumberOfComponents() == 3;
    if (!isDirection)
    {
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

TEST(SphereImageConversions, ImagesHaveCountablePixels)
{
  vtkNew<vtkInformation> info;
  for (const auto& size : { std::pair(0, 1), std::pair(1, -1), std::pair(1 << 16, 1 << 16) })
  {
    const int pixels[2] = { size.first, size.second };
    EXPECT_THROW(vtkConformalConversions::SetImageInformation(info, pixels), std::invalid_argument);
  }
}
