#include "vtkSphericalAlignment.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkGlobalConformalMap.h"
#include "vtkSphericalTextureMap.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkTransform.h"

#include <cmath>
#include <limits>
#include <string>

namespace
{
class SphericalAlignment : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkGeodesicSphereSource> source;
    source->SetFrequency(8);
    source->Update();
    this->Reference->DeepCopy(source->GetOutput());
    for (vtkIdType i = 0; i < this->Reference->GetNumberOfPoints(); ++i)
    {
      const double* n = source->GetOutput()->GetPoint(i);
      this->Reference->GetPoints()->SetPoint(i, 3.0 * n[0], 2.0 * n[1], n[2]);
    }
    this->Surface->DeepCopy(this->Reference);
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetReferenceData(this->Reference);
  }
  static vtkDataArray* MapOf(vtkPolyData* surface)
  {
    return surface->GetPointData()->GetArray("SpherePosition");
  }
  /// Turn the surface's map, as another program might have.
  void Turn(vtkTransform* turn)
  {
    for (vtkIdType i = 0; i < this->Surface->GetNumberOfPoints(); ++i)
    {
      double n[3];
      turn->TransformVector(MapOf(this->Reference)->GetTuple3(i), n);
      MapOf(this->Surface)->SetTuple(i, n);
    }
    this->Surface->Modified();
  }
  /// Draw all of the map to one side by a conformal map of the sphere: a zoom of the plane.
  void Zoom(double factor)
  {
    for (vtkIdType i = 0; i < this->Surface->GetNumberOfPoints(); ++i)
    {
      const double* n = MapOf(this->Reference)->GetTuple3(i);
      const double x = factor * n[0], y = factor * n[1], below = 1.0 - n[2];
      const double square = x * x + y * y;
      const double sum = square + below * below;
      if (sum > 0.0)
      {
        MapOf(this->Surface)
          ->SetTuple3(
            i, 2.0 * x * below / sum, 2.0 * y * below / sum, (square - below * below) / sum);
      }
    }
    this->Surface->Modified();
  }
  double MaximumDifference()
  {
    double largest = 0.0;
    for (vtkIdType i = 0; i < this->Surface->GetNumberOfPoints(); ++i)
    {
      double p[3], q[3];
      MapOf(this->Filter->GetOutput())->GetTuple(i, p);
      MapOf(this->Reference)->GetTuple(i, q);
      largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
    }
    return largest;
  }
  double Error()
  {
    return this->Filter->GetOutput()->GetFieldData()->GetArray("AlignmentError")->GetTuple1(0);
  }
  void ExpectRefused(const std::string& why)
  {
    contract::Observed observed(this->Filter);
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_NE(observed.ErrorMessage().find(why), std::string::npos) << observed.ErrorMessage();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkPolyData> Surface, Reference;
  vtkNew<vtkSphericalAlignment> Filter;
};
}

TEST_F(SphericalAlignment, WritesTheContractsArrays)
{
  EXPECT_EQ(this->Filter->GetTransform(), vtkSphericalAlignment::ROTATION);
  this->Filter->Update();
  vtkPolyData* output = this->Filter->GetOutput();
  contract::ExpectSpherePosition(output);
  contract::ExpectArray(output->GetFieldData(), "AlignmentError", VTK_DOUBLE, 1, 1);
  contract::ExpectArray(output->GetFieldData(), "AlignmentCenter", VTK_DOUBLE, 3, 1);
  contract::ExpectArray(output->GetFieldData(), "AlignmentRotation", VTK_DOUBLE, 9, 1);
  EXPECT_EQ(output->GetPoints(), this->Surface->GetPoints());
  EXPECT_LT(this->Error(), 1e-12);
  EXPECT_LT(this->MaximumDifference(), 1e-12);
}

