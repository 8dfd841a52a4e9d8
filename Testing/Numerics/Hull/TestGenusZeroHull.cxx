#include "Hull/GenusZeroHull.h"

#include "Hull/CloudDistance.h"
#include "Mesh/GenusZeroCheck.h"
#include "Runs.h"
#include "Search/TriangleTree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

using conformal::checkGenusZero;
using conformal::GenusZeroHullLimits;
using conformal::GenusZeroHullOptions;
using conformal::GenusZeroHullResult;
using conformal::GenusZeroReport;
using conformal::hasHandles;
using conformal::Index;
using conformal::makeGenusZeroHull;
using conformal::Pi;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
GenusZeroHullOptions spaced(double spacing)
{
  GenusZeroHullOptions options;
  options.Spacing = spacing;
  return options;
}

// Points of [0, 1)^2, spread evenly, on a surface.
Points pointsOf(
  Index size, const std::function<Vector3(double, double)>& surface, double noise = 0.0)
{
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0.0, 1.0);
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    constexpr double plastic = 1.32471795724474602596;
    double whole;
    const double u = std::modf(0.5 + i / plastic, &whole);
    const double v = std::modf(0.5 + i / (plastic * plastic), &whole);
    points.row(i) = surface(u, v) + noise * Vector3(normal(random), normal(random), normal(random));
  }
  return points;
}

Vector3 onSphere(double u, double v)
{
  const double z = 2.0 * v - 1.0, r = std::sqrt(1.0 - z * z);
  return { r * std::cos(2 * Pi * u), r * std::sin(2 * Pi * u), z };
}

Points stack(const Points& a, const Points& b)
{
  Points both(a.rows() + b.rows(), 3);
  both << a, b;
  return both;
}

// What every hull must be.
void expectClosed(const GenusZeroHullResult& hull)
{
  const GenusZeroReport report =
    checkGenusZero(hull.Triangles, hull.Positions.rows(), hull.Positions);
  EXPECT_TRUE(report.isGenusZero());
  EXPECT_TRUE(report.InconsistentEdges.empty());
  EXPECT_TRUE(report.IsolatedPoints.empty());
  EXPECT_TRUE(report.NonFinitePoints.empty());
  EXPECT_FALSE(report.InsideOut);
}

GenusZeroHullResult hullOf(const Points& points, const GenusZeroHullOptions& options)
{
  const GenusZeroHullResult hull = makeGenusZeroHull(TrainingSamples(PointView(points)), options);
  expectClosed(hull);
  return hull;
}

// Mean square distance of the samples that are data of the hull.
double meanSquareDistance(const TrainingSamples& samples, const GenusZeroHullResult& hull)
{
  const conformal::TriangleTree tree(hull.Positions, hull.Triangles);
  double sum = 0.0;
  Index count = 0;
  for (Index i = 0; i < samples.size(); ++i)
  {
    if (hull.Data.contains(samples[i]))
    {
      sum += tree.closestPoint(samples[i]).SquareDistance;
      ++count;
    }
  }
  EXPECT_EQ(count, samples.size() - hull.NumberOfSamplesOutside);
  return sum / static_cast<double>(count);
}

// Vertices of a scan in PLY or OBJ text, or of binary PLY floats; empty where it is missing.
Points scan(const std::string& name)
{
  std::ifstream file(std::string(CONFORMALSOM_SCAN_DIR) + "/" + name, std::ios::binary);
  std::vector<Vector3> vertices;
  for (std::string line; std::getline(file, line);)
  {
    Vector3 x;
    if (std::sscanf(line.c_str(), "v %lf %lf %lf", &x[0], &x[1], &x[2]) == 3)
    {
      vertices.push_back(x);
    }
  }
  Points points(static_cast<Index>(vertices.size()), 3);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    points.row(static_cast<Index>(i)) = vertices[i];
  }
  return points;
}
}

