#include "Learn/ConformalSOM.h"

#include "Base/FixedPointSums.h"
#include "Base/Random.h"
#include "Mesh/GenusZeroCheck.h"
#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Runs.h"
#include "Search/PointTree.h"
#include "Search/TriangleTree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using conformal::ConformalSOMOptions;
using conformal::ConformalSOMResult;
using conformal::Index;
using conformal::Points;
using conformal::trainConformalSOM;
using conformal::TrainingMode;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
Points sphereCloud(Index size)
{
  conformal::Random random(11);
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    const double z = 2.0 * random.uniform() - 1.0, angle = 8.0 * std::atan(1.0) * random.uniform();
    const double r = std::sqrt(1.0 - z * z);
    points.row(i) << r * std::cos(angle), r * std::sin(angle), z;
  }
  return points;
}

// A smooth closed shape without symmetry: an ellipsoid with a bump.
Points potato(Index size)
{
  Points points = sphereCloud(size);
  for (Index i = 0; i < size; ++i)
  {
    const Vector3 n = points.row(i);
    points.row(i) *= 1.0 + 0.4 * std::exp(4.0 * (n.dot(Vector3(0.6, 0.0, 0.8)) - 1.0));
    points(i, 1) *= 0.7;
  }
  return points;
}

// A bent sausage that nearly bites its tail: the center line runs over 5/6 of a circle of radius
// 1, the tube's radius is 0.3, its ends are round. Learned from a sphere it spans a web.
Points horseshoe(Index size)
{
  constexpr double Tube = 0.3;
  const double pi = std::acos(-1.0), arc = 5.0 / 3.0 * pi;
  conformal::Random random(17);
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    // Along the center line, beyond whose ends the sphere's share of the tube's area begins.
    const double along = (arc + 4.0 * Tube) * random.uniform() - 2.0 * Tube;
    const double around = 2.0 * pi * random.uniform();
    const double end = std::clamp(along, 0.0, arc);
    const double cap = std::clamp((along - end) / (2.0 * Tube), -1.0, 1.0);
    const double radius = Tube * std::sqrt(1.0 - cap * cap);
    const Vector3 outwards(std::cos(end), std::sin(end), 0.0);
    const Vector3 forwards(-std::sin(end), std::cos(end), 0.0);
    points.row(i) = outwards * (1.0 + radius * std::cos(around)) +
      Vector3(0, 0, radius * std::sin(around)) + forwards * Tube * cap;
  }
  return points;
}

// The longest way from a triangle's center to the nearest point.
double farthestFromData(const Points& points, const ConformalSOMResult& result)
{
  const conformal::PointTree data{ conformal::PointView(points) };
  double farthest = 0.0;
  for (Index r = 0; r < result.Triangles.rows(); ++r)
  {
    const auto ids = result.Triangles.row(r);
    const Vector3 center =
      (result.Positions.row(ids[0]) + result.Positions.row(ids[1]) + result.Positions.row(ids[2])) /
      3.0;
    farthest = std::max(farthest, data.nearest(center).SquareDistance);
  }
  return std::sqrt(farthest);
}

double pointToSurface(const TrainingSamples& samples, const ConformalSOMResult& result)
{
  const conformal::TriangleTree tree(result.Positions, result.Triangles);
  double sum = 0.0;
  for (Index i = 0; i < samples.size(); ++i)
  {
    sum += tree.closestPoint(samples.restore(samples[i])).SquareDistance;
  }
  return sum / static_cast<double>(samples.size());
}

ConformalSOMOptions online(int frequency)
{
  ConformalSOMOptions options;
  options.TrainingMode = TrainingMode::Online;
  options.NumberOfNeurons = conformal::geodesicSphereSize(frequency);
  options.Online.SamplesPerEpoch = 1000;
  return options;
}

ConformalSOMOptions automatic(Index neurons)
{
  ConformalSOMOptions options;
  options.NumberOfNeurons = neurons;
  return options;
}

