#include "vtkGenusZeroCheck.h"

#include "FilterContract.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkStripper.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

namespace
{
const char* const Figures[] = { "IsGenusZero", "EulerNumber", "NumberOfBoundaryEdges",
  "NumberOfBoundaryLoops", "NumberOfNonManifoldEdges", "NumberOfNonManifoldVertices",
  "NumberOfComponents", "NumberOfInconsistentEdges", "NumberOfDegenerateTriangles",
  "NumberOfIsolatedPoints", "NumberOfNonFinitePoints", "IsInsideOut" };

vtkIdType Figure(vtkGenusZeroCheck* check, const char* name)
{
  vtkDataArray* array = check->GetOutput()->GetFieldData()->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? static_cast<vtkIdType>(array->GetTuple1(0)) : -1;
}

std::string Words(vtkGenusZeroCheck* check)
{
  auto* lines = vtkStringArray::SafeDownCast(
    check->GetOutput()->GetFieldData()->GetAbstractArray("GenusZeroReport"));
  EXPECT_NE(lines, nullptr);
  std::string all;
  for (vtkIdType i = 0; lines && i < lines->GetNumberOfValues(); ++i)
  {
    all += lines->GetValue(i) + "\n";
  }
  return all;
}

vtkNew<vtkPolyData> SphereWithout(vtkIdType cell)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(3);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  surface->BuildLinks();
  surface->DeleteCell(cell);
  surface->RemoveDeletedCells();
  return surface;
}
}

TEST(GenusZeroCheck, WritesTheContractsArrays)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(4);
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputConnection(source->GetOutputPort());
  check->Update();
  vtkFieldData* data = check->GetOutput()->GetFieldData();
  for (const char* name : Figures)
  {
    contract::ExpectArray(data, name, VTK_ID_TYPE, 1, 1);
  }
  for (const char* name : { "BoundaryEdges", "NonManifoldEdges", "InconsistentEdges" })
  {
    contract::ExpectArray(data, name, VTK_ID_TYPE, 2, 0);
  }
  for (const char* name : { "NonManifoldVertices", "IsolatedPoints", "DegenerateTriangles" })
  {
    contract::ExpectArray(data, name, VTK_ID_TYPE, 1, 0);
  }
  EXPECT_EQ(Figure(check, "IsGenusZero"), 1);
  EXPECT_EQ(Figure(check, "EulerNumber"), 2);
  EXPECT_EQ(Figure(check, "NumberOfComponents"), 1);
  EXPECT_EQ(Figure(check, "IsInsideOut"), 0);
  EXPECT_EQ(Words(check),
    "a closed surface of genus zero: closed, manifold, one component, Euler number 2\n");
}

TEST(GenusZeroCheck, PassesTheSurfaceAndLeavesTheInputAlone)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(2);
  source->Update();
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputData(source->GetOutput());
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetPoints(), source->GetOutput()->GetPoints());
  EXPECT_EQ(check->GetOutput()->GetNumberOfCells(), source->GetOutput()->GetNumberOfCells());
  contract::ExpectSpherePosition(check->GetOutput());
  EXPECT_EQ(source->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST(GenusZeroCheck, SaysWhereASurfaceIsOpen)
{
  const auto open = SphereWithout(5);
  vtkNew<vtkGenusZeroCheck> check;
  contract::Observed observed(check);
  check->SetInputData(open);
  check->Update();
  EXPECT_FALSE(observed.Error());
  EXPECT_FALSE(observed.Warning());
  EXPECT_EQ(Figure(check, "IsGenusZero"), 0);
  EXPECT_EQ(Figure(check, "EulerNumber"), 1);
  EXPECT_EQ(Figure(check, "NumberOfBoundaryEdges"), 3);
  EXPECT_EQ(Figure(check, "NumberOfBoundaryLoops"), 1);
  contract::ExpectArray(check->GetOutput()->GetFieldData(), "BoundaryEdges", VTK_ID_TYPE, 2, 3);
  EXPECT_NE(Words(check).find("3 boundary edges in 1 loop"), std::string::npos);
}

// Its six squares have corners of their own.
TEST(GenusZeroCheck, SeesQuadsAndComponents)
{
  vtkNew<vtkCubeSource> cube;
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputConnection(cube->GetOutputPort());
  check->Update();
  EXPECT_EQ(Figure(check, "NumberOfComponents"), 6);
  EXPECT_EQ(Figure(check, "NumberOfBoundaryEdges"), 24);
  EXPECT_EQ(Figure(check, "NumberOfBoundaryLoops"), 6);
}

TEST(GenusZeroCheck, SeesStrips)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(4);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputConnection(strips->GetOutputPort());
  check->Update();
  ASSERT_GT(check->GetOutput()->GetNumberOfStrips(), 0);
  EXPECT_EQ(Figure(check, "IsGenusZero"), 1);
  EXPECT_EQ(Figure(check, "NumberOfInconsistentEdges"), 0);
  EXPECT_EQ(Figure(check, "IsInsideOut"), 0);
}

