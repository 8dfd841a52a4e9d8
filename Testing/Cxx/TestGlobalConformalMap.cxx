#include "vtkGlobalConformalMap.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalDistortion.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkSphericalAlignment.h"
#include "vtkSurfaceMismatch.h"

#include "vtkAppendPolyData.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkStripper.h"

#include <cmath>
#include <fstream>
#include <limits>
#include <string>

namespace
{
const char* const Counts[] = { "NumberOfIterations", "Converged", "NumberOfFlippedTriangles",
  "SphereMapTier", "NumberOfNegativeStringConstants", "NumberOfInfiniteStringConstants" };

/// A closed surface without symmetry, its triangles acute; 10 f^2 + 2 points.
vtkNew<vtkPolyData> Pebble(int frequency = 6)
{
  vtkNew<vtkGeodesicSphereSource> source;
  source->SetFrequency(frequency);
  source->Update();
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(source->GetOutput());
  surface->GetPointData()->Initialize();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double n[3];
    surface->GetPoint(i, n);
    const double radius = 1.0 + 0.15 * std::sin(3.0 * n[0] + 1.0) * std::cos(2.0 * n[1]);
    surface->GetPoints()->SetPoint(i, 7.0 + radius * n[0], radius * n[1], radius * n[2]);
  }
  return surface;
}

/// Vertices moved in and out at random: obtuse triangles.
void Roughen(vtkPolyData* surface, double amount)
{
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    const double scale = 1.0 + amount * std::sin(1e3 * i * i);
    surface->GetPoints()->SetPoint(i, 7.0 + scale * (p[0] - 7.0), scale * p[1], scale * p[2]);
  }
}

class GlobalConformalMap : public testing::Test
{
protected:
  vtkPolyData* Run(vtkPolyData* surface)
  {
    this->Filter->SetInputData(surface);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  double Figure(const char* name)
  {
    vtkDataArray* array = this->Filter->GetOutput()->GetFieldData()->GetArray(name);
    return array ? array->GetTuple1(0) : std::numeric_limits<double>::quiet_NaN();
  }
  /// Done, one to one, with a warning of this text, or without one if it is empty.
  /// @param[in] degree  -1 for a surface wound inward
  vtkPolyData* ExpectDone(vtkPolyData* surface, const std::string& warning, double degree = 1.0)
  {
    this->Seen.Clear();
    vtkPolyData* output = this->Run(surface);
    this->Seen.ExpectWarning(warning);
    contract::ExpectSpherePosition(output);
    EXPECT_EQ(this->Figure("NumberOfFlippedTriangles"), 0);
    EXPECT_EQ(this->Figure("Converged"), 1);
    EXPECT_NEAR(this->Distortion("SphereDegree"), degree, 1e-9);
    return output;
  }
  void ExpectRefused(vtkPolyData* surface, const std::string& why)
  {
    this->Seen.Clear();
    vtkPolyData* output = this->Run(surface);
    this->Seen.ExpectError(why);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetNumberOfCells(), 0);
    EXPECT_EQ(output->GetFieldData()->GetNumberOfArrays(), 0);
  }
  /// A figure of vtkConformalDistortion.
  double Distortion(const char* name)
  {
    vtkNew<vtkConformalDistortion> distortion;
    distortion->SetInputData(this->Filter->GetOutput());
    distortion->Update();
    return distortion->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
  }
  /// The places of points, by their ids in the surface that went in.
  static double MaximumDifference(vtkPolyData* a, vtkPolyData* b)
  {
    double largest = 0.0;
    for (vtkIdType i = 0; i < b->GetNumberOfPoints(); ++i)
    {
      const double* p = a->GetPointData()->GetArray("SpherePosition")->GetTuple3(i);
      double q[3];
      b->GetPointData()->GetArray("SpherePosition")->GetTuple(i, q);
      largest = std::max(largest, std::sqrt(vtkMath::Distance2BetweenPoints(p, q)));
    }
    return largest;
  }

  vtkNew<vtkGlobalConformalMap> Filter;
  contract::Observed Seen{ this->Filter };
};
}

