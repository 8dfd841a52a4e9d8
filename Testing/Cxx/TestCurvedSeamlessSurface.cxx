#include "vtkCurvedSeamlessSurface.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessMap.h"
#include "vtkGeodesicSphereSource.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFeatureEdges.h"
#include "vtkIdTypeArray.h"
#include "vtkMassProperties.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangle.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

using fixtures::Ellipsoid;

namespace
{
void SetSpherePosition(vtkPolyData* surface, vtkIdType id, double x, double y, double z)
{
  surface->GetPointData()->GetArray("SpherePosition")->SetTuple3(id, x, y, z);
}

/// An ellipsoid with its map to the sphere, to be broken.
/// Points at the eight corners of a cube, cells as given, mapped radially.
vtkNew<vtkPolyData> Cube(vtkCellArray* cells)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> positions;
  positions->SetName("SpherePosition");
  positions->SetNumberOfComponents(3);
  for (int i = 0; i < 8; ++i)
  {
    const std::array<double, 3> p{ i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0 };
    points->InsertNextPoint(p.data());
    positions->InsertNextTuple(p.data()); // not of unit length, which is allowed
  }
  vtkNew<vtkPolyData> cube;
  cube->SetPoints(points);
  cube->SetPolys(cells);
  cube->GetPointData()->AddArray(positions);
  return cube;
}

double MaximumDifference(vtkPolyData* a, vtkPolyData* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return std::numeric_limits<double>::infinity();
  }
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    a->GetPoint(i, p);
    b->GetPoint(i, q);
    largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
  }
  return largest;
}

/// V - E + F, or 0 if an edge has not two triangles that run along it in opposite directions.
vtkIdType EulerNumberIfClosed(vtkPolyData* surface)
{
  std::set<std::pair<vtkIdType, vtkIdType>> directed;
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < surface->GetNumberOfPolys(); ++i)
  {
    surface->GetPolys()->GetCellAtId(i, ids);
    for (vtkIdType k = 0; k < 3; ++k)
    {
      if (!directed.emplace(ids->GetId(k), ids->GetId((k + 1) % 3)).second)
      {
        return 0;
      }
    }
  }
  for (const auto& [from, to] : directed)
  {
    if (!directed.count({ to, from }))
    {
      return 0;
    }
  }
  return surface->GetNumberOfPoints() - static_cast<vtkIdType>(directed.size()) / 2 +
    surface->GetNumberOfPolys();
}

/// The map's northern hemisphere drawn together around the pole, as by a Moebius transform.
void ShrinkTheNorth(vtkPolyData* surface, double factor)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    const double* n = surface->GetPointData()->GetArray("SpherePosition")->GetTuple3(i);
    // Stereographic projection from the south pole, there and back.
    const double x = factor * n[0], y = factor * n[1], w = 1.0 + n[2];
    const double square = x * x + y * y;
    if (n[2] > -0.999999)
    {
      SetSpherePosition(surface, i, 2.0 * x * w, 2.0 * y * w, w * w - square);
    }
  }
}

double VolumeOf(vtkPolyData* surface)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(surface);
  mass->Update();
  return mass->GetVolume();
}

class CurvedSeamlessSurface : public testing::Test
{
protected:
  CurvedSeamlessSurface()
  {
    this->Filter->SetFrequency(10);
    this->Filter->SetVertexShift(0.0); // else a warning: most meshes here look like learned ones
  }

  vtkPolyData* Run(vtkPolyData* surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  /// An error with this text, and nothing in the output.
  void ExpectRefused(vtkPolyData* surface, const std::string& why)
  {
    this->Seen.Clear();
    vtkPolyData* output = this->Run(surface);
    this->Seen.ExpectError(why);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetNumberOfCells(), 0);
  }

  /// The whole surface, with a warning of this text, or without one if it is empty.
  vtkPolyData* ExpectDone(vtkPolyData* surface, const std::string& warning)
  {
    this->Seen.Clear();
    vtkPolyData* output = this->Run(surface);
    this->Seen.ExpectWarning(warning);
    EXPECT_EQ(output->GetNumberOfPoints(), 1002);
    contract::ExpectSpherePosition(output);
    contract::ExpectArray(output->GetPointData(), "Normals", VTK_DOUBLE, 3, 1002);
    return output;
  }

  vtkNew<vtkCurvedSeamlessSurface> Filter;
  contract::Observed Seen{ this->Filter };
};
}

TEST_F(CurvedSeamlessSurface, WritesTheContractsArrays)
{
  EXPECT_EQ(vtkNew<vtkCurvedSeamlessSurface>()->GetFrequency(), 80);
  vtkPolyData* output = this->ExpectDone(Ellipsoid(), "");
  EXPECT_EQ(output->GetNumberOfPolys(), 2000);
  EXPECT_EQ(output->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_NE(output->GetPointData()->GetNormals(), nullptr);
  contract::ExpectArray(output->GetCellData(), "Degenerate", VTK_UNSIGNED_CHAR, 1, 2000);
  EXPECT_EQ(output->GetCellData()->GetArray("Degenerate")->GetRange()[1], 0.0);
  contract::ExpectArray(output->GetFieldData(), "NumberOfDegeneratePatches", VTK_ID_TYPE, 1, 1);
  EXPECT_EQ(output->GetFieldData()->GetArray("NumberOfDegeneratePatches")->GetTuple1(0), 0.0);
}

TEST_F(CurvedSeamlessSurface, ClosesRoundTheEllipsoid)
{
  this->Filter->SetFrequency(40);
  vtkPolyData* output = this->Run(Ellipsoid(12));
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(output);
  edges->FeatureEdgesOff();
  edges->Update();
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(output);
  mass->Update();
  const double exact = 4.0 / 3.0 * vtkMath::Pi() * 3.0 * 2.0;
  EXPECT_NEAR(mass->GetVolume(), exact, 0.01 * exact);
  // Normals look out of the ellipsoid, along its gradient.
  double worst = 1.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    double gradient[3] = { (p[0] - 10.0) / 9.0, p[1] / 4.0, p[2] };
    vtkMath::Normalize(gradient);
    worst =
      std::min(worst, vtkMath::Dot(gradient, output->GetPointData()->GetNormals()->GetTuple3(i)));
  }
  EXPECT_GT(worst, 0.98);
}

