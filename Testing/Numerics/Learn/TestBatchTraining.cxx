#include "Learn/BatchTraining.h"

#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using conformal::ConformalSOMOptions;
using conformal::ConformalSOMResult;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Points;
using conformal::PointView;
using conformal::ReferencePoint;
using conformal::StartingShape;
using conformal::trainBatch;
using conformal::trainBatchFrom;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
Points ellipsoidCloud(Index size, double noise = 0.0)
{
  conformal::Random random(9);
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    const double z = 2.0 * random.uniform() - 1.0, angle = 2.0 * std::acos(-1.0) * random.uniform();
    const double r = std::sqrt(1.0 - z * z);
    points.row(i) << r * std::cos(angle), 0.7 * r * std::sin(angle), 0.8 * z;
    points.row(i) *= 1.0 + noise * (2.0 * random.uniform() - 1.0);
  }
  return points;
}

ConformalSOMOptions fast(StartingShape start)
{
  ConformalSOMOptions options;
  options.Frequency = 8;
  options.StartingShape = start;
  return options;
}
}

// Lattices 4 and 8 of some passes each, then the polish.
TEST(BatchTraining, GoesFromCoarseToFine)
{
  const Points cloud = ellipsoidCloud(8000);
  ConformalSOMOptions options = fast(StartingShape::Sphere);
  options.PassesPerLevel = 3;
  options.NumberOfPolishRounds = 2;
  const ConformalSOMResult result = trainBatch(TrainingSamples{ PointView(cloud) }, options, {});
  const int frequencies[] = { 4, 4, 4, 8, 8, 8, 8, 8 };
  ASSERT_EQ(result.History.size(), std::size(frequencies));
  for (std::size_t i = 0; i < result.History.size(); ++i)
  {
    EXPECT_EQ(result.History[i].Frequency, frequencies[i]) << i;
  }
  for (std::size_t i = 1; i < 6; ++i) // the neighborhood narrows on each lattice, and from it on
  {
    EXPECT_LE(result.History[i].NeighborhoodRadius, result.History[i - 1].NeighborhoodRadius);
  }
  EXPECT_LT(result.History.back().MeanSquareError, 1e-4);
  EXPECT_FALSE(result.Hulled);
}

// Eqs. 4 and 5 in Batch mode. In the first pass the triangles are still those of the network, whose
// conformal images are affine; after it they are not.
TEST(BatchTraining, SharesPatternsByTheirReferencePoints)
{
  const Points cloud = ellipsoidCloud(8000);
  ConformalSOMOptions options = fast(StartingShape::Sphere);
  options.Frequency = 4;
  options.NumberOfPolishRounds = 0;
  const auto learned = [&](ReferencePoint reference, int passes)
  {
    options.ReferencePoint = reference;
    options.PassesPerLevel = passes;
    return trainBatch(TrainingSamples{ PointView(cloud) }, options, {}).Positions;
  };
  const auto difference = [](const Points& a, const Points& b)
  { return (a - b).rowwise().norm().maxCoeff(); };
  for (const int passes : { 1, 5 })
  {
    const Points conformal = learned(ReferencePoint::Conformal, passes);
    const Points affine = learned(ReferencePoint::Affine, passes);
    EXPECT_EQ(learned(ReferencePoint::Automatic, passes), affine);
    EXPECT_GT(difference(learned(ReferencePoint::Winner, passes), affine), 1e-3);
    if (passes == 1)
    {
      EXPECT_LT(difference(conformal, affine), 1e-8);
    }
    else
    {
      EXPECT_GT(difference(conformal, affine), 1e-4);
    }
  }
}

TEST(BatchTraining, StartsFromTheHullWhereTold)
{
  const Points cloud = ellipsoidCloud(8000);
  const ConformalSOMResult result =
    trainBatch(TrainingSamples{ PointView(cloud) }, fast(StartingShape::Hull), {});
  EXPECT_TRUE(result.Hulled);
  EXPECT_FALSE(result.HullLeaks);
  EXPECT_LT(result.History.back().MeanSquareError, 1e-4);
}

TEST(BatchTraining, LearnsFromTheSphereAlone)
{
  const Points egg = ellipsoidCloud(8000);
  Points needle = egg;
  needle.col(0) *= 12.0;
  const auto learned = [](const Points& points, StartingShape shape)
  { return conformal::learnWithoutPolish(TrainingSamples{ PointView(points) }, fast(shape), {}); };
  const auto result = learned(egg, StartingShape::Automatic);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->History.size(), 10U); // two levels of five passes
  EXPECT_LT(result->History.back().MeanSquareError, 1e-3);
  EXPECT_FALSE(learned(needle, StartingShape::Automatic));
  EXPECT_TRUE(learned(needle, StartingShape::Sphere));
}

