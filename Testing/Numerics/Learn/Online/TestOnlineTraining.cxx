#include "Learn/Online/OnlineTraining.h"

#include "../../../Benchmarks/BruteForceTraining.h"
#include "Base/Random.h"
#include "Mesh/GeodesicSphere.h"
#include "Mesh/MeshTopology.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>

using conformal::Index;
using conformal::LearnedMesh;
using conformal::makeGeodesicSphere;
using conformal::Mesh;
using conformal::OnlineTrainingOptions;
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

OnlineTrainingOptions few(int epochs, int steps)
{
  OnlineTrainingOptions options;
  options.Frequency = 6;
  options.NumberOfEpochs = epochs;
  options.SamplesPerEpoch = steps;
  return options;
}

LearnedMesh trained(const TrainingSamples& samples, const OnlineTrainingOptions& options)
{
  const Mesh network = makeGeodesicSphere(options.Frequency);
  return trainOnline(samples, network, network.Positions, options, {});
}

// Where the conformal map from the upper half-plane to a triangle, 0, 1 and infinity to its
// corners, takes a point: a Schwarz-Christoffel integral, here the incomplete beta function by its
// series. It shares no code with the library's, which maps the disk.
Vector3 ofHalfPlane(std::complex<double> zeta, const std::array<Vector3, 3>& corners)
{
  const double pi = std::acos(-1.0);
  std::array<double, 3> angles; // in units of pi
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 u = corners[(k + 1) % 3] - corners[k], v = corners[(k + 2) % 3] - corners[k];
    angles[k] = std::atan2(u.cross(v).norm(), u.dot(v)) / pi;
  }
  const auto [a, b, c] = angles;
  std::complex<double> sum = 0.0, term = 1.0;
  for (int n = 0; n < 400; ++n)
  {
    sum += term / (a + n);
    term *= zeta * (n + 1.0 - b) / (n + 1.0);
  }
  const double side = std::exp(std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b));
  const std::complex<double> z = std::pow(zeta, a) * sum / side; // corners 0 and 1 at 0 and 1
  const double height = std::sin(b * pi) / std::sin(c * pi) * std::sin(a * pi);
  const double third = z.imag() / height;
  const double second = z.real() - third * height / std::tan(a * pi);
  return { 1.0 - second - third, second, third };
}

// Of the way to x that each neuron has gone.
std::vector<double> sharesOfTheWay(const Points& before, const Points& after, const Vector3& x)
{
  std::vector<double> shares(before.rows());
  for (Index i = 0; i < before.rows(); ++i)
  {
    const Vector3 way = x - Vector3(before.row(i));
    shares[i] = (after.row(i) - before.row(i)).dot(way) / way.squaredNorm();
  }
  return shares;
}

// The largest difference between shares and what Eq. 3 makes of the reference point r.
double differenceFromEquation3(const std::vector<double>& shares, const Mesh& network,
  const Vector3& r, double alpha, double sigma)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    const double square = (r - Vector3(network.Positions.row(i))).squaredNorm();
    const double share =
      std::sqrt(square) <= 4.0 * sigma ? alpha * std::exp(-square / (2.0 * sigma * sigma)) : 0.0;
    largest = std::max(largest, std::abs(shares[i] - share));
  }
  return largest;
}
}

