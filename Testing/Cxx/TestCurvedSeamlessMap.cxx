#include "vtkCurvedSeamlessMap.h"

#include "FilterContract.h"
#include "MeshFixtures.h"
#include "vtkConformalPLYReader.h"
#include "vtkConformalSOM.h"
#include "vtkCurvedSeamlessSurface.h"
#include "vtkGeodesicSphereSource.h"
#include "vtkGlobalConformalMap.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkOBJReader.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <string>
#include <vector>

using fixtures::Ellipsoid;

namespace
{
vtkNew<vtkDoubleArray> RandomDirections(vtkIdType size, unsigned int seed = 1)
{
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  vtkNew<vtkDoubleArray> directions;
  directions->SetNumberOfComponents(3);
  directions->SetNumberOfTuples(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    std::array<double, 3> p{ normal(engine), normal(engine), normal(engine) };
    vtkMath::Normalize(p.data());
    directions->SetTypedTuple(i, p.data());
  }
  return directions;
}

double MaximumDifference(vtkDoubleArray* a, vtkDoubleArray* b)
{
  double largest = a->GetNumberOfValues() == b->GetNumberOfValues()
    ? 0.0
    : std::numeric_limits<double>::infinity();
  for (vtkIdType i = 0; i < a->GetNumberOfValues() && i < b->GetNumberOfValues(); ++i)
  {
    largest = std::max(largest, std::abs(a->GetValue(i) - b->GetValue(i)));
  }
  return largest;
}

class CurvedSeamlessMap : public testing::Test
{
protected:
  CurvedSeamlessMap()
  {
    this->Map->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Map->AddObserver(vtkCommand::WarningEvent, this->Observer);
  }

  /// An error with this text.
  void ExpectError(bool result, const std::string& why)
  {
    EXPECT_FALSE(result);
    EXPECT_TRUE(this->Observer->GetError());
    EXPECT_NE(this->Observer->GetErrorMessage().find(why), std::string::npos)
      << this->Observer->GetErrorMessage();
    this->Observer->Clear();
  }

  bool Build(vtkPolyData* surface, vtkPointSet* cloud = nullptr)
  {
    return this->Settings->BuildMap(surface, cloud, this->Map);
  }

  vtkNew<vtkCurvedSeamlessMap> Map;
  vtkNew<vtkCurvedSeamlessSurface> Settings;
  vtkNew<vtkTest::ErrorObserver> Observer;
};

/// Directions of random points of a mesh's edges, a little to either side.
class EdgePoints
{
public:
  EdgePoints(vtkPolyData* mesh, vtkIdType count)
  {
    vtkDataArray* sphere = mesh->GetPointData()->GetArray("SpherePosition");
    std::mt19937_64 engine(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    vtkNew<vtkIdList> ids;
    this->Left->SetNumberOfComponents(3);
    this->Right->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < count; ++i)
    {
      mesh->GetPolys()->GetCellAtId(
        static_cast<vtkIdType>(engine() % mesh->GetNumberOfPolys()), ids);
      const vtkIdType a = ids->GetId(i % 3), b = ids->GetId((i + 1) % 3);
      double from[3], to[3], across[3], p[3];
      sphere->GetTuple(a, from);
      sphere->GetTuple(b, to);
      vtkMath::Cross(from, to, across);
      vtkMath::Normalize(across);
      const double t = uniform(engine);
      for (int c = 0; c < 3; ++c)
      {
        p[c] = (1.0 - t) * from[c] + t * to[c];
      }
      vtkMath::Normalize(p);
      const double aside = 1e-12;
      vtkMath::MultiplyScalar(across, aside);
      this->Left->InsertNextTuple3(p[0] + across[0], p[1] + across[1], p[2] + across[2]);
      this->Right->InsertNextTuple3(p[0] - across[0], p[1] - across[1], p[2] - across[2]);
      mesh->GetPoint(a, from);
      mesh->GetPoint(b, to);
      this->Lengths.push_back(std::sqrt(vtkMath::Distance2BetweenPoints(from, to)));
    }
  }

