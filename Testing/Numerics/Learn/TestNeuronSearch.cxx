#include "Learn/NeuronSearch.h"

#include "Base/Random.h"
#include "Learn/ConformalSOM.h"
#include "Mesh/GeodesicSphere.h"
#include "Ranks.h"
#include "Runs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using conformal::ConformalSOMOptions;
using conformal::ConformalSOMResult;
using conformal::Index;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
constexpr Index Size = 2000;
const Vector3 Axes(1.0, 0.7, 0.5);

/// Normal deviate with variance 1, as a sum of uniform ones.
double deviate(conformal::Random& random)
{
  double sum = -6.0;
  for (int i = 0; i < 12; ++i)
  {
    sum += random.uniform();
  }
  return sum;
}

/// Random points of an ellipsoid with Gaussian noise along each axis.
Points ellipsoid(double noise, Index size = Size)
{
  conformal::Random random(11);
  Points points(size, 3);
  for (Index i = 0; i < size; ++i)
  {
    Vector3 n, error;
    for (int c = 0; c < 3; ++c)
    {
      n[c] = deviate(random);
      error[c] = noise * deviate(random);
    }
    points.row(i) = n.normalized().cwiseProduct(Axes) + error;
  }
  return points;
}

/// Root mean square distance of the vertices from the ellipsoid, to first order.
double distanceOf(const ConformalSOMResult& result)
{
  double sum = 0.0;
  for (Index i = 0; i < result.Positions.rows(); ++i)
  {
    const Vector3 x = result.Positions.row(i), scaled = x.cwiseQuotient(Axes);
    const double distance =
      scaled.norm() * (scaled.norm() - 1.0) / scaled.cwiseQuotient(Axes).norm();
    sum += distance * distance;
  }
  return std::sqrt(sum / static_cast<double>(result.Positions.rows()));
}

ConformalSOMResult learn(const Points& points, const ConformalSOMOptions& options = {})
{
  return trainConformalSOM(TrainingSamples{ PointView(points) }, options);
}

ConformalSOMOptions withNeurons(Index neurons)
{
  ConformalSOMOptions options;
  options.NumberOfNeurons = neurons;
  return options;
}
}

TEST(NeuronSearch, ExactPointsGetMoreNeuronsThanPoints)
{
  EXPECT_EQ(learn(ellipsoid(0.0)).Positions.rows(), 3 * Size / 2);
}

TEST(NeuronSearch, NoisyPointsGetFewerNeuronsWhichAreCloser)
{
  constexpr double noise = 0.02;
  const Points points = ellipsoid(noise);
  const ConformalSOMResult result = learn(points), fine = learn(points, withNeurons(3 * Size / 2));
  EXPECT_LE(result.Positions.rows(), Size / 2);
  EXPECT_LT(distanceOf(result), 0.6 * distanceOf(fine));
  EXPECT_NEAR(result.Noise / noise, 1.0, 0.2);
}

TEST(NeuronSearch, AGivenNumberIsKept)
{
  EXPECT_EQ(learn(ellipsoid(0.02), withNeurons(700)).Positions.rows(), 700);
}

TEST(NeuronSearch, GeodesicAndPlaneMeshesHaveTheUsualNumber)
{
  ConformalSOMOptions geodesic;
  geodesic.MeshType = conformal::MeshType::Geodesic;
  EXPECT_EQ(learn(ellipsoid(0.0), geodesic).Positions.rows(), conformal::UsualNeurons);
  Points flat = ellipsoid(0.0);
  flat.col(2).setZero();
  EXPECT_EQ(learn(flat).Positions.rows(), conformal::UsualNeurons);
}

TEST(NeuronSearch, AMeshOfFewVerticesIsLearnedByTheUsualNumber)
{
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(6);
  conformal::MappedMesh mesh;
  static_cast<conformal::Mesh&>(mesh) = sphere;
  EXPECT_EQ(
    trainConformalSOM(TrainingSamples{ PointView(sphere.Positions) }, {}, &mesh).Positions.rows(),
    conformal::UsualNeurons);
}

TEST(NeuronSearch, StagesAreThoseOfTheResult)
{
  std::vector<conformal::LearningStage> stages;
  ConformalSOMOptions options;
  options.Observer = [&](const conformal::LearningStage& stage) { stages.push_back(stage); };
  const ConformalSOMResult result = learn(ellipsoid(0.02), options);
  ASSERT_FALSE(stages.empty());
  int fits = 0;
  for (const conformal::LearningStage& stage : stages)
  {
    fits += stage.Name == "fit";
    if (stage.Name == "fit" || stage.Name == "kept")
    {
      EXPECT_EQ(stage.Surface.Positions.rows(), result.Positions.rows());
    }
  }
  EXPECT_EQ(fits, result.NumberOfStarts);
}

TEST(NeuronSearch, ThreadsAndRanksChangeNoBit)
{
  const Points points = ellipsoid(0.02);
  const Points expected = learn(points).Positions;
  EXPECT_EQ(trainConformalSOM(TrainingSamples{ PointView(points) }, {}, nullptr, runs::backwards())
              .Positions,
    expected);
  ranks::run(2,
    [&](const conformal::Reduce& reduce)
    {
      const Index half = points.rows() / 2;
      const Points own = reduce.Rank == 0 ? Points(points.topRows(half))
                                          : Points(points.bottomRows(points.rows() - half));
      EXPECT_EQ(
        trainConformalSOM(TrainingSamples{ PointView(own), {}, {}, reduce }).Positions, expected);
    });
}

TEST(NeuronSearch, ReportsProgressAndStops)
{
  const Points points = ellipsoid(0.02);
  const TrainingSamples samples{ PointView(points) };
  runs::Watch watch;
  trainConformalSOM(samples, {}, nullptr, watch.run());
  EXPECT_EQ(watch.last(), 1.0);
  for (const double fraction : { 0.1, 0.3, 0.5 })
  {
    EXPECT_THROW(
      trainConformalSOM(samples, {}, nullptr, runs::stoppingAt(fraction)), conformal::Aborted);
  }
}
