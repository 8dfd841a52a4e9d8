#include "vtkSphericalRegistration.h"

#include "FilterContract.h"
#include "MeshFixtures.h"

#include "vtkMath.h"

#include <cmath>
#include <string>

namespace
{
// Mirror the map of a surface.
void Mirror(vtkPolyData* surface)
{
  vtkDataArray* map = surface->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
  {
    map->SetComponent(i, 0, -map->GetComponent(i, 0));
  }
  map->Modified();
  surface->Modified();
}

class SphericalRegistration : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(this->Moving);
    this->Filter->SetFixedData(this->Fixed);
    this->Filter->SetFrequency(8);
  }
  /// In degrees, from where the fixed surface has it.
  double MeanAngle()
  {
    vtkDataArray* a = this->Filter->GetOutput()->GetPointData()->GetArray("SpherePosition");
    vtkDataArray* b = this->Fixed->GetPointData()->GetArray("SpherePosition");
    double sum = 0.0;
    for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
    {
      double p[3], q[3];
      a->GetTuple(i, p);
      b->GetTuple(i, q);
      sum += vtkMath::DegreesFromRadians(std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
    }
    return sum / static_cast<double>(a->GetNumberOfTuples());
  }
  double Field(const char* name, int component = 0)
  {
    return this->Filter->GetOutput()->GetFieldData()->GetArray(name)->GetComponent(0, component);
  }
  void ExpectTargetsWhereTheMapSays()
  {
    vtkPolyData* output = this->Filter->GetOutput();
    vtkPointData* data = output->GetPointData();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double place[3] = {}, map[3];
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      const auto cell = static_cast<vtkIdType>(data->GetArray("TargetCellId")->GetComponent(i, 0));
      ASSERT_GE(cell, 0);
      this->Fixed->GetCellPoints(cell, count, ids);
      for (int k = 0; k < 3; ++k)
      {
        const auto id =
          static_cast<vtkIdType>(data->GetArray("TargetPointIds")->GetComponent(i, k));
        EXPECT_TRUE(id == ids[0] || id == ids[1] || id == ids[2]);
        this->Fixed->GetPointData()->GetArray("SpherePosition")->GetTuple(id, map);
        for (int axis = 0; axis < 3; ++axis)
        {
          place[axis] += data->GetArray("TargetBarycentric")->GetComponent(i, k) * map[axis];
        }
      }
      vtkMath::Normalize(place);
      data->GetArray("SpherePosition")->GetTuple(i, map);
      EXPECT_LT(std::sqrt(vtkMath::Distance2BetweenPoints(place, map)), 1e-9);
    }
  }
  void ExpectRefused(const std::string& why)
  {
    contract::Observed observed(this->Filter);
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_NE(observed.ErrorMessage().find(why), std::string::npos) << observed.ErrorMessage();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkPolyData> Moving = fixtures::Head(12, 2.0), Fixed = fixtures::Head(12, 0.0);
  vtkNew<vtkSphericalRegistration> Filter;
};
}

TEST_F(SphericalRegistration, WritesTheContractsArraysAndFindsTheTurn)
{
  this->Filter->Update();
  vtkPolyData* output = this->Filter->GetOutput();
  const vtkIdType size = this->Moving->GetNumberOfPoints();
  contract::ExpectSpherePosition(output);
  contract::ExpectArray(output->GetPointData(), "TargetCellId", VTK_ID_TYPE, 1, size);
  contract::ExpectArray(output->GetPointData(), "TargetPointIds", VTK_ID_TYPE, 3, size);
  contract::ExpectArray(output->GetPointData(), "TargetBarycentric", VTK_DOUBLE, 3, size);
  contract::ExpectArray(output->GetFieldData(), "RegistrationStretch", VTK_DOUBLE, 1, 1);
  contract::ExpectArray(output->GetFieldData(), "LandmarkError", VTK_DOUBLE, 1, 1);
  contract::ExpectArray(output->GetFieldData(), "FeatureAgreement", VTK_DOUBLE, 2, 1);
  contract::ExpectArray(output->GetFieldData(), "Ambiguous", VTK_ID_TYPE, 1, 1);
  EXPECT_EQ(output->GetPoints(), this->Moving->GetPoints());
  EXPECT_EQ(this->Field("NumberOfFolds"), 0.0);
  EXPECT_LT(this->Field("FeatureAgreement", 0), 0.8);
  EXPECT_GT(this->Field("FeatureAgreement", 1), 0.99);
  EXPECT_LT(this->MeanAngle(), 0.5);
}

