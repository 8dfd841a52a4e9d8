#include "vtkSphericalTextureImage.h"

#include "FilterContract.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkSphericalTextureMap.h"

#include "vtkCell.h"
#include "vtkCellLocator.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace
{
// Gives every point a color by its place, changing over a twentieth of the surface's extent.
void Color(vtkPolyData* surface)
{
  double bounds[6];
  surface->GetBounds(bounds);
  const double length =
    std::max({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* p = surface->GetPoint(i);
    double rgb[3];
    for (int c = 0; c < 3; ++c)
    {
      rgb[c] = std::round(127.5 + 110.0 * std::sin(20.0 * p[c] / length + p[(c + 1) % 3] / length));
    }
    colors->InsertNextTuple(rgb);
  }
  surface->GetPointData()->SetScalars(colors);
}

// What a renderer that mixes the four nearest pixels shows at (s, t).
double Sampled(vtkImageData* image, const double* st, int component)
{
  int size[3];
  image->GetDimensions(size);
  vtkDataArray* pixels = image->GetPointData()->GetScalars();
  const double x = std::clamp(st[0] * size[0] - 0.5, 0.0, size[0] - 1.0);
  const double y = std::clamp(st[1] * size[1] - 0.5, 0.0, size[1] - 1.0);
  const auto i = static_cast<vtkIdType>(std::min(std::floor(x), size[0] - 2.0));
  const auto j = static_cast<vtkIdType>(std::min(std::floor(y), size[1] - 2.0));
  const auto at = [&](vtkIdType column, vtkIdType row)
  { return pixels->GetComponent(row * size[0] + column, component); };
  const double u = x - i, v = y - j;
  return (1 - v) * ((1 - u) * at(i, j) + u * at(i + 1, j)) +
    v * ((1 - u) * at(i, j + 1) + u * at(i + 1, j + 1));
}

// The mean difference between the colors of points and what a textured surface shows where it is
// closest to them.
double MeanDifference(vtkPolyData* points, vtkPolyData* textured, vtkImageData* image)
{
  vtkNew<vtkCellLocator> locator;
  locator->SetDataSet(textured);
  locator->BuildLocator();
  vtkDataArray* colors = points->GetPointData()->GetScalars();
  vtkDataArray* coordinates = textured->GetPointData()->GetTCoords();
  vtkNew<vtkGenericCell> cell;
  double sum = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double closest[3], square, parametric[3], weights[3];
    vtkIdType cellId = -1;
    int subId = 0;
    locator->FindClosestPoint(points->GetPoint(i), closest, cell, cellId, subId, square);
    cell->EvaluatePosition(closest, nullptr, subId, parametric, square, weights);
    double st[2] = { 0.0, 0.0 };
    for (int k = 0; k < 3; ++k)
    {
      st[0] += weights[k] * coordinates->GetComponent(cell->GetPointId(k), 0);
      st[1] += weights[k] * coordinates->GetComponent(cell->GetPointId(k), 1);
    }
    for (int c = 0; c < 3; ++c)
    {
      sum += std::abs(Sampled(image, st, c) - colors->GetComponent(i, c));
    }
  }
  return sum / (3.0 * points->GetNumberOfPoints());
}

class SphericalTextureImage : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkGeodesicSphereSource> source;
    source->SetFrequency(24);
    source->Update();
    this->Surface->DeepCopy(source->GetOutput());
    Color(this->Surface);
    this->Map->SetInputData(this->Surface);
    this->Map->SplitSeamOn();
    this->Map->SetProjection(vtkSphericalTextureMap::OCTAHEDRAL);
    this->Map->SetMargin(0.01);
    this->Filter->SetInputConnection(this->Map->GetOutputPort());
    this->Filter->SetImageSize(300, 200);
  }
  void ExpectError(const std::string& text)
  {
    contract::Observed observed(this->Filter);
    this->Filter->Modified();
    this->Filter->Update();
    EXPECT_NE(observed.ErrorMessage().find(text), std::string::npos) << observed.ErrorMessage();
    EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetNumberOfArrays(), 0);
  }

  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkSphericalTextureMap> Map;
  vtkNew<vtkSphericalTextureImage> Filter;
};
}

TEST_F(SphericalTextureImage, WritesTheContractsArrays)
{
  this->Filter->Update();
  vtkImageData* image = this->Filter->GetOutput();
  EXPECT_EQ(image->GetNumberOfPoints(), 300 * 200);
  contract::ExpectArray(image->GetPointData(), "Colors", VTK_UNSIGNED_CHAR, 3, 300 * 200);
  contract::ExpectArray(image->GetPointData(), "OutsideSurface", VTK_UNSIGNED_CHAR, 1, 300 * 200);
  EXPECT_EQ(image->GetPointData()->GetScalars(), image->GetPointData()->GetArray("Colors"));
  EXPECT_EQ(image->GetPointData()->GetArray("OutsideSurface")->GetRange()[1], 0.0);
  EXPECT_DOUBLE_EQ(image->GetPoint(0)[0], 0.5 / 300);
  EXPECT_NEAR(image->GetPoint(300 * 200 - 1)[1], 1.0 - 0.5 / 200, 1e-12);
}

