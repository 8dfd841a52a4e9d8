// What every filter that needs a closed surface does with a surface that is not quite one.
#include "Glue/Meshes.h"

#include "FilterContract.h"
#include "Mesh/GenusZeroCheck.h"
#include "MeshFixtures.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCubeSource.h"
#include "vtkPoints.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSuperquadricSource.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <limits>
#include <stdexcept>

using glue::ClosedMesh;
using glue::ToClosedMesh;
using glue::ToTriangles;

namespace
{
// A surface of our own to be broken.
vtkNew<vtkPolyData> Sphere(int frequency = 3)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  return surface;
}

class Meshes : public testing::Test
{
protected:
  std::string WhyNot(vtkPolyData* surface)
  {
    try
    {
      ToClosedMesh(this->Filter, surface, {});
    }
    catch (const std::invalid_argument& e)
    {
      return e.what();
    }
    return "";
  }
  void ExpectGenusZero(const ClosedMesh& mesh)
  {
    const auto report =
      conformal::checkGenusZero(mesh.Triangles, mesh.Positions.rows(), mesh.Positions);
    EXPECT_TRUE(report.isGenusZero());
    EXPECT_TRUE(report.InconsistentEdges.empty());
    EXPECT_TRUE(report.IsolatedPoints.empty());
    EXPECT_EQ(mesh.PointIds.size(), static_cast<std::size_t>(mesh.Positions.rows()));
  }
  void ExpectPoints(const ClosedMesh& mesh, vtkPolyData* surface)
  {
    for (conformal::Index v = 0; v < mesh.Positions.rows(); ++v)
    {
      const conformal::Vector3 p(surface->GetPoint(mesh.PointIds[v]));
      ASSERT_EQ(p, conformal::Vector3(mesh.Positions.row(v)));
    }
  }

  vtkNew<vtkGeodesicSphereSource> Filter; // any filter: warnings come from it
  contract::Observed Observed{ this->Filter };
};
}

TEST_F(Meshes, TakesAGoodSurfaceAsItIs)
{
  const auto surface = Sphere();
  const ClosedMesh mesh = ToClosedMesh(this->Filter, surface, {});
  this->ExpectGenusZero(mesh);
  this->ExpectPoints(mesh, surface);
  EXPECT_EQ(mesh.Positions.rows(), 92);
  EXPECT_EQ(mesh.Triangles.rows(), 180);
  EXPECT_FALSE(mesh.InsideOut);
  EXPECT_FALSE(this->Observed.Warning());
}

TEST_F(Meshes, RefusesOpenSurfacesWithFigures)
{
  const auto surface = Sphere();
  fixtures::ChangePolygons(surface, [](vtkIdType i, vtkIdList*) { return i != 0; });
  EXPECT_NE(this->WhyNot(surface).find("3 boundary edges in 1 loop (first: "), std::string::npos);
  EXPECT_FALSE(this->Observed.Warning());
}

TEST_F(Meshes, RefusesAnotherGenusWithItsEulerNumber)
{
  vtkNew<vtkSuperquadricSource> torus;
  torus->ToroidalOn();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(torus->GetOutputPort());
  triangles->Update();
  EXPECT_NE(this->WhyNot(triangles->GetOutput()).find("Euler number 0"), std::string::npos);
}

TEST_F(Meshes, RefusesSeveralComponents)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Sphere(2));
  both->AddInputData(Sphere(3));
  both->Update();
  EXPECT_NE(this->WhyNot(both->GetOutput()).find("2 components"), std::string::npos);
}

TEST_F(Meshes, RefusesWhatIsNotManifoldWithFirstIds)
{
  const auto surface = Sphere();
  surface->GetPolys()->InsertNextCell({ 0, 40, 80 });
  const vtkIdType* ids = nullptr;
  vtkIdType size = 0;
  surface->GetPolys()->GetCellAtId(0, size, ids);
  surface->GetPolys()->InsertNextCell({ ids[0], ids[1], 80 });
  const std::string why = this->WhyNot(surface);
  EXPECT_NE(why.find("not manifold"), std::string::npos);
  EXPECT_NE(why.find("1 edge of more than two triangles (first: "), std::string::npos);
}

TEST_F(Meshes, RefusesCoordinatesThatAreNotFinite)
{
  const auto surface = Sphere();
  surface->GetPoints()->SetPoint(3, std::numeric_limits<double>::quiet_NaN(), 0, 0);
  surface->GetPoints()->SetPoint(5, 0, std::numeric_limits<double>::infinity(), 0);
  EXPECT_NE(this->WhyNot(surface).find("2 of 92 points"), std::string::npos);
}

TEST_F(Meshes, TurnsTrianglesAndWarns)
{
  const auto surface = Sphere();
  fixtures::ChangePolygons(surface,
    [](vtkIdType i, vtkIdList* ids)
    {
      if (i % 50 == 7)
      {
        const vtkIdType second = ids->GetId(1);
        ids->SetId(1, ids->GetId(2));
        ids->SetId(2, second);
      }
      return true;
    });
  const ClosedMesh mesh = ToClosedMesh(this->Filter, surface, {});
  this->ExpectGenusZero(mesh);
  EXPECT_FALSE(mesh.InsideOut);
  EXPECT_NE(this->Observed.WarningMessage().find("4 triangles were reversed"), std::string::npos);
}