// A limb that bends back to its body closes a handle of the hull, not of the object.
TEST(BatchTraining, TellsHandlesOfTheObjectFromThoseOfTheHull)
{
  const double pi = std::acos(-1.0);
  constexpr double Tube = 0.1;
  const auto ring = [&](double gap)
  {
    conformal::Random random(4);
    Points points(20000, 3);
    const double end = gap > 0.0 ? Tube + gap / 2.0 : 0.0; // where a cap begins, along the ring
    for (Index i = 0; i < points.rows();)
    {
      const double bend = 2.0 * pi * random.uniform(), turn = 2.0 * pi * random.uniform();
      const double beyond = std::max({ 0.0, end - bend, bend - (2.0 * pi - end) });
      const double tube = std::sqrt(std::max(0.0, Tube * Tube - beyond * beyond));
      const double r = 1.0 + tube * std::cos(turn);
      if (beyond < Tube && (1.0 + Tube) * random.uniform() < r)
      {
        points.row(i++) << r * std::cos(bend), r * std::sin(bend), tube * std::sin(turn);
      }
    }
    return points;
  };
  ConformalSOMOptions options = fast(StartingShape::Hull);
  options.NumberOfPolishRounds = 1;
  const auto cutFraction = [&](const Points& cloud)
  { return trainBatch(TrainingSamples{ PointView(cloud) }, options, {}).CutFraction; };
  EXPECT_EQ(cutFraction(ring(0.03)), 0.0);
  // Two discs as wide as the tube.
  EXPECT_NEAR(cutFraction(ring(0.0)), Tube / (2.0 * pi), 0.03);
}

// Errors of a clean cloud fall with the lattice's, those of a noisy one stay.
TEST(BatchTraining, FindsTheNoise)
{
  const auto noiseToDetail = [](double noise)
  {
    const Points cloud = ellipsoidCloud(40000, noise);
    ConformalSOMOptions options = fast(StartingShape::Sphere);
    options.Frequency = 24;
    return trainBatch(TrainingSamples{ PointView(cloud) }, options, {}).NoiseToDetail;
  };
  const double clean = noiseToDetail(0.0), noisy = noiseToDetail(0.05);
  EXPECT_LT(clean, 0.5);
  EXPECT_GT(noisy, 2.0);
}

// Where the surface is met already it is left alone, but for what the samples do not know of it.
TEST(BatchTraining, KeepsAStartThatFits)
{
  const Points cloud = ellipsoidCloud(20000);
  const TrainingSamples samples{ PointView(cloud) };
  ConformalSOMOptions options = fast(StartingShape::Automatic);
  Points start = makeGeodesicSphere(options.Frequency).Positions;
  for (Index i = 0; i < start.rows(); ++i)
  {
    const Vector3 onEllipsoid = Vector3(start.row(i)).cwiseProduct(Vector3(1.0, 0.7, 0.8));
    start.row(i) = samples.normalize(onEllipsoid);
  }
  const ConformalSOMResult result = trainBatchFrom(start, samples, options, {});
  EXPECT_FALSE(result.Hulled);
  EXPECT_EQ(result.History.size(), 20U); // a rough start is due twice the rounds
  EXPECT_LT((result.Positions - start).rowwise().norm().maxCoeff(), 0.05);
  EXPECT_EQ(result.UnsupportedFraction, 0.0);
}

TEST(BatchTraining, ReportsTheShareWithoutSamples)
{
  Points cloud = ellipsoidCloud(20000);
  Index kept = 0;
  for (Index i = 0; i < cloud.rows(); ++i)
  {
    if (cloud(i, 2) < 0.4) // of 0.8
    {
      cloud.row(kept++) = cloud.row(i).eval();
    }
  }
  cloud.conservativeResize(kept, 3);
  ConformalSOMOptions options = fast(StartingShape::Sphere);
  options.Frequency = 16;
  const ConformalSOMResult result = trainBatch(TrainingSamples{ PointView(cloud) }, options, {});
  EXPECT_GT(result.UnsupportedFraction, 0.05);
  EXPECT_LT(result.UnsupportedFraction, 0.3);
}