ConformalSOMOptions batch(int frequency)
{
  ConformalSOMOptions options;
  options.MeshType = conformal::MeshType::Geodesic;
  options.NumberOfNeurons = conformal::geodesicSphereSize(frequency);
  return options;
}

}

TEST(ConformalSOM, DefaultsAreThePapers)
{
  const ConformalSOMOptions options;
  EXPECT_EQ(conformal::geodesicFrequencyFor(conformal::UsualNeurons), 36);
  EXPECT_EQ(options.Online.NumberOfEpochs, 80);
  EXPECT_EQ(options.Online.SamplesPerEpoch, 8000);
  EXPECT_EQ(options.Online.InitialNeighborhoodRadius, 0.4);
  EXPECT_EQ(options.Online.NeighborhoodTimeConstant, 20.0);
  EXPECT_EQ(options.Online.InitialLearningRate, 0.01);
  EXPECT_EQ(options.Online.LearningRateTimeConstant, 60.0);
}

TEST(ConformalSOM, ASpheresCloudGivesASphere)
{
  const Points points = sphereCloud(20000);
  const TrainingSamples samples(points);
  for (const ConformalSOMOptions& options : { online(8), batch(8) })
  {
    const ConformalSOMResult result = trainConformalSOM(samples, options);
    EXPECT_TRUE(conformal::checkGenusZero(result.Triangles, result.Positions.rows()).isGenusZero());
    double turned = 0.0;
    for (Index i = 0; i < result.Positions.rows(); ++i)
    {
      const Vector3 w = result.Positions.row(i);
      // The neurons average over a neighborhood (Online) or fit flat triangles (Batch).
      EXPECT_NEAR(w.norm(), 1.0, options.TrainingMode == TrainingMode::Online ? 0.05 : 0.01);
      turned = std::max(turned, (w.normalized() - Vector3(result.SpherePositions.row(i))).norm());
    }
    EXPECT_LT(turned, 0.15); // each neuron near where it started: the map is near the identity
  }
}

TEST(ConformalSOM, BatchFitsCloserThanOnline)
{
  const Points points = potato(20000);
  const TrainingSamples samples(points);
  const double slow = pointToSurface(samples, trainConformalSOM(samples, online(10)));
  const double fast = pointToSurface(samples, trainConformalSOM(samples, batch(10)));
  EXPECT_LT(fast, 2e-5);
  EXPECT_LT(10.0 * fast, slow);
}

TEST(ConformalSOM, FittingImprovesTheMesh)
{
  const Points points = potato(20000);
  const TrainingSamples samples(points);
  ConformalSOMOptions options = batch(10);
  const double fitted = pointToSurface(samples, trainConformalSOM(samples, options));
  options.Fit.Iterations = 0;
  const double raw = pointToSurface(samples, trainConformalSOM(samples, options));
  EXPECT_LT(2.0 * fitted, raw);
}

TEST(ConformalSOM, SameInputSameBitsInAnyOrderOfBlocks)
{
  const Points points = potato(30000);
  for (const ConformalSOMOptions& options : { online(6), batch(12) })
  {
    const ConformalSOMResult a = trainConformalSOM(TrainingSamples(points), options);
    const ConformalSOMResult b = trainConformalSOM(
      TrainingSamples(points, {}, {}, {}, runs::backwards()), options, nullptr, runs::backwards());
    EXPECT_EQ(a.Positions, b.Positions);
    ConformalSOMOptions other = options;
    other.RandomSeed = 2;
    other.Batch.SamplesPerNeuron = 3;
    EXPECT_NE(a.Positions, trainConformalSOM(TrainingSamples(points), other).Positions);
  }
}

TEST(ConformalSOM, ScalesBitByBitWithPowersOfTwo)
{
  const Points points = potato(5000);
  for (const ConformalSOMOptions& options : { online(4), batch(8) })
  {
    const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), options);
    for (int power : { -60, 3, 90 })
    {
      const Points scaled = std::ldexp(1.0, power) * points;
      const ConformalSOMResult other = trainConformalSOM(TrainingSamples(scaled), options);
      EXPECT_EQ(other.Positions, std::ldexp(1.0, power) * result.Positions);
    }
  }
}

