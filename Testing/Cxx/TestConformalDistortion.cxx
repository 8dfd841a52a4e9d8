#include "vtkConformalDistortion.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <limits>

namespace
{
const char* const CellArrays[] = { "AngleDistortion", "AreaDistortion", "QuasiConformalError" };
const char* const Figures[] = { "MeanAngleDistortion", "MeanQuasiConformalError",
  "AreaDistortionDeviation", "SphereDegree" };
const char* const Counts[] = { "NumberOfFlippedTriangles", "NumberOfZeroAreaTriangles" };

class ConformalDistortion : public testing::Test
{
protected:
  void SetUp() override
  {
    vtkNew<vtkGeodesicSphereSource> source;
    source->SetFrequency(4);
    source->Update();
    this->Surface->DeepCopy(source->GetOutput());
    this->Filter->SetInputData(this->Surface);
  }
  double Figure(const char* name)
  {
    return this->Filter->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
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
  vtkNew<vtkConformalDistortion> Filter;
};
}

TEST_F(ConformalDistortion, WritesTheContractsArrays)
{
  this->Filter->Update();
  vtkPolyData* output = this->Filter->GetOutput();
  for (const char* name : CellArrays)
  {
    contract::ExpectArray(output->GetCellData(), name, VTK_DOUBLE, 1, output->GetNumberOfCells());
  }
  for (const char* name : Figures)
  {
    contract::ExpectArray(output->GetFieldData(), name, VTK_DOUBLE, 1, 1);
  }
  for (const char* name : Counts)
  {
    contract::ExpectArray(output->GetFieldData(), name, VTK_ID_TYPE, 1, 1);
  }
  EXPECT_NEAR(this->Figure("SphereDegree"), 1.0, 1e-12);
  EXPECT_NEAR(this->Figure("MeanAngleDistortion"), 0.0, 1e-10);
  EXPECT_EQ(this->Figure("NumberOfFlippedTriangles"), 0);
  EXPECT_EQ(this->Surface->GetCellData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(this->Surface->GetFieldData()->GetNumberOfArrays(), 0);
}

// A surface twice as high: equatorial angles change, and only the geometry is to blame.
TEST_F(ConformalDistortion, SeesAStretchedSurface)
{
  vtkPoints* points = this->Surface->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* n = this->SpherePosition()->GetTuple3(i);
    points->SetPoint(i, n[0], n[1], 2.0 * n[2]);
  }
  this->Filter->Update();
  EXPECT_GT(this->Figure("MeanQuasiConformalError"), 1.3);
  EXPECT_LT(this->Figure("MeanQuasiConformalError"), 2.0);
  const double* range = this->Filter->GetOutput()->GetCellData()->GetArray(2)->GetRange();
  EXPECT_GE(range[0], 1.0);
  EXPECT_LE(range[1], 2.0 + 1e-9);
}

// Values belong to cells as VTK counts them; those of polygons are means.
TEST_F(ConformalDistortion, KnowsVerticesLinesAndQuads)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(1, 1, 0);
  points->InsertNextPoint(0, 1, 0);
  vtkNew<vtkCellArray> vertices, polygons;
  vertices->InsertNextCell({ 0 });
  polygons->InsertNextCell({ 0, 1, 2, 3 });
  polygons->InsertNextCell({ 0, 1, 2 });
  polygons->InsertNextCell({ 0, 2, 3 });
  polygons->InsertNextCell({ 0, 1, 3 });
  polygons->InsertNextCell({ 1, 2, 3 });
  vtkNew<vtkDoubleArray> positions;
  positions->SetName("SpherePosition");
  positions->SetNumberOfComponents(3);
  positions->InsertNextTuple3(1, 0, 0);
  positions->InsertNextTuple3(0, 1, 0);
  positions->InsertNextTuple3(0, 0, 2); // any length
  positions->InsertNextTuple3(0, -1, 0.5);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetVerts(vertices);
  surface->SetPolys(polygons);
  surface->GetPointData()->AddArray(positions);
  this->Filter->SetInputData(surface);
  this->Filter->Update();
  vtkDataArray* angles = this->Filter->GetOutput()->GetCellData()->GetArray("AngleDistortion");
  vtkDataArray* errors = this->Filter->GetOutput()->GetCellData()->GetArray("QuasiConformalError");
  EXPECT_EQ(angles->GetTuple1(0), 0.0);
  EXPECT_EQ(errors->GetTuple1(0), 1.0);
  EXPECT_NEAR(angles->GetTuple1(2), 20.0, 1e-9);
  // The quad was cut along one of its diagonals.
  const double along02 = 0.5 * (angles->GetTuple1(2) + angles->GetTuple1(3));
  const double along13 = 0.5 * (angles->GetTuple1(4) + angles->GetTuple1(5));
  ASSERT_GT(std::abs(along02 - along13), 1.0);
  EXPECT_LT(
    std::min(std::abs(angles->GetTuple1(1) - along02), std::abs(angles->GetTuple1(1) - along13)),
    1e-9);
}

TEST_F(ConformalDistortion, WarnsOfAnEmptySurface)
{
  contract::Observed observed(this->Filter);
  vtkNew<vtkPolyData> nothing;
  this->Filter->SetInputData(nothing);
  this->Filter->Update();
  EXPECT_TRUE(observed.Warning());
  EXPECT_FALSE(observed.Error());
}

TEST_F(ConformalDistortion, RefusesSurfacesWithoutASphereMap)
{
  vtkNew<vtkDoubleArray> odd;
  odd->SetName("SpherePosition");
  odd->SetNumberOfComponents(2);
  odd->SetNumberOfTuples(this->Surface->GetNumberOfPoints());
  odd->Fill(0.0);
  this->Surface->GetPointData()->AddArray(odd);
  this->ExpectError("has 2 components instead of 3");
  this->Surface->GetPointData()->Initialize();
  this->ExpectError("no point array SpherePosition");
}

TEST_F(ConformalDistortion, RefusesSpherePositionsWithoutADirection)
{
  this->SpherePosition()->SetTuple3(3, 0, 0, 0);
  this->SpherePosition()->SetTuple3(4, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  this->ExpectError("2 of 162 vectors of SpherePosition are zero or not finite");
}

TEST_F(ConformalDistortion, RefusesCoordinatesThatAreNotFinite)
{
  this->Surface->GetPoints()->SetPoint(0, 0, 0, std::numeric_limits<double>::infinity());
  this->ExpectError("not finite");
}

TEST_F(ConformalDistortion, RunsOnlyWhenModified)
{
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Surface->Modified(); });
}