TEST_F(GlobalConformalMap, WritesTheContractsArrays)
{
  vtkPolyData* output = this->ExpectDone(Pebble(), "");
  EXPECT_EQ(output->GetNumberOfPoints(), 362);
  EXPECT_EQ(output->GetNumberOfPolys(), 720);
  vtkFieldData* data = output->GetFieldData();
  contract::ExpectArray(data, "Energy", VTK_DOUBLE, 1, 1);
  for (const char* name : Counts)
  {
    contract::ExpectArray(data, name, VTK_ID_TYPE, 1, 1);
  }
  EXPECT_EQ(this->Figure("SphereMapTier"), 0);
  EXPECT_EQ(this->Figure("NumberOfIterations"), 1);
  EXPECT_NEAR(this->Figure("Energy"), 4.0 * vtkMath::Pi(), 0.3);
}

TEST_F(GlobalConformalMap, TheSphereIsItsOwnMap)
{
  vtkNew<vtkGeodesicSphereSource> sphere;
  sphere->SetFrequency(20);
  sphere->Update();
  vtkPolyData* output = this->ExpectDone(sphere->GetOutput(), "");
  EXPECT_LT(MaximumDifference(output, sphere->GetOutput()), 2e-3);
}

// Angles are kept, the better the finer the mesh, and areas are not.
TEST_F(GlobalConformalMap, IsConformal)
{
  this->ExpectDone(Pebble(8), "");
  const double coarse = this->Distortion("MeanQuasiConformalError") - 1.0;
  this->ExpectDone(Pebble(24), "");
  const double fine = this->Distortion("MeanQuasiConformalError") - 1.0;
  EXPECT_LT(fine, 0.4 * coarse);
  EXPECT_LT(fine, 0.01);
  EXPECT_LT(this->Distortion("MeanAngleDistortion"), 0.3);
  EXPECT_GT(this->Distortion("AreaDistortionDeviation"), 0.05);
}

// Numbers of science.md's rivals, and ours, on a real scan.
TEST_F(GlobalConformalMap, OfARealScan)
{
  const std::string path = CONFORMALSOM_SCAN_DIR "/igea-closed.ply";
  if (!std::ifstream(path))
  {
    GTEST_SKIP() << path << " is missing";
  }
  vtkNew<vtkConformalPLYReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  this->ExpectDone(reader->GetOutput(), "");
  EXPECT_EQ(this->Figure("SphereMapTier"), 0);
  EXPECT_LT(this->Distortion("MeanQuasiConformalError"), 1.00705);
  EXPECT_LT(this->Distortion("MeanAngleDistortion"), 0.21);
}

TEST_F(GlobalConformalMap, AreaBalanceTradesAnglesForAreas)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    double p[3];
    surface->GetPoint(i, p);
    surface->GetPoints()->SetPoint(i, p[0], p[1], 4.0 * p[2]);
  }
  double lastArea = std::numeric_limits<double>::infinity(), lastAngle = 0.0;
  for (double balance : { 0.0, 0.2, 0.5, 1.0 })
  {
    this->Filter->SetAreaBalance(balance);
    this->ExpectDone(surface, "");
    EXPECT_EQ(this->Figure("SphereMapTier"), balance > 0.0 ? 2 : 0);
    EXPECT_LT(this->Distortion("AreaDistortionDeviation"), lastArea);
    EXPECT_GT(this->Distortion("MeanQuasiConformalError"), lastAngle);
    lastArea = this->Distortion("AreaDistortionDeviation");
    lastAngle = this->Distortion("MeanQuasiConformalError");
  }
}

TEST_F(GlobalConformalMap, GuYauAgreesOnAcuteTriangles)
{
  const vtkNew<vtkPolyData> surface = Pebble(10);
  this->ExpectDone(surface, "");
  const double robust = this->Distortion("MeanQuasiConformalError");
  this->Filter->SetMethodToGuYau();
  this->Filter->SetTolerance(1e-9);
  this->Filter->SetMaximumNumberOfIterations(20000);
  this->ExpectDone(surface, "");
  EXPECT_NEAR(this->Distortion("MeanQuasiConformalError"), robust, 0.01 * robust);
  EXPECT_GT(this->Figure("NumberOfIterations"), 10);
  EXPECT_EQ(this->Figure("NumberOfNegativeStringConstants"), 0);
}