TEST(ConformalSOM, MovesWithItsPoints)
{
  const Points points = potato(5000);
  const Eigen::RowVector3d shift(1e3, -2e3, 5e2);
  const Points moved = points.rowwise() + shift;
  const ConformalSOMResult a = trainConformalSOM(TrainingSamples(points), batch(8));
  const ConformalSOMResult b = trainConformalSOM(TrainingSamples(moved), batch(8));
  EXPECT_LT(((b.Positions.rowwise() - shift) - a.Positions).cwiseAbs().maxCoeff(), 1e-6);
}

// The paper gives priority to extrusive parts: they are drawn more often, and get more neurons.
TEST(ConformalSOM, PriorityDrawsNeurons)
{
  const Points points = sphereCloud(20000);
  std::vector<double> weights(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    weights[i] = points(i, 2) > 0.5 ? 10.0 : 1.0;
  }
  for (const ConformalSOMOptions& options : { online(8), batch(8) })
  {
    const ConformalSOMResult even = trainConformalSOM(TrainingSamples(points), options);
    const ConformalSOMResult pulled = trainConformalSOM(TrainingSamples(points, weights), options);
    const auto above = [](const ConformalSOMResult& result)
    { return (result.Positions.col(2).array() > 0.5).count(); };
    EXPECT_GT(above(pulled), above(even) * 11 / 10);
  }
}

TEST(ConformalSOM, PlainMapUsesTheWinnersPosition)
{
  const Points points = potato(5000);
  ConformalSOMOptions options = online(6);
  const Points conformalMap = trainConformalSOM(TrainingSamples(points), options).Positions;
  options.ReferencePoint = conformal::ReferencePoint::Winner;
  const Points plainMap = trainConformalSOM(TrainingSamples(points), options).Positions;
  EXPECT_NE(conformalMap, plainMap);
  EXPECT_LT((conformalMap - plainMap).rowwise().norm().mean(), 0.02);
}

// Stray points in a box around the object would hang on its surface in clumps.
TEST(ConformalSOM, OutliersDoNotSpoilTheMap)
{
  constexpr Index count = 8000, outliers = count / 20;
  Points points(count + outliers, 3);
  points.topRows(count) = horseshoe(count);
  conformal::Random random(5);
  for (Index i = 3 * count; i < points.size(); ++i)
  {
    points.data()[i] = 2.4 * random.uniform() - 1.2;
  }
  const ConformalSOMOptions options = automatic(2562);
  const ConformalSOMResult clean =
    trainConformalSOM(TrainingSamples(conformal::PointView(points.data(), count)), options);
  EXPECT_EQ(clean.NumberOfOutliers, 0);
  const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), options);
  EXPECT_GT(result.NumberOfOutliers, outliers * 9 / 10);
  EXPECT_LT(result.NumberOfOutliers, outliers * 11 / 10);
  EXPECT_LT(result.MeanQuasiConformalError, 1.05 * clean.MeanQuasiConformalError);
  EXPECT_GE(result.MaximumQuasiConformalError, result.MeanQuasiConformalError);
  EXPECT_LT(farthestFromData(points.topRows(count), result), 0.08);
}

// From the sphere the mesh spans the space between the ends; from the hull it does not.
TEST(ConformalSOM, WebsAreFoundAndAvoided)
{
  const Points points = horseshoe(20000);
  ConformalSOMOptions options = automatic(2562);
  options.StartingShape = conformal::StartingShape::Sphere;
  const ConformalSOMResult webbed = trainConformalSOM(TrainingSamples(points), options);
  EXPECT_FALSE(webbed.FromHull);
  EXPECT_GT(webbed.UnsupportedFraction, 0.02);
  EXPECT_GT(farthestFromData(points, webbed), 0.2);

  options.StartingShape = conformal::StartingShape::Automatic;
  const ConformalSOMResult clean = trainConformalSOM(TrainingSamples(points), options);
  EXPECT_TRUE(clean.FromHull);
  EXPECT_LT(clean.UnsupportedFraction, 0.002);
  EXPECT_LT(farthestFromData(points, clean), 0.08);
  EXPECT_TRUE(conformal::checkGenusZero(clean.Triangles, clean.Positions.rows()).isGenusZero());
  EXPECT_LT(pointToSurface(TrainingSamples(points), clean), 1e-4);
  EXPECT_EQ(clean.Positions,
    trainConformalSOM(
      TrainingSamples(points, {}, {}, {}, runs::backwards()), options, nullptr, runs::backwards())
      .Positions);
}

