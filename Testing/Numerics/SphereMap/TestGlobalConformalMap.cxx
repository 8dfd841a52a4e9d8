#include "SphereMap/GlobalConformalMap.h"

#include "Base/Random.h"
#include "Measure/Distortion.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/Remeshing.h"
#include "Runs.h"
#include "Sphere/ClosestMoebiusTransform.h"
#include "Sphere/SphereOrientation.h"
#include "Spheres.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

using conformal::globalConformalMap;
using conformal::GlobalConformalMapOptions;
using conformal::GlobalConformalMapResult;
using conformal::GlobalConformalMethod;
using conformal::GlobalConformalTier;
using conformal::Index;
using conformal::Mesh;
using conformal::Points;
using conformal::Vector3;
using spheres::shaped;

namespace
{
const double Pi = std::acos(-1.0);

// Smooth, without symmetry, its triangles acute.
Mesh bumpy(int frequency)
{
  return shaped(frequency,
    [](const Vector3& n)
    { return Vector3(n * (1.0 + 0.15 * std::sin(3.0 * n[0] + 1.0) * std::cos(2.0 * n[1]))); });
}

Mesh noisy(int frequency, double amount)
{
  conformal::Random random(1);
  return shaped(
    frequency, [&](const Vector3& n) { return Vector3(n * (1.0 + amount * random.uniform())); });
}

// A closed tube of circumference 2 pi; length in circumferences.
Mesh tube(double length, int sides = 16)
{
  std::vector<std::pair<double, double>> profile; // radius, height
  const int cap = sides / 4;
  for (int i = 1; i < cap; ++i)
  {
    profile.emplace_back(std::sin(0.5 * Pi * i / cap), -std::cos(0.5 * Pi * i / cap));
  }
  const int rings = static_cast<int>(length * sides);
  const double step = 2.0 * Pi / sides;
  for (int i = 0; i <= rings; ++i)
  {
    profile.emplace_back(1.0, i * step);
  }
  for (int i = cap - 1; i > 0; --i)
  {
    profile.emplace_back(std::sin(0.5 * Pi * i / cap), rings * step + std::cos(0.5 * Pi * i / cap));
  }
  const int size = static_cast<int>(profile.size());
  Mesh mesh;
  mesh.Positions.resize(2 + size * sides, 3);
  mesh.Positions.row(0) << 0.0, 0.0, -1.0;
  const int last = 1 + size * sides;
  mesh.Positions.row(last) << 0.0, 0.0, rings * step + 1.0;
  std::vector<int> ids;
  const auto id = [&](int ring, int k) { return 1 + ring * sides + k % sides; };
  for (int k = 0; k < sides; ++k)
  {
    for (int i = 0; i < size; ++i)
    {
      mesh.Positions.row(id(i, k)) << profile[i].first * std::cos(k * step),
        profile[i].first * std::sin(k * step), profile[i].second;
      if (i + 1 < size)
      {
        ids.insert(ids.end(), { id(i, k), id(i, k + 1), id(i + 1, k + 1) });
        ids.insert(ids.end(), { id(i, k), id(i + 1, k + 1), id(i + 1, k) });
      }
    }
    ids.insert(ids.end(), { 0, id(0, k + 1), id(0, k) });
    ids.insert(ids.end(), { last, id(size - 1, k), id(size - 1, k + 1) });
  }
  mesh.Triangles =
    Eigen::Map<conformal::Triangles>(ids.data(), static_cast<Index>(ids.size()) / 3, 3);
  return mesh;
}

// Triangles split into three, again and again, at random.
Mesh valenceThree(int splits)
{
  conformal::Random random(1);
  std::vector<Vector3> points = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
  std::vector<std::array<int, 3>> triangles = { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 },
    { 1, 3, 2 } };
  for (int i = 0; i < splits; ++i)
  {
    const Index r = random.index(static_cast<Index>(triangles.size()));
    const auto [a, b, c] = triangles[r];
    const int middle = static_cast<int>(points.size());
    points.push_back((points[a] + points[b] + points[c]) / 3.0);
    triangles[r] = { a, b, middle };
    triangles.push_back({ b, c, middle });
    triangles.push_back({ c, a, middle });
  }
  Mesh mesh;
  mesh.Positions.resize(static_cast<Index>(points.size()), 3);
  mesh.Triangles.resize(static_cast<Index>(triangles.size()), 3);
  for (Index i = 0; i < mesh.Positions.rows(); ++i)
  {
    mesh.Positions.row(i) = points[i];
  }
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    mesh.Triangles.row(r) << triangles[r][0], triangles[r][1], triangles[r][2];
  }
  return mesh;
}

