#include "Learn/Batch/BatchTraining.h"

#include "Base/NumericalFailure.h"
#include "Base/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using conformal::BatchTrainingOptions;
using conformal::FittedMesh;
using conformal::Index;
using conformal::LearnedMesh;
using conformal::Points;
using conformal::PointView;
using conformal::ReferencePoint;
using conformal::trainBatch;
using conformal::TrainingSamples;

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

BatchTrainingOptions fast()
{
  BatchTrainingOptions options;
  options.Frequency = 8;
  return options;
}
}

// Lattices 4 and 8 of some passes each, then the fit.
TEST(BatchTraining, GoesFromCoarseToFine)
{
  const Points cloud = ellipsoidCloud(8000);
  BatchTrainingOptions options = fast();
  options.PassesPerLevel = 3;
  options.Fit.Iterations = 2;
  const FittedMesh result = trainBatch(TrainingSamples{ PointView(cloud) }, options, {});
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
}

// Eqs. 4 and 5 in Batch mode. In the first pass the triangles are still those of the network, whose
// conformal images are affine; after it they are not.
TEST(BatchTraining, SharesPatternsByTheirReferencePoints)
{
  const Points cloud = ellipsoidCloud(8000);
  BatchTrainingOptions options = fast();
  options.Frequency = 4;
  options.Fit.Iterations = 0;
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

TEST(BatchTraining, LearnsAsFarAsAsked)
{
  const Points egg = ellipsoidCloud(8000);
  const auto learned = [&](int levels)
  {
    return conformal::learnFromSphere(TrainingSamples{ PointView(egg) }, fast(),
      [&](const LearnedMesh& mesh, const std::vector<double>& masses)
      {
        EXPECT_EQ(mesh.Triangles.rows(), static_cast<Index>(masses.size()));
        return --levels > 0;
      });
  };
  EXPECT_THROW(learned(1), conformal::NumericalFailure);
  const auto result = learned(3);
  EXPECT_EQ(result.History.size(), 10U); // two levels of five passes
  EXPECT_LT(result.History.back().MeanSquareError, 1e-3);
}

// Errors of a clean cloud fall with the lattice's, those of a noisy one stay.
TEST(BatchTraining, FindsTheNoise)
{
  const auto noiseToDetail = [](double noise)
  {
    const Points cloud = ellipsoidCloud(40000, noise);
    BatchTrainingOptions options = fast();
    options.Frequency = 24;
    return trainBatch(TrainingSamples{ PointView(cloud) }, options, {}).NoiseToDetail;
  };
  const double clean = noiseToDetail(0.0), noisy = noiseToDetail(0.05);
  EXPECT_LT(clean, 0.5);
  EXPECT_GT(noisy, 2.0);
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
  BatchTrainingOptions options = fast();
  options.Frequency = 16;
  const FittedMesh result = trainBatch(TrainingSamples{ PointView(cloud) }, options, {});
  EXPECT_GT(result.UnsupportedFraction, 0.05);
  EXPECT_LT(result.UnsupportedFraction, 0.3);
}