TEST_F(CurvedSeamlessSurface, TheSphereStaysASphere)
{
  vtkNew<vtkGeodesicSphereSource> network;
  network->SetFrequency(6);
  network->Update();
  for (const auto& [domeHeight, tolerance] :
    { std::pair<int, double>{ vtkCurvedSeamlessSurface::NONE, 8e-3 },
      { vtkCurvedSeamlessSurface::PUBLISHED, 1.6e-5 }, { vtkCurvedSeamlessSurface::SCALED, 2e-5 },
      { vtkCurvedSeamlessSurface::CURVATURE, 5e-4 } })
  {
    this->Filter->SetDomeHeight(domeHeight);
    vtkPolyData* output = this->ExpectDone(network->GetOutput(), "");
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      EXPECT_NEAR(vtkMath::Norm(output->GetPoint(i)), 1.0, tolerance);
    }
  }
}

TEST_F(CurvedSeamlessSurface, AGivenSphereSaysWhereAndHowConnected)
{
  vtkNew<vtkSphereSource> sphere; // of radius 0.5: only the directions count
  sphere->SetThetaResolution(20);
  sphere->SetPhiResolution(15);
  sphere->Update();
  this->Filter->SetSphereConnection(sphere->GetOutputPort());
  vtkPolyData* output = this->Run(Ellipsoid());
  ASSERT_EQ(output->GetNumberOfPoints(), sphere->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(output->GetNumberOfPolys(), sphere->GetOutput()->GetNumberOfPolys());
  contract::ExpectSpherePosition(output);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    sphere->GetOutput()->GetPoint(i, p);
    vtkMath::Normalize(p);
    const double* n = output->GetPointData()->GetArray("SpherePosition")->GetTuple3(i);
    EXPECT_NEAR(vtkMath::Dot(p, n), 1.0, 1e-14);
  }
}

TEST_F(CurvedSeamlessSurface, TheSpherePositionsOfAGivenSphereGoBeforeItsPoints)
{
  // At the positions of the mesh's own points the surface goes through the points.
  const vtkNew<vtkPolyData> ellipsoid = Ellipsoid();
  this->Filter->SetSphereData(ellipsoid);
  EXPECT_EQ(MaximumDifference(this->Run(ellipsoid), ellipsoid), 0.0);
}

TEST_F(CurvedSeamlessSurface, AGivenSphereMayHaveNoTriangles)
{
  const vtkNew<vtkPolyData> points = Ellipsoid();
  points->SetPolys(vtkNew<vtkCellArray>());
  this->Filter->SetSphereData(points);
  vtkPolyData* output = this->Run(Ellipsoid());
  EXPECT_FALSE(this->Seen.Error());
  EXPECT_EQ(output->GetNumberOfCells(), 0);
  contract::ExpectArray(
    output->GetPointData(), "Normals", VTK_DOUBLE, 3, points->GetNumberOfPoints());
  EXPECT_NEAR(vtkMath::Norm(output->GetPointData()->GetNormals()->GetTuple3(7)), 1.0, 1e-12);
}

TEST_F(CurvedSeamlessSurface, ThreadsChangeNoBit)
{
  const vtkNew<vtkPolyData> ellipsoid = Ellipsoid(9);
  for (const int sampling :
    { vtkCurvedSeamlessSurface::DIRECTIONS, vtkCurvedSeamlessSurface::NETWORK })
  {
    this->Filter->SetSampling(sampling);
    this->Filter->SetFrequency(30);
    vtkSMPTools::Initialize(1);
    vtkNew<vtkPolyData> alone;
    alone->DeepCopy(this->Run(ellipsoid));
    vtkSMPTools::Initialize(2);
    this->Filter->Modified();
    EXPECT_EQ(MaximumDifference(this->Run(ellipsoid), alone), 0.0);
  }
  vtkSMPTools::Initialize();
}

