#include "vtkSurfaceNormalMap.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkSphericalTextureMap.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace
{
class SurfaceNormalMap : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Few->SetFrequency(6);
    this->Many->SetFrequency(40);
    this->Map->SetInputConnection(this->Few->GetOutputPort());
    this->Map->SetProjectionToOctahedral();
    this->Map->SetMargin(0.02);
    this->Map->SplitSeamOn();
    this->Filter->SetInputConnection(this->Map->GetOutputPort());
    this->Filter->SetDetailConnection(this->Many->GetOutputPort());
    this->Filter->SetImageSize(64, 32);
  }
  void ExpectError(const std::string& text)
  {
    contract::Observed observed(this->Filter);
    this->Filter->Update();
    EXPECT_NE(observed.ErrorMessage().find(text), std::string::npos) << observed.ErrorMessage();
    EXPECT_EQ(this->Filter->GetSurface()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkGeodesicSphereSource> Few, Many;
  vtkNew<vtkSphericalTextureMap> Map;
  vtkNew<vtkSurfaceNormalMap> Filter;
};
}

// Of two spheres with exact normals, each normal is that of the surface: (0, 0, 1).
TEST_F(SurfaceNormalMap, IsFlatForEqualSpheres)
{
  this->Filter->Update();
  vtkDataArray* pixels = this->Filter->GetOutput()->GetPointData()->GetScalars();
  ASSERT_EQ(pixels->GetNumberOfTuples(), 64 * 32);
  EXPECT_STREQ(pixels->GetName(), "NormalMap");
  double sum[3] = { 0.0, 0.0, 0.0 };
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      sum[c] += pixels->GetComponent(i, c) / 2048.0;
    }
    EXPECT_GT(pixels->GetComponent(i, 2), 240.0) << i;
  }
  EXPECT_NEAR(sum[0], 127.5, 1.5);
  EXPECT_NEAR(sum[1], 127.5, 1.5);
  EXPECT_GT(sum[2], 254.0);
}

TEST_F(SurfaceNormalMap, AddsTangents)
{
  this->Filter->Update();
  vtkPolyData* surface = this->Filter->GetSurface();
  vtkDataArray* tangents = surface->GetPointData()->GetTangents();
  ASSERT_TRUE(tangents);
  EXPECT_STREQ(tangents->GetName(), "Tangents");
  ASSERT_EQ(tangents->GetNumberOfTuples(), this->Map->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < tangents->GetNumberOfTuples(); ++i)
  {
    double t[3], n[3];
    tangents->GetTuple(i, t);
    surface->GetPointData()->GetNormals()->GetTuple(i, n);
    EXPECT_NEAR(std::hypot(t[0], t[1], t[2]), 1.0, 1e-6);
    EXPECT_NEAR(t[0] * n[0] + t[1] * n[1] + t[2] * n[2], 0.0, 1e-6);
  }
}

TEST_F(SurfaceNormalMap, SaysWhatTheSurfaceLacks)
{
  vtkNew<vtkPolyData> plain;
  plain->ShallowCopy((this->Map->Update(), this->Map->GetOutput()));
  plain->GetPointData()->SetNormals(nullptr);
  plain->GetPointData()->RemoveArray("Normals");
  this->Filter->SetInputData(plain);
  this->ExpectError("no point normals");
  plain->ShallowCopy(this->Map->GetOutput());
  plain->GetPointData()->SetTCoords(nullptr);
  plain->Modified();
  this->ExpectError("no texture coordinates");
  this->Few->Update();
  this->Filter->SetInputData(this->Few->GetOutput());
  this->ExpectError("vtkSphericalTextureMap");
}