TEST(GenusZeroHull, WrapsASphereAtTheOffset)
{
  const Points points = pointsOf(20000, onSphere);
  for (const double offset : { 1.0, 2.5 })
  {
    GenusZeroHullOptions options = spaced(0.04);
    options.Offset = offset;
    const GenusZeroHullResult hull = hullOf(points, options);
    const double radius =
      std::cbrt(conformal::signedVolume(hull.Positions, hull.Triangles) / (4.0 / 3.0 * Pi));
    EXPECT_NEAR(radius, 1.0 + 0.04 * offset, 0.005);
    EXPECT_EQ(hull.EulerNumber, 1);
    EXPECT_EQ(hull.NumberOfCutNodes, 0);
    EXPECT_EQ(hull.NumberOfSamplesOutside, 0);
    EXPECT_FALSE(hull.Leaks);
    // Nodes of a ball.
    EXPECT_NEAR(static_cast<double>(hull.NumberOfInsideNodes) * std::pow(0.04, 3),
      4.0 / 3.0 * Pi * std::pow(1.0 - 0.04 * offset, 3), 0.05);
  }
}

TEST(GenusZeroHull, CutsATorusOpen)
{
  const Points points = pointsOf(20000,
    [](double u, double v)
    {
      const double r = 0.7 + 0.3 * std::cos(2 * Pi * v);
      return Vector3(
        r * std::cos(2 * Pi * u), r * std::sin(2 * Pi * u), 0.3 * std::sin(2 * Pi * v));
    });
  const GenusZeroHullResult hull = hullOf(points, spaced(0.03));
  EXPECT_EQ(hull.EulerNumber, 0);
  // A slice of the tube or so, no more.
  EXPECT_NEAR(hull.NumberOfCutNodes * 0.03 * 0.03, Pi * 0.33 * 0.33, 0.25);
  EXPECT_NEAR(hull.NumberOfCutInsideNodes * 0.03 * 0.03, Pi * 0.27 * 0.27, 0.25);
  EXPECT_TRUE(hasHandles(hull));
  // Two discs as wide as the tube, of its hull's area.
  const double tube = 0.33, area = 4.0 * Pi * Pi * 0.7 * tube;
  EXPECT_NEAR(conformal::cutFraction(hull), 2.0 * Pi * tube * tube / area, 0.06);
  EXPECT_EQ(hull.NumberOfSamplesOutside, 0);
}

// Rings in a row, each grown into the next: of any number, and also where the grid is too coarse
// for an inside of their tubes, their handles are told from those of the offset.
// Handles of the object are kept, and those of noise and gaps are not.
TEST(GenusZeroHull, KeepsTheHandlesOfTheObject)
{
  const auto torus = [](double u, double v)
  {
    const double r = 1.0 + 0.4 * std::cos(2.0 * Pi * v);
    return Vector3(
      r * std::cos(2.0 * Pi * u), r * std::sin(2.0 * Pi * u), 0.4 * std::sin(2.0 * Pi * v));
  };
  const auto ball = [](double u, double v)
  {
    const double z = 2.0 * v - 1.0, r = std::sqrt(1.0 - z * z);
    return Vector3(r * std::cos(2.0 * Pi * u), r * std::sin(2.0 * Pi * u), z);
  };
  using conformal::HullMethod;
  for (const auto& [method, noise] : { std::pair(HullMethod::Distance, 0.0),
         std::pair(HullMethod::Distance, 0.02), std::pair(HullMethod::WindingNumbers, 0.02) })
  {
    for (const bool isTorus : { true, false })
    {
      const Points points = isTorus ? pointsOf(3000, torus, noise) : pointsOf(3000, ball, noise);
      const TrainingSamples samples{ PointView(points) };
      GenusZeroHullOptions options = spaced(0.05);
      options.Method = method;
      options.Genus = conformal::HullGenus::AsFound;
      const GenusZeroHullResult hull = makeGenusZeroHull(samples, options);
      EXPECT_EQ(hull.NumberOfHandles, isTorus) << noise;
      EXPECT_FALSE(hasHandles(hull));
      const GenusZeroReport report = checkGenusZero(hull.Triangles, hull.Positions.rows());
      EXPECT_EQ(report.numberOfHandles(), isTorus) << noise;
      if (method == HullMethod::Distance)
      {
        EXPECT_EQ(hull.Triangles, makeGenusZeroHull(samples, options, runs::backwards()).Triangles);
        // A width beyond that of the tube cuts the handle.
        options.HandleWidth = 30.0;
        EXPECT_EQ(makeGenusZeroHull(samples, options).NumberOfHandles, 0);
      }
    }
  }
}