// What a geodesic mesh cannot do is an error; the message names what can.
TEST(ConformalSOM, AGeodesicMeshIsLearnedFromTheSphereOnly)
{
  const Points points = potato(500);
  const TrainingSamples samples(points);
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(3);
  const conformal::MappedMesh start{ sphere, sphere.Positions };
  for (ConformalSOMOptions options : { online(4), batch(4) })
  {
    const std::string instead = options.TrainingMode == TrainingMode::Online
      ? "TrainingMode to Batch"
      : "MeshType to Adaptive";
    const auto message = [&](const conformal::MappedMesh* mesh) -> std::string
    {
      try
      {
        trainConformalSOM(samples, options, mesh);
      }
      catch (const std::invalid_argument& e)
      {
        return e.what();
      }
      return "no error";
    };
    const conformal::MappedMesh unmapped{ sphere, {} };
    EXPECT_NE(message(&unmapped).find(instead), std::string::npos) << message(&unmapped);
    for (const auto shape : { conformal::StartingShape::Hull, conformal::StartingShape::Mesh })
    {
      options.StartingShape = shape;
      EXPECT_NE(message(nullptr).find(instead), std::string::npos) << message(nullptr);
    }
  }
  // Points in a plane are learned from the sphere, whatever an adaptive mesh would start from.
  Points flat = points;
  flat.col(2).setZero();
  ConformalSOMOptions options;
  options.NumberOfNeurons = 162;
  const ConformalSOMResult plain = trainConformalSOM(TrainingSamples(flat), options);
  options.StartingShape = conformal::StartingShape::Hull;
  const ConformalSOMResult hull = trainConformalSOM(TrainingSamples(flat), options, &start);
  EXPECT_EQ(hull.Positions, plain.Positions);
  EXPECT_FALSE(hull.FromHull || hull.FromMesh);
}

TEST(ConformalSOM, SimpleObjectsNeedNoHull)
{
  const ConformalSOMResult result =
    trainConformalSOM(TrainingSamples(potato(20000)), automatic(2562));
  EXPECT_FALSE(result.FromHull);
  EXPECT_EQ(result.UnsupportedFraction, 0.0);
}

TEST(ConformalSOM, StartsFromAMappedMesh)
{
  const Points points = potato(20000);
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(7);
  conformal::MappedMesh start{ sphere.Positions, sphere.Triangles, sphere.Positions };
  start.Positions.col(1) *= 0.7;
  const ConformalSOMResult result =
    trainConformalSOM(TrainingSamples(points), automatic(1442), &start);
  EXPECT_TRUE(result.FromMesh);
  EXPECT_FALSE(result.FromHull);
  EXPECT_EQ(result.NumberOfStarts, 1);
  EXPECT_LT(pointToSurface(TrainingSamples(points), result), 2e-5);

  ConformalSOMOptions one = online(7);
  one.Online.NumberOfEpochs = 0;
  EXPECT_LT((trainConformalSOM(TrainingSamples(points), one, &start).Positions - start.Positions)
              .cwiseAbs()
              .maxCoeff(),
    1e-12);
}