//------------------------------------------------------------------------------
// What the pipeline expects of any filter.

TEST_F(GlobalConformalMap, LeavesItsInputAlone)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  const vtkMTimeType before = surface->GetMTime();
  this->Run(surface);
  EXPECT_EQ(surface->GetMTime(), before);
  EXPECT_EQ(surface->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(surface->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST_F(GlobalConformalMap, KeepsTheDataOfItsInput)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  vtkNew<vtkFloatArray> colors;
  colors->SetName("Colors");
  colors->SetNumberOfTuples(362);
  colors->Fill(5.0);
  surface->GetPointData()->AddArray(colors);
  vtkNew<vtkFloatArray> marks;
  marks->SetName("Marks");
  marks->SetNumberOfTuples(720);
  marks->Fill(6.0);
  surface->GetCellData()->AddArray(marks);
  vtkPolyData* output = this->Run(surface);
  EXPECT_EQ(output->GetPoints(), surface->GetPoints());
  EXPECT_EQ(output->GetPointData()->GetArray("Colors"), colors);
  EXPECT_EQ(output->GetCellData()->GetArray("Marks"), marks);
}

TEST_F(GlobalConformalMap, ThreadsChangeNoBit)
{
  const vtkNew<vtkPolyData> surface = Pebble(30);
  for (int method : { vtkGlobalConformalMap::ROBUST, vtkGlobalConformalMap::GUYAU })
  {
    this->Filter->SetMethod(method);
    this->Filter->SetMaximumNumberOfIterations(20);
    vtkSMPTools::Initialize(1);
    this->Filter->Modified();
    vtkNew<vtkPolyData> alone;
    alone->DeepCopy(this->Run(surface));
    vtkSMPTools::Initialize(2);
    this->Filter->Modified();
    EXPECT_EQ(MaximumDifference(this->Run(surface), alone), 0.0);
    vtkSMPTools::Initialize();
  }
}

TEST_F(GlobalConformalMap, RunsOnlyWhenModifiedAndPrints)
{
  this->Filter->SetInputData(Pebble());
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetAreaBalance(0.5); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetMethodToGuYau(); });
  contract::ExpectRunsOnlyWhenModified(
    this->Filter, [&]() { this->Filter->SetMaximumNumberOfIterations(7); });
  contract::ExpectRunsOnlyWhenModified(this->Filter, [&]() { this->Filter->SetTolerance(1e-3); });
  for (const char* property : { "Method", "AreaBalance", "MaximumNumberOfIterations", "Tolerance" })
  {
    contract::ExpectPrints(this->Filter, property);
  }
}

TEST_F(GlobalConformalMap, ClampsItsProperties)
{
  this->Filter->SetMethod(9);
  EXPECT_EQ(this->Filter->GetMethod(), vtkGlobalConformalMap::GUYAU);
  this->Filter->SetMethodToRobust();
  EXPECT_EQ(this->Filter->GetMethod(), vtkGlobalConformalMap::ROBUST);
  this->Filter->SetAreaBalance(2.0);
  EXPECT_EQ(this->Filter->GetAreaBalance(), 1.0);
  this->Filter->SetMaximumNumberOfIterations(-1);
  EXPECT_EQ(this->Filter->GetMaximumNumberOfIterations(), 0);
}

TEST_F(GlobalConformalMap, ParametersThatAreNotNumbersAreRefused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  this->Filter->SetAreaBalance(nan);
  this->ExpectRefused(Pebble(), "AreaBalance must lie in [0, 1]");
  this->Filter->SetAreaBalance(0.0);
  this->Filter->SetTolerance(nan);
  this->ExpectRefused(Pebble(), "Tolerance must not be negative or NaN");
}