  struct Jump
  {
    double Mean = 0.0, Maximum = 0.0; // in lengths of the edge
  };
  Jump Jumps(vtkCurvedSeamlessMap* map, vtkPolyData* mesh, vtkCurvedSeamlessSurface* settings) const
  {
    vtkNew<vtkDoubleArray> left, right;
    EXPECT_TRUE(settings->BuildMap(mesh, nullptr, map));
    EXPECT_TRUE(map->ToSurface(this->Left, left));
    EXPECT_TRUE(map->ToSurface(this->Right, right));
    Jump jump;
    for (vtkIdType i = 0; i < left->GetNumberOfTuples(); ++i)
    {
      double p[3], q[3];
      left->GetTypedTuple(i, p);
      right->GetTypedTuple(i, q);
      const double size = std::sqrt(vtkMath::Distance2BetweenPoints(p, q)) / this->Lengths[i];
      jump.Mean += size / static_cast<double>(this->Lengths.size());
      jump.Maximum = std::max(jump.Maximum, size);
    }
    return jump;
  }

private:
  vtkNew<vtkDoubleArray> Left, Right;
  std::vector<double> Lengths;
};

/// The learned mesh of a real scan, with limbs as large on the sphere as the tests' precision
/// needs; null if there is no such file.
vtkSmartPointer<vtkPolyData> LearnedMesh(const std::string& name)
{
  const std::string file = std::string(CONFORMALSOM_SCAN_DIR) + "/" + name;
  if (!std::ifstream(file))
  {
    return nullptr;
  }
  vtkNew<vtkConformalSOM> network;
  network->SetNumberOfNeurons(4002);
  if (name.substr(name.size() - 3) == "obj")
  {
    vtkNew<vtkOBJReader> reader;
    reader->SetFileName(file.c_str());
    network->SetInputConnection(reader->GetOutputPort());
  }
  else
  {
    vtkNew<vtkConformalPLYReader> reader;
    reader->SetFileName(file.c_str());
    network->SetInputConnection(reader->GetOutputPort());
  }
  vtkNew<vtkGlobalConformalMap> map;
  map->SetInputConnection(network->GetOutputPort());
  map->SetAreaBalance(1.0);
  map->Update();
  return map->GetOutput();
}
}

TEST_F(CurvedSeamlessMap, MapsToTheSurface)
{
  ASSERT_TRUE(this->Build(Ellipsoid(12)));
  EXPECT_TRUE(this->Map->IsBuilt());
  EXPECT_EQ(this->Map->GetNumberOfDegeneratePatches(), 0);
  const vtkNew<vtkDoubleArray> directions = RandomDirections(2000);
  vtkNew<vtkDoubleArray> positions, normals;
  ASSERT_TRUE(this->Map->ToSurface(directions, positions, normals));
  ASSERT_EQ(positions->GetNumberOfTuples(), 2000);
  ASSERT_EQ(normals->GetNumberOfTuples(), 2000);
  for (vtkIdType i = 0; i < 2000; ++i)
  {
    double p[3], n[3];
    positions->GetTypedTuple(i, p);
    normals->GetTypedTuple(i, n);
    const double x = (p[0] - 10.0) / 3.0, y = p[1] / 2.0;
    EXPECT_NEAR(x * x + y * y + p[2] * p[2], 1.0, 2e-3);
    double gradient[3] = { x / 3.0, y / 2.0, p[2] };
    vtkMath::Normalize(gradient);
    EXPECT_GT(vtkMath::Dot(n, gradient), 0.999);
  }
  EXPECT_FALSE(this->Observer->GetError());
}

TEST_F(CurvedSeamlessMap, TakesDirectionsOfAnyLengthAndType)
{
  ASSERT_TRUE(this->Build(Ellipsoid(6)));
  vtkNew<vtkIntArray> integers;
  integers->SetNumberOfComponents(3);
  integers->InsertNextTuple3(3, -4, 12);
  vtkNew<vtkFloatArray> floats;
  floats->SetNumberOfComponents(3);
  floats->InsertNextTuple3(0.75, -1.0, 3.0);
  vtkNew<vtkDoubleArray> doubles;
  doubles->SetNumberOfComponents(3);
  doubles->InsertNextTuple3(3e200, -4e200, 12e200);
  vtkNew<vtkDoubleArray> ofIntegers, ofFloats, ofDoubles;
  ASSERT_TRUE(this->Map->ToSurface(integers, ofIntegers));
  ASSERT_TRUE(this->Map->ToSurface(floats, ofFloats));
  ASSERT_TRUE(this->Map->ToSurface(doubles, ofDoubles));
  EXPECT_LT(MaximumDifference(ofIntegers, ofFloats), 1e-14);
  EXPECT_LT(MaximumDifference(ofIntegers, ofDoubles), 1e-14);
}

