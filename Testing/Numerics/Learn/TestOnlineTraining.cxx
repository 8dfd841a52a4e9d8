#include "Learn/OnlineTraining.h"

#include "../../Benchmarks/BruteForceTraining.h"
#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::ConformalSOMOptions;
using conformal::ConformalSOMResult;
using conformal::Index;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::trainOnline;
using conformal::Vector3;

namespace
{
Points ellipsoidCloud(Index size)
{
  conformal::Random random(3);
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    const double z = 2.0 * random.uniform() - 1.0, angle = 2.0 * std::acos(-1.0) * random.uniform();
    const double r = std::sqrt(1.0 - z * z);
    points.row(i) << r * std::cos(angle), 0.7 * r * std::sin(angle), 0.8 * z;
  }
  return points;
}

ConformalSOMOptions few(int epochs, int steps)
{
  ConformalSOMOptions options;
  options.TrainingMode = conformal::TrainingMode::Online;
  options.Frequency = 6;
  options.NumberOfEpochs = epochs;
  options.SamplesPerEpoch = steps;
  return options;
}

ConformalSOMResult trained(const TrainingSamples& samples, const ConformalSOMOptions& options)
{
  const Mesh network = makeGeodesicSphere(options.Frequency);
  return trainOnline(samples, network, network.Positions, options, {});
}
}

// Eq. 3 with every neuron asked and moved, nothing cut off: the same patterns give the same map,
// but for shares below exp(-8).
TEST(OnlineTraining, AgreesWithBruteForce)
{
  const Points cloud = ellipsoidCloud(2000);
  const TrainingSamples samples{ PointView(cloud) };
  const ConformalSOMOptions options = few(10, 400);
  const Points fast = trained(samples, options).Positions;
  const Points reference = reference::trainByBruteForce(samples, options);
  const Points start = makeGeodesicSphere(options.Frequency).Positions;
  const double moved = (fast - start).rowwise().norm().mean();
  EXPECT_GT(moved, 0.05);
  EXPECT_LT((fast - reference).rowwise().norm().maxCoeff(), 0.01 * moved);
}

// One step by hand: alpha h(|r - n_i|) of the way to the pattern, with r the winner.
TEST(OnlineTraining, OneStepIsEquation3)
{
  Points cloud(2, 3); // the frame needs a size; both are equally far from the centroid
  cloud << 0.3, -0.5, 0.2, -0.3, 0.5, -0.2;
  const TrainingSamples samples{ PointView(cloud) };
  ConformalSOMOptions options = few(1, 1);
  options.ReferencePoint = conformal::ReferencePoint::Winner;
  options.InitialLearningRate = 0.5;
  options.InitialNeighborhoodRadius = 0.6;
  const Mesh network = makeGeodesicSphere(options.Frequency);
  const Points after = trained(samples, options).Positions;

  // Which of the two was drawn shows in where the neurons went.
  const Vector3 drift = (after - network.Positions).colwise().sum();
  const Vector3 x = drift.dot(samples[0]) > 0.0 ? samples[0] : samples[1];
  Index winner = 0;
  (network.Positions.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff(&winner);
  for (Index i = 0; i < after.rows(); ++i)
  {
    const Vector3 n = network.Positions.row(i);
    const double square = (Vector3(network.Positions.row(winner)) - n).squaredNorm();
    const double sigma = options.InitialNeighborhoodRadius;
    const double share =
      std::sqrt(square) <= 4.0 * sigma ? 0.5 * std::exp(-square / (2.0 * sigma * sigma)) : 0.0;
    const Vector3 expected = n + share * (x - n);
    ASSERT_LT((Vector3(after.row(i)) - expected).norm(), 1e-4 * (x - n).norm()) << i;
  }
}

TEST(OnlineTraining, SchedulesFall)
{
  const Points cloud = ellipsoidCloud(500);
  ConformalSOMOptions options = few(4, 50);
  const ConformalSOMResult result = trained(TrainingSamples{ PointView(cloud) }, options);
  ASSERT_EQ(result.History.size(), 4U);
  for (int t = 0; t < 4; ++t)
  {
    EXPECT_DOUBLE_EQ(result.History[t].LearningRate, 0.01 * std::exp(-t / 60.0));
    EXPECT_DOUBLE_EQ(result.History[t].NeighborhoodRadius, 0.4 * std::exp(-t / 20.0));
    EXPECT_GT(result.History[t].MeanDisplacement, 0.0);
  }
}

TEST(OnlineTraining, WithoutEpochsIsTheStart)
{
  const Points cloud = ellipsoidCloud(100);
  const ConformalSOMResult result = trained(TrainingSamples{ PointView(cloud) }, few(0, 10));
  EXPECT_EQ(result.Positions, makeGeodesicSphere(6).Positions);
  EXPECT_TRUE(result.History.empty());
}

// Patterns are drawn in proportion to their priority: three on the axes draw the network by so
// many steps each.
TEST(OnlineTraining, DrawsByPriority)
{
  Points cloud(3, 3);
  cloud << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  const std::vector<double> weights = { 4.0, 1.0, 1.0 };
  const TrainingSamples samples{ PointView(cloud), weights };
  ConformalSOMOptions options = few(1, 6000);
  options.InitialLearningRate = 1e-6;        // steps add up, and hardly change the winners
  options.InitialNeighborhoodRadius = 100.0; // all neurons move alike
  const Points start = makeGeodesicSphere(options.Frequency).Positions;
  const Vector3 drift = (trained(samples, options).Positions - start).colwise().mean();
  const Vector3 expected =
    (4.0 * samples[0] + samples[1] + samples[2]) / 6.0 * (6000 * options.InitialLearningRate);
  EXPECT_LT((drift - expected).norm(), 0.05 * samples[0].norm() * 6000 * 1e-6);
}