TEST_F(Meshes, WeldsASoupAndWarns)
{
  const auto sphere = Sphere();
  vtkNew<vtkPoints> corners;
  vtkNew<vtkCellArray> polygons;
  fixtures::ChangePolygons(sphere,
    [&](vtkIdType, vtkIdList* ids)
    {
      polygons->InsertNextCell(3);
      for (int k = 0; k < 3; ++k)
      {
        polygons->InsertCellPoint(corners->InsertNextPoint(sphere->GetPoint(ids->GetId(k))));
      }
      return true;
    });
  vtkNew<vtkPolyData> soup;
  soup->SetPoints(corners);
  soup->SetPolys(polygons);
  const ClosedMesh mesh = ToClosedMesh(this->Filter, soup, {});
  this->ExpectGenusZero(mesh);
  this->ExpectPoints(mesh, soup);
  EXPECT_EQ(mesh.Positions.rows(), 92);
  EXPECT_NE(this->Observed.WarningMessage().find("448 coincident points"), std::string::npos);
  EXPECT_EQ(this->Observed.WarningMessage().find("no triangle"), std::string::npos);
}

TEST_F(Meshes, CutsUpQuadsSilently)
{
  // A cube of quads with shared corners.
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners->InsertNextPoint(i & 1, (i >> 1) & 1, i >> 2);
  }
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 2, 3, 1 });
  quads->InsertNextCell({ 4, 5, 7, 6 });
  quads->InsertNextCell({ 0, 1, 5, 4 });
  quads->InsertNextCell({ 2, 6, 7, 3 });
  quads->InsertNextCell({ 0, 4, 6, 2 });
  quads->InsertNextCell({ 1, 3, 7, 5 });
  vtkNew<vtkPolyData> cube;
  cube->SetPoints(corners);
  cube->SetPolys(quads);
  const ClosedMesh mesh = ToClosedMesh(this->Filter, cube, {});
  this->ExpectGenusZero(mesh);
  EXPECT_EQ(mesh.Triangles.rows(), 12);
  EXPECT_FALSE(mesh.InsideOut);
  EXPECT_FALSE(this->Observed.Warning());
}

TEST_F(Meshes, DropsIsolatedPointsAndRepeatedTrianglesAndWarns)
{
  const auto surface = Sphere();
  surface->GetPointData()->Initialize();
  surface->GetPoints()->InsertNextPoint(5, 5, 5);
  surface->GetPolys()->InsertNextCell({ 1, 1, 2 });
  const ClosedMesh mesh = ToClosedMesh(this->Filter, surface, {});
  this->ExpectGenusZero(mesh);
  EXPECT_EQ(mesh.Positions.rows(), 92);
  const std::string warnings = this->Observed.WarningMessage();
  EXPECT_NE(warnings.find("1 triangles with a repeated point"), std::string::npos);
  EXPECT_NE(warnings.find("1 points that belong to no triangle"), std::string::npos);
  EXPECT_EQ(warnings.find("the output keeps"), std::string::npos);
  ToClosedMesh(this->Filter, surface, {}, {}, glue::Topology::Closed, glue::MeshUse::Copy);
  this->Observed.ExpectWarning("the output keeps the points and polygons of the input");
}

TEST_F(Meshes, TellsInsideOutAndLeavesIt)
{
  const auto surface = Sphere();
  fixtures::ChangePolygons(surface,
    [](vtkIdType, vtkIdList* ids)
    {
      std::swap(*ids->GetPointer(1), *ids->GetPointer(2));
      return true;
    });
  EXPECT_TRUE(ToClosedMesh(this->Filter, surface, {}).InsideOut);
  EXPECT_FALSE(this->Observed.Warning());
}

// A polygon whose ears cannot be found still closes the surface.
// A pyramid over a star: with VTK's triangulation this would take minutes.
TEST_F(Meshes, CutsUpPolygonsOfManyCorners)
{
  constexpr vtkIdType count = 100000;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 1.0);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdList> base;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = 8.0 * std::atan(1.0) * static_cast<double>(i) / count;
    const double radius = 1.0 - 0.3 * static_cast<double>(i % 2);
    points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.0);
    base->InsertNextId(count - i);
    cells->InsertNextCell({ 0, 1 + i, 1 + (i + 1) % count });
  }
  cells->InsertNextCell(base);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(cells);
  const ClosedMesh mesh = ToClosedMesh(this->Filter, surface, {});
  EXPECT_EQ(mesh.Triangles.rows(), 2 * count - 2);
  this->ExpectGenusZero(mesh);
  EXPECT_FALSE(mesh.InsideOut);
}

TEST_F(Meshes, KeepsTheBorderOfImpossiblePolygons)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i < 5 ? 0.0 : std::numeric_limits<double>::quiet_NaN(), 0, 0);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3, 4, 5 });
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  std::vector<vtkIdType> cellIds;
  const auto report = conformal::checkGenusZero(ToTriangles(surface, cellIds), 6);
  EXPECT_EQ(report.BoundaryEdges.size(), 6u);
  EXPECT_EQ(cellIds, std::vector<vtkIdType>(4, 0));
}
