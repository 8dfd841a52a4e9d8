#include "vtkSurfaceGeodesics.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkCellData.h"
#include "vtkConeSource.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>
#include <string>

namespace
{
vtkDoubleArray* DistancesOf(vtkSurfaceGeodesics* filter)
{
  return vtkDoubleArray::SafeDownCast(
    filter->GetOutput()->GetPointData()->GetArray("GeodesicDistance"));
}

vtkIdTypeArray* NearestOf(vtkSurfaceGeodesics* filter)
{
  return vtkIdTypeArray::SafeDownCast(
    filter->GetOutput()->GetPointData()->GetArray("NearestSource"));
}

// An open square of 41 by 41 points.
vtkNew<vtkPlaneSource> Square()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(40, 40);
  plane->Update();
  return plane;
}

void ExpectError(vtkSurfaceGeodesics* filter, const std::string& text)
{
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find(text), std::string::npos) << observed.ErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetSources()->GetNumberOfPoints(), 0);
}
}

TEST(SurfaceGeodesics, MeasuresDistancesOnAnOpenSquare)
{
  const auto plane = Square();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-0.51, -0.52, 0.3); // near corner 0
  points->InsertNextPoint(-0.5, -0.5, 0.0);   // the same corner
  points->InsertNextPoint(0.5, 0.5, 0.0);     // the opposite corner
  vtkNew<vtkPolyData> picked;
  picked->SetPoints(points);
  vtkNew<vtkSurfaceGeodesics> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  filter->SetSourcesData(picked);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  ASSERT_EQ(filter->GetSources()->GetNumberOfPoints(), 2);
  EXPECT_EQ(filter->GetSources()->GetNumberOfVerts(), 2);
  vtkDoubleArray* distances = DistancesOf(filter);
  vtkIdTypeArray* nearest = NearestOf(filter);
  EXPECT_EQ(distances->GetValue(0), 0.0);
  EXPECT_NEAR(distances->GetValue(40), 1.0, 0.03);
  EXPECT_EQ(nearest->GetValue(1), 0);
  EXPECT_EQ(nearest->GetValue(1679), 1680);
  double sum = 0.0;
  for (vtkIdType i = 0; i < 1681; ++i)
  {
    double p[3];
    filter->GetOutput()->GetPoint(i, p);
    const double exact =
      std::min(std::hypot(p[0] + 0.5, p[1] + 0.5), std::hypot(p[0] - 0.5, p[1] - 0.5));
    sum += std::abs(distances->GetValue(i) - exact);
  }
  EXPECT_LT(sum / 1681.0, 0.01);
}

TEST(SurfaceGeodesics, AddsSourcesByIdsArrayAndDistance)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(12);
  source->Update();
  vtkNew<vtkPolyData> sphere;
  sphere->ShallowCopy(source->GetOutput());
  vtkNew<vtkDoubleArray> mask;
  mask->SetName("Mask");
  mask->SetNumberOfValues(sphere->GetNumberOfPoints());
  mask->Fill(0.0);
  mask->SetValue(9, 2.0);
  mask->SetValue(11, std::nan(""));
  sphere->GetPointData()->AddArray(mask);
  vtkNew<vtkSurfaceGeodesics> filter;
  filter->SetInputData(sphere);
  filter->AddSourceId(4);
  filter->AddSourceId(4);
  filter->SetSourceArrayName("Mask");
  filter->SetNumberOfFarthestPoints(3);
  filter->Update();
  vtkPolyData* sources = filter->GetSources();
  auto* ids = vtkIdTypeArray::SafeDownCast(sources->GetPointData()->GetArray("SourceId"));
  ASSERT_NE(ids, nullptr);
  ASSERT_EQ(ids->GetNumberOfValues(), 5);
  EXPECT_EQ(ids->GetValue(0), 4);
  EXPECT_EQ(ids->GetValue(1), 9);
  for (vtkIdType i = 0; i < 5; ++i)
  {
    EXPECT_EQ(DistancesOf(filter)->GetValue(ids->GetValue(i)), 0.0);
    EXPECT_EQ(NearestOf(filter)->GetValue(ids->GetValue(i)), ids->GetValue(i));
  }
  EXPECT_LT(DistancesOf(filter)->GetRange()[1], 1.8);
}

