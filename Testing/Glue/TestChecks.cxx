#include "Glue/Checks.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>

namespace
{
/// A square of two triangles, a vertex and a line: 4 points, 4 cells.
vtkNew<vtkPolyData> Square()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i % 2, i / 2, 0.0);
  }
  const vtkIdType ids[] = { 0, 1, 3, 2 }, others[] = { 0, 3, 2 };
  vtkNew<vtkCellArray> vertices, lines, polygons;
  vertices->InsertNextCell(1, ids);
  lines->InsertNextCell(2, ids);
  polygons->InsertNextCell(3, ids);
  polygons->InsertNextCell(3, others);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetVerts(vertices);
  surface->SetLines(lines);
  surface->SetPolys(polygons);
  return surface;
}

template <typename Array>
vtkNew<Array> ArrayOf(const char* name, int components, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// What is said against it, or nothing.
std::string Refusal(const std::function<void()>& check)
{
  try
  {
    check();
  }
  catch (const std::invalid_argument& e)
  {
    return e.what();
  }
  return "";
}

std::string Refusal(vtkDataObject* data)
{
  return Refusal([&]() { glue::RequireConsistentData(data, "it"); });
}
}

TEST(Checks, DataThatFitPass)
{
  const vtkNew<vtkPolyData> surface = Square();
  EXPECT_EQ(Refusal(surface), "");
  surface->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("A", 3, 4));
  surface->GetPointData()->AddArray(ArrayOf<vtkStringArray>("B", 1, 4));
  surface->GetCellData()->AddArray(ArrayOf<vtkFloatArray>("C", 9, 4));
  surface->GetFieldData()->AddArray(ArrayOf<vtkDoubleArray>("D", 2, 17));
  const char* const ghosts = vtkDataSetAttributes::GhostArrayName();
  surface->GetPointData()->AddArray(ArrayOf<vtkUnsignedCharArray>(ghosts, 1, 4));
  surface->GetCellData()->AddArray(ArrayOf<vtkUnsignedCharArray>(ghosts, 1, 4));
  EXPECT_EQ(Refusal(surface), "");
  EXPECT_EQ(Refusal(vtkNew<vtkPolyData>()), "");
  EXPECT_EQ(Refusal(vtkNew<vtkImageData>()), "");
  EXPECT_EQ(Refusal(vtkNew<vtkUnstructuredGrid>()), "");
  EXPECT_EQ(Refusal(vtkNew<vtkStructuredGrid>()), "");
  EXPECT_EQ(Refusal(vtkNew<vtkTable>()), "");
  EXPECT_EQ(Refusal(nullptr), "");
}

TEST(Checks, SaysWhichArrayHowManyAndWhatToDo)
{
  const vtkNew<vtkPolyData> surface = Square();
  surface->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("Good", 1, 4));
  surface->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("Bad", 1, 1));
  EXPECT_EQ(Refusal(surface),
    "it: the point array \"Bad\" has 1 tuple for 4 points. Give it a tuple for each "
    "point, or remove it.");
  surface->GetPointData()->Initialize();
  surface->GetCellData()->AddArray(ArrayOf<vtkStringArray>(nullptr, 1, 5));
  EXPECT_EQ(Refusal(surface),
    "it: the cell array 0 (without a name) has 5 tuples for 4 cells. Give it a tuple "
    "for each cell, or remove it.");
}

TEST(Checks, GhostsAreOneUnsignedCharEach)
{
  const char* const ghosts = vtkDataSetAttributes::GhostArrayName();
  const vtkNew<vtkPolyData> surface = Square();
  surface->GetPointData()->AddArray(ArrayOf<vtkUnsignedCharArray>(ghosts, 2, 4));
  EXPECT_EQ(Refusal(surface),
    "it: the point array \"vtkGhostType\" is a vtkUnsignedCharArray of 2 components, but ghosts "
    "are marked by a vtkUnsignedCharArray of 1 component. Convert it, or remove it.");
  surface->GetPointData()->Initialize();
  surface->GetCellData()->AddArray(ArrayOf<vtkFloatArray>(ghosts, 1, 4));
  EXPECT_NE(
    Refusal(surface).find("the cell array \"vtkGhostType\" is a vtkFloatArray"), std::string::npos);
}