// Not the sphere, but the mesh itself says where the surface is wanted.
TEST_F(CurvedSeamlessSurface, TheNetworkIsCutIntoEqualParts)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  this->Filter->SetSamplingToNetwork();
  for (int height = vtkCurvedSeamlessSurface::NONE; height <= vtkCurvedSeamlessSurface::FITTED;
       ++height)
  {
    this->Filter->SetDomeHeight(height);
    this->Filter->SetCloudData(surface);
    for (const int seam :
      { vtkCurvedSeamlessSurface::PER_TRIANGLE, vtkCurvedSeamlessSurface::EDGE_MATCHED })
    {
      this->Filter->SetSeamMode(seam);
      for (const int k : { 1, 2, 5 })
      {
        this->Filter->SetSubdivisions(k);
        vtkPolyData* output = this->Run(surface);
        EXPECT_FALSE(this->Seen.Error() || this->Seen.Warning());
        ASSERT_EQ(output->GetNumberOfPoints(), 160 * k * k + 2);
        ASSERT_EQ(output->GetNumberOfPolys(), 320 * k * k);
        EXPECT_EQ(EulerNumberIfClosed(output), 2);
        contract::ExpectSpherePosition(output);
        contract::ExpectArray(
          output->GetPointData(), "Normals", VTK_DOUBLE, 3, output->GetNumberOfPoints());
        EXPECT_EQ(output->GetCellData()->GetArray("Degenerate")->GetRange()[1], 0.0);
      }
    }
  }
}

TEST_F(CurvedSeamlessSurface, TheNetworksPointsComeFirstAndAreExact)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  this->Filter->SetSamplingToNetwork();
  this->Filter->SetSubdivisions(4);
  vtkPolyData* output = this->Run(surface);
  vtkDataArray* map = output->GetPointData()->GetArray("SpherePosition");
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3], q[3];
    output->GetPoint(i, p);
    surface->GetPoint(i, q);
    EXPECT_EQ(vtkMath::Distance2BetweenPoints(p, q), 0.0);
    EXPECT_NEAR(vtkMath::Dot(map->GetTuple3(i),
                  std::array<double, 3>{ (q[0] - 10.0) / 3.0, q[1] / 2.0, q[2] }.data()),
      1.0, 1e-14);
  }
  // And the map finds every point again where the surface says it is.
  vtkNew<vtkDoubleArray> positions;
  ASSERT_TRUE(this->Filter->GetMap()->ToSurface(map, positions));
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    EXPECT_LT(vtkMath::Distance2BetweenPoints(positions->GetTuple3(i), output->GetPoint(i)), 1e-26);
  }
}

// A cap of the map is shrunk to where no direction of a regular sphere comes by.
TEST_F(CurvedSeamlessSurface, TheNetworkKeepsWhatDirectionsMiss)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(8);
  ShrinkTheNorth(surface, 1e-3);
  this->Filter->SetSamplingToDirections();
  const double exact = 4.0 / 3.0 * vtkMath::Pi() * 3.0 * 2.0;
  EXPECT_LT(VolumeOf(this->Run(surface)), 0.8 * exact);
  this->Filter->SetSamplingToAutomatic();
  EXPECT_GT(VolumeOf(this->Run(surface)), 0.97 * exact);
}

TEST_F(CurvedSeamlessSurface, AutomaticSamplingIsByTheNetworkUnlessItIsGeodesic)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(), uneven = Ellipsoid();
  ShrinkTheNorth(uneven, 0.1);
  const auto run = [&](vtkPolyData* input, int sampling)
  {
    this->Filter->SetSampling(sampling);
    vtkNew<vtkPolyData> output;
    output->DeepCopy(this->Run(input));
    return output;
  };
  using F = vtkCurvedSeamlessSurface;
  EXPECT_EQ(this->Filter->GetSampling(), F::AUTOMATIC);
  EXPECT_EQ(
    MaximumDifference(run(surface, F::AUTOMATIC).Get(), run(surface, F::DIRECTIONS).Get()), 0.0);
  EXPECT_EQ(MaximumDifference(run(uneven, F::AUTOMATIC).Get(), run(uneven, F::NETWORK).Get()), 0.0);
  // 160 k^2 + 2 reaches 10 f^2 + 2 = 1,002 with k = 3.
  EXPECT_EQ(run(uneven, F::AUTOMATIC)->GetNumberOfPoints(), 1442);
  EXPECT_EQ(run(surface, F::NETWORK)->GetNumberOfPoints(), 1442);
  // A sphere on port 1 is meant to be used; an empty one makes an empty output.
  const vtkNew<vtkPolyData> sphere = Ellipsoid(3);
  this->Filter->SetSphereData(sphere);
  EXPECT_EQ(run(uneven, F::AUTOMATIC)->GetNumberOfPoints(), 92);
  EXPECT_EQ(run(uneven, F::DIRECTIONS)->GetNumberOfPoints(), 92);
  EXPECT_EQ(run(uneven, F::NETWORK)->GetNumberOfPoints(), 1442);
  this->Filter->SetSphereData(vtkNew<vtkPolyData>());
  EXPECT_EQ(run(uneven, F::NETWORK)->GetNumberOfPoints(), 1442);
  EXPECT_FALSE(this->Seen.Warning());
  EXPECT_EQ(run(uneven, F::AUTOMATIC)->GetNumberOfPoints(), 0);
  this->Seen.ExpectWarning("the sphere on input port 1 is empty");
}

TEST_F(CurvedSeamlessSurface, MoreTrianglesThanAnIntCountsAreRefused)
{
  this->Filter->SetSamplingToNetwork();
  this->Filter->SetSubdivisions(100);
  this->ExpectRefused(
    Ellipsoid(110), "more triangles than fit into an int"); // 242,000 times 10,000
}