TEST(GenusZeroHull, KnowsHandlesThatHaveNothingInside)
{
  const Points ring = pointsOf(30000,
    [](double u, double v)
    {
      const double r = 1.0 + 0.35 * std::cos(2 * Pi * v);
      return Vector3(
        r * std::cos(2 * Pi * u), r * std::sin(2 * Pi * u), 0.35 * std::sin(2 * Pi * v));
    });
  Points rings = ring;
  for (int count = 1; count <= 4; ++count)
  {
    for (const double spacing : { 0.1, 0.08, 0.05, 0.03 })
    {
      SCOPED_TRACE(std::to_string(count) + " rings, spacing " + std::to_string(spacing));
      const GenusZeroHullResult hull = hullOf(rings, spaced(spacing));
      EXPECT_LT(hull.EulerNumber, 1);
      EXPECT_TRUE(hasHandles(hull) || hull.NumberOfInsideNodes == 0) << hull.NumberOfCutDataNodes;
    }
    Points next = ring;
    next.col(0).array() += 2.3 * count;
    rings = stack(rings, next);
  }
}

// A ring with a gap that only the offset closes: a limb that bends back to its body.
TEST(GenusZeroHull, KnowsHandlesOfTheOffset)
{
  for (const double tube : { 0.03, 0.1, 0.2 })
  {
    const double spacing = 0.05, gap = 1.4 * spacing;
    const Points open = pointsOf(40000,
      [&](double u, double v)
      {
        const double bend = tube + gap / 2.0 + u * (2.0 * (Pi - tube) - gap);
        const double r = 1.0 + tube * std::cos(2 * Pi * v);
        return Vector3(r * std::cos(bend), r * std::sin(bend), tube * std::sin(2 * Pi * v));
      });
    Points ends[2];
    for (const int side : { 0, 1 })
    {
      const double bend = tube + gap / 2.0;
      ends[side] = pointsOf(4000,
        [&](double u, double v) // half a ball
        {
          const Vector3 n = tube * onSphere(u, 0.5 * v + 0.5);
          const double turn = side ? bend : -bend, out = side ? -n[2] : n[2];
          const Vector3 along(-std::sin(turn), std::cos(turn), 0.0);
          const Vector3 across(std::cos(turn), std::sin(turn), 0.0);
          return Vector3(across + n[0] * across + n[1] * Vector3(0, 0, 1) + out * along);
        });
    }
    const Points all = stack(stack(open, ends[0]), ends[1]);
    const TrainingSamples samples{ PointView(all) };
    const GenusZeroHullResult hull = hullOf(all, spaced(spacing / samples.scale()));
    EXPECT_EQ(hull.EulerNumber, 0) << tube;
    EXPECT_FALSE(hasHandles(hull)) << tube << " " << hull.NumberOfCutDataNodes;
    EXPECT_GT(hull.NumberOfCutNodes, 0);
    EXPECT_EQ(conformal::cutFraction(hull), 0.0);
  }
}

TEST(GenusZeroHull, JoinsTangentSpheres)
{
  Points left = pointsOf(15000, onSphere), right = left;
  left.col(0).array() -= 1.0;
  right.col(0).array() += 1.0;
  const GenusZeroHullResult hull = hullOf(stack(left, right), spaced(0.02));
  EXPECT_EQ(hull.NumberOfSamplesOutside, 0);
  EXPECT_NEAR(conformal::signedVolume(hull.Positions, hull.Triangles),
    2.0 * 4.0 / 3.0 * Pi * std::pow(0.52, 3), 0.03);
}