TEST_F(GlobalConformalMap, ReportsProgressAndStopsWithoutAWord)
{
  double last = -1.0;
  vtkNew<vtkCallbackCommand> watch;
  watch->SetClientData(&last);
  watch->SetCallback(
    [](vtkObject*, unsigned long, void* data, void* amount)
    {
      double& seen = *static_cast<double*>(data);
      EXPECT_GE(*static_cast<double*>(amount), seen);
      seen = *static_cast<double*>(amount);
    });
  const unsigned long tag = this->Filter->AddObserver(vtkCommand::ProgressEvent, watch);
  this->ExpectDone(Pebble(), "");
  EXPECT_EQ(last, 1.0);
  this->Filter->RemoveObserver(tag);

  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void* amount)
    {
      if (*static_cast<double*>(amount) > 0.3)
      {
        static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
      }
    });
  this->Filter->AddObserver(vtkCommand::ProgressEvent, abort);
  for (int method : { vtkGlobalConformalMap::ROBUST, vtkGlobalConformalMap::GUYAU })
  {
    this->Filter->SetMethod(method);
    this->Seen.Clear();
    vtkPolyData* output = this->Run(Pebble(40));
    EXPECT_FALSE(this->Seen.Error());
    EXPECT_FALSE(this->Seen.Warning());
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
  }
}

//------------------------------------------------------------------------------
// What happens on bad input.