// By plain floating point too, as other programs look.
void expectOneToOne(const Mesh& mesh, const Points& map)
{
  ASSERT_EQ(map.rows(), mesh.Positions.rows());
  ASSERT_TRUE(map.allFinite());
  EXPECT_LT((map.rowwise().norm().array() - 1.0).abs().maxCoeff(), 1e-12);
  EXPECT_EQ(conformal::countFlippedTriangles(map, mesh.Triangles), 0);
  double solidAngle = 0.0;
  Index flips = 0;
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 a = map.row(mesh.Triangles(r, 0)), b = map.row(mesh.Triangles(r, 1)),
                  c = map.row(mesh.Triangles(r, 2));
    const double volume = a.dot(b.cross(c));
    flips += !(volume > 0.0);
    solidAngle += 2.0 * std::atan2(volume, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  EXPECT_EQ(flips, 0);
  EXPECT_NEAR(solidAngle, 4.0 * Pi, 1e-9);
}

GlobalConformalMapResult mapOf(const Mesh& mesh, const GlobalConformalMapOptions& options = {})
{
  return globalConformalMap(mesh, options);
}

double meanK(const Mesh& mesh, const Points& map)
{
  return conformal::measureDistortion(mesh.Positions, mesh.Triangles, map).MeanQuasiConformalError;
}
}

// Nothing to do: centered and turned as it is, the sphere is its own map.
TEST(GlobalConformalMap, OfTheSphereIsTheSphere)
{
  const auto sphere = conformal::makeGeodesicSphere(20);
  const auto map = mapOf(sphere);
  expectOneToOne(sphere, map.Positions);
  EXPECT_LT((map.Positions - sphere.Positions).rowwise().norm().maxCoeff(), 2e-3);
  EXPECT_NEAR(map.Energy, 4.0 * Pi, 0.05);
  EXPECT_EQ(map.Tier, GlobalConformalTier::Harmonic);
  EXPECT_TRUE(map.Converged);
}

TEST(GlobalConformalMap, IsConformalMoreAndMoreWithTheMesh)
{
  double last = 0.1;
  for (int frequency : { 10, 20, 40 })
  {
    const auto mesh = bumpy(frequency);
    const auto map = mapOf(mesh);
    expectOneToOne(mesh, map.Positions);
    const double error = meanK(mesh, map.Positions) - 1.0;
    EXPECT_LT(error, 0.6 * last) << frequency;
    last = error;
  }
  EXPECT_LT(last, 0.01);
}