// The radius of a hole in a sphere is that of its rim; behind it is the sphere's radius.
TEST(GenusZeroHull, ClosesHolesByPersistence)
{
  for (const double angle : { 0.3, 0.6, 0.9 })
  {
    const double top = 0.5 * (1.0 + std::cos(angle));
    const Points points = pointsOf(20000, [&](double u, double v) { return onSphere(u, v * top); });
    const TrainingSamples samples{ PointView(points) };
    const GenusZeroHullResult hull = hullOf(points, spaced(0.04));
    EXPECT_NEAR(hull.LargestHole.Saddle * samples.scale(), std::sin(angle), 0.03);
    EXPECT_NEAR(hull.LargestHole.Peak * samples.scale(), 1.0, 0.03);
    EXPECT_EQ(hull.Leaks, std::sin(angle) > 1.0 / 1.5);
    // Closed by about the plane of the rim.
    const double volume = conformal::signedVolume(hull.Positions, hull.Triangles);
    EXPECT_NEAR(volume * std::pow(samples.scale(), 3), 4.0 / 3.0 * Pi * std::pow(1.04, 3), 0.6);
  }
}

// Half a sphere with a wall: what it holds is outside.
TEST(GenusZeroHull, LeavesACupOpen)
{
  const auto half = [](double u, double v) { return onSphere(u, 0.5 * v); };
  const Points outer = pointsOf(20000, half), inner = 0.7 * outer;
  const Points rim = pointsOf(10000,
    [](double u, double v)
    {
      const double r = 0.7 + 0.3 * v;
      return Vector3(r * std::cos(2 * Pi * u), r * std::sin(2 * Pi * u), 0.0);
    });
  const Points cup = stack(stack(outer, inner), rim);
  const TrainingSamples samples{ PointView(cup) };
  const GenusZeroHullResult hull = hullOf(cup, spaced(0.02));
  const double volume =
    conformal::signedVolume(hull.Positions, hull.Triangles) * std::pow(samples.scale(), 3);
  const double offset = 0.02 * samples.scale();
  const double wall = 2.0 / 3.0 * Pi * (1.0 - std::pow(0.7, 3));
  const double area = 2.0 * Pi * (1.0 + 0.49) + Pi * (1.0 - 0.49);
  EXPECT_NEAR(volume, wall + offset * area, 0.05);
  EXPECT_EQ(hull.EulerNumber, 1);
}

// Two slabs on a common base, four spacings apart: the gap between them stays one.
TEST(GenusZeroHull, KeepsAGapBetweenLimbs)
{
  const double h = 0.02;
  for (const bool open : { true, false })
  {
    const double half = open ? 2.0 * h : 0.5 * h;
    // The outline of a U in (x, y), swept along z, with lids.
    Points points(0, 3);
    const auto isInside = [&](double x, double y)
    { return std::abs(x) < 0.5 && y > -0.5 && y < 0.5 && !(std::abs(x) < half && y > -0.2); };
    std::vector<Vector3> found;
    const double step = 0.01;
    const auto wall = [&](double x0, double y0, double x1, double y1)
    {
      const double length = std::hypot(x1 - x0, y1 - y0);
      for (double s = 0.0; s < length; s += step)
      {
        for (double z = -0.2; z <= 0.2; z += step)
        {
          found.emplace_back(x0 + (x1 - x0) * s / length, y0 + (y1 - y0) * s / length, z);
        }
      }
    };
    wall(-0.5, -0.5, 0.5, -0.5);
    wall(0.5, -0.5, 0.5, 0.5);
    wall(0.5, 0.5, half, 0.5);
    wall(half, 0.5, half, -0.2);
    wall(half, -0.2, -half, -0.2);
    wall(-half, -0.2, -half, 0.5);
    wall(-half, 0.5, -0.5, 0.5);
    wall(-0.5, 0.5, -0.5, -0.5);
    for (double x = -0.5; x <= 0.5; x += step)
    {
      for (double y = -0.5; y <= 0.5; y += step)
      {
        if (isInside(x, y))
        {
          found.emplace_back(x, y, -0.2);
          found.emplace_back(x, y, 0.2);
        }
      }
    }
    points.resize(static_cast<Index>(found.size()), 3);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      points.row(static_cast<Index>(i)) = found[i];
    }
    const TrainingSamples samples{ PointView(points) };
    const GenusZeroHullResult hull = hullOf(points, spaced(h / samples.scale()));
    // Is there surface within the gap's upper part?
    const conformal::TriangleTree tree(hull.Positions, hull.Triangles);
    const Vector3 middle = samples.normalize(Vector3(0.0, 0.2, 0.0));
    const double distance = std::sqrt(tree.closestPoint(middle).SquareDistance) * samples.scale();
    if (open)
    {
      EXPECT_NEAR(distance, half - h, 0.5 * h);
    }
    else
    {
      EXPECT_GT(distance, 5.0 * h); // bridged: all around is solid
    }
    EXPECT_FALSE(hasHandles(hull));
  }
}