TEST_F(GlobalConformalMap, WithoutInputTheExecutiveComplains)
{
  this->Filter->Update();
  EXPECT_TRUE(this->Seen.ExecutiveError());
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(GlobalConformalMap, AnEmptySurfaceGivesAWarningAndNothing)
{
  this->Run(vtkNew<vtkPolyData>());
  EXPECT_FALSE(this->Seen.Error());
  EXPECT_NE(this->Seen.WarningMessage().find("the surface is empty"), std::string::npos);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST_F(GlobalConformalMap, PointsWithoutTrianglesAreRefused)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  surface->SetPolys(vtkNew<vtkCellArray>());
  this->ExpectRefused(surface, "but it has no triangles");
}

// The upper half of the pebble, and the same with a hole.
TEST_F(GlobalConformalMap, SheetsAreMappedToTheDisk)
{
  for (const bool hasHole : { false, true })
  {
    const vtkNew<vtkPolyData> surface = Pebble(12);
    fixtures::ChangePolygons(surface,
      [&, first = true](vtkIdType, vtkIdList* ids) mutable
      {
        double p[3];
        surface->GetPoint(ids->GetId(0), p);
        const bool isHole = hasHole && first && p[2] > 0.8;
        first = first && !isHole;
        return p[2] > 0.1 && !isHole;
      });
    vtkNew<vtkCleanPolyData> used;
    used->SetInputData(surface);
    used->Update();
    this->Seen.Clear();
    vtkPolyData* output = this->Run(used->GetOutput());
    this->Seen.ExpectWarning(hasHole ? "2 borders" : "all three corners on the border (ears)");
    vtkPointData* data = output->GetPointData();
    vtkDataArray *sphere = data->GetArray("SpherePosition"), *disk = data->GetArray("DiskPosition");
    ASSERT_TRUE(sphere && disk);
    EXPECT_EQ(disk->GetNumberOfComponents(), 2);
    vtkIdType onBorder = 0;
    for (vtkIdType i = 0; i < sphere->GetNumberOfTuples(); ++i)
    {
      const double z = sphere->GetComponent(i, 2);
      const double radius = std::hypot(disk->GetComponent(i, 0), disk->GetComponent(i, 1));
      EXPECT_GE(z, 0.0);
      onBorder += z == 0.0;
      EXPECT_NEAR(radius, std::sqrt((1.0 - z) / (1.0 + z)), 1e-12); // stereographic projection
    }
    EXPECT_GT(onBorder, 20);
    EXPECT_EQ(this->Figure("NumberOfFlippedTriangles"), 0);
    EXPECT_NEAR(
      output->GetFieldData()->GetArray("Energy")->GetTuple1(0), 2.0 * vtkMath::Pi(), 0.15);
    this->Filter->SetAreaBalance(0.5);
    this->ExpectRefused(used->GetOutput(), "AreaBalance 0");
    this->Filter->SetAreaBalance(0.0);
  }
}

// A torus of revolution, whose modulus is known.
TEST_F(GlobalConformalMap, MapsASurfaceOfGenusOneToAFlatTorus)
{
  const auto torus = fixtures::Torus(0.6, 60, 60);
  this->Seen.Clear();
  vtkPolyData* output = this->Run(torus);
  this->Seen.ExpectWarning("");
  contract::ExpectArray(
    output->GetPointData(), "TorusPosition", VTK_DOUBLE, 2, output->GetNumberOfPoints());
  EXPECT_FALSE(output->GetPointData()->HasArray("SpherePosition"));
  contract::ExpectArray(output->GetFieldData(), "TorusModulus", VTK_DOUBLE, 2, 1);
  const double* modulus = output->GetFieldData()->GetArray("TorusModulus")->GetTuple2(0);
  EXPECT_NEAR(modulus[0], 0.0, 1e-9);
  EXPECT_NEAR(modulus[1], std::sqrt(1.0 - 0.36) / 0.6, 3e-3);
  for (const char* name : { "Energy", "MeanQuasiConformalError", "QuasiConformalError95" })
  {
    contract::ExpectArray(output->GetFieldData(), name, VTK_DOUBLE, 1, 1);
    EXPECT_NEAR(this->Figure(name), 1.0, 0.1) << name;
    EXPECT_GE(this->Figure(name), 1.0) << name;
  }
  EXPECT_EQ(this->Figure("NumberOfFlippedTriangles"), 0);
  EXPECT_EQ(this->Figure("Converged"), 1);
  // Inside out, the map is mirrored with the surface.
  const auto reversed = fixtures::Torus(0.6, 60, 60, true);
  this->Run(reversed);
  this->Seen.ExpectWarning("");
  EXPECT_NEAR(
    this->Filter->GetOutput()->GetFieldData()->GetArray("TorusModulus")->GetComponent(0, 1),
    std::sqrt(1.0 - 0.36) / 0.6, 3e-3);
}

// Arrays of an earlier map, which the new map does not replace.
TEST_F(GlobalConformalMap, RemovesArraysOfAnEarlierMap)
{
  const auto sphere = Pebble();
  const auto torus = fixtures::Torus(0.6, 20, 12);
  for (vtkPolyData* surface : { sphere.Get(), torus.Get() })
  {
    for (const char* name : { "DiskPosition", "TorusPosition", "SpherePosition" })
    {
      vtkNew<vtkDoubleArray> old;
      old->SetName(name);
      old->SetNumberOfComponents(2);
      old->SetNumberOfTuples(surface->GetNumberOfPoints());
      old->Fill(0.5);
      surface->GetPointData()->AddArray(old);
    }
    for (const char* name : { "SphereMapTier", "TorusModulus", "QuasiConformalError95" })
    {
      vtkNew<vtkDoubleArray> old;
      old->SetName(name);
      old->InsertNextValue(7.0);
      surface->GetFieldData()->AddArray(old);
    }
    const bool isTorus = surface == torus.Get();
    vtkPolyData* output = this->Run(surface);
    vtkPointData* points = output->GetPointData();
    vtkFieldData* data = output->GetFieldData();
    EXPECT_FALSE(points->HasArray("DiskPosition"));
    EXPECT_EQ(points->HasArray("SpherePosition") != 0, !isTorus);
    EXPECT_EQ(points->HasArray("TorusPosition") != 0, isTorus);
    EXPECT_EQ(data->HasArray("SphereMapTier") != 0, !isTorus);
    EXPECT_EQ(data->HasArray("TorusModulus") != 0, isTorus);
    EXPECT_EQ(data->HasArray("QuasiConformalError95") != 0, isTorus);
    EXPECT_TRUE(surface->GetPointData()->HasArray("DiskPosition"));
    EXPECT_TRUE(surface->GetFieldData()->HasArray("SphereMapTier"));
  }
}

TEST_F(GlobalConformalMap, MapsGenusOneOnlyRobustly)
{
  const auto torus = fixtures::Torus(0.6, 20, 12);
  this->Filter->SetMethodToGuYau();
  this->ExpectRefused(torus, "a surface of genus 1 is mapped only by Method ROBUST");
  this->Filter->SetMethodToRobust();
  this->Filter->SetAreaBalance(0.5);
  this->ExpectRefused(torus, "AreaBalance 0");
}

// Filters for maps to the sphere reject the result with a reason.
TEST_F(GlobalConformalMap, OtherFiltersRejectAMapToATorus)
{
  this->Run(fixtures::Torus(0.6, 20, 12));
  vtkNew<vtkConformalDistortion> distortion;
  contract::Observed seen{ distortion };
  distortion->SetInputData(this->Filter->GetOutput());
  distortion->Update();
  seen.ExpectError("it is mapped to a flat torus");
}

// Triangles this large cannot preserve the angles.
TEST_F(GlobalConformalMap, WarnsOfTrianglesTooLargeForATorus)
{
  this->Seen.Clear();
  this->Run(fixtures::Torus(0.6, 3, 3));
  this->Seen.ExpectWarning("far from conformal");
}

TEST_F(GlobalConformalMap, AHigherGenusIsRefusedWithTheWayOut)
{
  this->ExpectRefused(fixtures::SphereWithHandles(2, 20),
    "the surface has genus 2 (number of handles); only surfaces of genus 0 are mapped to the "
    "sphere, and surfaces of genus 1 to a flat torus. vtkGenusZeroRepair removes handles");
}

TEST_F(GlobalConformalMap, SeveralPiecesAreRefused)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(Pebble(2));
  both->AddInputData(Pebble(3));
  both->Update();
  this->ExpectRefused(both->GetOutput(), "2 components");
}