TEST_F(CurvedSeamlessMap, GoesBackToTheSphere)
{
  ASSERT_TRUE(this->Build(Ellipsoid(6)));
  const vtkNew<vtkDoubleArray> directions = RandomDirections(2000);
  vtkNew<vtkDoubleArray> positions, back, feet;
  ASSERT_TRUE(this->Map->ToSurface(directions, positions));
  ASSERT_TRUE(this->Map->ToSphere(positions, back, feet));
  EXPECT_LT(MaximumDifference(back, directions), 1e-9);
  EXPECT_LT(MaximumDifference(feet, positions), 1e-13);
}

TEST_F(CurvedSeamlessMap, DifferentiatesAndMeasures)
{
  ASSERT_TRUE(this->Build(Ellipsoid(6)));
  const vtkNew<vtkDoubleArray> directions = RandomDirections(500);
  vtkNew<vtkDoubleArray> jacobians, metrics, elements;
  ASSERT_TRUE(this->Map->Differentiate(directions, jacobians, metrics, elements));
  for (vtkIdType i = 0; i < 500; ++i)
  {
    double p[3], j[9], g[9];
    directions->GetTypedTuple(i, p);
    jacobians->GetTypedTuple(i, j);
    metrics->GetTypedTuple(i, g);
    double u[3], v[3], ju[3], jv[3], area[3];
    vtkMath::Perpendiculars(p, u, v, 0.3);
    for (int r = 0; r < 3; ++r)
    {
      ju[r] = vtkMath::Dot(j + 3 * r, u);
      jv[r] = vtkMath::Dot(j + 3 * r, v);
      for (int c = 0; c < 3; ++c)
      {
        EXPECT_NEAR(g[3 * r + c], j[r] * j[c] + j[3 + r] * j[3 + c] + j[6 + r] * j[6 + c], 1e-12);
      }
    }
    vtkMath::Cross(ju, jv, area);
    EXPECT_NEAR(elements->GetValue(i), vtkMath::Norm(area), 1e-12);
  }
  // Alone too.
  vtkNew<vtkDoubleArray> alone;
  ASSERT_TRUE(this->Map->Differentiate(directions, nullptr, nullptr, alone));
  EXPECT_EQ(MaximumDifference(alone, elements), 0.0);
}

TEST_F(CurvedSeamlessMap, SaysWhatCannotBeDone)
{
  const vtkNew<vtkDoubleArray> directions = RandomDirections(5);
  vtkNew<vtkDoubleArray> result;
  this->ExpectError(this->Map->ToSurface(directions, result), "call Build() first");
  this->ExpectError(this->Build(nullptr), "the surface is empty");
  this->ExpectError(this->Build(vtkNew<vtkPolyData>()), "the surface is empty");
  EXPECT_FALSE(this->Map->IsBuilt());

  ASSERT_TRUE(this->Build(Ellipsoid(6)));
  this->ExpectError(this->Map->ToSurface(nullptr, result), "array of 3 components");
  vtkNew<vtkDoubleArray> odd;
  odd->SetNumberOfComponents(2);
  odd->InsertNextTuple2(1.0, 0.0);
  this->ExpectError(this->Map->ToSurface(odd, result), "array of 3 components");
  directions->SetTuple3(3, 0.0, 0.0, 0.0);
  result->SetNumberOfTuples(7);
  this->ExpectError(this->Map->ToSurface(directions, result), "direction 3 is zero");
  EXPECT_EQ(result->GetNumberOfTuples(), 0);
  this->ExpectError(this->Map->Differentiate(directions, result), "direction 3 is zero");
  directions->SetTuple3(3, std::nan(""), 0.0, 0.0);
  this->ExpectError(this->Map->ToSphere(directions, result), "point 3 is not finite");

  directions->SetTuple3(3, 1.0, 0.0, 0.0);
  this->Settings->SetDomeHeightToPublished();
  ASSERT_TRUE(this->Build(Ellipsoid(6)));
  ASSERT_TRUE(this->Map->ToSurface(directions, result));
  this->ExpectError(this->Map->Differentiate(directions, result), "no derivative");
  this->ExpectError(this->Map->ToSphere(directions, result), "no inverse");
  this->Settings->SetDomeHeightToFitted();
  this->ExpectError(this->Build(Ellipsoid(6)), "needs a cloud of points");
  EXPECT_FALSE(this->Map->IsBuilt()); // the old one must not be taken for the new one
}