// Eq. 3 with every neuron asked and moved, nothing cut off: the same patterns give the same map,
// but for shares below exp(-8).
TEST(OnlineTraining, AgreesWithBruteForce)
{
  const Points cloud = ellipsoidCloud(2000);
  const TrainingSamples samples{ PointView(cloud) };
  const OnlineTrainingOptions options = few(10, 400);
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
  OnlineTrainingOptions options = few(1, 1);
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

// Eqs. 4 and 5: a step from a network whose simplices have other shapes than its triangles spreads
// from the conformal image of the pattern, not from an affine one and not from the winner; the next
// epoch's step is narrower and shorter, as the schedules say.
TEST(OnlineTraining, StepsGoToTheConformalImage)
{
  OnlineTrainingOptions options = few(2, 1);
  options.Frequency = 4;
  options.InitialLearningRate = 0.3;
  options.InitialNeighborhoodRadius = 0.2;
  options.LearningRateTimeConstant = 3.0;
  options.NeighborhoodTimeConstant = 2.0;
  const Mesh network = makeGeodesicSphere(options.Frequency);
  int tried = 0;
  double closestAffine = 1.0, closestWinner = 1.0;
  for (const Index triangle : { 0, 17, 101, 233 })
  {
    for (const std::complex<double> zeta : { std::complex<double>(0.4, 0.3), { -0.2, 0.5 } })
    {
      // Stretched, and scaled so that the pattern, which lies on the simplex, has norm 1.
      Points start = network.Positions;
      start.col(1) *= 1.7;
      const auto ids = network.Triangles.row(triangle);
      const auto cornersOf = [&](const Points& points)
      {
        return std::array<Vector3, 3>{ Vector3(points.row(ids[0])), Vector3(points.row(ids[1])),
          Vector3(points.row(ids[2])) };
      };
      const auto at = [&](const Points& points, const Vector3& weights)
      {
        const auto corners = cornersOf(points);
        return Vector3(weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2]);
      };
      const Vector3 inSimplex = ofHalfPlane(zeta, cornersOf(start));
      const Vector3 inTriangle = ofHalfPlane(zeta, cornersOf(network.Positions));
      start /= at(start, inSimplex).norm();
      const Vector3 x = at(start, inSimplex);

      // The cloud's centroid is 0, and the network symmetric: -x is as good a pattern as x.
      Points cloud(2, 3);
      cloud.row(0) = x;
      cloud.row(1) = -x;
      const TrainingSamples samples{ PointView(cloud) };
      options.NumberOfEpochs = 1;
      const Points after = trainOnline(samples, network, start, options, {}).Positions;
      Index winner = 0;
      (start.rowwise() - x.transpose()).rowwise().squaredNorm().minCoeff(&winner);
      const std::vector<double> shares = sharesOfTheWay(start, after, x);
      if (shares[winner] < 0.05)
      {
        continue; // -x was drawn
      }
      ++tried;
      const auto differenceAt = [&](const Vector3& r)
      { return differenceFromEquation3(shares, network, r.normalized(), 0.3, 0.2); };
      EXPECT_LT(differenceAt(at(network.Positions, inTriangle)), 1e-5) << triangle << ", " << zeta;
      closestAffine = std::min(closestAffine, differenceAt(at(network.Positions, inSimplex)));
      closestWinner = std::min(closestWinner, differenceAt(network.Positions.row(winner)));

      options.ReferencePoint = conformal::ReferencePoint::Winner;
      const Points plain = trainOnline(samples, network, start, options, {}).Positions;
      EXPECT_LT(differenceFromEquation3(sharesOfTheWay(start, plain, x), network,
                  network.Positions.row(winner), 0.3, 0.2),
        1e-5);
      // The second epoch: alpha and sigma of t = 1.
      options.NumberOfEpochs = 2;
      const Points last = trainOnline(samples, network, start, options, {}).Positions;
      double second = 1.0;
      for (const Vector3& drawn : { x, Vector3(-x) })
      {
        Index next = 0;
        (plain.rowwise() - drawn.transpose()).rowwise().squaredNorm().minCoeff(&next);
        second = std::min(second,
          differenceFromEquation3(sharesOfTheWay(plain, last, drawn), network,
            network.Positions.row(next), 0.3 * std::exp(-1.0 / 3.0), 0.2 * std::exp(-1.0 / 2.0)));
      }
      EXPECT_LT(second, 1e-5);
      options.ReferencePoint = conformal::ReferencePoint::Conformal;
    }
  }
  EXPECT_GE(tried, 2);
  EXPECT_GT(closestAffine, 1e-3);
  EXPECT_GT(closestWinner, 1e-3);
}