TEST_F(GlobalConformalMap, NonManifoldSurfacesAreRefusedWithFirstIds)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  vtkNew<vtkCellArray> cells;
  cells->DeepCopy(surface->GetPolys());
  vtkNew<vtkIdList> ids;
  cells->GetCellAtId(3, ids);
  cells->InsertNextCell({ ids->GetId(0), ids->GetId(1), 300 });
  surface->SetPolys(cells);
  this->ExpectRefused(surface, "1 edge of more than two triangles (first: ");

  vtkNew<vtkAppendPolyData> both; // joined in one point
  const vtkNew<vtkPolyData> other = Pebble();
  both->AddInputData(Pebble());
  both->AddInputData(other);
  both->Update();
  fixtures::ChangePolygons(both->GetOutput(),
    [](vtkIdType, vtkIdList* corners)
    {
      for (vtkIdType k = 0; k < 3; ++k)
      {
        corners->SetId(k, corners->GetId(k) == 362 + 5 ? 0 : corners->GetId(k));
      }
      return true;
    });
  this->ExpectRefused(both->GetOutput(), "1 vertex with several fans of triangles (first: ");
}

TEST_F(GlobalConformalMap, PointsThatAreNotFiniteAreRefused)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  surface->GetPoints()->SetPoint(8, 1.0, std::numeric_limits<double>::quiet_NaN(), 0.0);
  this->ExpectRefused(surface, "1 of 362 points of the surface are not finite");
}

TEST_F(GlobalConformalMap, TrianglesThatDisagreeAreTurned)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  fixtures::TurnOverEvery(100, surface);
  vtkPolyData* output = this->ExpectDone(surface, "8 triangles were reversed");
  EXPECT_LT(MaximumDifference(output, expected), 1e-9);
}

TEST_F(GlobalConformalMap, TrianglesInsideOutAreMappedFromOutside)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  fixtures::TurnOverEvery(1, surface);
  EXPECT_LT(MaximumDifference(this->ExpectDone(surface, "", -1.0), expected), 1e-6);
}

TEST_F(GlobalConformalMap, PolygonSoupIsMerged)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  fixtures::ChangePolygons(surface,
    [&](vtkIdType, vtkIdList* ids)
    {
      for (vtkIdType k = 0; k < 3; ++k)
      {
        ids->SetId(k, points->InsertNextPoint(surface->GetPoint(ids->GetId(k))));
      }
      return true;
    });
  surface->SetPoints(points);
  vtkPolyData* output = this->ExpectDone(surface, "1798 coincident points"); // 2160 - 362
  EXPECT_EQ(output->GetNumberOfPoints(), 362);
  EXPECT_EQ(output->GetNumberOfPolys(), 720);
}