TEST(ConformalSOM, AutomaticPriorityReachesTips)
{
  // A spike along one axis, four clouds: where neurons come to lie on a tip is luck.
  const Points sphere = sphereCloud(20000);
  double farthest[2] = {};
  for (int spike = 0; spike < 4; ++spike)
  {
    Points points = sphere;
    for (Index i = 0; i < points.rows(); ++i)
    {
      const double height = (spike % 2 ? 1.0 : -1.0) * points(i, spike / 2);
      points.row(i) *= 1.0 + std::exp(60.0 * (height - 1.0));
    }
    for (const bool automatic : { false, true })
    {
      ConformalSOMOptions options = batch(12);
      options.Fit.AutomaticPriority = automatic;
      options.StartingShape = conformal::StartingShape::Sphere;
      const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), options);
      const conformal::TriangleTree tree(result.Positions, result.Triangles);
      double longest = 0.0;
      for (Index i = 0; i < points.rows(); ++i)
      {
        longest = std::max(longest, tree.closestPoint(points.row(i)).SquareDistance);
      }
      farthest[automatic] += std::sqrt(longest) / 4.0;
    }
  }
  RecordProperty("WithoutPriority", std::to_string(farthest[0]));
  RecordProperty("WithPriority", std::to_string(farthest[1]));
  EXPECT_LT(farthest[1], 0.8 * farthest[0]);
}

// A cloud cut in parts gives the bits of the whole, noise, priorities and all; the cuts do not
// matter.
TEST(ConformalSOM, RanksShareTheSums)
{
  const Points points = potato(9000);
  std::vector<double> priority(points.rows());
  for (Index i = 0; i < points.rows(); ++i)
  {
    priority[i] = points(i, 2) > 0.5 ? 3.0 : 1.0;
  }
  ConformalSOMOptions options = batch(12);
  options.StartingShape = conformal::StartingShape::Sphere;
  const ConformalSOMResult whole = trainConformalSOM(TrainingSamples(points, priority), options);
  for (const std::vector<Index>& cuts :
    std::vector<std::vector<Index>>{ { 0, 2000, 9000 }, { 0, 5000, 5000, 9000 } })
  {
    ranks::run(static_cast<int>(cuts.size()) - 1,
      [&](const conformal::Reduce& reduce)
      {
        const Index first = cuts[reduce.Rank], size = cuts[reduce.Rank + 1] - first;
        const Points own = points.middleRows(first, size);
        const std::vector<double> weights(
          priority.begin() + first, priority.begin() + first + size);
        const TrainingSamples part(own, weights, {}, reduce);
        EXPECT_EQ(part.totalSize(), points.rows());
        const ConformalSOMResult result = trainConformalSOM(part, options);
        EXPECT_EQ(result.Positions, whole.Positions) << reduce.Rank;
        EXPECT_EQ(result.UnsupportedFraction, whole.UnsupportedFraction);
      });
  }
}

TEST(ConformalSOM, RanksPresentTheSamePatterns)
{
  const Points points = potato(3000);
  const std::vector<double> priority = [&]
  {
    std::vector<double> values;
    for (Index i = 0; i < points.rows(); ++i)
    {
      values.push_back(1.0 + points(i, 0));
    }
    return values;
  }();
  ConformalSOMOptions options = online(7);
  options.Online.NumberOfEpochs = 5;
  options.Online.SamplesPerEpoch = 500;
  for (const bool weighted : { false, true })
  {
    const TrainingSamples samples(
      points, weighted ? conformal::NumberView(priority) : conformal::NumberView());
    const ConformalSOMResult whole = trainConformalSOM(samples, options);
    const std::vector<double> errors = conformal::quantizationErrors(samples, whole, {});
    ranks::run(3,
      [&](const conformal::Reduce& reduce)
      {
        const Index first = 1000 * reduce.Rank;
        const Points own = points.middleRows(first, 1000);
        const std::vector<double> weights(
          priority.begin() + first, priority.begin() + first + 1000);
        const TrainingSamples part(
          own, weighted ? conformal::NumberView(weights) : conformal::NumberView(), {}, reduce);
        const ConformalSOMResult result = trainConformalSOM(part, options);
        EXPECT_EQ(result.Positions, whole.Positions) << reduce.Rank;
        EXPECT_EQ(conformal::quantizationErrors(part, result, {}), errors);
      });
  }
}