TEST_F(SphericalAlignment, RemovesTexturePositionsOfTheEarlierMap)
{
  vtkNew<vtkSphericalTextureMap> texture;
  texture->SetInputData(this->Surface);
  texture->SetAreaBalance(0.5);
  this->Filter->SetInputConnection(texture->GetOutputPort());
  this->Filter->Update();
  ASSERT_TRUE(texture->GetOutput()->GetPointData()->HasArray("TexturePosition"));
  EXPECT_FALSE(this->Filter->GetOutput()->GetPointData()->HasArray("TexturePosition"));
  EXPECT_FALSE(this->Filter->GetOutput()->GetFieldData()->HasArray("TextureAreaBalance"));
}

TEST_F(SphericalAlignment, TurnsTheMapBackByTheSurfaces)
{
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(130.0, 1.0, -2.0, 0.5);
  this->Turn(turn);
  this->Filter->Update();
  EXPECT_LT(this->MaximumDifference(), 1e-9);
  EXPECT_LT(this->Error(), 1e-9);
  // Row by row, it is the inverse of what was done.
  turn->Inverse();
  const double* rotation =
    this->Filter->GetOutput()->GetFieldData()->GetArray("AlignmentRotation")->GetTuple(0);
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_NEAR(rotation[i], turn->GetMatrix()->GetElement(i / 3, i % 3), 1e-9);
  }
}

TEST_F(SphericalAlignment, TurnsTheMapBackByLandmarks)
{
  vtkNew<vtkTransform> turn;
  turn->RotateWXYZ(-70.0, 0.0, 1.0, 0.5);
  this->Turn(turn);
  this->Filter->AddLandmark(5, 5);
  this->Filter->AddLandmark(200, 200);
  EXPECT_EQ(this->Filter->GetNumberOfLandmarks(), 2);
  this->Filter->Update();
  EXPECT_LT(this->MaximumDifference(), 1e-9);
  this->Filter->RemoveAllLandmarks();
  EXPECT_EQ(this->Filter->GetNumberOfLandmarks(), 0);
}

TEST_F(SphericalAlignment, OnlyAMoebiusTransformUndoesAZoom)
{
  this->Zoom(3.0);
  this->Filter->Update();
  EXPECT_GT(this->Error(), 0.3);
  this->Filter->SetTransformToMoebius();
  this->Filter->Update();
  EXPECT_LT(this->Error(), 1e-7);
  EXPECT_LT(this->MaximumDifference(), 1e-6);
  const double* center =
    this->Filter->GetOutput()->GetFieldData()->GetArray("AlignmentCenter")->GetTuple3(0);
  EXPECT_NEAR(vtkMath::Norm(center), 0.5, 1e-6); // (3 - 1) / (3 + 1)
}

TEST_F(SphericalAlignment, ThreeLandmarksFixAMoebiusTransform)
{
  this->Zoom(3.0);
  this->Filter->SetTransformToMoebius();
  for (vtkIdType id : { 7, 300, 511 })
  {
    this->Filter->AddLandmark(id, id);
  }
  this->Filter->Update();
  EXPECT_LT(this->Error(), 1e-7);
  EXPECT_LT(this->MaximumDifference(), 1e-5);
}

// Two meshes of one surface, each mapped conformally, agree after a Moebius transform.
TEST_F(SphericalAlignment, MapsOfOneSurfaceAgree)
{
  vtkNew<vtkGeodesicSphereSource> finer;
  finer->SetFrequency(21);
  finer->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(finer->GetOutput());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* n = finer->GetOutput()->GetPoint(i);
    surface->GetPoints()->SetPoint(i, 3.0 * n[0], 2.0 * n[1], n[2]);
  }
  vtkNew<vtkGlobalConformalMap> map, reference;
  map->SetInputData(surface);
  reference->SetInputData(this->Reference);
  this->Filter->SetInputConnection(map->GetOutputPort());
  this->Filter->SetReferenceConnection(reference->GetOutputPort());
  this->Filter->SetTransformToMoebius();
  this->Filter->Update();
  EXPECT_LT(this->Error(), 0.02);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), surface->GetNumberOfPoints());
}