TEST_F(GlobalConformalMap, QuadsAndStripsAreCutSilently)
{
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(Pebble());
  stripper->Update();
  ASSERT_GT(stripper->GetOutput()->GetNumberOfStrips(), 0);
  vtkPolyData* output = this->ExpectDone(stripper->GetOutput(), "");
  EXPECT_EQ(output->GetNumberOfPoints(), 362);

  vtkNew<vtkCubeSource> cube; // six quads of four points each, to be merged
  cube->Update();
  output = this->ExpectDone(cube->GetOutput(), "16 coincident points");
  EXPECT_EQ(output->GetNumberOfPoints(), 8);
  EXPECT_EQ(output->GetNumberOfPolys(), 12);
}

TEST_F(GlobalConformalMap, IsolatedPointsAreDropped)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  vtkNew<vtkPolyData> expected;
  expected->DeepCopy(this->Run(surface));
  vtkNew<vtkFloatArray> ids;
  ids->SetName("Ids");
  surface->GetPoints()->InsertNextPoint(100.0, 0.0, 0.0);
  for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
  {
    ids->InsertNextValue(static_cast<float>(i));
  }
  surface->GetPointData()->AddArray(ids);
  surface->Modified();
  vtkPolyData* output = this->ExpectDone(surface, "1 points that belong to no triangle");
  ASSERT_EQ(output->GetNumberOfPoints(), 362);
  EXPECT_EQ(MaximumDifference(output, expected), 0.0);
  EXPECT_EQ(output->GetPointData()->GetArray("Ids")->GetTuple1(361), 361.0);
}

TEST_F(GlobalConformalMap, TrianglesWithoutAreaAreMappedWithAWarning)
{
  const vtkNew<vtkPolyData> surface = Pebble();
  vtkNew<vtkIdList> ids;
  surface->GetPolys()->GetCellAtId(40, ids);
  surface->GetPoints()->SetPoint(ids->GetId(1), surface->GetPoint(ids->GetId(0)));
  this->ExpectDone(surface, "5 edges belong to triangles without area");
  EXPECT_EQ(this->Figure("NumberOfInfiniteStringConstants"), 5);

  this->Filter->SetMethodToGuYau();
  this->Seen.Clear();
  vtkPolyData* output = this->Run(surface);
  EXPECT_FALSE(this->Seen.Error());
  // Further iterations would not help.
  EXPECT_NE(this->Seen.WarningMessage().find("infinite and are left out"), std::string::npos);
  EXPECT_EQ(this->Seen.WarningMessage().find("not converged"), std::string::npos);
  EXPECT_EQ(this->Figure("Converged"), 0);
  EXPECT_EQ(this->Figure("NumberOfInfiniteStringConstants"), 5);
  contract::ExpectSpherePosition(output);
}

// The failure that the paper shows, and what ROBUST makes of the same surface.
TEST_F(GlobalConformalMap, ObtuseTrianglesFoldGuYauOnly)
{
  const vtkNew<vtkPolyData> surface = Pebble(16);
  Roughen(surface, 0.3);
  this->ExpectDone(surface, "");
  EXPECT_GT(this->Figure("NumberOfNegativeStringConstants"), 100);

  this->Filter->SetMethodToGuYau();
  this->Seen.Clear();
  vtkPolyData* output = this->Run(surface);
  EXPECT_FALSE(this->Seen.Error());
  EXPECT_NE(this->Seen.WarningMessage().find("triangles are flipped"), std::string::npos);
  EXPECT_EQ(this->Figure("Converged"), 0);
  EXPECT_GT(this->Figure("NumberOfFlippedTriangles"), 10);
  EXPECT_EQ(this->Figure("NumberOfFlippedTriangles"), this->Distortion("NumberOfFlippedTriangles"));
  contract::ExpectSpherePosition(output);
}

TEST_F(GlobalConformalMap, StoppingEarlyIsAWarningAndTheBestSoFar)
{
  this->Filter->SetMethodToGuYau();
  this->Filter->SetMaximumNumberOfIterations(3);
  vtkPolyData* output = this->Run(Pebble(10));
  EXPECT_FALSE(this->Seen.Error());
  EXPECT_NE(
    this->Seen.WarningMessage().find("has not converged in 6 iterations"), std::string::npos);
  EXPECT_EQ(this->Figure("Converged"), 0);
  contract::ExpectSpherePosition(output);
}

//------------------------------------------------------------------------------
// Together with the other way to make a map.

