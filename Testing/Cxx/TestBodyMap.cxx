#include "vtkBodyMap.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalDistortion.h"
#include "vtkGlobalConformalMap.h"

#include "vtkCellData.h"
#include "vtkCellLocator.h"
#include "vtkFieldData.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
double Number(vtkPolyData* surface, const char* name, vtkIdType id)
{
  return surface->GetPointData()->GetArray(name)->GetTuple1(id);
}

vtkNew<vtkPolyData> Places(vtkPolyData* surface)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(Number(surface, "Longitude", i), Number(surface, "Latitude", i), 0.0);
  }
  vtkNew<vtkPolyData> places;
  places->SetPoints(points);
  return places;
}

/// A unit sphere around the origin, with its map.
vtkNew<vtkPolyData> Sphere(int frequency)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  return surface;
}
}

TEST(BodyMap, WritesTheContractsArrays)
{
  const auto surface = fixtures::TwoLobes(12);
  vtkNew<vtkBodyMap> filter;
  contract::Observed observed(filter);
  filter->SetInputData(surface);
  vtkNew<vtkPolyData> places;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-20.0, 45.0, 0.0);
  places->SetPoints(points);
  filter->SetPlacesData(places);
  filter->Update();
  observed.ExpectWarning("");
  vtkPolyData* output = filter->GetOutput();
  const vtkIdType size = surface->GetNumberOfPoints();
  contract::ExpectSpherePosition(output);
  for (const char* name : { "Longitude", "Latitude", "Height", "Slope" })
  {
    contract::ExpectArray(output->GetPointData(), name, VTK_DOUBLE, 1, size);
  }
  for (const char* name :
    { "BodyNorthPole", "BodySouthPole", "BodyMarker", "ReferenceCenter", "ReferenceRadii" })
  {
    contract::ExpectArray(output->GetFieldData(), name, VTK_DOUBLE, 3, 1);
  }
  contract::ExpectArray(output->GetFieldData(), "ReferenceAxes", VTK_DOUBLE, 9, 1);
  auto* lines = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(lines->GetNumberOfLines(), 24 + 11);
  contract::ExpectArray(lines->GetCellData(), "IsMeridian", VTK_ID_TYPE, 1, 35);
  contract::ExpectArray(lines->GetCellData(), "Degrees", VTK_DOUBLE, 1, 35);
  EXPECT_EQ(vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2))->GetNumberOfPoints(), 1);
  EXPECT_FALSE(surface->GetPointData()->HasArray("Longitude"));
}

// On a sphere that is its own map they are what everybody calls so.
TEST(BodyMap, KnowsTheSphere)
{
  const auto sphere = Sphere(12);
  vtkNew<vtkBodyMap> filter;
  filter->SetInputData(sphere);
  filter->SetReferenceToSphere();
  filter->Update();
  const double degree = vtkMath::Pi() / 180.0;
  for (vtkIdType i = 0; i < sphere->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sphere->GetPoint(i, p);
    const double longitude = Number(filter->GetOutput(), "Longitude", i) * degree,
                 latitude = Number(filter->GetOutput(), "Latitude", i) * degree;
    EXPECT_GE(longitude, 0.0);
    EXPECT_NEAR(std::cos(latitude) * std::cos(longitude), p[0], 1e-7);
    EXPECT_NEAR(std::cos(latitude) * std::sin(longitude), p[1], 1e-7);
    EXPECT_NEAR(std::sin(latitude), p[2], 1e-7);
    EXPECT_NEAR(Number(filter->GetOutput(), "Height", i), 0.0, 0.01);
    EXPECT_LT(Number(filter->GetOutput(), "Slope", i), 2.0);
  }
}

// The promise: to the map and back.
TEST(BodyMap, ComesBackToTheBody)
{
  const auto surface = fixtures::TwoLobes(40);
  vtkNew<vtkBodyMap> filter;
  filter->SetInputData(surface);
  filter->SetRotationAxis(0.2, -0.1, 3.0);
  filter->SetMarkerPoint(1.0, 2.0, 0.5);
  filter->UseMarkerPointOn();
  filter->Update();
  const auto places = Places(filter->GetOutput());
  filter->SetPlacesData(places);
  filter->Update();
  auto* back = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2));
  ASSERT_EQ(back->GetNumberOfPoints(), surface->GetNumberOfPoints());
  double worst = 0.0;
  for (vtkIdType i = 0; i < back->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    back->GetPoint(i, p);
    surface->GetPoint(i, q);
    worst = std::max(worst, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  EXPECT_LT(worst, 1e-9);
}

// A conformal map stays one; a body of two lobes has a mean quasi-conformal error of its mesh only.
TEST(BodyMap, KeepsAConformalMap)
{
  const auto surface = fixtures::TwoLobes(60);
  vtkNew<vtkGlobalConformalMap> map;
  map->SetInputData(surface);
  vtkNew<vtkBodyMap> filter;
  filter->SetInputConnection(map->GetOutputPort());
  vtkNew<vtkConformalDistortion> distortion;
  distortion->SetInputConnection(filter->GetOutputPort());
  distortion->Update();
  vtkFieldData* data = distortion->GetOutput()->GetFieldData();
  EXPECT_LT(data->GetArray("MeanQuasiConformalError")->GetTuple1(0), 1.02);
  EXPECT_EQ(data->GetArray("NumberOfFlippedTriangles")->GetTuple1(0), 0);
}

TEST(BodyMap, DrawsLinesOnTheSurface)
{
  vtkNew<vtkBodyMap> filter;
  filter->SetInputData(fixtures::TwoLobes(20));
  filter->SetGraticuleSpacing(30.0);
  filter->Update();
  auto* lines = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  EXPECT_EQ(lines->GetNumberOfLines(), 12 + 5);
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(filter->GetOutput());
  locator->BuildLocator();
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3], square = 0.0;
    lines->GetPoint(i, p);
    vtkIdType cell = 0;
    int part = 0;
    locator->FindClosestPoint(p, q, cell, part, square);
    EXPECT_LT(square, 1e-20);
  }
}