TEST_F(CurvedSeamlessSurface, LeavesItsInputAlone)
{
  const vtkNew<vtkPolyData> ellipsoid = Ellipsoid();
  vtkNew<vtkPolyData> copy;
  copy->DeepCopy(ellipsoid);
  this->Run(ellipsoid);
  EXPECT_EQ(MaximumDifference(ellipsoid, copy), 0.0);
  EXPECT_EQ(ellipsoid->GetNumberOfCells(), copy->GetNumberOfCells());
  EXPECT_EQ(
    ellipsoid->GetPointData()->GetNumberOfArrays(), copy->GetPointData()->GetNumberOfArrays());
  EXPECT_EQ(ellipsoid->GetCellData()->GetNumberOfArrays(), 0);
}

TEST_F(CurvedSeamlessSurface, RunsOnlyWhenModifiedAndPrints)
{
  this->Filter->SetInputData(Ellipsoid());
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetFrequency(3); });
  const vtkMTimeType before = this->Filter->GetOutput()->GetMTime();
  this->Filter->SetSeamModeToPerTriangle();
  this->Filter->Update();
  EXPECT_GT(this->Filter->GetOutput()->GetMTime(), before);
  for (const char* property : { "Sampling", "Frequency", "Subdivisions", "SeamMode", "DomeHeight",
         "VertexShift", "NumberOfFitRounds", "FitSmoothness" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
  this->Filter->SetFrequency(0);
  EXPECT_EQ(this->Filter->GetFrequency(), 1);
  this->Filter->SetFrequency(1001);
  EXPECT_EQ(this->Filter->GetFrequency(), 1000);
  EXPECT_EQ(this->Filter->GetSubdivisions(), 0);
  this->Filter->SetSubdivisions(-1);
  EXPECT_EQ(this->Filter->GetSubdivisions(), 0);
  this->Filter->SetSubdivisions(101);
  EXPECT_EQ(this->Filter->GetSubdivisions(), 100);
}

TEST_F(CurvedSeamlessSurface, PropertiesAreClampedAndItsMapIsBuilt)
{
  vtkNew<vtkCurvedSeamlessSurface> filter;
  EXPECT_EQ(filter->GetSeamMode(), vtkCurvedSeamlessSurface::EDGE_MATCHED);
  EXPECT_EQ(filter->GetDomeHeight(), vtkCurvedSeamlessSurface::CURVATURE);
  EXPECT_EQ(filter->GetVertexShift(), -1.0);
  filter->SetDomeHeight(17);
  EXPECT_EQ(filter->GetDomeHeight(), vtkCurvedSeamlessSurface::FITTED);
  filter->SetVertexShift(3.0);
  EXPECT_EQ(filter->GetVertexShift(), 2.0);
  for (const char* property :
    { "SeamMode", "DomeHeight", "VertexShift", "NumberOfFitRounds", "FitSmoothness" })
  {
    contract::ExpectPrints(filter, property);
  }
  vtkCurvedSeamlessMap* map = this->Filter->GetMap();
  EXPECT_FALSE(map->IsBuilt());
  this->Run(Ellipsoid());
  EXPECT_TRUE(map->IsBuilt());
}

TEST_F(CurvedSeamlessSurface, IsWhatItsMapSays)
{
  vtkPolyData* output = this->Run(Ellipsoid());
  vtkNew<vtkDoubleArray> positions, normals;
  ASSERT_TRUE(this->Filter->GetMap()->ToSurface(
    output->GetPointData()->GetArray("SpherePosition"), positions, normals));
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      ASSERT_NEAR(positions->GetComponent(i, c), output->GetPoint(i)[c], 1e-13);
      ASSERT_NEAR(normals->GetComponent(i, c),
        output->GetPointData()->GetNormals()->GetComponent(i, c), 1e-12);
    }
  }
}

TEST_F(CurvedSeamlessSurface, FitsACloud)
{
  const vtkNew<vtkPolyData> coarse = Ellipsoid(4), fine = Ellipsoid(40);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(fine->GetPoints());
  const auto error = [&]()
  {
    vtkPolyData* output = this->ExpectDone(coarse, "");
    double sum = 0.0;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double p[3];
      output->GetPoint(i, p);
      p[0] = (p[0] - 10.0) / 3.0;
      p[1] /= 2.0;
      sum += std::pow(vtkMath::Norm(p) - 1.0, 2);
    }
    return std::sqrt(sum / static_cast<double>(output->GetNumberOfPoints()));
  };
  this->Filter->SetCloudData(cloud);
  const double curved = error();
  this->Filter->SetDomeHeightToFitted();
  EXPECT_LT(error(), 0.4 * curved);
}

TEST_F(CurvedSeamlessSurface, FitsNothingWithoutACloud)
{
  this->Filter->SetDomeHeightToFitted();
  this->ExpectRefused(Ellipsoid(), "needs a cloud of points");
  this->Filter->SetCloudData(vtkNew<vtkPolyData>());
  this->ExpectRefused(Ellipsoid(), "needs a cloud of points");
}