// Centered by area, and turned with the surface, wherever and of whatever size it is.
TEST(GlobalConformalMap, IsCanonical)
{
  auto mesh = bumpy(15);
  const auto map = mapOf(mesh);
  Vector3 mean = Vector3::Zero();
  for (Index r = 0; r < mesh.Triangles.rows(); ++r)
  {
    const Vector3 a = mesh.Positions.row(mesh.Triangles(r, 0));
    const double area = (mesh.Positions.row(mesh.Triangles(r, 1)).transpose() - a)
                          .cross(mesh.Positions.row(mesh.Triangles(r, 2)).transpose() - a)
                          .norm();
    for (int k = 0; k < 3; ++k)
    {
      mean += area * map.Positions.row(mesh.Triangles(r, k)).transpose();
    }
  }
  EXPECT_LT(mean.norm(), 1e-9);

  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.0, Vector3(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
  Mesh moved = mesh;
  moved.Positions = (100.0 * mesh.Positions * turn.transpose()).eval();
  moved.Positions.rowwise() += Eigen::RowVector3d(1e3, -2e3, 5e2);
  const Points expected = map.Positions * turn.transpose();
  EXPECT_LT((mapOf(moved).Positions - expected).rowwise().norm().maxCoeff(), 1e-6);
}

TEST(GlobalConformalMap, NeverFolds)
{
  const auto spikes = shaped(16,
    [](const Vector3& n)
    { return Vector3(n * (1.0 + 3.0 * std::pow(std::abs(n[0] * n[1] * n[2]) * 5.19, 6.0))); });
  const auto needles =
    shaped(12, [](const Vector3& n) { return Vector3(n[0], 0.01 * n[1], n[2]); });
  const auto neck = shaped(16,
    [](const Vector3& n)
    {
      const double radius = 0.05 + n[2] * n[2];
      return Vector3(radius * n[0], radius * n[1], 1.5 * n[2]);
    });
  Mesh bottles = tube(8.0, 32); // joined by necks of needles
  for (Index v = 0; v < bottles.Positions.rows(); ++v)
  {
    bottles.Positions.row(v).head<2>() *=
      0.02 + std::abs(std::cos(0.375 * bottles.Positions(v, 2)));
  }
  for (const auto& mesh : { spikes, needles, neck, bottles, noisy(16, 0.02), noisy(16, 0.3),
         noisy(8, 1.5), valenceThree(60), valenceThree(600), conformal::makeGeodesicSphere(1) })
  {
    const auto map = mapOf(mesh);
    expectOneToOne(mesh, map.Positions);
    EXPECT_TRUE(map.Converged);
    EXPECT_GE(map.Energy, 4.0 * Pi * 0.5);
  }
}

TEST(GlobalConformalMap, NeverFoldsTubes)
{
  for (double length : { 1.0, 3.0, 5.0, 10.0, 30.0, 50.0 })
  {
    const auto mesh = tube(length);
    const auto map = mapOf(mesh);
    expectOneToOne(mesh, map.Positions);
    EXPECT_EQ(
      map.Tier, length < 6.0 ? GlobalConformalTier::Harmonic : GlobalConformalTier::Progressive)
      << length;
  }
}

// Triangles without area, a surface that is a line, and one that is a point.
TEST(GlobalConformalMap, NeverFoldsWhatHasNoArea)
{
  const auto line = shaped(6, [](const Vector3& n) { return Vector3(n[0], 0.0, 0.0); });
  const auto point = shaped(6, [](const Vector3&) { return Vector3(1.0, 2.0, 3.0); });
  Mesh partly = bumpy(10);
  conformal::Random random(1);
  for (int i = 0; i < 100; ++i)
  {
    partly.Positions.row(random.index(partly.Positions.rows())) = partly.Positions.row(0);
  }
  for (const auto& mesh : { line, point, partly })
  {
    const auto map = mapOf(mesh);
    expectOneToOne(mesh, map.Positions);
    EXPECT_GT(map.NumberOfInfiniteStringConstants, 0);
  }
}

// As many vertices as a network has by default: the order in which they are inserted must not crowd
// them.
TEST(GlobalConformalMap, FindsRoomForManyTrianglesWithoutShape)
{
  const auto point = shaped(36, [](const Vector3&) { return Vector3(1.0, 2.0, 3.0); });
  const auto map = mapOf(point);
  expectOneToOne(point, map.Positions);
  EXPECT_EQ(map.Tier, GlobalConformalTier::Progressive);
}

// A tail of three vertices around shrinks by an order of magnitude from ring to ring. It is
// inserted anew, and the rest of the map stays conformal.
TEST(GlobalConformalMap, KeepsTheAnglesOfABodyWithAThinTail)
{
  Mesh mesh = conformal::makeGeodesicSphere(12);
  constexpr int rings = 30;
  const Index size = mesh.Positions.rows(), last = mesh.Triangles.rows();
  const Eigen::RowVector3i base = mesh.Triangles.row(0);
  const Eigen::RowVector3d outward =
    (mesh.Positions.row(base[0]) + mesh.Positions.row(base[1]) + mesh.Positions.row(base[2]))
      .normalized();
  mesh.Positions.conservativeResize(size + 3 * rings, 3);
  mesh.Triangles.conservativeResize(last + 6 * rings, 3);
  const auto id = [&](int ring, int k)
  { return ring == 0 ? base[k % 3] : static_cast<int>(size) + 3 * (ring - 1) + k % 3; };
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int k = 0; k < 3; ++k)
    {
      mesh.Positions.row(id(ring + 1, k)) =
        mesh.Positions.row(base[k]) + 0.1 * (ring + 1) * outward;
      const Index r = last + 6 * ring + 2 * k;
      mesh.Triangles.row(r) << id(ring, k), id(ring, k + 1), id(ring + 1, k + 1);
      mesh.Triangles.row(r + 1) << id(ring, k), id(ring + 1, k + 1), id(ring + 1, k);
    }
  }
  mesh.Triangles.row(0) << id(rings, 0), id(rings, 1), id(rings, 2);
  const auto map = mapOf(mesh);
  expectOneToOne(mesh, map.Positions);
  EXPECT_EQ(map.Tier, GlobalConformalTier::Repaired);
  // Of the body alone.
  const conformal::Triangles body = mesh.Triangles.middleRows(1, last - 1);
  EXPECT_LT(
    conformal::measureDistortion(mesh.Positions, body, map.Positions).MeanQuasiConformalError, 1.1);
}