// The targets are points of the fixed surface at the same place of the sphere.
TEST_F(SphericalRegistration, TargetsLieWhereTheMapSays)
{
  this->Filter->Update();
  this->ExpectTargetsWhereTheMapSays();
}

TEST_F(SphericalRegistration, TargetsAndUnusedPointsOfMirroredMapsLieWhereTheMapSays)
{
  this->Moving->GetPoints()->InsertNextPoint(this->Moving->GetPoint(77));
  vtkPointData* data = this->Moving->GetPointData();
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    data->GetArray(k)->InsertNextTuple(data->GetArray(k)->GetTuple(77));
  }
  contract::Observed observed(this->Filter);
  for (vtkPolyData* surface : { this->Moving.Get(), this->Fixed.Get() })
  {
    Mirror(surface);
    this->Filter->Modified();
    this->Filter->Update();
    observed.ExpectWarning("1 points that belong to no triangle were dropped for the computation; "
                           "the output keeps the points and polygons of the input");
    this->ExpectTargetsWhereTheMapSays();
    vtkDataArray* map = this->Filter->GetOutput()->GetPointData()->GetArray("SpherePosition");
    double used[3], unused[3];
    map->GetTuple(77, used);
    map->GetTuple(map->GetNumberOfTuples() - 1, unused);
    EXPECT_LT(std::sqrt(vtkMath::Distance2BetweenPoints(used, unused)), 1e-6);
  }
}

TEST_F(SphericalRegistration, WritesTheSecondBestOfTwoEqualEnds)
{
  this->Filter->Update();
  EXPECT_EQ(this->Field("Ambiguous"), 0.0);
  EXPECT_EQ(this->Filter->GetOutput(1)->GetNumberOfPoints(), 0);
  // A turn by 180 degrees about z leaves this body as it is.
  vtkNew<vtkPolyData> twin;
  twin->DeepCopy(this->Fixed);
  for (vtkIdType i = 0; i < twin->GetNumberOfPoints(); ++i)
  {
    double n[3];
    twin->GetPointData()->GetArray("SpherePosition")->GetTuple(i, n);
    const double end = std::exp((std::abs(n[0]) * 0.9 + n[2] * 0.4 - 1.0) / 0.09);
    twin->GetPoints()->SetPoint(
      i, 1.6 * (1.0 + end) * n[0], 0.9 * (1.0 + end) * n[1], (1.0 + end) * n[2]);
  }
  this->Filter->SetInputData(twin);
  this->Filter->SetFixedData(twin);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_NE(observed.WarningMessage().find("two correspondences are about equally good"),
    std::string::npos);
  EXPECT_EQ(this->Field("Ambiguous"), 1.0);
  vtkPolyData* second = this->Filter->GetOutput(1);
  contract::ExpectSpherePosition(second);
  contract::ExpectArray(
    second->GetPointData(), "TargetCellId", VTK_ID_TYPE, 1, twin->GetNumberOfPoints());
  double products = 0.0;
  for (vtkIdType i = 0; i < twin->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    this->Filter->GetOutput()->GetPointData()->GetArray("SpherePosition")->GetTuple(i, p);
    second->GetPointData()->GetArray("SpherePosition")->GetTuple(i, q);
    products += p[0] * q[0];
  }
  EXPECT_LT(products, 0.0);
}

TEST_F(SphericalRegistration, LandmarksByIdsAndByPositionsAgree)
{
  const vtkIdType ids[] = { 0, 3, 500, 900 };
  for (const vtkIdType id : ids)
  {
    this->Filter->AddLandmark(id, id);
  }
  this->Filter->Update();
  EXPECT_LT(this->Field("LandmarkError"), 1e-6);
  vtkNew<vtkPolyData> byIds;
  byIds->DeepCopy(this->Filter->GetOutput());
  this->Filter->RemoveAllLandmarks();
  for (const vtkIdType id : ids)
  {
    double p[3];
    this->Fixed->GetPoint(id, p);
    this->Filter->AddLandmarkPosition(p[0] + 0.01, p[1], p[2], p[0], p[1] - 0.01, p[2]);
  }
  this->Filter->Update();
  for (vtkIdType i = 0; i < byIds->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(byIds->GetPointData()->GetArray("SpherePosition")->GetComponent(i, k),
        this->Filter->GetOutput()->GetPointData()->GetArray("SpherePosition")->GetComponent(i, k));
    }
  }
}