TEST_F(CurvedSeamlessSurface, PointsOfACloudThatAreNotFiniteAreLeftOut)
{
  const vtkNew<vtkPolyData> cloud = Ellipsoid(20);
  vtkNew<vtkPolyData> expected;
  this->Filter->SetDomeHeightToFitted();
  this->Filter->SetCloudData(cloud);
  expected->DeepCopy(this->Run(Ellipsoid()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  cloud->GetPoints()->InsertNextPoint(nan, 0.0, 0.0);
  cloud->GetPointData()->Initialize();
  cloud->Modified();
  vtkPolyData* output =
    this->ExpectDone(Ellipsoid(), "1 points of the cloud are not finite and left out");
  EXPECT_LT(MaximumDifference(output, expected), 1e-12);
}

TEST_F(CurvedSeamlessSurface, PointsOfACloudFarFromAllOthersAreLeftOut)
{
  const vtkNew<vtkPolyData> cloud = Ellipsoid(20);
  vtkNew<vtkPolyData> expected;
  this->Filter->SetDomeHeightToFitted();
  this->Filter->SetCloudData(cloud);
  expected->DeepCopy(this->Run(Ellipsoid()));
  cloud->GetPointData()->Initialize();
  cloud->SetPolys(nullptr);
  cloud->GetPoints()->InsertNextPoint(1e4, 0.0, 0.0);
  for (const double distance : { 1e4, 1e9, 1e15 })
  {
    cloud->GetPoints()->SetPoint(cloud->GetNumberOfPoints() - 1, distance, 0.0, 0.0);
    cloud->Modified();
    vtkPolyData* output =
      this->ExpectDone(Ellipsoid(), "1 of 4003 points lie far from all others and are left out");
    EXPECT_LT(MaximumDifference(output, expected), 1e-12);
  }
}

// The vertices of a fitted mesh lie outside of ridges.
TEST_F(CurvedSeamlessSurface, VerticesOfFittedMeshesAreMovedInwards)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  this->Filter->SetSphereData(surface); // evaluated at the vertices
  EXPECT_EQ(MaximumDifference(this->Run(surface), surface), 0.0);
  this->Filter->SetVertexShift(-1.0);
  vtkNew<vtkDoubleArray> shift;
  shift->SetName("VertexShift");
  shift->InsertNextValue(0.0);
  surface->GetFieldData()->AddArray(shift);
  surface->Modified();
  EXPECT_EQ(MaximumDifference(this->Run(surface), surface), 0.0);
  shift->SetValue(0, 1.0);
  surface->Modified();
  vtkPolyData* output = this->Run(surface);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    p[0] = (p[0] - 10.0) / 3.0;
    p[1] /= 2.0;
    EXPECT_LT(vtkMath::Norm(p), 1.0 - 1e-4);
  }
  this->Filter->SetVertexShift(0.0);
  EXPECT_EQ(MaximumDifference(this->Run(surface), surface), 0.0);
}

// The property comes before the field array.
TEST_F(CurvedSeamlessSurface, VertexShiftIsThatOfTheMesh)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  const auto shifted = [&](double shift)
  {
    this->Filter->SetVertexShift(shift);
    vtkNew<vtkPolyData> output;
    output->DeepCopy(this->ExpectDone(surface, ""));
    return output;
  };
  const vtkNew<vtkPolyData> usual = shifted(1.0), little = shifted(0.25);
  EXPECT_GT(MaximumDifference(usual, little), 1e-4);
  vtkNew<vtkDoubleArray> array;
  array->SetName("VertexShift");
  array->InsertNextValue(0.25);
  surface->GetFieldData()->AddArray(array);
  surface->Modified();
  EXPECT_EQ(MaximumDifference(shifted(-1.0), little), 0.0);
  EXPECT_EQ(MaximumDifference(shifted(1.0), usual), 0.0);
}

// Field data are lost in most files: there is a warning, and the property replaces them.
TEST_F(CurvedSeamlessSurface, LostFieldDataChangeNothingSilently)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkDoubleArray> array;
  array->SetName("VertexShift");
  array->InsertNextValue(1.0);
  surface->GetFieldData()->AddArray(array);
  this->Filter->SetVertexShift(-1.0);
  vtkNew<vtkPolyData> expected, unmoved;
  expected->DeepCopy(this->ExpectDone(surface, ""));
  surface->GetFieldData()->RemoveArray("VertexShift");
  surface->Modified();
  const char* warning = "no field array \"VertexShift\"; its vertices are not moved";
  unmoved->DeepCopy(this->ExpectDone(surface, warning));
  EXPECT_GT(MaximumDifference(unmoved, expected), 1e-4);
  this->Filter->SetVertexShift(1.0);
  EXPECT_EQ(MaximumDifference(this->ExpectDone(surface, ""), expected), 0.0);
  this->Filter->SetVertexShift(0.0);
  EXPECT_EQ(MaximumDifference(this->ExpectDone(surface, ""), unmoved), 0.0);
  this->Filter->SetVertexShift(-1.0);
  for (const int height : { vtkCurvedSeamlessSurface::NONE, vtkCurvedSeamlessSurface::PUBLISHED })
  {
    this->Filter->SetDomeHeight(height); // which moves no vertex
    this->ExpectDone(surface, "");
  }
}

// A learned mesh without the connectivity of a geodesic sphere.
TEST_F(CurvedSeamlessSurface, LostFieldDataOfAdaptiveMeshesAreNoticed)
{
  const vtkNew<vtkPolyData> cloud = Ellipsoid(40);
  vtkNew<vtkConformalSOM> network;
  network->SetInputData(cloud);
  network->SetMeshTypeToAdaptive();
  network->SetNumberOfNeurons(2000);
  network->Update();
  vtkPolyData* learned = network->GetOutput();
  this->Filter->SetVertexShift(-1.0);
  vtkNew<vtkPolyData> expected, unmoved;
  expected->DeepCopy(this->Run(learned));
  EXPECT_EQ(expected->GetNumberOfPoints(), 2000); // k = 1
  EXPECT_FALSE(this->Seen.Warning());
  const double shift = learned->GetFieldData()->GetArray("VertexShift")->GetTuple1(0);
  vtkNew<vtkPolyData> lost;
  lost->ShallowCopy(learned);
  lost->SetFieldData(vtkNew<vtkFieldData>());
  unmoved->DeepCopy(this->Run(lost));
  this->Seen.ExpectWarning("no field array \"VertexShift\"; its vertices are not moved");
  this->Seen.Clear();
  EXPECT_GT(MaximumDifference(unmoved, expected), 1e-4);
  this->Filter->SetVertexShift(shift);
  EXPECT_EQ(MaximumDifference(this->Run(lost), expected), 0.0);
  EXPECT_FALSE(this->Seen.Warning());
}