// A process without points has no weights either.
TEST(ConformalSOM, RanksWithoutPointsDrawWithTheOthers)
{
  const Points points = potato(1000);
  std::vector<double> priority;
  for (Index i = 0; i < points.rows(); ++i)
  {
    priority.push_back(1.0 + points(i, 0));
  }
  ConformalSOMOptions options = online(4);
  options.Online.NumberOfEpochs = 3;
  const ConformalSOMResult whole = trainConformalSOM(TrainingSamples(points, priority), options);
  ranks::run(3,
    [&](const conformal::Reduce& reduce)
    {
      const bool hasAll = reduce.Rank == 1;
      const Points own = hasAll ? points : Points(0, 3);
      const TrainingSamples part(
        own, hasAll ? conformal::NumberView(priority) : conformal::NumberView(), {}, reduce);
      EXPECT_TRUE(part.weighted());
      EXPECT_EQ(trainConformalSOM(part, options).Positions, whole.Positions) << reduce.Rank;
    });
}

TEST(ConformalSOM, RanksRefuseWeightsThatSomeLack)
{
  const Points points = potato(100);
  const std::vector<double> priority(100, 1.0);
  ranks::run(2,
    [&](const conformal::Reduce& reduce)
    {
      const conformal::NumberView weights =
        reduce.Rank == 0 ? conformal::NumberView(priority) : conformal::NumberView();
      EXPECT_THROW(TrainingSamples(points, weights, {}, reduce), std::invalid_argument);
    });
}

TEST(ConformalSOM, RanksShareTheHull)
{
  const Points points = horseshoe(6000);
  ConformalSOMOptions options = automatic(1442);
  options.StartingShape = conformal::StartingShape::Hull;
  const ConformalSOMResult whole = trainConformalSOM(TrainingSamples(points), options);
  ASSERT_TRUE(whole.FromHull);
  ranks::run(2,
    [&](const conformal::Reduce& reduce)
    {
      const Points own = reduce.Rank == 0 ? Points(points.topRows(2500))
                                          : Points(points.bottomRows(points.rows() - 2500));
      const ConformalSOMResult result =
        trainConformalSOM(TrainingSamples(own, {}, {}, reduce), options);
      EXPECT_EQ(result.Positions, whole.Positions) << reduce.Rank;
      EXPECT_EQ(result.NumberOfSamplesOutside, whole.NumberOfSamplesOutside);
    });
}

TEST(ConformalSOM, HistoryFollowsThePapersSchedules)
{
  const Points points = potato(2000);
  ConformalSOMOptions options = online(4);
  options.Online.NumberOfEpochs = 20;
  const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), options);
  ASSERT_EQ(result.History.size(), 20U);
  for (std::size_t t = 0; t < result.History.size(); ++t)
  {
    EXPECT_NEAR(result.History[t].NeighborhoodRadius, 0.4 * std::exp(-(t / 20.0)), 1e-15);
    EXPECT_NEAR(result.History[t].LearningRate, 0.01 * std::exp(-(t / 60.0)), 1e-15);
  }
  EXPECT_LT(result.History.back().MeanSquareError, result.History.front().MeanSquareError);
  const ConformalSOMOptions many = batch(9);
  const std::size_t passes = 2 * many.Batch.PassesPerLevel + many.Fit.Iterations; // f = 4, 9
  EXPECT_EQ(trainConformalSOM(TrainingSamples(points), many).History.size(), passes);
}

TEST(ConformalSOM, QuantizationErrorIsTheNeuronsScatter)
{
  const Points points = sphereCloud(5000);
  const TrainingSamples samples(points);
  const ConformalSOMResult result = trainConformalSOM(samples, batch(4));
  const std::vector<double> errors = conformal::quantizationErrors(samples, result);
  ASSERT_EQ(static_cast<Index>(errors.size()), result.Positions.rows());
  // 162 cells of area 4 pi / 162: discs of that area have a root mean square radius of 0.11.
  double mean = 0.0;
  for (double error : errors)
  {
    mean += error / errors.size();
  }
  EXPECT_NEAR(mean, 0.11, 0.01);
}