TEST(GenusZeroHull, WithstandsNoiseAndSparseData)
{
  const GenusZeroHullResult noisy = hullOf(pointsOf(20000, onSphere, 0.005), spaced(0.03));
  EXPECT_EQ(noisy.EulerNumber, 1);

  for (const Index size : { 4, 5, 10, 50, 300, 3000 })
  {
    const GenusZeroHullResult sparse = hullOf(pointsOf(size, onSphere), spaced(0.04));
    EXPECT_LE(2 * sparse.NumberOfSamplesOutside, size) << size;
    EXPECT_FALSE(hasHandles(sparse)) << size;
  }
}

// One sample in fifty anywhere, whatever the size of the cloud. Those within three spacings of the
// sphere, about half, may pass for data.
TEST(GenusZeroHull, WithstandsOutliers)
{
  for (const Index size : { 20000, 200000 })
  {
    Points points = pointsOf(size, onSphere);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    const Index outliers = size / 50;
    for (Index i = 0; i < outliers; ++i)
    {
      points.row(50 * i) << uniform(random), uniform(random), uniform(random);
    }
    const TrainingSamples samples{ PointView(points) };
    const double spacing = size == 20000 ? 0.02 : 0.04;
    const GenusZeroHullResult hull = hullOf(points, spaced(spacing));
    const double radius = 1.0 + spacing * samples.scale();
    EXPECT_NEAR(
      conformal::signedVolume(hull.Positions, hull.Triangles) * std::pow(samples.scale(), 3),
      4.0 / 3.0 * Pi * std::pow(radius, 3), 0.2);
    EXPECT_GT(hull.NumberOfSamplesOutside, outliers / 4);
    EXPECT_LE(hull.NumberOfSamplesOutside, outliers);
  }
}

// No inside, but a surface all the same.
TEST(GenusZeroHull, WrapsCloudsThatEncloseNothing)
{
  const auto square = [](double u, double v) { return Vector3(u, v, 0.0); };
  const auto line = [](double u, double) { return Vector3(u, 0.0, 0.0); };
  const auto point = [](double, double) { return Vector3(3.0, 0.0, 0.0); };
  for (const Index size : { 1, 2, 3, 1000 })
  {
    for (const auto& surface :
      std::vector<std::function<Vector3(double, double)>>{ square, line, point })
    {
      const GenusZeroHullResult hull = hullOf(pointsOf(size, surface), spaced(0.05));
      EXPECT_EQ(hull.NumberOfInsideNodes, 0);
      EXPECT_LE(2 * hull.NumberOfSamplesOutside, size);
    }
  }
}

TEST(GenusZeroHull, KeepsTheMaximumPiece)
{
  const Points large = pointsOf(20000, onSphere);
  Points small = 0.4 * pointsOf(3000, onSphere);
  small.col(0).array() += 2.0;
  const GenusZeroHullResult hull = hullOf(stack(large, small), spaced(0.03));
  EXPECT_EQ(hull.NumberOfSamplesOutside, 3000);
}