TEST_F(CurvedSeamlessSurface, NormalsLookOutwardsWhateverTheDomes)
{
  const vtkNew<vtkPolyData> ellipsoid = Ellipsoid(6);
  for (int domeHeight = vtkCurvedSeamlessSurface::NONE;
       domeHeight < vtkCurvedSeamlessSurface::FITTED; ++domeHeight)
  {
    this->Filter->SetDomeHeight(domeHeight);
    vtkPolyData* output = this->ExpectDone(ellipsoid, "");
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double p[3];
      output->GetPoint(i, p);
      double gradient[3] = { (p[0] - 10.0) / 9.0, p[1] / 4.0, p[2] };
      vtkMath::Normalize(gradient);
      ASSERT_GT(vtkMath::Dot(gradient, output->GetPointData()->GetNormals()->GetTuple3(i)), 0.9);
    }
  }
}

// Also where the map to the sphere mirrors, and so the sphere's triangles would come out inside
// out.
TEST_F(CurvedSeamlessSurface, TrianglesRunAsTheNormalsLook)
{
  for (const bool mirrors : { false, true })
  {
    const vtkNew<vtkPolyData> ellipsoid = Ellipsoid(6);
    vtkDataArray* map = ellipsoid->GetPointData()->GetArray("SpherePosition");
    for (vtkIdType i = 0; mirrors && i < map->GetNumberOfTuples(); ++i)
    {
      const double* n = map->GetTuple3(i);
      map->SetTuple3(i, -n[0], -n[1], -n[2]);
    }
    for (const int mode :
      { vtkCurvedSeamlessSurface::PER_TRIANGLE, vtkCurvedSeamlessSurface::EDGE_MATCHED })
    {
      for (int dome = vtkCurvedSeamlessSurface::NONE; dome < vtkCurvedSeamlessSurface::FITTED;
           ++dome)
      {
        SCOPED_TRACE(std::to_string(mirrors) + std::to_string(mode) + std::to_string(dome));
        this->Filter->SetSeamMode(mode);
        this->Filter->SetDomeHeight(dome);
        vtkPolyData* output = this->ExpectDone(ellipsoid, "");
        vtkNew<vtkIdList> ids;
        for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
        {
          output->GetCellPoints(cell, ids);
          double corners[3][3], normal[3];
          for (int k = 0; k < 3; ++k)
          {
            output->GetPoint(ids->GetId(k), corners[k]);
          }
          vtkTriangle::ComputeNormal(corners[0], corners[1], corners[2], normal);
          double* smooth = output->GetPointData()->GetNormals()->GetTuple3(ids->GetId(0));
          ASSERT_GT(vtkMath::Dot(normal, smooth), 0.0);
          corners[0][0] -= 10.0; // seen from the middle
          ASSERT_GT(vtkMath::Dot(normal, corners[0]), 0.0);
        }
      }
    }
  }
}