TEST(BodyMap, SaysWhatIsWrong)
{
  vtkNew<vtkBodyMap> filter;
  contract::Observed observed(filter);
  const auto expect = [&](const char* text)
  {
    filter->Update();
    observed.ExpectError(text);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    observed.Clear();
  };
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  observed.ExpectWarning("the surface is empty");
  observed.Clear();

  const auto surface = fixtures::TwoLobes(8);
  filter->SetInputData(surface);
  filter->SetCenter(0.0, 0.0, 100.0);
  expect("the rotation axis does not intersect the surface to the north of Center");
  filter->SetCenter(0.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  expect("must be finite");
  filter->SetCenter(0.0, 0.0, 0.0);
  filter->SetRotationAxis(0.0, 0.0, 0.0);
  expect("RotationAxis not zero");
  filter->SetRotationAxis(0.0, 0.0, 1e-300);
  vtkNew<vtkPolyData> places;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 91.0, 0.0);
  places->SetPoints(points);
  filter->SetPlacesData(places);
  expect("place 0 must have a finite longitude as x and a latitude in [-90, 90] as y");
  filter->SetPlacesData(nullptr);
  vtkDataArray* map = surface->GetPointData()->GetArray("SpherePosition");
  const double* other = map->GetTuple3(40);
  map->SetTuple3(41, other[0], -other[1], -other[2]);
  filter->Modified();
  surface->Modified();
  filter->Update();
  observed.ExpectWarning(
    "folded triangles: some longitudes and latitudes belong to several points");
  observed.Clear();
  surface->GetPointData()->RemoveArray("SpherePosition");
  expect("the surface has no point array SpherePosition");
  const auto broken = fixtures::TwoLobes(8);
  broken->GetPoints()->SetPoint(0, 0.0, std::numeric_limits<double>::infinity(), 0.0);
  filter->SetInputData(broken);
  expect("some points of the surface are not finite");
}

TEST(BodyMap, MeasuresHeightsWhereTrianglesAreReversed)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(8);
  source->Update();
  vtkNew<vtkPolyData> sphere;
  sphere->DeepCopy(source->GetOutput());
  vtkNew<vtkCellArray> polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfCells(); ++cell)
  {
    sphere->GetCellPoints(cell, ids);
    const bool isReversed = cell < 50;
    polygons->InsertNextCell(
      { ids->GetId(0), ids->GetId(isReversed ? 2 : 1), ids->GetId(isReversed ? 1 : 2) });
  }
  sphere->SetPolys(polygons);
  vtkNew<vtkBodyMap> filter;
  filter->SetInputData(sphere);
  const contract::Observed seen(filter);
  filter->Update();
  seen.ExpectWarning("50 triangles were reversed");
  vtkDataArray* heights = filter->GetOutput()->GetPointData()->GetArray("Height");
  ASSERT_NE(heights, nullptr);
  EXPECT_LT(heights->GetRange()[1] - heights->GetRange()[0], 0.01);
  EXPECT_LT(filter->GetOutput()->GetPointData()->GetArray("Slope")->GetRange()[1], 5.0);
}

TEST(BodyMap, AbortLeavesNothing)
{
  vtkNew<vtkBodyMap> filter;
  filter->SetInputData(fixtures::TwoLobes(30));
  contract::ExpectStopsWhenAsked(filter);
}

TEST(BodyMap, RunsOnlyWhenModifiedAndPrints)
{
  vtkNew<vtkBodyMap> filter;
  filter->SetInputData(fixtures::TwoLobes(8));
  contract::ExpectRunsOnlyWhenModified(filter, [&]() { filter->SetCenter(0.1, 0.0, 0.0); });
  for (const char* name :
    { "Center", "RotationAxis", "UseMarkerPoint", "MarkerPoint", "Reference", "GraticuleSpacing" })
  {
    contract::ExpectPrints(filter, name);
  }
}
