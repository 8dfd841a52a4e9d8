#include "Hull/NestedLayers.h"

#include "Base/Random.h"
#include "Ranks.h"
#include "Sheets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using conformal::findNestedLayers;
using conformal::Index;
using conformal::NestedLayers;
using conformal::Points;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
constexpr Index Size = 15000;

// Random points of an ellipsoid whose longest radius is given.
Points ellipsoid(double radius, Index size, unsigned int seed)
{
  Points points = radius * sheets::pointsAbove(-1.0, size, seed);
  points.col(1) *= 0.8;
  points.col(2) *= 0.7;
  return points;
}

Points shell(double inner)
{
  Points points(2 * Size, 3);
  points << ellipsoid(1.0, Size, 3), ellipsoid(inner, Size, 4);
  return points;
}

// Random points of a vase: a sphere of radius 0.75 with a wall of 0.16, and an opening with a
// radius of 0.47, which is 6 to 10 spacings.
Points vase(Index size)
{
  constexpr double radius = 0.75, half = 0.08, rim = 0.064; // rim: fraction of the area
  const double pi = std::acos(-1.0), top = std::sqrt(0.5);
  const Points directions = sheets::pointsAbove(-1.0, 3 * size, 5);
  Points points(size, 3);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform;
  Index next = 0;
  for (Index i = 0; i < size; ++i)
  {
    if (uniform(random) < rim)
    {
      const double angle = 2.0 * pi * uniform(random), around = pi * uniform(random);
      const double distance = radius + half * std::cos(around), along = half * std::sin(around);
      const double x = top * (distance - along), z = top * (distance + along);
      points.row(i) << x * std::cos(angle), x * std::sin(angle), z;
      continue;
    }
    while (directions(next, 2) > top)
    {
      ++next;
    }
    const double outside = radius + half, inside = radius - half;
    const double share = outside * outside / (outside * outside + inside * inside);
    points.row(i) = (uniform(random) < share ? outside : inside) * directions.row(next++);
  }
  return points;
}

Points withNoise(Points points, double deviation)
{
  conformal::Random random(5);
  for (Index i = 0; i < points.size(); ++i)
  {
    double sum = -6.0; // of twelve uniform numbers: nearly normal, of variance 1
    for (int k = 0; k < 12; ++k)
    {
      sum += random.uniform();
    }
    points.data()[i] += deviation * sum;
  }
  return points;
}

// Return the fraction of the points of a shell that are sorted into the wrong layer.
double wrong(const Points& points)
{
  const TrainingSamples samples(points);
  const NestedLayers layers = findNestedLayers(samples);
  if (!layers.found())
  {
    return 1.0;
  }
  Index errors = 0;
  for (Index i = 0; i < points.rows(); ++i)
  {
    errors += layers.isInner(samples.normalize(points.row(i))) != (i >= Size);
  }
  return static_cast<double>(errors) / static_cast<double>(points.rows());
}

bool foundIn(const Points& points)
{
  return findNestedLayers(TrainingSamples(points)).found();
}
}

TEST(NestedLayers, ThinAndThickWallsAreSorted)
{
  EXPECT_LT(wrong(shell(0.9)), 0.003); // the wall has three spacings
  EXPECT_LT(wrong(shell(0.7)), 1e-4);
  EXPECT_LT(wrong(shell(0.5)), 1e-4);
  EXPECT_LT(wrong(withNoise(shell(0.85), 0.01)), 0.02);
}

TEST(NestedLayers, OneLayerIsNoShell)
{
  const Points one = ellipsoid(1.0, 2 * Size, 3);
  EXPECT_FALSE(foundIn(one));
  for (const double noise : { 0.005, 0.02, 0.05 })
  {
    EXPECT_FALSE(foundIn(withNoise(one, noise))) << noise;
  }
  // Two registered scans that do not match.
  Points shifted = one;
  shifted.bottomRows(Size).rowwise() += Eigen::RowVector3d(0.02, -0.02, 0.02);
  EXPECT_FALSE(foundIn(shifted));
}

TEST(NestedLayers, ACavityWithAnOpeningIsPartOfTheSurface)
{
  Points bowl = shell(0.8);
  Index size = 0;
  for (Index i = 0; i < bowl.rows(); ++i)
  {
    if (bowl(i, 2) < 0.5) // the opening has a radius of about 0.4
    {
      bowl.row(size++) = bowl.row(i);
    }
  }
  EXPECT_FALSE(foundIn(bowl.topRows(size)));
  for (const Index number : { 2500, 4000, 6000 })
  {
    EXPECT_FALSE(foundIn(vase(number))) << number;
  }
}

TEST(NestedLayers, ASmallBallInsideIsNoLayer)
{
  Points points(Size + 100, 3);
  points << ellipsoid(1.0, Size, 3), ellipsoid(0.2, 100, 4);
  EXPECT_FALSE(foundIn(points));
}

TEST(NestedLayers, AllRanksSortAlike)
{
  const Points points = shell(0.8);
  const NestedLayers alone = findNestedLayers(TrainingSamples(points));
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const int rank = reduce.Rank;
      const Index first = points.rows() * rank / 3, last = points.rows() * (rank + 1) / 3;
      const Points own = points.middleRows(first, last - first);
      const TrainingSamples samples(own, {}, {}, reduce);
      const NestedLayers layers = findNestedLayers(samples);
      ASSERT_TRUE(layers.found());
      EXPECT_EQ(layers.Sorted->IsInner, alone.Sorted->IsInner);
    });
}

TEST(NestedLayers, FewOrFlatPointsHaveNoLayers)
{
  EXPECT_FALSE(foundIn(Points(0, 3)));
  EXPECT_FALSE(foundIn(ellipsoid(1.0, 100, 3)));
  Points flat = shell(0.5);
  flat.col(2).setZero();
  EXPECT_FALSE(foundIn(flat));
}
