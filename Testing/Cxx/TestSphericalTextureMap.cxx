#include "vtkSphericalTextureMap.h"

#include "FilterContract.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkOBJReader.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>

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

// Triangles that show the image backwards, or show some of it where it does not reach.
vtkIdType CountBackwards(vtkPolyData* surface)
{
  vtkDataArray* coordinates = surface->GetPointData()->GetTCoords();
  vtkDataArray* outside = surface->GetPointData()->GetArray("OutsideImage");
  vtkIdType backwards = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    double st[3][2];
    int hidden = 0;
    for (int k = 0; k < 3; ++k)
    {
      coordinates->GetTuple(ids->GetId(k), st[k]);
      hidden += outside->GetTuple1(ids->GetId(k)) != 0.0;
    }
    const double area =
      (st[1][0] - st[0][0]) * (st[2][1] - st[0][1]) - (st[1][1] - st[0][1]) * (st[2][0] - st[0][0]);
    backwards += hidden < 3 ? !(area > 0.0) : area != 0.0;
  }
  return backwards;
}

// Triangles whose texture positions are in clockwise order.
vtkIdType CountFlipped(vtkPolyData* surface)
{
  vtkDataArray* positions = surface->GetPointData()->GetArray("TexturePosition");
  vtkIdType flipped = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    double corners[3][3];
    for (int k = 0; k < 3; ++k)
    {
      positions->GetTuple(ids->GetId(k), corners[k]);
    }
    flipped += vtkMath::Determinant3x3(corners) < 0.0;
  }
  return flipped;
}
}

TEST_F(SphericalTextureMap, HasTheDocumentedDefaults)
{
  EXPECT_EQ(this->Filter->GetViewDirection()[2], 1.0);
  EXPECT_EQ(this->Filter->GetViewUp()[1], 1.0);
  EXPECT_EQ(this->Filter->GetFieldOfView(), 180.0);
  EXPECT_EQ(this->Filter->GetProjection(), vtkSphericalTextureMap::STEREOGRAPHIC);
  EXPECT_EQ(this->Filter->GetWrap(), vtkSphericalTextureMap::CLAMP);
  EXPECT_FALSE(this->Filter->GetSplitSeam());
  EXPECT_FALSE(this->Filter->GetUseViewPoint());
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
  for (const char* name : { "TextureFieldOfView", "TextureMargin" })
  {
    contract::ExpectArray(output->GetFieldData(), name, VTK_DOUBLE, 1, 1);
  }
  contract::ExpectArray(output->GetFieldData(), "TextureProjection", VTK_ID_TYPE, 1, 1);
  contract::ExpectArray(output->GetFieldData(), "TextureScale", VTK_DOUBLE, 2, 1);
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

TEST_F(SphericalTextureMap, PutsThePoleAtAPickedPoint)
{
  this->Filter->UseViewPointOn();
  this->Filter->SetViewPoint(2, 0, 0);
  this->Filter->Update();
  vtkFieldData* data = this->Filter->GetOutput()->GetFieldData();
  EXPECT_NEAR(data->GetArray("SpherePole")->GetComponent(0, 0), 1.0, 1e-3);
  EXPECT_NEAR(data->GetArray("SphereUp")->GetComponent(0, 1), 1.0, 2e-2);
}

TEST_F(SphericalTextureMap, SplitsSeamsAndKeepsOriginalIds)
{
  const vtkIdType size = this->Surface->GetNumberOfPoints();
  vtkNew<vtkDoubleArray> height;
  height->SetName("Height");
  vtkNew<vtkIdTypeArray> number;
  number->SetName("Number");
  for (vtkIdType i = 0; i < size; ++i)
  {
    height->InsertNextValue(this->Surface->GetPoint(i)[2]);
  }
  for (vtkIdType i = 0; i < this->Surface->GetNumberOfCells(); ++i)
  {
    number->InsertNextValue(i);
  }
  this->Surface->GetPointData()->AddArray(height);
  this->Surface->GetCellData()->AddArray(number);
  this->Filter->SplitSeamOn();
  for (int projection = 0; projection < 4; ++projection)
  {
    this->Filter->SetProjection(projection);
    this->Filter->Update();
    vtkPolyData* output = this->Filter->GetOutput();
    const vtkIdType points = output->GetNumberOfPoints(), cells = output->GetNumberOfCells();
    EXPECT_GT(points, size);
    EXPECT_EQ(CountBackwards(output), 0);
    contract::ExpectSpherePosition(output);
    contract::ExpectArray(output->GetPointData(), "Normals", VTK_DOUBLE, 3, points);
    contract::ExpectArray(output->GetPointData(), "Texture Coordinates", VTK_FLOAT, 2, points);
    contract::ExpectArray(output->GetPointData(), "OutsideImage", VTK_UNSIGNED_CHAR, 1, points);
    contract::ExpectArray(output->GetPointData(), "OriginalPointIds", VTK_ID_TYPE, 1, points);
    contract::ExpectArray(output->GetCellData(), "OriginalCellIds", VTK_ID_TYPE, 1, cells);
    contract::ExpectArray(output->GetPointData(), "Height", VTK_DOUBLE, 1, points);
    vtkIdType copies = 0;
    for (vtkIdType i = 0; i < points; ++i)
    {
      const auto id =
        static_cast<vtkIdType>(output->GetPointData()->GetArray("OriginalPointIds")->GetTuple1(i));
      ASSERT_LT(id, size);
      if (i < size)
      {
        ASSERT_EQ(id, i);
      }
      copies += i >= size && id >= 0;
      double position[3];
      output->GetPoint(i, position);
      for (int c = 0; id >= 0 && c < 3; ++c)
      {
        ASSERT_EQ(position[c], this->Surface->GetPoint(id)[c]);
      }
      ASSERT_NEAR( // data follow the point
        output->GetPointData()->GetArray("Height")->GetTuple1(i), position[2], 1e-12);
    }
    EXPECT_GT(copies, 0);
    for (vtkIdType i = 0; i < cells; ++i)
    {
      ASSERT_EQ(output->GetCellData()->GetArray("Number")->GetTuple1(i),
        output->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(i));
    }
  }
}

// Floats as input and cells that are no triangles.
TEST_F(SphericalTextureMap, SplitsWhateverItsInputIsMadeOf)
{
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(this->Surface->GetPoints());
  this->Surface->SetPoints(floats);
  vtkNew<vtkCellArray> verts;
  verts->InsertNextCell({ 0 });
  this->Surface->SetVerts(verts);
  this->Filter->SplitSeamOn();
  this->Filter->SetProjection(vtkSphericalTextureMap::CUBE_MAP);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfVerts(), 0);
  EXPECT_EQ(
    this->Filter->GetOutput()->GetCellData()->GetArray("OriginalCellIds")->GetRange()[0], 1.0);
  EXPECT_EQ(CountBackwards(this->Filter->GetOutput()), 0);
}