// Degenerate triangles are told by cell id: lines come before polygons.
TEST(GenusZeroCheck, CountsCellsAsVtkDoes)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  points->InsertNextPoint(2, 0, 0);
  vtkNew<vtkCellArray> lines, polygons;
  lines->InsertNextCell({ 0, 1 });
  polygons->InsertNextCell({ 0, 1, 2 });
  polygons->InsertNextCell({ 0, 1 });
  polygons->InsertNextCell({ 0, 1, 3 });
  polygons->InsertNextCell({ 0, 1, 1 });
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetLines(lines);
  surface->SetPolys(polygons);
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputData(surface);
  check->Update();
  vtkDataArray* bad = check->GetOutput()->GetFieldData()->GetArray("DegenerateTriangles");
  ASSERT_EQ(bad->GetNumberOfTuples(), 2);
  EXPECT_EQ(bad->GetTuple1(0), 3);
  EXPECT_EQ(bad->GetTuple1(1), 4);
}

TEST(GenusZeroCheck, ReportsCloudsAndNothing)
{
  vtkNew<vtkGenusZeroCheck> check;
  contract::Observed observed(check);
  vtkNew<vtkPolyData> cloud;
  check->SetInputData(cloud);
  check->Update();
  EXPECT_EQ(Figure(check, "IsGenusZero"), 0);
  EXPECT_EQ(Words(check), "no triangles\n");
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  cloud->SetPoints(points);
  check->Update();
  EXPECT_EQ(Figure(check, "NumberOfIsolatedPoints"), 1);
  EXPECT_FALSE(observed.Error());
}

TEST(GenusZeroCheck, RefusesIdsOutOfRange)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2 });
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  vtkNew<vtkGenusZeroCheck> check;
  contract::Observed observed(check);
  check->SetInputData(surface);
  check->Update();
  EXPECT_TRUE(observed.Error());
  EXPECT_NE(observed.ErrorMessage().find("cell 0 refers to point 1 of 1"), std::string::npos);
  EXPECT_EQ(check->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(GenusZeroCheck, RunsOnlyWhenModified)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(2);
  vtkNew<vtkGenusZeroCheck> check;
  check->SetInputConnection(source->GetOutputPort());
  contract::ExpectRunsOnlyWhenModified(check, [&]() { source->SetFrequency(3); });
}

// The figures are those of nothing, so that scripts find them.
TEST(GenusZeroCheck, WarnsOfAnEmptySurface)
{
  vtkNew<vtkGenusZeroCheck> check;
  contract::Observed observed(check);
  check->SetInputData(vtkNew<vtkPolyData>());
  check->Update();
  observed.ExpectWarning("the surface is empty");
  EXPECT_EQ(check->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(Figure(check, "IsGenusZero"), 0);
  EXPECT_EQ(Figure(check, "NumberOfComponents"), 0);
}