TEST_F(CurvedSeamlessSurface, WithoutInputTheExecutiveComplains)
{
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(CurvedSeamlessSurface, EmptyInputsGiveAWarningAndNothing)
{
  this->Run(vtkNew<vtkPolyData>());
  EXPECT_FALSE(this->Seen.Error());
  EXPECT_NE(this->Seen.WarningMessage().find("the surface is empty"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);

  this->Seen.Clear();
  this->Filter->SetSphereData(vtkNew<vtkPolyData>());
  this->Run(Ellipsoid());
  EXPECT_FALSE(this->Seen.Error());
  EXPECT_NE(
    this->Seen.WarningMessage().find("the sphere on input port 1 is empty"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(CurvedSeamlessSurface, StopsWhenAskedWithoutAWord)
{
  struct Abort : vtkCommand
  {
    static Abort* New() { return new Abort; }
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
      static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
    }
  };
  this->Filter->AddObserver(vtkCommand::ProgressEvent, vtkNew<Abort>());
  vtkPolyData* output = this->Run(Ellipsoid());
  EXPECT_FALSE(this->Seen.Error());
  EXPECT_FALSE(this->Seen.Warning());
  EXPECT_EQ(output->GetNumberOfPoints(), 0);
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(CurvedSeamlessSurface, OpenSurfacesKeepTheirBorder)
{
  const vtkNew<vtkPolyData> open = Ellipsoid();
  fixtures::ChangePolygons(open, [](vtkIdType i, vtkIdList*) { return i != 17; });
  this->Filter->SetInputData(open);
  this->Filter->SetSamplingToNetwork();
  this->Filter->SetSubdivisions(3);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPolys(), 9 * open->GetNumberOfPolys());
  this->Filter->SetSamplingToDirections();
  this->ExpectRefused(open, "border");
}

TEST_F(CurvedSeamlessSurface, SurfacesWithAHandleAreRefused)
{
  // A torus of 8 by 8 quads.
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkDoubleArray> positions;
  positions->SetName("SpherePosition");
  positions->SetNumberOfComponents(3);
  for (int i = 0; i < 8; ++i)
  {
    for (int j = 0; j < 8; ++j)
    {
      const double u = vtkMath::Pi() * i / 4.0, v = vtkMath::Pi() * j / 4.0;
      points->InsertNextPoint(
        (2.0 + std::cos(v)) * std::cos(u), (2.0 + std::cos(v)) * std::sin(u), std::sin(v));
      positions->InsertNextTuple3(1.0, u, v);
      const vtkIdType across = (i + 1) % 8, up = (j + 1) % 8;
      const std::array<vtkIdType, 4> quad{ 8 * i + j, 8 * across + j, 8 * across + up, 8 * i + up };
      quads->InsertNextCell(4, quad.data());
    }
  }
  vtkNew<vtkPolyData> torus;
  torus->SetPoints(points);
  torus->SetPolys(quads);
  torus->GetPointData()->AddArray(positions);
  this->ExpectRefused(torus, "genus");
}

TEST_F(CurvedSeamlessSurface, SeveralPiecesAreRefused)
{
  const vtkNew<vtkPolyData> first = Ellipsoid(), second = Ellipsoid();
  for (vtkIdType i = 0; i < second->GetNumberOfPoints(); ++i)
  {
    double p[3];
    second->GetPoint(i, p);
    second->GetPoints()->SetPoint(i, p[0] + 20.0, p[1], p[2]);
  }
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(first);
  both->AddInputData(second);
  both->Update();
  this->ExpectRefused(both->GetOutput(), "one piece");
}

TEST_F(CurvedSeamlessSurface, NonManifoldSurfacesAreRefused)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkCellArray> cells;
  cells->DeepCopy(surface->GetPolys());
  vtkNew<vtkIdList> ids;
  cells->GetCellAtId(3, ids);
  cells->InsertNextCell(ids);
  surface->SetPolys(cells);
  this->ExpectRefused(surface, "manifold");
}

TEST_F(CurvedSeamlessSurface, PointsThatAreNotFiniteAreRefused)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  surface->GetPoints()->SetPoint(8, 1.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  this->ExpectRefused(surface, "1 of 162 points of the surface are not finite");
}

TEST_F(CurvedSeamlessSurface, SurfacesWithoutAMapAreRefused)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  surface->GetPointData()->RemoveArray("SpherePosition");
  this->ExpectRefused(surface, "has no point array SpherePosition");
  vtkNew<vtkDoubleArray> odd;
  odd->SetName("SpherePosition");
  odd->SetNumberOfComponents(2);
  odd->SetNumberOfTuples(162);
  odd->Fill(1.0);
  surface->GetPointData()->AddArray(odd);
  this->ExpectRefused(surface, "the point array SpherePosition has 2 components instead of 3");
  odd->SetNumberOfComponents(3);
  odd->SetNumberOfTuples(100);
  odd->Fill(1.0);
  surface->Modified();
  this->ExpectRefused(
    surface, "input port 0: the point array \"SpherePosition\" has 100 tuples for 162 points");

  this->Filter->SetSphereData(surface);
  this->ExpectRefused(
    Ellipsoid(), "input port 1: the point array \"SpherePosition\" has 100 tuples for 162 points");
}

TEST_F(CurvedSeamlessSurface, MapsThatAreNoneAreRefused)
{
  vtkNew<vtkPolyData> surface = Ellipsoid();
  SetSpherePosition(surface, 5, std::numeric_limits<double>::infinity(), 0.0, 0.0);
  this->ExpectRefused(surface, "zero or not finite");
  SetSpherePosition(surface, 5, 0.0, 0.0, 0.0);
  surface->Modified();
  this->ExpectRefused(surface, "zero or not finite");
}

TEST_F(CurvedSeamlessSurface, MapsThatDoNotCoverTheSphereOnceAreRefused)
{
  const vtkNew<vtkPolyData> bowl = Ellipsoid();
  for (vtkIdType i = 0; i < bowl->GetNumberOfPoints(); ++i)
  {
    const double* n = bowl->GetPointData()->GetArray("SpherePosition")->GetTuple3(i);
    SetSpherePosition(bowl, i, n[0], n[1], std::abs(n[2]));
  }
  this->ExpectRefused(bowl, "cover the sphere exactly once");

  const vtkNew<vtkPolyData> folded = Ellipsoid();
  const double* n = folded->GetPointData()->GetArray("SpherePosition")->GetTuple3(0);
  SetSpherePosition(folded, 0, -n[0], -n[1], -n[2]);
  this->ExpectRefused(folded, "triangles folded over");
}

TEST_F(CurvedSeamlessSurface, BadDenseSpheresAreRefused)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  const vtkNew<vtkPolyData> sphere = Ellipsoid();
  SetSpherePosition(sphere, 5, std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0);
  this->Filter->SetSphereData(sphere);
  this->ExpectRefused(surface, "direction 5 is zero or not finite");

  sphere->GetPointData()->RemoveArray("SpherePosition");
  sphere->GetPoints()->SetPoint(9, 0.0, 0.0, 0.0);
  sphere->Modified();
  this->ExpectRefused(surface, "direction 9 is zero or not finite");
}

TEST_F(CurvedSeamlessSurface, TrianglesThatDisagreeAreTurned)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  fixtures::TurnOverEvery(50, surface);
  vtkPolyData* output = this->ExpectDone(surface, "7 triangles were reversed");
  EXPECT_LT(MaximumDifference(output, expected), 1e-12);
}