// On the unit sphere a pixel's position is its direction.
TEST_F(SphericalTextureImage, BakesAnyArrayInAnyProjection)
{
  this->Filter->SetArrayName("SpherePosition");
  for (int projection = 0; projection < 4; ++projection)
  {
    this->Map->SetProjection(projection);
    this->Filter->Update();
    vtkImageData* image = this->Filter->GetOutput();
    contract::ExpectArray(image->GetPointData(), "SpherePosition", VTK_DOUBLE, 3, 300 * 200);
    vtkPolyData* mapped = this->Map->GetOutput();
    vtkDataArray* outside = mapped->GetPointData()->GetArray("OutsideImage");
    for (vtkIdType i = 0; i < mapped->GetNumberOfPoints(); ++i)
    {
      if (outside->GetTuple1(i) != 0.0)
      {
        continue;
      }
      const double* st = mapped->GetPointData()->GetTCoords()->GetTuple2(i);
      const double s[2] = { st[0], st[1] };
      for (int c = 0; c < 3; ++c)
      {
        ASSERT_NEAR(Sampled(image, s, c), mapped->GetPoint(i)[c],
          projection == vtkSphericalTextureMap::OCTAHEDRAL ? 0.012 : 0.05);
      }
    }
  }
}

TEST_F(SphericalTextureImage, PutBackItLooksAsBefore)
{
  this->Map->SetMargin(0.01);
  this->Filter->SetImageSize(768, 512);
  for (int projection : { 1, 2, 3 })
  {
    this->Map->SetProjection(projection);
    this->Filter->Update();
    EXPECT_LT(MeanDifference(this->Surface, this->Map->GetOutput(), this->Filter->GetOutput()), 1.0)
      << projection;
  }
}

// A scan's own colors, of which the learned surface knows nothing.
TEST_F(SphericalTextureImage, KeepsTheColorsOfAScan)
{
  const std::string path = std::string(CONFORMALSOM_SCAN_DIR) + "/igea.ply";
  if (!std::filesystem::exists(path))
  {
    GTEST_SKIP() << "no " << path;
  }
  vtkNew<vtkConformalPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* scan = reader->GetOutput();
  Color(scan);
  vtkNew<vtkConformalSOM> network;
  network->SetInputData(scan);
  vtkNew<vtkCurvedSeamlessSurface> surface;
  surface->SetInputConnection(network->GetOutputPort());
  this->Map->SetInputConnection(surface->GetOutputPort());
  this->Filter->SetSourceData(scan);
  this->Filter->SetImageSize(1024, 1024);
  this->Filter->Update();
  EXPECT_LT(MeanDifference(scan, this->Map->GetOutput(), this->Filter->GetOutput()), 1.0);
}

TEST_F(SphericalTextureImage, TakesValuesFromPointsWithoutTriangles)
{
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(this->Surface->GetPoints());
  Color(cloud);
  this->Filter->SetSourceData(cloud);
  this->Map->SetProjection(vtkSphericalTextureMap::LONGITUDE_LATITUDE);
  this->Filter->SetImageSize(1024, 512);
  this->Filter->Update();
  // Every pixel has the color of some point; the mean of neighbors is none of them.
  EXPECT_LT(MeanDifference(this->Surface, this->Map->GetOutput(), this->Filter->GetOutput()), 2.0);
}

TEST_F(SphericalTextureImage, LeavesItsInputsAlone)
{
  this->Map->Update();
  const vtkMTimeType before = this->Map->GetOutput()->GetMTime();
  this->Filter->Update();
  EXPECT_EQ(this->Map->GetOutput()->GetMTime(), before);
}

TEST_F(SphericalTextureImage, RefusesWhatItCannotBake)
{
  this->Filter->SetArrayName("nothing");
  this->ExpectError("no point array nothing to bake");
  this->Filter->SetArrayName("");
  this->Surface->GetPointData()->SetActiveScalars(nullptr);
  this->Surface->Modified();
  this->ExpectError("the source has no active scalars to bake; set ArrayName");
  this->Surface->GetPointData()->SetActiveScalars("Colors");
  this->Filter->SetInputData(this->Surface);
  this->ExpectError("no field data SpherePole of vtkSphericalTextureMap");
  this->Filter->SetInputConnection(this->Map->GetOutputPort());
  vtkNew<vtkPolyData> nobody;
  Color(nobody);
  this->Filter->SetInputDataObject(1, nobody);
  this->ExpectError("the source has no points");
  this->Filter->SetInputDataObject(1, nullptr);
  this->Filter->SetImageSize(0, 7);
  contract::Observed observed(this->Filter);
  this->Filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("ImageSize"), std::string::npos);
}

TEST_F(SphericalTextureImage, WarnsOfAnEmptySurface)
{
  contract::Observed observed(this->Filter);
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetInputData(nothing);
  this->Filter->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_FALSE(observed.Error());
}

TEST_F(SphericalTextureImage, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetArrayName("Normals"); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetImageSize(9, 8); });
  contract::ExpectPrints(this->Filter, "ArrayName");
  contract::ExpectPrints(this->Filter, "ImageSize");
}

TEST_F(SphericalTextureImage, StopsWhenAsked)
{
  contract::ExpectStopsWhenAsked(this->Filter);
}