// Points few, equal, in line or in a plane: a finite mesh of the right topology all the same.
TEST(ConformalSOM, DegenerateCloudsGiveFiniteMeshes)
{
  std::vector<Points> clouds;
  for (Index size : { 1, 2, 3, 50 })
  {
    clouds.emplace_back(Points::Constant(size, 3, 7.0));
    Points line = Points::Zero(size, 3);
    line.col(0).setLinSpaced(0.0, 1.0);
    clouds.push_back(line);
    line.col(1) = line.col(0).array().square();
    clouds.push_back(line);
  }
  for (const Points& points : clouds)
  {
    for (const ConformalSOMOptions& options : { online(4), batch(4) })
    {
      const ConformalSOMResult result = trainConformalSOM(TrainingSamples(points), options);
      EXPECT_EQ(result.Positions.rows(), 162);
      EXPECT_TRUE(result.Positions.allFinite());
    }
  }
}

TEST(ConformalSOM, StopsWhenToldTo)
{
  const Points points = potato(2000);
  for (const ConformalSOMOptions& options : { online(6), batch(6) })
  {
    runs::Watch watch;
    trainConformalSOM(TrainingSamples(points), options, nullptr, watch.run());
    EXPECT_GE(watch.calls(), 15);
    EXPECT_LE(watch.calls(), 2000);
    EXPECT_EQ(watch.last(), 1.0);
    EXPECT_THROW(
      trainConformalSOM(TrainingSamples(points), options, nullptr, runs::stoppingAt(0.5)),
      conformal::Aborted);
  }
}

TEST(ConformalSOM, RefusesWhatItCannotUse)
{
  const Points points = potato(10);
  const TrainingSamples samples(points);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [&](auto change)
  {
    ConformalSOMOptions options = batch(2);
    change(options);
    EXPECT_THROW(trainConformalSOM(samples, options), std::invalid_argument);
  };
  refused([](auto& o) { o.NumberOfNeurons = conformal::geodesicSphereSize(0); });
  refused([](auto& o) { o.Online.NumberOfEpochs = -1; });
  refused([](auto& o) { o.Online.SamplesPerEpoch = 0; });
  refused([](auto& o) { o.Online.InitialNeighborhoodRadius = 0.0; });
  refused([&](auto& o) { o.Online.InitialNeighborhoodRadius = nan; });
  refused([](auto& o) { o.Online.NeighborhoodTimeConstant = 0.0; });
  refused([&](auto& o) { o.Online.NeighborhoodTimeConstant = nan; });
  refused([](auto& o) { o.Online.InitialLearningRate = 1.0; });
  refused([&](auto& o) { o.Online.InitialLearningRate = nan; });
  refused([](auto& o) { o.Online.LearningRateTimeConstant = -1.0; });
  refused([](auto& o) { o.Batch.PassesPerLevel = -1; });
  refused([](auto& o) { o.Batch.SamplesPerNeuron = 0; });
  refused([](auto& o) { o.Fit.Iterations = -1; });
  refused([&](auto& o) { o.Fit.Smoothness = nan; });
  EXPECT_THROW(trainConformalSOM(TrainingSamples(Points(0, 3))), std::invalid_argument);
}

TEST(ConformalSOM, SumsDoNotDependOnTheOrder)
{
  conformal::Random random(3);
  std::vector<double> values(1000);
  double exact = 0.0;
  for (double& value : values)
  {
    value = 2.0 * random.uniform() - 1.0;
    exact += value;
  }
  conformal::FixedPointSums forward(1), backward(1);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    forward.add(0, values[i]);
    backward.add(0, values[values.size() - 1 - i]);
  }
  EXPECT_EQ(forward[0], backward[0]);
  EXPECT_NEAR(forward[0], exact, 1e-9);
}
