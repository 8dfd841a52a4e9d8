#include "vtkTorusTextureMap.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkGlobalConformalMap.h"

#include "vtkCellData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
class TorusTextureMap : public testing::Test
{
protected:
  TorusTextureMap()
  {
    vtkNew<vtkGlobalConformalMap> map;
    map->SetInputData(fixtures::Torus(0.5, 40, 24));
    map->Update();
    this->Surface->DeepCopy(map->GetOutput());
    vtkNew<vtkDoubleArray> marks;
    marks->SetName("Marks");
    for (vtkIdType i = 0; i < this->Surface->GetNumberOfPolys(); ++i)
    {
      marks->InsertNextValue(static_cast<double>(i));
    }
    this->Surface->GetCellData()->AddArray(marks);
    this->Filter->SetInputData(this->Surface);
  }

  vtkPolyData* Run()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  void ExpectRefused(const std::string& why)
  {
    this->Seen.Clear();
    this->Filter->Modified();
    EXPECT_EQ(this->Run()->GetNumberOfPoints(), 0);
    this->Seen.ExpectError(why);
  }

  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkTorusTextureMap> Filter;
  contract::Observed Seen{ this->Filter };
};
}

TEST_F(TorusTextureMap, WritesItsArrays)
{
  vtkPolyData* output = this->Run();
  this->Seen.ExpectWarning("");
  const vtkIdType points = output->GetNumberOfPoints(), cells = output->GetNumberOfCells();
  EXPECT_GT(points, 960);
  EXPECT_EQ(cells, 1920);
  contract::ExpectArray(output->GetPointData(), "Texture Coordinates", VTK_FLOAT, 2, points);
  EXPECT_EQ(
    output->GetPointData()->GetTCoords(), output->GetPointData()->GetArray("Texture Coordinates"));
  contract::ExpectArray(output->GetPointData(), "OriginalPointIds", VTK_ID_TYPE, 1, points);
  contract::ExpectArray(output->GetPointData(), "TorusPosition", VTK_DOUBLE, 2, points);
  contract::ExpectArray(output->GetCellData(), "OriginalCellIds", VTK_ID_TYPE, 1, cells);
  contract::ExpectArray(output->GetFieldData(), "TorusModulus", VTK_DOUBLE, 2, 1);
  for (vtkIdType i = 0; i < cells; ++i)
  {
    EXPECT_EQ(output->GetCellData()->GetArray("OriginalCellIds")->GetTuple1(i), i);
    EXPECT_EQ(output->GetCellData()->GetArray("Marks")->GetTuple1(i), i);
  }
}

// Triangles keep their corners, and their texture coordinates are close together and differ from
// the positions on the torus by whole numbers.
TEST_F(TorusTextureMap, IsContinuousInEachTriangle)
{
  this->Filter->SetRepeats(3, 5);
  vtkPolyData* output = this->Run();
  vtkDataArray *coordinates = output->GetPointData()->GetTCoords(),
               *ids = output->GetPointData()->GetArray("OriginalPointIds"),
               *map = this->Surface->GetPointData()->GetArray("TorusPosition");
  vtkNew<vtkIdList> corners;
  double area = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i)
  {
    output->GetCellPoints(i, corners);
    double st[3][2];
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType id = corners->GetId(k), original = static_cast<vtkIdType>(ids->GetTuple1(id));
      coordinates->GetTuple(id, st[k]);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_EQ(output->GetPoint(id)[c], this->Surface->GetPoint(original)[c]);
      }
      for (int c = 0; c < 2; ++c)
      {
        const double whole = st[k][c] / (c == 0 ? 3.0 : 5.0) - map->GetComponent(original, c);
        EXPECT_NEAR(whole, std::round(whole), 1e-6);
        EXPECT_LT(std::abs(st[k][c] - st[0][c]), 0.5);
      }
    }
    area += 0.5 *
      ((st[1][0] - st[0][0]) * (st[2][1] - st[0][1]) -
        (st[2][0] - st[0][0]) * (st[1][1] - st[0][1]));
  }
  EXPECT_NEAR(area, 15.0, 1e-4);
}

TEST_F(TorusTextureMap, RefusesWhatItCannotUse)
{
  this->Filter->SetRepeats(0, 1);
  this->ExpectRefused("must be repeated at least once");
  this->Filter->SetRepeats(1, 1);
  auto* map =
    vtkDoubleArray::SafeDownCast(this->Surface->GetPointData()->GetArray("TorusPosition"));
  const double before = map->GetComponent(7, 1);
  map->SetComponent(7, 1, std::numeric_limits<double>::quiet_NaN());
  this->ExpectRefused("1 of 960 positions of TorusPosition are not finite");
  map->SetComponent(7, 1, before);
  std::fill_n(map->GetPointer(0), map->GetNumberOfValues(), 0.25);
  this->ExpectRefused("the triangles cover the torus 0.000000 times instead of once");
  vtkNew<vtkDoubleArray> wide;
  wide->SetName("TorusPosition");
  wide->SetNumberOfComponents(3);
  wide->SetNumberOfTuples(960);
  wide->Fill(0.0);
  this->Surface->GetPointData()->AddArray(wide);
  this->ExpectRefused("TorusPosition must have 2 components, not 3");
  wide->SetNumberOfTuples(959);
  this->ExpectRefused("the point array \"TorusPosition\"");
  this->Surface->GetPointData()->RemoveArray("TorusPosition");
  this->ExpectRefused("the surface has no point array TorusPosition; vtkGlobalConformalMap");
}

TEST_F(TorusTextureMap, WarnsOfAnEmptySurface)
{
  vtkNew<vtkPolyData> empty;
  this->Filter->SetInputData(empty);
  EXPECT_EQ(this->Run()->GetNumberOfPoints(), 0);
  this->Seen.ExpectWarning("the surface is empty");
}

TEST_F(TorusTextureMap, RunsOnlyWhenModifiedAndPrints)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetRepeats(2, 3); });
  contract::ExpectPrints(this->Filter, "Repeats");
  const vtkMTimeType before = this->Surface->GetMTime();
  this->Run();
  EXPECT_EQ(this->Surface->GetMTime(), before);
}