// Components that are changed after VTK looked at them.
TEST(Checks, VectorsOfPointsHaveThreeComponents)
{
  const vtkNew<vtkPolyData> surface = Square();
  const vtkNew<vtkFloatArray> normals = ArrayOf<vtkFloatArray>("N", 3, 4);
  surface->GetPointData()->SetNormals(normals);
  EXPECT_EQ(Refusal(surface), "");
  normals->SetNumberOfComponents(9);
  normals->SetNumberOfTuples(4);
  EXPECT_EQ(Refusal(surface),
    "it: the active normals of the points have 9 components instead of 3. Convert them, or remove "
    "them.");
  surface->GetPointData()->Initialize();
  surface->GetPoints()->GetData()->SetNumberOfComponents(2);
  EXPECT_EQ(Refusal(surface), "it: the points have 2 components instead of 3. Convert them.");
}

TEST(Checks, OffsetsFitTheIds)
{
  for (const std::initializer_list<vtkIdType>& offsets :
    { std::initializer_list<vtkIdType>{ 0, 4 }, { 0, 3, 2 }, { 1, 3 }, { 0, 2 }, {} })
  {
    vtkNew<vtkIdTypeArray> places;
    for (const vtkIdType offset : offsets)
    {
      places->InsertNextValue(offset);
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(places, ArrayOf<vtkIdTypeArray>("ids", 1, 3));
    const vtkNew<vtkPolyData> surface = Square();
    surface->SetStrips(cells);
    EXPECT_EQ(Refusal(surface),
      "it: the offsets of the strips do not fit their point ids (see vtkCellArray::IsValid). "
      "Rebuild the cells.");
    surface->SetStrips(nullptr);
    surface->SetLines(cells);
    EXPECT_NE(Refusal(surface).find("the offsets of the lines"), std::string::npos);
  }
}

TEST(Checks, ImagesAndGridsHaveThePointsOfTheirExtent)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(2, 4, 5, 6, 0, 0);
  image->GetPointData()->SetScalars(ArrayOf<vtkUnsignedCharArray>("S", 3, 6));
  EXPECT_EQ(Refusal(image), "");
  image->SetExtent(2, 4, 5, 7, 0, 0);
  EXPECT_NE(Refusal(image).find("has 6 tuples for 9 points"), std::string::npos);
  vtkNew<vtkStructuredGrid> grid;
  grid->SetDimensions(2, 2, 1);
  grid->SetPoints(Square()->GetPoints());
  grid->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("A", 1, 1));
  EXPECT_EQ(Refusal(grid), "");
  grid->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("B", 1, 2));
  EXPECT_NE(Refusal(grid).find("has 2 tuples for 1 cell."), std::string::npos);
}

TEST(Checks, CellsNamePointsThatAreThere)
{
  const vtkNew<vtkPolyData> surface = Square();
  const auto refusal = [&]() { return Refusal([&]() { glue::RequireCellIds(surface); }); };
  EXPECT_EQ(refusal(), "");
  vtkNew<vtkCellArray> strips;
  const vtkIdType ids[] = { 0, 1, 2, 4 }, negative[] = { 0, -1 };
  strips->InsertNextCell(3, ids);
  strips->InsertNextCell(4, ids);
  surface->SetStrips(strips);
  EXPECT_EQ(refusal(), "cell 5 refers to point 4 of 4");
  surface->SetStrips(nullptr);
  surface->GetPolys()->InsertNextCell(2, negative);
  EXPECT_EQ(refusal(), "cell 4 refers to point -1 of 4");
  surface->GetPolys()->Initialize();
  surface->GetLines()->InsertNextCell(2, negative);
  EXPECT_EQ(refusal(), "cell 2 refers to point -1 of 4");
}

// All connections of all ports, the optional ones that have none left out.
TEST(Checks, LooksAtEveryConnection)
{
  const vtkNew<vtkPolyData> good = Square(), bad = Square();
  bad->GetPointData()->AddArray(ArrayOf<vtkDoubleArray>("Bad", 1, 3));
  vtkNew<vtkAppendPolyData> append;
  const auto refusal = [&]() { return Refusal([&]() { glue::RequireConsistentInputs(append); }); };
  EXPECT_EQ(refusal(), "");
  append->AddInputData(good);
  EXPECT_EQ(refusal(), "");
  append->AddInputData(bad);
  EXPECT_NE(
    refusal().find("input port 0: the point array \"Bad\" has 3 tuples"), std::string::npos);
  vtkNew<vtkSphereSource> source;
  EXPECT_EQ(Refusal([&]() { glue::RequireConsistentInputs(source); }), "");
}