// On surfaces of 64,002 points vtkTextureMapToSphere shows 481 triangles backwards.
TEST_F(SphericalTextureMap, NoTriangleOfAScanShowsTheImageBackwards)
{
  const std::string folder = CONFORMALSOM_SCAN_DIR;
  if (!std::filesystem::exists(folder + "/igea.ply") ||
    !std::filesystem::exists(folder + "/stanford-bunny.obj"))
  {
    GTEST_SKIP() << "no igea.ply and stanford-bunny.obj in " << folder;
  }
  vtkNew<vtkConformalPLYReader> igea;
  igea->SetFileName((folder + "/igea.ply").c_str());
  vtkNew<vtkOBJReader> bunny;
  bunny->SetFileName((folder + "/stanford-bunny.obj").c_str());
  for (vtkAlgorithm* reader :
    { static_cast<vtkAlgorithm*>(igea), static_cast<vtkAlgorithm*>(bunny) })
  {
    vtkNew<vtkConformalSOM> network;
    network->SetInputConnection(reader->GetOutputPort());
    vtkNew<vtkCurvedSeamlessSurface> surface;
    surface->SetInputConnection(network->GetOutputPort());
    surface->Update();
    ASSERT_EQ(surface->GetOutput()->GetNumberOfPoints(), 116642);
    this->Filter->SetInputConnection(surface->GetOutputPort());
    for (int projection = 0; projection < 4; ++projection)
    {
      this->Filter->SetProjection(projection);
      this->Filter->SplitSeamOff();
      this->Filter->Update();
      EXPECT_GT(CountBackwards(this->Filter->GetOutput()), projection == 0 ? 0 : 400);
      this->Filter->SplitSeamOn();
      this->Filter->Update();
      EXPECT_EQ(CountBackwards(this->Filter->GetOutput()), 0) << projection;
    }
  }
}

// A limb of a thousand radii has no balanced map that is one to one.
TEST_F(SphericalTextureMap, ReportsTrianglesThatABalancedMapFlips)
{
  for (const auto& [length, power] : { std::pair(20.0, 60.0), std::pair(1000.0, 30.0) })
  {
    vtkNew<vtkGeodesicSphereSource> source;
    source->SetFrequency(20);
    source->Update();
    vtkNew<vtkPolyData> limb;
    limb->DeepCopy(source->GetOutput());
    for (vtkIdType v = 0; v < limb->GetNumberOfPoints(); ++v)
    {
      double x[3];
      limb->GetPoint(v, x);
      x[2] += length * std::pow(std::max(x[2], 0.0), power);
      limb->GetPoints()->SetPoint(v, x);
    }
    this->Filter->SetInputData(limb);
    this->Filter->SetAreaBalance(0.5);
    contract::Observed observed(this->Filter);
    this->Filter->Update();
    const vtkIdType flipped = CountFlipped(this->Filter->GetOutput());
    EXPECT_EQ(flipped > 0, length > 100.0);
    EXPECT_EQ(observed.WarningMessage().find(std::to_string(flipped) +
                " of 8000 triangles show the image backwards") != std::string::npos,
      flipped > 0)
      << observed.WarningMessage();
  }
}

TEST_F(SphericalTextureMap, LeavesTheInputAlone)
{
  this->Filter->SplitSeamOn();
  this->Filter->Update();
  this->Filter->SplitSeamOff();
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
  this->Filter->SetFieldOfView(180);
  this->Filter->SetRotation(std::numeric_limits<double>::infinity());
  this->ExpectError("Rotation must be finite");
  this->Filter->SetRotation(0);
  this->Filter->SetScale(1, 0);
  this->ExpectError("Scale must lie between");
  this->Filter->SetScale(1, 1);
  this->Filter->SetMargin(std::numeric_limits<double>::quiet_NaN());
  this->ExpectError("Margin must lie between");
  this->Filter->SetMargin(0);
  this->Filter->UseViewPointOn();
  this->Filter->SetViewPoint(0, std::numeric_limits<double>::quiet_NaN(), 0);
  this->ExpectError("ViewPoint must be finite");
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
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetRotation(7); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SplitSeamOn(); });
  for (const char* property : { "ViewDirection", "ViewUp", "UseViewPoint", "ViewPoint",
         "Projection", "FieldOfView", "Rotation", "Scale", "Wrap", "SplitSeam", "Margin" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
}

TEST_F(SphericalTextureMap, StopsWhenAsked)
{
  this->Filter->SplitSeamOn();
  contract::ExpectStopsWhenAsked(this->Filter);
}