TEST(SurfaceGeodesics, FindsPaths)
{
  const auto plane = Square();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, -0.2, 0.0);
  points->InsertNextPoint(-0.5, -0.5, 0.0); // the source
  vtkNew<vtkPolyData> starts;
  starts->SetPoints(points);
  vtkNew<vtkSurfaceGeodesics> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  filter->SetTargetsData(starts);
  filter->AddSourceId(0);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  vtkPolyData* paths = filter->GetPaths();
  ASSERT_EQ(paths->GetNumberOfLines(), 1); // no path from the source to itself
  vtkCellData* data = paths->GetCellData();
  EXPECT_NEAR(data->GetArray("PathLength")->GetComponent(0, 0), std::hypot(1.0, 0.3), 1e-6);
  EXPECT_EQ(data->GetArray("SourceId")->GetComponent(0, 0), 0.0);
  EXPECT_EQ(data->GetArray("TargetId")->GetComponent(0, 0), 12 * 41 + 40);
  EXPECT_GT(paths->GetNumberOfPoints(), 40);
}

// On an open square, distances are lengths of straight lines.
TEST(SurfaceGeodesics, MeasuresExactDistances)
{
  const auto plane = Square();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.5, -0.2, 0.0);
  vtkNew<vtkPolyData> starts;
  starts->SetPoints(points);
  vtkNew<vtkSurfaceGeodesics> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  filter->SetTargetsData(starts);
  filter->AddSourceId(0);
  filter->SetMethodToExact();
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  for (vtkIdType i = 0; i < 1681; ++i)
  {
    double p[3];
    filter->GetOutput()->GetPoint(i, p);
    EXPECT_NEAR(DistancesOf(filter)->GetValue(i), std::hypot(p[0] + 0.5, p[1] + 0.5), 1e-7);
    EXPECT_EQ(NearestOf(filter)->GetValue(i), 0);
  }
  vtkPolyData* paths = filter->GetPaths();
  ASSERT_EQ(paths->GetNumberOfLines(), 1);
  vtkCellData* data = paths->GetCellData();
  EXPECT_NEAR(data->GetArray("PathLength")->GetComponent(0, 0), std::hypot(1.0, 0.3), 1e-7);
  EXPECT_EQ(data->GetArray("TargetId")->GetComponent(0, 0), 12 * 41 + 40);
}

// A corner of 1,000 thin triangles.
TEST(SurfaceGeodesics, AdvisesExactDistancesIfTheHeatMethodFails)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(1000);
  cone->SetHeight(3.0);
  cone->CappingOff();
  vtkNew<vtkSurfaceGeodesics> filter;
  filter->SetInputConnection(cone->GetOutputPort());
  filter->AddSourceId(0);
  ExpectError(filter, "set Method to EXACT");
  filter->SetMethodToExact();
  filter->SetNumberOfFarthestPoints(1);
  ExpectError(filter, "set NumberOfFarthestPoints to 0");
  filter->SetNumberOfFarthestPoints(0);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_NEAR(DistancesOf(filter)->GetValue(1), std::hypot(3.0, 0.5), 1e-6);
}

TEST(SurfaceGeodesics, ReportsMissingAndInvalidSources)
{
  const auto plane = Square();
  vtkNew<vtkSurfaceGeodesics> filter;
  filter->SetInputConnection(plane->GetOutputPort());
  ExpectError(filter, "there are no sources");
  filter->AddSourceId(1681);
  ExpectError(filter, "source 1681 is not the id of a point");
  filter->RemoveAllSourceIds();
  filter->SetSourceArrayName("Missing");
  ExpectError(filter, "no point array Missing");
  filter->SetSourceArrayName("");
  filter->SetNumberOfFarthestPoints(1);
  filter->Update();
  EXPECT_EQ(filter->GetSources()->GetNumberOfPoints(), 1);
}
