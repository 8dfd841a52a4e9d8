#include "vtkSphericalTextureMap.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkDataArray.h"
#include "vtkPoints.h"

#include <limits>

namespace
{
class SphericalTextureMap : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkGeodesicSphereSource> source;
    source->SetFrequency(6);
    source->Update();
    this->Surface->DeepCopy(source->GetOutput());
    this->Filter->SetInputData(this->Surface);
  }
  vtkDataArray* SpherePosition()
  {
    return this->Surface->GetPointData()->GetArray("SpherePosition");
  }
  void ExpectError(const std::string& text)
  {
    contract::Observed observed(this->Filter);
    this->Surface->Modified();
    this->Filter->Update();
    EXPECT_NE(observed.ErrorMessage().find(text), std::string::npos) << observed.ErrorMessage();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkSphericalTextureMap> Filter;
};
}

TEST_F(SphericalTextureMap, HasTheDocumentedDefaults)
{
  EXPECT_EQ(this->Filter->GetViewDirection()[2], 1.0);
  EXPECT_EQ(this->Filter->GetViewUp()[1], 1.0);
  EXPECT_EQ(this->Filter->GetFieldOfView(), 180.0);
}

TEST_F(SphericalTextureMap, WritesTheContractsArrays)
{
  this->Filter->Update();
  vtkPolyData* output = this->Filter->GetOutput();
  vtkPointData* pointData = output->GetPointData();
  const vtkIdType size = output->GetNumberOfPoints();
  contract::ExpectArray(pointData, "Texture Coordinates", VTK_FLOAT, 2, size);
  contract::ExpectArray(pointData, "OutsideImage", VTK_UNSIGNED_CHAR, 1, size);
  EXPECT_EQ(pointData->GetTCoords(), pointData->GetArray("Texture Coordinates"));
  EXPECT_GE(pointData->GetTCoords()->GetRange(0)[0], 0.0);
  EXPECT_LE(pointData->GetTCoords()->GetRange(1)[1], 1.0);
  for (const char* name : { "SpherePole", "SphereUp", "SphereRight" })
  {
    contract::ExpectArray(output->GetFieldData(), name, VTK_DOUBLE, 3, 1);
  }
  EXPECT_EQ(output->GetPoints(), this->Surface->GetPoints());
  contract::ExpectSpherePosition(output);
}

// Point 0 of the source is its north pole, in the middle of the default view.
TEST_F(SphericalTextureMap, PutsThePoleInTheMiddle)
{
  this->Filter->Update();
  vtkPolyData* output = this->Filter->GetOutput();
  EXPECT_NEAR(output->GetPointData()->GetTCoords()->GetComponent(0, 0), 0.5, 1e-6);
  EXPECT_NEAR(output->GetPointData()->GetTCoords()->GetComponent(0, 1), 0.5, 1e-6);
  EXPECT_EQ(output->GetPointData()->GetArray("OutsideImage")->GetTuple1(0), 0.0);
  EXPECT_EQ(output->GetPointData()->GetArray("OutsideImage")->GetTuple1(11), 1.0);
  EXPECT_NEAR(output->GetFieldData()->GetArray("SpherePole")->GetComponent(0, 2), 1.0, 1e-12);
  EXPECT_NEAR(output->GetFieldData()->GetArray("SphereUp")->GetComponent(0, 1), 1.0, 1e-2);
  EXPECT_NEAR(output->GetFieldData()->GetArray("SphereRight")->GetComponent(0, 0), 1.0, 1e-2);
}

TEST_F(SphericalTextureMap, FollowsTheView)
{
  this->Filter->SetViewDirection(3, 0, 0);
  this->Filter->SetViewUp(0, 0, 2);
  this->Filter->Update();
  vtkFieldData* data = this->Filter->GetOutput()->GetFieldData();
  EXPECT_NEAR(data->GetArray("SpherePole")->GetComponent(0, 0), 1.0, 1e-12);
  EXPECT_NEAR(data->GetArray("SphereUp")->GetComponent(0, 2), 1.0, 1e-2);
  EXPECT_NEAR(data->GetArray("SphereRight")->GetComponent(0, 1), 1.0, 1e-2);
}

TEST_F(SphericalTextureMap, LeavesTheInputAlone)
{
  this->Filter->Update();
  EXPECT_EQ(this->Surface->GetPointData()->GetTCoords(), nullptr);
  EXPECT_EQ(this->Surface->GetPointData()->GetArray("OutsideImage"), nullptr);
  EXPECT_EQ(this->Surface->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST_F(SphericalTextureMap, WarnsOfAnEmptySurface)
{
  contract::Observed observed(this->Filter);
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetInputData(nothing);
  this->Filter->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(SphericalTextureMap, RefusesSurfacesWithoutASphereMap)
{
  this->Surface->GetPointData()->Initialize();
  this->ExpectError("no point array SpherePosition");
}

TEST_F(SphericalTextureMap, RefusesSpherePositionsWithoutADirection)
{
  this->SpherePosition()->SetTuple3(3, 0, 0, 0);
  this->SpherePosition()->SetTuple3(5, 0, std::numeric_limits<double>::quiet_NaN(), 0);
  this->ExpectError("2 of 362 vectors of SpherePosition are zero or not finite");
}

TEST_F(SphericalTextureMap, RefusesCoordinatesThatAreNotFinite)
{
  this->Surface->GetPoints()->SetPoint(8, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  this->ExpectError("1 of 362 points of the surface are not finite");
}

TEST_F(SphericalTextureMap, RefusesViewsThatAreNone)
{
  this->Filter->SetViewUp(0, 0, 7);
  this->ExpectError("parallel");
  this->Filter->SetViewUp(0, 1, 0);
  this->Filter->SetViewDirection(0, 0, 0);
  this->ExpectError("ViewDirection must be finite and not zero");
  this->Filter->SetViewDirection(0, 0, 1);
  this->Filter->SetFieldOfView(std::numeric_limits<double>::quiet_NaN());
  this->ExpectError("FieldOfView must lie between");
}

TEST_F(SphericalTextureMap, ClampsItsFieldOfView)
{
  this->Filter->SetFieldOfView(0.0);
  EXPECT_EQ(this->Filter->GetFieldOfView(), 0.001);
  this->Filter->SetFieldOfView(360.0);
  EXPECT_EQ(this->Filter->GetFieldOfView(), 340.0);
}

TEST_F(SphericalTextureMap, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetFieldOfView(90); });
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetViewDirection(1, 0, 0); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetViewUp(0, 1, 1); });
  for (const char* property : { "ViewDirection", "ViewUp", "FieldOfView" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
}