TEST_F(CurvedSeamlessMap, EmptyArraysGiveEmptyArrays)
{
  ASSERT_TRUE(this->Build(Ellipsoid(6)));
  vtkNew<vtkDoubleArray> none, result;
  none->SetNumberOfComponents(3);
  EXPECT_TRUE(this->Map->ToSurface(none, result));
  EXPECT_EQ(result->GetNumberOfTuples(), 0);
  EXPECT_TRUE(this->Map->ToSphere(none, result));
  EXPECT_TRUE(this->Map->Differentiate(none, result));
}

TEST_F(CurvedSeamlessMap, DegenerateTrianglesAreCountedWithAWarning)
{
  const vtkNew<vtkPolyData> surface = Ellipsoid(6);
  vtkNew<vtkIdList> ids;
  surface->GetPolys()->GetCellAtId(40, ids);
  surface->GetPoints()->SetPoint(ids->GetId(1), surface->GetPoint(ids->GetId(0)));
  EXPECT_TRUE(this->Build(surface));
  EXPECT_TRUE(this->Observer->GetWarning());
  EXPECT_NE(this->Observer->GetWarningMessage().find("2 of 720 triangles"), std::string::npos);
  EXPECT_EQ(this->Map->GetNumberOfDegeneratePatches(), 2);
}

TEST_F(CurvedSeamlessMap, KnowsHowMuchItsNormalsJump)
{
  double jumps[2] = { -1.0, -1.0 };
  this->Map->GetNormalJumps(jumps);
  EXPECT_EQ(jumps[0], 0.0);
  ASSERT_TRUE(this->Build(Ellipsoid(12)));
  this->Map->GetNormalJumps(jumps);
  EXPECT_GT(jumps[0], 0.0);
  EXPECT_LT(jumps[0], 1.0);
  EXPECT_GT(jumps[1], jumps[0]);
}

TEST_F(CurvedSeamlessMap, ArraysThatDoNotFitTheirPointsAreRefused)
{
  for (const vtkIdType tuples : { 0, 361, 363 })
  {
    const vtkNew<vtkPolyData> surface = Ellipsoid(6);
    vtkNew<vtkFloatArray> numbers;
    numbers->SetName("Unrelated");
    numbers->SetNumberOfTuples(tuples);
    surface->GetPointData()->AddArray(numbers);
    const std::string text =
      "the point array \"Unrelated\" has " + std::to_string(tuples) + " tuples for 362 points";
    this->ExpectError(this->Build(surface), "surface: " + text);
    EXPECT_FALSE(this->Map->IsBuilt());
    this->ExpectError(this->Build(Ellipsoid(6), surface), "cloud: " + text);
    EXPECT_FALSE(this->Map->IsBuilt());
  }
  const vtkNew<vtkPolyData> surface = Ellipsoid(6);
  vtkNew<vtkDoubleArray> shift;
  shift->SetName("VertexShift");
  surface->GetFieldData()->AddArray(shift);
  const char* message = "VertexShift of the surface has no number in [0, 2]";
  this->ExpectError(this->Build(surface), message);
  shift->InsertNextValue(2.5);
  this->ExpectError(this->Build(surface), message);
  shift->SetValue(0, std::nan(""));
  this->ExpectError(this->Build(surface), message);
  this->Settings->SetVertexShift(0.5); // the array is not used
  EXPECT_TRUE(this->Build(surface));
}

