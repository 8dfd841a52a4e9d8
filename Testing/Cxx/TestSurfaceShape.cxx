#include "vtkSurfaceShape.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkPoints.h"
#include "vtkReverseSense.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
const char* const Arrays[] = { "MeanCurvature", "GaussianCurvature", "SulcalDepth" };

/// A sphere with its map, of this radius, away from the origin.
vtkNew<vtkPolyData> Ball(double radius)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(24);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPointData()->GetArray("SpherePosition")->GetTuple(i, p);
    surface->GetPoints()->SetPoint(i, radius * p[0] + 10.0, radius * p[1] - 5.0, radius * p[2]);
  }
  return surface;
}

void ExpectError(vtkPolyData* surface, const char* text)
{
  vtkNew<vtkSurfaceShape> filter;
  contract::Observed observed(filter);
  filter->SetInputData(surface);
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find(text), std::string::npos) << observed.ErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}
}

TEST(SurfaceShape, WritesTheContractsArrays)
{
  const auto surface = fixtures::TwoLobes(12);
  vtkNew<vtkSurfaceShape> filter;
  EXPECT_EQ(filter->GetCurvatureScale(), 0.01);
  EXPECT_EQ(filter->GetDepthScale(), 0.03);
  filter->SetInputData(surface);
  contract::Observed observed(filter);
  filter->Update();
  EXPECT_FALSE(observed.Error() || observed.Warning());
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), surface->GetPoints());
  EXPECT_EQ(output->GetPolys(), surface->GetPolys());
  contract::ExpectSpherePosition(output);
  for (const char* name : Arrays)
  {
    contract::ExpectArray(output->GetPointData(), name, VTK_DOUBLE, 1, output->GetNumberOfPoints());
    EXPECT_FALSE(surface->GetPointData()->HasArray(name));
  }
  // The waist between the lobes is the one saddle, and the deepest place.
  double depths[2], curvatures[2];
  output->GetPointData()->GetArray("SulcalDepth")->GetRange(depths);
  output->GetPointData()->GetArray("GaussianCurvature")->GetRange(curvatures);
  EXPECT_LT(depths[0], 0.0);
  EXPECT_GT(depths[1], 0.0);
  EXPECT_LT(curvatures[0], 0.0);
}

TEST(SurfaceShape, ABallOfRadiusRHasTheCurvature1ByR)
{
  constexpr double radius = 80.0; // as a brain's, in millimeters
  for (const bool isInsideOut : { false, true })
  {
    const auto surface = Ball(radius);
    vtkNew<vtkReverseSense> turned;
    turned->SetInputData(surface);
    turned->Update();
    vtkNew<vtkSurfaceShape> filter;
    filter->SetInputData(isInsideOut ? turned->GetOutput() : surface.Get());
    filter->Update();
    vtkPointData* data = filter->GetOutput()->GetPointData();
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      ASSERT_NEAR(radius * data->GetArray("MeanCurvature")->GetTuple1(i), 1.0, 1e-3);
      ASSERT_NEAR(radius * radius * data->GetArray("GaussianCurvature")->GetTuple1(i), 1.0, 1e-3);
      ASSERT_NEAR(data->GetArray("SulcalDepth")->GetTuple1(i), 0.0, 1e-4 * radius);
    }
  }
}

// An ellipsoid's largest mean curvature is (a / b^2 + a / c^2) / 2, at the end of its longest axis.
TEST(SurfaceShape, TheScaleSmooths)
{
  const auto surface = Ball(1.0);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPointData()->GetArray("SpherePosition")->GetTuple(i, p);
    surface->GetPoints()->SetPoint(i, 2.0 * p[0], p[1], p[2]);
  }
  double before = 2.05;
  for (const double scale : { 0.01, 0.05, 0.2, 1.0 })
  {
    vtkNew<vtkSurfaceShape> filter;
    filter->SetInputData(surface);
    filter->SetCurvatureScale(scale);
    filter->Update();
    double range[2];
    filter->GetOutput()->GetPointData()->GetArray("MeanCurvature")->GetRange(range);
    EXPECT_LT(range[1], before);
    if (scale == 0.01)
    {
      EXPECT_GT(range[1], 1.9);
    }
    before = range[1];
  }
  EXPECT_LT(before, 1.1);
}

// Without cells that share points: as an STL file.
TEST(SurfaceShape, RepairsWhatCanBeRepaired)
{
  const auto surface = Ball(2.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfPolys(); ++cell)
  {
    surface->GetPolys()->GetCellAtId(cell, ids);
    triangles->InsertNextCell(3);
    for (const vtkIdType id : *ids)
    {
      triangles->InsertCellPoint(points->InsertNextPoint(surface->GetPoint(id)));
    }
  }
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(points);
  soup->SetPolys(triangles);
  vtkNew<vtkSurfaceShape> filter;
  contract::Observed observed(filter);
  filter->SetInputData(soup);
  filter->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_FALSE(observed.Error());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), surface->GetNumberOfPoints());
  double range[2];
  filter->GetOutput()->GetPointData()->GetArray("MeanCurvature")->GetRange(range);
  EXPECT_NEAR(range[0], 0.5, 1e-3);
  EXPECT_NEAR(range[1], 0.5, 1e-3);
}

TEST(SurfaceShape, SaysWhatIsWrong)
{
  const auto open = Ball(1.0);
  vtkNew<vtkCellArray> all;
  for (vtkIdType cell = 1; cell < open->GetNumberOfPolys(); ++cell)
  {
    vtkNew<vtkIdList> ids;
    open->GetPolys()->GetCellAtId(cell, ids);
    all->InsertNextCell(ids);
  }
  open->SetPolys(all);
  ExpectError(open, "boundary");
  const auto broken = Ball(1.0);
  broken->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  ExpectError(broken, "finite");
  vtkNew<vtkSurfaceShape> filter;
  contract::Observed observed(filter);
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_FALSE(observed.Error());
  filter->SetInputData(Ball(1.0));
  filter->SetCurvatureScale(std::numeric_limits<double>::quiet_NaN());
  filter->Update();
  EXPECT_NE(observed.ErrorMessage().find("CurvatureScale is out of its range"), std::string::npos)
    << observed.ErrorMessage();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(SurfaceShape, AbortLeavesNothing)
{
  vtkNew<vtkSurfaceShape> filter;
  filter->SetInputData(Ball(1.0));
  contract::ExpectStopsWhenAsked(filter);
}

TEST(SurfaceShape, RunsOnlyWhenModifiedAndPrints)
{
  vtkNew<vtkSurfaceShape> filter;
  filter->SetInputData(Ball(1.0));
  contract::ExpectRunsOnlyWhenModified(filter, [&]() { filter->SetDepthScale(0.2); });
  contract::ExpectPrints(filter, "CurvatureScale");
  contract::ExpectPrints(filter, "DepthScale");
}