TEST_F(CurvedSeamlessSurface, TrianglesInsideOutAreFine)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  fixtures::TurnOverEvery(1, surface);
  EXPECT_LT(MaximumDifference(this->ExpectDone(surface, ""), expected), 1e-12);
}

TEST_F(CurvedSeamlessSurface, PolygonSoupIsMerged)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> positions;
  positions->SetName("SpherePosition");
  positions->SetNumberOfComponents(3);
  vtkDataArray* old = surface->GetPointData()->GetArray("SpherePosition");
  fixtures::ChangePolygons(surface,
    [&](vtkIdType, vtkIdList* ids)
    {
      for (vtkIdType k = 0; k < 3; ++k)
      {
        positions->InsertNextTuple(ids->GetId(k), old);
        ids->SetId(k, points->InsertNextPoint(surface->GetPoint(ids->GetId(k))));
      }
      return true;
    });
  surface->SetPoints(points);
  surface->GetPointData()->Initialize();
  surface->GetPointData()->AddArray(positions);
  vtkPolyData* output = this->ExpectDone(surface, "798 coincident points"); // 960 - 162
  EXPECT_LT(MaximumDifference(output, expected), 1e-12);
}

TEST_F(CurvedSeamlessSurface, QuadsAndStripsAreCutSilently)
{
  vtkNew<vtkCellArray> quads;
  for (const std::array<vtkIdType, 4>& quad : { std::array<vtkIdType, 4>{ 0, 2, 3, 1 },
         { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
  {
    quads->InsertNextCell(4, quad.data());
  }
  this->Filter->SetSamplingToDirections();
  this->Filter->SetVertexShift(-1.0); // no mesh of vtkConformalSOM has 8 points
  this->ExpectDone(Cube(quads), "");
  this->Filter->SetVertexShift(0.0);

  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(surface);
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  // Away from edges, where it would matter which of two triangles comes first.
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(13);
  sphere->SetStartTheta(7.0);
  this->Filter->SetSphereConnection(sphere->GetOutputPort());
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  EXPECT_LT(MaximumDifference(this->Run(stripper->GetOutput()), expected), 1e-12);
  EXPECT_FALSE(this->Seen.Warning());
}

TEST_F(CurvedSeamlessSurface, TrianglesWithoutAreaAreMarked)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkIdList> ids;
  surface->GetPolys()->GetCellAtId(40, ids);
  surface->GetPoints()->SetPoint(ids->GetId(1), surface->GetPoint(ids->GetId(0)));
  vtkPolyData* output = this->ExpectDone(surface, "2 of 320 triangles of the mesh have no shape");
  EXPECT_EQ(output->GetFieldData()->GetArray("NumberOfDegeneratePatches")->GetTuple1(0), 2.0);
  auto* marks = vtkUnsignedCharArray::SafeDownCast(output->GetCellData()->GetArray("Degenerate"));
  const auto count = std::count(marks->GetPointer(0), marks->GetPointer(0) + 2000, 1);
  EXPECT_GT(count, 10); // about two in 320 of the cells
  EXPECT_LT(count, 100);
}

TEST_F(CurvedSeamlessSurface, IsolatedPointsAreDropped)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  surface->GetPoints()->InsertNextPoint(100.0, 0.0, 0.0);
  surface->GetPointData()->GetArray("SpherePosition")->InsertNextTuple3(0.0, 0.0, 0.0);
  surface->GetPointData()->RemoveArray("Normals");
  surface->Modified();
  vtkPolyData* output = this->ExpectDone(surface, "1 points that belong to no triangle");
  EXPECT_LT(MaximumDifference(output, expected), 1e-12);
}

// A number for each vertex of the mesh is one for each point of the surface, linear between.
TEST_F(CurvedSeamlessSurface, CarriesSupportOn)
{
  const vtkNew<vtkPolyData> mesh = fixtures::Ellipsoid(6);
  vtkNew<vtkDoubleArray> support;
  support->SetName("Supported");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    support->InsertNextValue(mesh->GetPoint(i)[2] > 0.0 ? 0.0 : 1.0);
  }
  for (const int sampling :
    { vtkCurvedSeamlessSurface::NETWORK, vtkCurvedSeamlessSurface::DIRECTIONS })
  {
    vtkNew<vtkCurvedSeamlessSurface> filter;
    filter->SetInputData(mesh);
    filter->SetSampling(sampling);
    filter->SetFrequency(12);
    mesh->GetPointData()->RemoveArray("Supported");
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetPointData()->GetArray("Supported"), nullptr);
    mesh->GetPointData()->AddArray(support);
    mesh->Modified();
    filter->Update();
    vtkPolyData* surface = filter->GetOutput();
    contract::ExpectArray(
      surface->GetPointData(), "Supported", VTK_DOUBLE, 1, surface->GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      const double z = surface->GetPoint(i)[2];
      const double value = surface->GetPointData()->GetArray("Supported")->GetTuple1(i);
      if (std::abs(z) > 0.3)
      {
        ASSERT_NEAR(value, z > 0.0 ? 0.0 : 1.0, 1e-12) << z;
      }
      ASSERT_TRUE(value >= 0.0 && value <= 1.0);
    }
  }
}