// Inner parts are inside however large and crumpled they are: here with more nodes than the sphere.
TEST(GenusZeroHull, CountsInnerParts)
{
  Points all = pointsOf(20000, onSphere);
  for (const double radius : { 0.2, 0.4, 0.6, 0.8 })
  {
    all = stack(all, radius * pointsOf(10000, onSphere));
    const GenusZeroHullResult hull = hullOf(all, spaced(0.03));
    EXPECT_EQ(hull.NumberOfSamplesInside, all.rows() - 20000);
    EXPECT_EQ(hull.NumberOfSamplesOutside, 0);
    EXPECT_FALSE(hasHandles(hull));
  }
  // What hangs on the surface is of it.
  Points wall(10000, 3);
  for (Index i = 0; i < 10000; ++i)
  {
    wall.row(i) << 0.0, -0.71 + 0.0142 * (i % 100), -0.71 + 0.0142 * (i / 100);
  }
  EXPECT_EQ(hullOf(stack(pointsOf(20000, onSphere), wall), spaced(0.03)).NumberOfSamplesInside, 0);
}

TEST(GenusZeroHull, MovesWithTheCloud)
{
  const Points points =
    pointsOf(5000, onSphere).array().rowwise() * Eigen::Array3d(1.0, 0.8, 0.5).transpose();
  const Points moved = (4.0 * points).array() + 16.0;
  const TrainingSamples samples{ PointView(points) }, movedSamples{ PointView(moved) };
  const GenusZeroHullResult a = makeGenusZeroHull(samples, spaced(0.04));
  const GenusZeroHullResult b = makeGenusZeroHull(movedSamples, spaced(0.04));
  ASSERT_EQ(a.Triangles, b.Triangles);
  for (Index i = 0; i < a.Positions.rows(); ++i)
  {
    const Vector3 there = (4.0 * samples.restore(a.Positions.row(i))).array() + 16.0;
    ASSERT_LT((movedSamples.restore(b.Positions.row(i)) - there).norm(), 1e-3);
  }
}

TEST(GenusZeroHull, DoesNotDependOnTheOrderOfBlocks)
{
  const Points points = pointsOf(30000, onSphere, 0.01);
  const TrainingSamples samples{ PointView(points) };
  const GenusZeroHullResult a = makeGenusZeroHull(samples, spaced(0.03));
  const GenusZeroHullResult b = makeGenusZeroHull(samples, spaced(0.03), runs::backwards());
  EXPECT_EQ(a.Positions, b.Positions);
  EXPECT_EQ(a.Triangles, b.Triangles);
  EXPECT_EQ(a.NumberOfSamplesOutside, b.NumberOfSamplesOutside);
}

TEST(GenusZeroHull, RefusesWhatItCannotWrap)
{
  const Points none(0, 3), some = pointsOf(100, onSphere);
  const TrainingSamples empty{ PointView(none) }, samples{ PointView(some) };
  EXPECT_THROW(makeGenusZeroHull(empty), std::invalid_argument);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : { nan, 0.0, -1.0, 1e9 })
  {
    GenusZeroHullOptions options;
    options.Spacing = bad;
    EXPECT_THROW(makeGenusZeroHull(samples, options), std::invalid_argument);
    options = {};
    options.Offset = bad;
    EXPECT_THROW(makeGenusZeroHull(samples, options), std::invalid_argument);
    options = {};
    options.Persistence = bad;
    EXPECT_THROW(makeGenusZeroHull(samples, options), std::invalid_argument);
  }
  GenusZeroHullOptions options;
  options.SmoothingPasses = -1;
  EXPECT_THROW(makeGenusZeroHull(samples, options), std::invalid_argument);
}