TEST(GlobalConformalMap, RepairsAFewFolds)
{
  Mesh mesh = conformal::makeGeodesicSphere(20);
  conformal::Random random(4);
  for (Index v = 0; v < mesh.Positions.rows(); v += 7) // tangentially, which makes needles
  {
    const Vector3 n = mesh.Positions.row(v), along = n.unitOrthogonal();
    mesh.Positions.row(v) += 0.18 * (random.uniform() - 0.5) * along.transpose();
  }
  const auto map = mapOf(mesh);
  EXPECT_EQ(map.Tier, GlobalConformalTier::Repaired);
  expectOneToOne(mesh, map.Positions);
  EXPECT_GT(map.NumberOfNegativeStringConstants, 0);
}

TEST(GlobalConformalMap, BalanceTradesAnglesForAreas)
{
  const auto mesh = shaped(12, [](const Vector3& n) { return Vector3(n[0], n[1], 4.0 * n[2]); });
  double lastArea = std::numeric_limits<double>::infinity(), lastAngle = 0.0;
  for (double balance : { 0.0, 0.1, 0.3, 0.6, 1.0 })
  {
    GlobalConformalMapOptions options;
    options.AreaBalance = balance;
    const auto map = mapOf(mesh, options);
    expectOneToOne(mesh, map.Positions);
    const auto distortion =
      conformal::measureDistortion(mesh.Positions, mesh.Triangles, map.Positions);
    EXPECT_LT(distortion.AreaDistortionDeviation, lastArea);
    EXPECT_GT(distortion.MeanQuasiConformalError, lastAngle);
    lastArea = distortion.AreaDistortionDeviation;
    lastAngle = distortion.MeanQuasiConformalError;
  }
  EXPECT_LT(lastArea, 0.35);
}

// On acute triangles both methods find the same map, but for a Moebius transform.
TEST(GlobalConformalMap, GuYauAgreesOnAcuteTriangles)
{
  const auto mesh = bumpy(10);
  GlobalConformalMapOptions options;
  options.Method = GlobalConformalMethod::GuYau;
  options.Tolerance = 1e-9;
  options.MaximumNumberOfIterations = 20000;
  const auto published = mapOf(mesh, options), robust = mapOf(mesh);
  EXPECT_EQ(published.NumberOfNegativeStringConstants, 0);
  EXPECT_EQ(published.NumberOfFlippedTriangles, 0);
  EXPECT_TRUE(published.Converged);
  EXPECT_GT(published.NumberOfIterations, 10);
  const double k = meanK(mesh, robust.Positions);
  EXPECT_NEAR(meanK(mesh, published.Positions), k, 0.01 * k);
  Points moved = published.Positions;
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(moved.rows());
  conformal::closestMoebiusTransform(moved, robust.Positions, ones).applyTo(moved);
  EXPECT_LT((moved - robust.Positions).rowwise().norm().maxCoeff(), 0.02);
}

// What the paper says of it: obtuse triangles make it fold.
TEST(GlobalConformalMap, GuYauFoldsWithObtuseTriangles)
{
  const auto mesh = noisy(16, 0.8);
  GlobalConformalMapOptions options;
  options.Method = GlobalConformalMethod::GuYau;
  options.MaximumNumberOfIterations = 2000;
  const auto published = mapOf(mesh, options), robust = mapOf(mesh);
  EXPECT_GT(published.NumberOfNegativeStringConstants, 100);
  EXPECT_GT(published.NumberOfFlippedTriangles, 10);
  EXPECT_TRUE(published.Positions.allFinite());
  EXPECT_EQ(robust.NumberOfFlippedTriangles, 0);
}

