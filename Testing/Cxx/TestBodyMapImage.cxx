#include "vtkBodyMapImage.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkBodyMap.h"

#include "vtkCellLocator.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <cstring>
#include <vector>

namespace
{
const int All[] = { vtkBodyMapImage::EQUIRECTANGULAR, vtkBodyMapImage::LAMBERT_AZIMUTHAL,
  vtkBodyMapImage::MOLLWEIDE, vtkBodyMapImage::PEIRCE_QUINCUNCIAL };

vtkSmartPointer<vtkPolyData> Body(int frequency)
{
  vtkNew<vtkBodyMap> map;
  map->SetInputData(fixtures::TwoLobes(frequency));
  map->Update();
  vtkSmartPointer<vtkPolyData> body = map->GetOutput();
  body->GetPointData()->SetActiveScalars("Height");
  return body;
}
}

TEST(BodyMapImage, WritesTheContractsArrays)
{
  vtkNew<vtkBodyMapImage> filter;
  contract::Observed observed(filter);
  filter->SetInputData(Body(10));
  filter->SetImageSize(40, 20);
  filter->GeneratePositionsOn();
  filter->Update();
  observed.ExpectWarning("");
  vtkPointData* data = filter->GetOutput()->GetPointData();
  contract::ExpectArray(data, "Height", VTK_DOUBLE, 1, 800);
  EXPECT_STREQ(data->GetScalars()->GetName(), "Height");
  for (const char* name : { "OutsideMap", "OutsideSurface", "Graticule" })
  {
    contract::ExpectArray(data, name, VTK_UNSIGNED_CHAR, 1, 800);
  }
  contract::ExpectArray(data, "BodyPosition", VTK_DOUBLE, 3, 800);
  EXPECT_NEAR(filter->GetOutput()->GetOrigin()[0], -175.5, 1e-12);
  EXPECT_NEAR(filter->GetOutput()->GetSpacing()[1], 9.0, 1e-12);
  filter->SetGraticuleSpacing(0.0);
  filter->Update();
  EXPECT_FALSE(filter->GetOutput()->GetPointData()->HasArray("Graticule"));
}

// The promise: all of the surface is on the map. Where the map is none there is no surface either.
TEST(BodyMapImage, HasAllOfTheSurface)
{
  const auto body = Body(20);
  vtkDataArray* map = body->GetPointData()->GetArray("SpherePosition");
  for (const int projection : All)
  {
    vtkNew<vtkBodyMapImage> filter;
    filter->SetInputData(body);
    filter->SetProjection(projection);
    filter->SetImageSize(200, 100);
    filter->SetGraticuleSpacing(0.0);
    filter->GeneratePositionsOn();
    filter->Update();
    vtkPointData* data = filter->GetOutput()->GetPointData();
    for (vtkIdType i = 0; i < 20000; ++i)
    {
      EXPECT_EQ(
        data->GetArray("OutsideMap")->GetTuple1(i), data->GetArray("OutsideSurface")->GetTuple1(i));
    }
    // Every part of the surface is near some pixel's point.
    vtkNew<vtkPolyData> seen;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < 20000; ++i)
    {
      if (data->GetArray("OutsideMap")->GetTuple1(i) == 0.0)
      {
        cells->InsertNextCell(
          { points->InsertNextPoint(data->GetArray("BodyPosition")->GetTuple3(i)) });
      }
    }
    seen->SetPoints(points);
    seen->SetVerts(cells);
    vtkNew<vtkCellLocator> locator;
    locator->SetDataSet(seen);
    locator->BuildLocator();
    for (vtkIdType i = 0; i < map->GetNumberOfTuples(); ++i)
    {
      double p[3], q[3], square = 0.0;
      body->GetPoint(i, p);
      vtkIdType cell = 0;
      int part = 0;
      locator->FindClosestPoint(p, q, cell, part, square);
      EXPECT_LT(square, 0.15 * 0.15) << projection;
    }
  }
}

// A pixel's value is that of the point it shows, and its place is where that point is on the map.
TEST(BodyMapImage, ShowsWhereThePointIs)
{
  const auto body = Body(30);
  vtkNew<vtkDoubleArray> x;
  x->SetName("X");
  for (vtkIdType i = 0; i < body->GetNumberOfPoints(); ++i)
  {
    x->InsertNextValue(body->GetPoint(i)[0]);
  }
  body->GetPointData()->AddArray(x);
  vtkNew<vtkBodyMapImage> filter;
  filter->SetInputData(body);
  filter->SetArrayName("X");
  filter->SetImageSize(72, 36);
  filter->SetCentralLongitude(90.0);
  filter->GeneratePositionsOn();
  vtkNew<vtkBodyMap> map;
  map->SetInputData(fixtures::TwoLobes(30));
  for (const int projection : All)
  {
    filter->SetProjection(projection);
    filter->Update();
    vtkPointData* data = filter->GetOutput()->GetPointData();
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
    {
      EXPECT_NEAR(data->GetArray("X")->GetTuple1(i),
        data->GetArray("BodyPosition")->GetComponent(i, 0), 1e-12);
    }
  }
  filter->SetProjectionToEquirectangular();
  filter->Update();
  vtkImageData* image = filter->GetOutput();
  vtkNew<vtkPolyData> places;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    points->InsertNextPoint(p[0] + 90.0, p[1], 0.0);
  }
  places->SetPoints(points);
  map->SetPlacesData(places);
  map->Update();
  auto* placed = vtkPolyData::SafeDownCast(map->GetOutputDataObject(2));
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(placed->GetPoint(i)[c],
        image->GetPointData()->GetArray("BodyPosition")->GetComponent(i, c), 1e-9);
    }
  }
}