TEST(GenusZeroHull, SaysTheMinimumSpacingWhereTheGridIsTooLarge)
{
  const Points sphere = pointsOf(1000, onSphere);
  const TrainingSamples samples{ PointView(sphere) };
  const int margin = 3; // of an offset of 1
  const auto nodes = [&](double spacing)
  { return conformal::gridAround(samples, spacing, margin).numberOfNodes(); };
  std::string message;
  try
  {
    makeGenusZeroHull(samples, spaced(GenusZeroHullLimits::MinimumSpacing));
  }
  catch (const std::invalid_argument& e)
  {
    message = e.what();
  }
  EXPECT_NE(message.find(std::to_string(conformal::MaximumNumberOfNodes)), std::string::npos)
    << message;
  const double smallest = std::stod("0" + message.substr(message.rfind('.')));
  EXPECT_NEAR(smallest, 0.00315, 0.00005); // as the header says
  EXPECT_LE(nodes(smallest), conformal::MaximumNumberOfNodes);
  EXPECT_THROW(nodes(0.999 * smallest), std::invalid_argument);

  // A rod takes all of the documented range.
  const Points rod = pointsOf(1000, [](double u, double v) { return Vector3(u, 0.001 * v, 0.0); });
  EXPECT_LE(conformal::gridAround(
              TrainingSamples{ PointView(rod) }, GenusZeroHullLimits::MinimumSpacing, margin)
              .numberOfNodes(),
    conformal::MaximumNumberOfNodes);
}