TEST_F(GlobalConformalMap, FeedsTheCurvedSeamlessSurface)
{
  this->Filter->SetInputData(Pebble(8));
  vtkNew<vtkCurvedSeamlessSurface> surface;
  surface->SetInputConnection(this->Filter->GetOutputPort());
  surface->SetFrequency(20);
  surface->Update();
  EXPECT_FALSE(this->Seen.Error());
  ASSERT_EQ(surface->GetOutput()->GetNumberOfPoints(), 4002);
  contract::ExpectSpherePosition(surface->GetOutput());
}

// The neurons start where the map says, so the learned mesh is aligned with it.
TEST_F(GlobalConformalMap, StartsLearning)
{
  const vtkNew<vtkPolyData> surface = Pebble(24);
  this->Filter->SetInputData(surface);
  vtkNew<vtkConformalSOM> network;
  network->SetInputData(surface);
  network->SetInputConnection(1, this->Filter->GetOutputPort());
  network->SetNumberOfNeurons(1002);
  contract::Observed observed(network);
  vtkNew<vtkSurfaceMismatch> mismatch;
  mismatch->SetInputConnection(0, network->GetOutputPort());
  mismatch->SetInputData(1, surface);
  mismatch->Update();
  EXPECT_FALSE(observed.Error()) << observed.ErrorMessage();
  ASSERT_EQ(network->GetOutput()->GetNumberOfPoints(), 1002);
  EXPECT_LT(
    mismatch->GetOutput()->GetFieldData()->GetArray("MeanSquarePointToSurface")->GetTuple1(0),
    1e-5);
  vtkNew<vtkSphericalAlignment> alignment;
  alignment->SetInputConnection(network->GetOutputPort());
  alignment->SetReferenceConnection(this->Filter->GetOutputPort());
  alignment->Update();
  vtkFieldData* data = alignment->GetOutput()->GetFieldData();
  EXPECT_LT(data->GetArray("AlignmentError")->GetTuple1(0), 0.2);
  const double* rotation = data->GetArray("AlignmentRotation")->GetTuple(0);
  EXPECT_GT(rotation[0] + rotation[4] + rotation[8], 1.0 + 2.0 * std::cos(0.2));
}

// A learned mesh is as conformal as its triangles are equilateral; mapped anew, all of it is.
TEST_F(GlobalConformalMap, MakesALearnedMeshConformal)
{
  const vtkNew<vtkPolyData> cloud = Pebble(40);
  for (vtkIdType i = 0; i < cloud->GetNumberOfPoints(); ++i)
  {
    double p[3];
    cloud->GetPoint(i, p);
    cloud->GetPoints()->SetPoint(i, p[0], p[1], 2.0 * p[2]);
  }
  vtkNew<vtkConformalSOM> network;
  network->SetInputData(cloud);
  network->SetMeshTypeToGeodesic();
  network->SetNumberOfNeurons(2562);
  vtkNew<vtkConformalDistortion> distortion;
  distortion->SetInputConnection(network->GetOutputPort());
  distortion->Update();
  vtkFieldData* data = distortion->GetOutput()->GetFieldData();
  EXPECT_GT(data->GetArray("MeanQuasiConformalError")->GetTuple1(0), 1.15);
  this->Filter->SetInputConnection(network->GetOutputPort());
  this->Filter->Update();
  EXPECT_LT(this->Distortion("MeanQuasiConformalError"), 1.04);
  EXPECT_EQ(this->Distortion("NumberOfFlippedTriangles"), 0);
}

TEST_F(GlobalConformalMap, LeavesTrianglesOfARepeatedPointOut)
{
  const auto surface = fixtures::Ellipsoid();
  const vtkIdType triangles = surface->GetNumberOfPolys();
  surface->GetPolys()->InsertNextCell({ 3, 3, 4 }); // the last ones
  surface->GetPolys()->InsertNextCell({ 5, 5, 5 });
  vtkNew<vtkGlobalConformalMap> filter;
  filter->SetInputData(surface);
  const contract::Observed observed(filter);
  filter->Update();
  observed.ExpectWarning("2 triangles with a repeated point were dropped");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPolys(), triangles);
}