// The array alone leaves a turn about z undecided; with the shape it adds to the agreement.
TEST_F(SphericalRegistration, AgreesOnAnArray)
{
  this->Filter->AddFeature("Height", 1.0);
  this->Filter->Update();
  EXPECT_LT(this->MeanAngle(), 0.5);
  this->Filter->SetShapeWeight(0.0);
  this->Filter->Update();
  EXPECT_GT(this->Field("FeatureAgreement", 1), 0.98);
  EXPECT_EQ(this->Field("NumberOfFolds"), 0.0);
}

TEST_F(SphericalRegistration, LandmarksThatFoldGiveAWarning)
{
  vtkIdType count = 0;
  const vtkIdType* ids = nullptr;
  this->Fixed->GetCellPoints(200, count, ids);
  const vtkIdType a = ids[0], b = ids[1], c = ids[2];
  this->Filter->AddLandmark(a, b);
  this->Filter->AddLandmark(b, a);
  this->Filter->AddLandmark(c, c);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_NE(observed.WarningMessage().find("landmarks cannot be matched without folds of the map"),
    std::string::npos);
  EXPECT_EQ(this->Field("NumberOfFolds"), 0.0);
}

TEST_F(SphericalRegistration, RefusesWhatItCannotUse)
{
  this->Filter->AddLandmark(0, 100000);
  this->ExpectRefused("a landmark refers to point 100000 of the fixed surface");
  this->Filter->RemoveAllLandmarks();
  this->Filter->AddLandmark(4, 5);
  this->Filter->AddLandmark(4, 6);
  this->ExpectRefused("the point 4 of the moving surface is in two landmarks");
  this->Filter->RemoveAllLandmarks();
  this->Filter->AddFeature("Nothing", 1.0);
  this->ExpectRefused("every surface must have the feature \"Nothing\"");
  this->Filter->RemoveAllFeatures();
  this->Filter->AddFeature("Height", -1.0);
  this->ExpectRefused("must be finite and at least 0");
  this->Filter->RemoveAllFeatures();
  this->Filter->AddLandmarkPosition(0.0, 0.0, std::nan(""), 0.0, 0.0, 0.0);
  this->ExpectRefused("the position of a landmark is not finite");
  this->Filter->RemoveAllLandmarkPositions();
  this->Filter->AddLandmarkPosition(1000.0, 0.0, 0.0, 1000.0, 0.0, 0.0);
  this->ExpectRefused("of the moving surface, but must be closer than 5 % of the diagonal");
  this->Filter->RemoveAllLandmarkPositions();
  const double* point = this->Moving->GetPoint(0);
  this->Filter->AddLandmarkPosition(point[0], point[1], point[2], 1000.0, 0.0, 0.0);
  this->ExpectRefused("of the fixed surface, but must be closer than 5 % of the diagonal");
  this->Filter->RemoveAllLandmarkPositions();
  this->Filter->SetSpaceOfTransformsToMoebius();
  this->Filter->AddLandmark(4, 5);
  this->ExpectRefused("3 or more pairs of points are needed");
}

TEST_F(SphericalRegistration, RunsOnlyWhenModifiedAndPrints)
{
  this->Filter->SetSpaceOfTransformsToRotation();
  EXPECT_EQ(this->Filter->GetSpaceOfTransforms(), vtkSphericalRegistration::ROTATION);
  this->Filter->Update();
  const vtkMTimeType time = this->Filter->GetOutput()->GetMTime();
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetMTime(), time);
  this->Filter->AddFeature("Height", 1.0);
  EXPECT_EQ(this->Filter->GetNumberOfFeatures(), 1);
  this->Filter->Update();
  EXPECT_GT(this->Filter->GetOutput()->GetMTime(), time);
  std::ostringstream text;
  this->Filter->Print(text);
  EXPECT_NE(text.str().find("SpaceOfTransforms: Rotation"), std::string::npos);
}

TEST_F(SphericalRegistration, EmptyInputsGiveAWarningAndNothing)
{
  vtkNew<vtkPolyData> empty;
  this->Filter->SetFixedData(empty);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_NE(observed.WarningMessage().find("the fixed surface is empty"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}