TEST(GenusZeroHull, ReportsProgressAndStops)
{
  const Points points = pointsOf(5000, onSphere);
  const TrainingSamples samples{ PointView(points) };
  runs::Watch watch;
  makeGenusZeroHull(samples, spaced(0.08), watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  EXPECT_GE(watch.calls(), 20);
  for (int stop = 0; stop < watch.calls(); ++stop)
  {
    int left = stop;
    EXPECT_THROW(
      makeGenusZeroHull(samples, spaced(0.08), { {}, [&](double) { return left-- > 0; } }),
      conformal::Aborted);
  }
}

TEST(GenusZeroHull, WrapsTheBunny)
{
  const Points points = scan("stanford-bunny.obj");
  if (points.rows() == 0)
  {
    GTEST_SKIP() << "stanford-bunny.obj is not in CONFORMALSOM_SCAN_DIR";
  }
  const TrainingSamples samples{ PointView(points) };
  const GenusZeroHullResult hull = hullOf(points, {});
  EXPECT_LE(meanSquareDistance(samples, hull), std::pow(2.0 * hull.Spacing, 2));
  EXPECT_EQ(hull.EulerNumber, 1);
  EXPECT_EQ(hull.NumberOfSamplesOutside, 0);
  EXPECT_NEAR(hull.LargestHole.Saddle, 0.07, 0.01); // the holes in its base
  EXPECT_NEAR(hull.LargestHole.Peak, 0.34, 0.01);

  // A ball of data missing at the base, a hole nearly as wide as the body.
  const Vector3 base(0.5 * (points.col(0).minCoeff() + points.col(0).maxCoeff()),
    points.col(1).minCoeff(), 0.5 * (points.col(2).minCoeff() + points.col(2).maxCoeff()));
  const TrainingSamples torn(PointView(points), {},
    [&](Index i) { return (Vector3(points.row(i)) - base).norm() < 0.3 * samples.scale(); });
  const GenusZeroHullResult closed = makeGenusZeroHull(torn);
  expectClosed(closed);
  EXPECT_TRUE(closed.Leaks);
  EXPECT_NEAR(conformal::signedVolume(closed.Positions, closed.Triangles) *
      std::pow(torn.scale(), 3) /
      (conformal::signedVolume(hull.Positions, hull.Triangles) * std::pow(samples.scale(), 3)),
    1.0, 0.1);
}

// What is apart from the largest piece is left out, whichever way tells what is inside.
TEST(GenusZeroHull, LeavesOutWhatIsApartByEitherIndicator)
{
  const Points large = pointsOf(8000, onSphere);
  Points small = 0.8 * pointsOf(6000, onSphere);
  small.col(0).array() += 3.0;
  const Points both = stack(large, small);
  const TrainingSamples samples{ PointView(both) };
  GenusZeroHullOptions options = spaced(0.03);
  for (const conformal::HullMethod indicator :
    { conformal::HullMethod::Distance, conformal::HullMethod::WindingNumbers })
  {
    options.Method = indicator;
    const GenusZeroHullResult hull = hullOf(both, options);
    EXPECT_EQ(hull.Method, indicator);
    EXPECT_EQ(hull.NumberOfSamplesOutside, 6000);
    const double volume =
      conformal::signedVolume(hull.Positions, hull.Triangles) * std::pow(samples.scale(), 3);
    EXPECT_NEAR(volume, 4.0 / 3.0 * Pi, 1.0); // the distance's is larger by the offset
  }
}

// By the distance where that is right, to the bit, and for a ring, whose handle is its own; by
// winding numbers where a hole is as wide as the object.
TEST(GenusZeroHull, ChoosesByWhatEitherHullShows)
{
  using conformal::HullMethod;
  const auto hullBy = [](const Points& points, HullMethod indicator)
  {
    GenusZeroHullOptions options = spaced(0.03);
    options.Method = indicator;
    return hullOf(points, options);
  };
  const Points sphere = pointsOf(8000, onSphere);
  Points bowl(sphere.rows(), 3), ring(sphere.rows(), 3);
  Index size = 0;
  for (Index i = 0; i < sphere.rows(); ++i)
  {
    const Vector3 n = sphere.row(i);
    if (n[2] < 0.1)
    {
      bowl.row(size++) = n.transpose();
    }
    const double around = std::atan2(n[1], n[0]), along = Pi * n[2];
    const double r = 1.0 + 0.4 * std::cos(along);
    ring.row(i) << r * std::cos(around), r * std::sin(around), 0.4 * std::sin(along);
  }
  bowl.conservativeResize(size, 3);
  for (const Points& points : { sphere, ring })
  {
    const GenusZeroHullResult hull = hullBy(points, HullMethod::Automatic);
    EXPECT_EQ(hull.Method, HullMethod::Distance);
    EXPECT_EQ(hull.Positions, hullBy(points, HullMethod::Distance).Positions);
  }
  EXPECT_TRUE(hasHandles(hullBy(ring, HullMethod::Automatic)));
  const GenusZeroHullResult closed = hullBy(bowl, HullMethod::Automatic);
  EXPECT_EQ(closed.Method, HullMethod::WindingNumbers);
  EXPECT_EQ(closed.Positions, hullBy(bowl, HullMethod::WindingNumbers).Positions);
}

namespace
{
// Random points on both sides of a disc of radius 1 and on its rounded rim.
Points sheet(Index size, double thickness)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double half = 0.5 * thickness, sides = 2.0 * Pi, rim = 2.0 * Pi * Pi * half;
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    const double angle = 2.0 * Pi * uniform(random), side = uniform(random) < 0.5 ? -1.0 : 1.0;
    double radius = std::sqrt(uniform(random)), height = side * half;
    if (uniform(random) * (sides + rim) > sides)
    {
      const double tilt = Pi * (uniform(random) - 0.5);
      radius = 1.0 + half * std::cos(tilt);
      height = half * std::sin(tilt);
    }
    points.row(i) << radius * std::cos(angle), radius * std::sin(angle), height;
  }
  return points;
}
}

// Between random points, a sheet thinner than their spacing has holes.
TEST(GenusZeroHull, ClosesTheHolesOfAThinSheet)
{
  const Points points = sheet(3000, 0.02);
  const TrainingSamples samples{ PointView(points) };
  const GenusZeroHullResult torn = makeGenusZeroHull(samples, spaced(0.025));
  EXPECT_TRUE(conformal::isTorn(torn));
  const GenusZeroHullResult hull = conformal::chooseHull(samples, spaced(0.025), spaced(0.025));
  EXPECT_FALSE(conformal::isTorn(hull));
  EXPECT_LE(hull.NumberOfCutNodes, 8);
  EXPECT_EQ(hull.NumberOfSamplesOutside, 0);
  EXPECT_TRUE(checkGenusZero(hull.Triangles, hull.Positions.rows()).isGenusZero());
  // Both sides of the hull are on their side of the disc: the tears are gone.
  const double area = conformal::surfaceArea(hull.Positions, hull.Triangles);
  EXPECT_LT(area, 1.4 * 2.0 * Pi);
}