// One array for two purposes would be emptied or written twice.
TEST_F(CurvedSeamlessMap, EachArrayIsOfItsOwn)
{
  ASSERT_TRUE(this->Build(Ellipsoid(6)));
  const vtkNew<vtkDoubleArray> directions = RandomDirections(10);
  vtkNew<vtkDoubleArray> a, b;
  this->ExpectError(this->Map->ToSurface(directions, directions), "passed twice");
  EXPECT_EQ(directions->GetNumberOfTuples(), 10);
  this->ExpectError(this->Map->ToSurface(directions, a, a), "passed twice");
  this->ExpectError(this->Map->Differentiate(directions, a, b, a), "passed twice");
  this->ExpectError(this->Map->ToSphere(directions, a, directions), "passed twice");
  this->ExpectError(
    this->Map->ToSphere(directions, nullptr, a), "the array for the directions is null");
  EXPECT_TRUE(this->Map->ToSurface(directions, nullptr, nullptr));
  EXPECT_TRUE(this->Map->ToSurface(directions, a, b));
}

TEST_F(CurvedSeamlessMap, IsBuiltWithTheSettingsOfAFilter)
{
  contract::ExpectPrints(this->Map, "IsBuilt");
  const vtkNew<vtkDoubleArray> directions = RandomDirections(20);
  vtkNew<vtkDoubleArray> plain, usual, flat;
  const vtkNew<vtkPolyData> mesh = Ellipsoid(6);
  ASSERT_TRUE(this->Map->Build(mesh));
  ASSERT_TRUE(this->Map->ToSurface(directions, plain));
  ASSERT_TRUE(this->Build(mesh));
  ASSERT_TRUE(this->Map->ToSurface(directions, usual));
  this->Settings->SetDomeHeightToNone();
  ASSERT_TRUE(this->Build(mesh));
  ASSERT_TRUE(this->Map->ToSurface(directions, flat));
  EXPECT_EQ(MaximumDifference(plain, usual), 0.0);
  EXPECT_GT(MaximumDifference(plain, flat), 1e-4);
  this->Settings->SetDomeHeightToCurvature();
  this->Settings->SetVertexShift(std::nan("")); // which clamps let through
  this->ExpectError(this->Build(mesh), "VertexShift");
}

//------------------------------------------------------------------------------
// On learned meshes of real scans.

TEST_F(CurvedSeamlessMap, MeetsAcrossEdgesOfLearnedMeshes)
{
  for (const char* name : { "igea.ply", "stanford-bunny.obj" })
  {
    const vtkSmartPointer<vtkPolyData> mesh = LearnedMesh(name);
    if (!mesh)
    {
      GTEST_SKIP() << name << " is not in CONFORMALSOM_SCAN_DIR";
    }
    const EdgePoints points(mesh, 100000);
    this->Settings->SetSeamModeToEdgeMatched();
    EXPECT_LE(points.Jumps(this->Map, mesh, this->Settings).Maximum, 2e-9) << name;
    this->Settings->SetSeamModeToPerTriangle();
    const auto published = points.Jumps(this->Map, mesh, this->Settings);
    EXPECT_GT(published.Mean, 0.03) << name;
    EXPECT_GT(published.Maximum, 0.3) << name;
  }
}

TEST_F(CurvedSeamlessMap, GoesBackFromLearnedMeshes)
{
  const vtkNew<vtkDoubleArray> directions = RandomDirections(200000);
  for (const char* name : { "igea.ply", "stanford-bunny.obj" })
  {
    const vtkSmartPointer<vtkPolyData> mesh = LearnedMesh(name);
    if (!mesh)
    {
      GTEST_SKIP() << name << " is not in CONFORMALSOM_SCAN_DIR";
    }
    ASSERT_TRUE(this->Build(mesh));
    vtkNew<vtkDoubleArray> positions, back;
    ASSERT_TRUE(this->Map->ToSurface(directions, positions));
    ASSERT_TRUE(this->Map->ToSphere(positions, back));
    EXPECT_LE(MaximumDifference(back, directions), 1e-9) << name;
  }
}