TEST(GlobalConformalMap, GuYauCountsInfiniteStringConstants)
{
  Mesh mesh = conformal::makeGeodesicSphere(6);
  mesh.Positions.row(mesh.Triangles(10, 0)) = mesh.Positions.row(mesh.Triangles(10, 1));
  GlobalConformalMapOptions options;
  options.Method = GlobalConformalMethod::GuYau;
  options.MaximumNumberOfIterations = 100;
  const auto map = mapOf(mesh, options);
  EXPECT_EQ(map.NumberOfInfiniteStringConstants, 5); // of the two triangles beside the edge
  EXPECT_TRUE(map.Positions.allFinite());
}

TEST(GlobalConformalMap, SameBitsOnTwoThreads)
{
  const auto mesh = bumpy(40);
  for (auto method : { GlobalConformalMethod::Robust, GlobalConformalMethod::GuYau })
  {
    GlobalConformalMapOptions options;
    options.Method = method;
    options.MaximumNumberOfIterations = 20;
    const auto one = globalConformalMap(mesh, options);
    const auto two = globalConformalMap(mesh, options, runs::backwards());
    EXPECT_EQ(one.Positions, two.Positions);
    EXPECT_EQ(one.Energy, two.Energy);
  }
}

TEST(GlobalConformalMap, ReportsProgressAndStops)
{
  GlobalConformalMapOptions published, balanced;
  published.Method = GlobalConformalMethod::GuYau;
  published.MaximumNumberOfIterations = 50;
  balanced.AreaBalance = 0.5;
  const auto smooth = bumpy(12), rough = noisy(12, 0.3);
  for (const auto& options : { GlobalConformalMapOptions(), published, balanced })
  {
    for (const auto& mesh : { smooth, rough })
    {
      runs::Watch watch;
      globalConformalMap(mesh, options, watch.run());
      EXPECT_EQ(watch.last(), 1.0);
      EXPECT_GT(watch.calls(), 5);
      for (double end : { 0.01, 0.2, 0.5 })
      {
        EXPECT_THROW(globalConformalMap(mesh, options, runs::stoppingAt(end)), conformal::Aborted);
      }
    }
  }
}

TEST(GlobalConformalMap, RefusesWhatItCannotMap)
{
  const auto mesh = bumpy(4);
  const conformal::Triangles open = mesh.Triangles.bottomRows(mesh.Triangles.rows() - 1);
  EXPECT_THROW(globalConformalMap({ mesh.Positions, open }), std::invalid_argument);
  Points bad = mesh.Positions;
  bad(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(globalConformalMap({ bad, mesh.Triangles }), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  GlobalConformalMapOptions options[4];
  options[0].AreaBalance = nan;
  options[1].AreaBalance = 1.5;
  options[2].Tolerance = nan;
  options[3].MaximumNumberOfIterations = -1;
  for (const auto& wrong : options)
  {
    EXPECT_THROW(mapOf(mesh, wrong), std::invalid_argument);
  }
}

// The ends of a spindle are tiny in a conformal map, but not too small for numbers.
TEST(GlobalConformalMap, KeepsTheAnglesOfSpindles)
{
  for (const double length : { 12.0, 21.0 })
  {
    Mesh spindle = conformal::makeGeodesicSphere(24);
    spindle.Positions = (spindle.Positions * Vector3(length, 1.0, 1.0).asDiagonal()).eval();
    conformal::RemeshingOptions remeshing;
    remeshing.NumberOfVertices = 4000;
    remeshing.NumberOfIterations = 8;
    remeshing.MeetNumber = true;
    conformal::remesh(spindle, remeshing);
    const GlobalConformalMapResult map = globalConformalMap(spindle);
    const auto distortion =
      conformal::measureDistortion(spindle.Positions, spindle.Triangles, map.Positions);
    EXPECT_EQ(map.Tier, GlobalConformalTier::Harmonic) << length;
    EXPECT_EQ(map.NumberOfFlippedTriangles, 0);
    EXPECT_LT(distortion.MeanQuasiConformalError, 1.2);
  }
}