TEST_F(SphericalAlignment, LeavesItsInputsAlone)
{
  this->Zoom(2.0);
  const double before = MapOf(this->Surface)->GetComponent(17, 2);
  const vtkMTimeType time = this->Reference->GetMTime();
  this->Filter->SetTransformToMoebius();
  this->Filter->Update();
  EXPECT_EQ(MapOf(this->Surface)->GetComponent(17, 2), before);
  EXPECT_EQ(this->Surface->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(this->Reference->GetMTime(), time);
}

TEST_F(SphericalAlignment, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetTransformToMoebius(); });
  contract::ExpectRunsOnlyWhenModified(this->Filter,
    [&]()
    {
      for (vtkIdType id : { 1, 2, 3 })
      {
        this->Filter->AddLandmark(id, id);
      }
    });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->RemoveAllLandmarks(); });
  contract::ExpectPrints(this->Filter, "Transform");
  contract::ExpectPrints(this->Filter, "NumberOfLandmarks");
  this->Filter->SetTransform(5);
  EXPECT_EQ(this->Filter->GetTransform(), vtkSphericalAlignment::MOEBIUS);
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(SphericalAlignment, EmptyInputsGiveAWarningAndNothing)
{
  contract::Observed observed(this->Filter);
  this->Filter->SetReferenceData(vtkNew<vtkPolyData>());
  this->Filter->Update();
  EXPECT_NE(observed.WarningMessage().find("the reference is empty"), std::string::npos);
  observed.Clear();
  this->Filter->SetInputData(vtkNew<vtkPolyData>());
  this->Filter->Update();
  EXPECT_NE(observed.WarningMessage().find("the surface is empty"), std::string::npos);
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(SphericalAlignment, WithoutAReferenceTheExecutiveComplains)
{
  contract::Observed observed(this->Filter);
  this->Filter->SetInputDataObject(1, nullptr);
  this->Filter->Update();
  EXPECT_TRUE(observed.ExecutiveError());
}

TEST_F(SphericalAlignment, SurfacesWithoutAMapAreRefused)
{
  this->Reference->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused("no point array SpherePosition");
  this->SetUp();
  MapOf(this->Surface)->SetTuple3(9, 0.0, 0.0, 0.0);
  this->ExpectRefused("zero or not finite");
}

// The map of a sheet is the hemisphere z >= 0, here with the rounding of floats.
TEST_F(SphericalAlignment, SheetsAreRefused)
{
  vtkNew<vtkPolyData> sheet;
  sheet->DeepCopy(this->Surface);
  vtkDataArray* map = sheet->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
  {
    map->SetComponent(i, 2, std::abs(map->GetComponent(i, 2)) - 5e-8);
  }
  this->Filter->SetInputData(sheet);
  this->ExpectRefused("the map of the surface covers only the hemisphere");
  this->Filter->SetInputData(this->Surface);
  this->Filter->SetReferenceData(sheet);
  this->ExpectRefused("the map of the reference covers only the hemisphere");
}

TEST_F(SphericalAlignment, LandmarksThatAreNotThereAreRefused)
{
  this->Filter->AddLandmark(0, 0);
  this->Filter->AddLandmark(3, 642);
  this->ExpectRefused("landmark 1 refers to the points 3 and 642 of 642 and 642");
  this->Filter->RemoveAllLandmarks();
  this->Filter->AddLandmark(-1, 2);
  this->ExpectRefused("landmark 0 refers to the points -1 and 2");
}

TEST_F(SphericalAlignment, TooFewLandmarksAreRefused)
{
  this->Filter->AddLandmark(0, 0);
  this->ExpectRefused("2 or more pairs of points are needed to determine a rotation, not 1");
  this->Filter->AddLandmark(1, 1);
  this->Filter->SetTransformToMoebius();
  this->ExpectRefused(
    "3 or more pairs of points are needed to determine a Moebius transform, not 2");
}

TEST_F(SphericalAlignment, WithoutLandmarksSurfacesNeedTrianglesAndFinitePoints)
{
  this->Reference->GetPoints()->SetPoint(0, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  this->ExpectRefused("some points are not finite");
  this->Reference->SetPolys(vtkNew<vtkCellArray>());
  this->ExpectRefused(
    "without landmarks both surfaces must have triangles; add landmarks or triangles");
}