// A projection on an edge is that of both triangles, each of which has another image of it: which
// is taken does not depend on their order, nor on that of their corners.
TEST(OnlineTraining, ProjectionsOnEdgesAreOfTheLowestNeurons)
{
  OnlineTrainingOptions options = few(1, 1);
  options.InitialNeighborhoodRadius = 0.1;
  options.InitialLearningRate = 0.5;
  const Mesh network = makeGeodesicSphere(options.Frequency);
  Points start = network.Positions;
  start.col(0) *= 0.6;
  start.col(1) *= 0.8;
  Mesh other = network;
  for (Index r = 0; r < other.Triangles.rows(); ++r)
  {
    const auto ids = network.Triangles.row(network.Triangles.rows() - 1 - r);
    other.Triangles.row(r) << ids[1 + r % 2], ids[(2 + r % 2) % 3], ids[r % 2];
  }
  const auto normal = [&](Index r)
  {
    const Vector3 a = start.row(network.Triangles(r, 0)), b = start.row(network.Triangles(r, 1)),
                  c = start.row(network.Triangles(r, 2));
    return Vector3((b - a).cross(c - a).normalized());
  };
  const conformal::Triangles neighbors =
    conformal::triangleNeighbors(network.Triangles, network.Positions.rows());
  Points cloud(3 * network.Triangles.rows(), 3);
  for (Index r = 0; r < network.Triangles.rows(); ++r)
  {
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 a = start.row(network.Triangles(r, k)),
                    b = start.row(network.Triangles(r, (k + 1) % 3));
      cloud.row(3 * r + k) = 0.7 * a + 0.3 * b + 0.05 * (normal(r) + normal(neighbors(r, k)));
    }
  }
  const TrainingSamples samples{ PointView(cloud) };
  for (Index i = 0; i < start.rows(); ++i)
  {
    start.row(i) = samples.normalize(start.row(i));
  }
  for (options.RandomSeed = 1; options.RandomSeed <= 40; ++options.RandomSeed)
  {
    const Points one = trainOnline(samples, network, start, options, {}).Positions;
    const Points two = trainOnline(samples, other, start, options, {}).Positions;
    ASSERT_GT((one - start).rowwise().norm().maxCoeff(), 0.01);
    EXPECT_LT((one - two).rowwise().norm().maxCoeff(), 1e-8) << options.RandomSeed;
  }
}

TEST(OnlineTraining, SchedulesFall)
{
  const Points cloud = ellipsoidCloud(500);
  OnlineTrainingOptions options = few(4, 50);
  const LearnedMesh result = trained(TrainingSamples{ PointView(cloud) }, options);
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
  const LearnedMesh result = trained(TrainingSamples{ PointView(cloud) }, few(0, 10));
  EXPECT_EQ(result.Positions, makeGeodesicSphere(6).Positions);
  EXPECT_TRUE(result.History.empty());
}

// Patterns are drawn in proportion to their priority: three on the axes draw the network by so
// many steps each.
// Patterns without a weight are drawn like all others in the first half of the epochs, and not at
// all in the second.
TEST(OnlineTraining, PrioritiesCountInTheSecondHalf)
{
  Points cloud(3, 3);
  cloud << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  const std::vector<double> weights = { 4.0, 1.0, 1.0 };
  const TrainingSamples samples{ PointView(cloud), weights };
  const auto drift = [&](int epochs)
  {
    OnlineTrainingOptions options = few(epochs, 6000);
    options.InitialLearningRate = 1e-6;
    options.LearningRateTimeConstant = options.NeighborhoodTimeConstant = 1e6;
    options.InitialNeighborhoodRadius = 100.0; // all neurons move alike
    const Points start = makeGeodesicSphere(options.Frequency).Positions;
    return Vector3((trained(samples, options).Positions - start).colwise().mean() / (6000 * 1e-6));
  };
  const Vector3 even = (samples[0] + samples[1] + samples[2]) / 3.0;
  const Vector3 weighted = (4.0 * samples[0] + samples[1] + samples[2]) / 6.0;
  const double rounding = 0.1 * (even - weighted).norm();
  ASSERT_GT(rounding, 0.01);
  EXPECT_LT((drift(1) - weighted).norm(), rounding);
  EXPECT_LT((drift(2) - (even + weighted)).norm(), rounding);
  EXPECT_LT((drift(4) - 2.0 * (even + weighted)).norm(), 2.0 * rounding);
}