TEST(BodyMapImage, KeepsTheTypeOfWhatItDraws)
{
  const auto body = Body(8);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(body->GetNumberOfPoints());
  colors->Fill(77.0);
  body->GetPointData()->AddArray(colors);
  vtkNew<vtkBodyMapImage> filter;
  filter->SetInputData(body);
  filter->SetArrayName("Colors");
  filter->SetImageSize(20, 10);
  filter->Update();
  contract::ExpectArray(filter->GetOutput()->GetPointData(), "Colors", VTK_UNSIGNED_CHAR, 3, 200);
  EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Colors")->GetComponent(100, 1), 77.0);
}

TEST(BodyMapImage, InterpolatesLongitudesAcrossZero)
{
  vtkNew<vtkGeodesicSphereSource> sphere;
  sphere->SetFrequency(12);
  vtkNew<vtkBodyMap> body;
  body->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkBodyMapImage> map;
  map->SetInputConnection(body->GetOutputPort());
  map->SetArrayName("PlanetocentricLongitude");
  map->SetImageSize(360, 180);
  map->Update();
  double largest = 0.0;
  for (int j = 20; j < 160; ++j) // up to 70 degrees of latitude
  {
    for (int i = 0; i < 360; ++i)
    {
      const double drawn =
        map->GetOutput()->GetPointData()->GetScalars()->GetComponent(360 * j + i, 0);
      const double difference = drawn - (i + 0.5 - 180.0);
      largest = std::max(largest, std::abs(difference - 360.0 * std::round(difference / 360.0)));
    }
  }
  EXPECT_LT(largest, 2.0);
}

TEST(BodyMapImage, SaysWhatIsWrong)
{
  vtkNew<vtkBodyMapImage> filter;
  contract::Observed observed(filter);
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  observed.ExpectWarning("the surface is empty");
  observed.Clear();
  filter->SetInputData(Body(8));
  filter->SetArrayName("Nothing");
  filter->Update();
  observed.ExpectError("no point array Nothing to bake");
  observed.Clear();
  filter->SetArrayName("");
  filter->SetImageSize(0, 10);
  filter->Update();
  observed.ExpectError("ImageSize must be at least (1, 1)");
  observed.Clear();
  filter->SetImageSize(20, 10);
  filter->SetCentralLongitude(std::numeric_limits<double>::quiet_NaN());
  filter->Update();
  observed.ExpectError("CentralLongitude and GraticuleSpacing must be finite");
  observed.Clear();
  filter->SetCentralLongitude(0.0);
  const auto body = Body(8);
  body->GetPointData()->GetScalars()->SetName("OutsideMap");
  filter->SetInputData(body);
  filter->Update();
  observed.ExpectError("OutsideMap has the name of an array that the image gets; rename it");
}

TEST(BodyMapImage, GivesTheSameBitsOnAnyThreads)
{
  const auto body = Body(10);
  std::vector<double> before;
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkBodyMapImage> filter;
    filter->SetInputData(body);
    filter->SetProjectionToPeirceQuincuncial();
    filter->SetImageSize(100, 100);
    filter->Update();
    auto* array = vtkDoubleArray::SafeDownCast(filter->GetOutput()->GetPointData()->GetScalars());
    const std::vector<double> values(array->GetPointer(0), array->GetPointer(0) + 10000);
    EXPECT_TRUE(before.empty() || before == values);
    before = values;
  }
  vtkSMPTools::Initialize(0);
}

TEST(BodyMapImage, AbortLeavesNothing)
{
  vtkNew<vtkBodyMapImage> filter;
  filter->SetInputData(Body(30));
  filter->SetImageSize(600, 300);
  contract::ExpectStopsWhenAsked(filter);
}

TEST(BodyMapImage, RunsOnlyWhenModifiedAndPrints)
{
  vtkNew<vtkBodyMapImage> filter;
  filter->SetInputData(Body(8));
  filter->SetImageSize(20, 10);
  contract::ExpectRunsOnlyWhenModified(filter, [&]() { filter->SetCentralLongitude(90.0); });
  for (const char* name : { "ArrayName", "Projection", "CentralLongitude", "ImageSize",
         "GraticuleSpacing", "GeneratePositions" })
  {
    contract::ExpectPrints(filter, name);
  }
}