TEST(OnlineTraining, DrawsByPriority)
{
  Points cloud(3, 3);
  cloud << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  const std::vector<double> weights = { 4.0, 1.0, 1.0 };
  const TrainingSamples samples{ PointView(cloud), weights };
  OnlineTrainingOptions options = few(1, 6000);
  options.InitialLearningRate = 1e-6;        // steps add up, and hardly change the winners
  options.InitialNeighborhoodRadius = 100.0; // all neurons move alike
  const Points start = makeGeodesicSphere(options.Frequency).Positions;
  const Vector3 drift = (trained(samples, options).Positions - start).colwise().mean();
  const Vector3 expected =
    (4.0 * samples[0] + samples[1] + samples[2]) / 6.0 * (6000 * options.InitialLearningRate);
  EXPECT_LT((drift - expected).norm(), 0.05 * samples[0].norm() * 6000 * 1e-6);
}

// Values that are a rotated copy of the coordinates make an isometric copy of the cloud in six
// dimensions, scaled by the square root of 2: winners and images are those of three dimensions.
TEST(OnlineTraining, ValuesJoinTheCoordinates)
{
  const Points cloud = ellipsoidCloud(1500);
  const TrainingSamples plain{ PointView(cloud) };
  const OnlineTrainingOptions options = few(30, 500);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()).toRotationMatrix();
  conformal::Columns values(3, cloud.rows());
  for (Index i = 0; i < cloud.rows(); ++i)
  {
    values.col(i) = turn * plain[i];
  }
  TrainingSamples samples = plain;
  samples.setPatternValues(values);
  const LearnedMesh expected = trained(plain, options), learned = trained(samples, options);
  ASSERT_EQ(learned.PatternValues.rows(), expected.Positions.rows());
  EXPECT_EQ(expected.PatternValues.size(), 0);
  // The values begin at 0, and the first winners differ from those of the sphere.
  const Points turned = (learned.Positions * turn.transpose()).eval();
  const double error = (Points(learned.PatternValues) - turned).rowwise().norm().mean();
  EXPECT_LT(error, 0.25 * (Points(learned.PatternValues)).rowwise().norm().mean());
  EXPECT_LT((learned.Positions - expected.Positions).rowwise().norm().mean(), 0.05);
}

// A value with a step across a plane attracts neurons to both sides: fewer neurons have values in
// between than with a value that does not affect the winners.
TEST(OnlineTraining, NeuronsLeaveAStepOfAValue)
{
  const Points cloud = ellipsoidCloud(4000);
  const OnlineTrainingOptions options = few(60, 1000);
  const auto between = [&](double weight)
  {
    conformal::Columns values(1, cloud.rows());
    for (Index i = 0; i < cloud.rows(); ++i)
    {
      values(0, i) = cloud(i, 0) > 0.1 ? weight : -weight;
    }
    TrainingSamples samples{ PointView(cloud) };
    samples.setPatternValues(values);
    const LearnedMesh learned = trained(samples, options);
    return (learned.PatternValues.array().abs() < 0.6 * weight).count();
  };
  EXPECT_LT(between(0.3), 0.9 * between(0.001));
}
