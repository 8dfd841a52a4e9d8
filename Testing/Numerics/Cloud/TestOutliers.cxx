#include "Cloud/Outliers.h"

#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <random>

using conformal::Index;
using conformal::Points;
using conformal::PointView;
using conformal::TrainingSamples;
using conformal::Vector3;

namespace
{
constexpr Index Sphere = 16002; // points of makeGeodesicSphere(40)

/// A sphere, its points moved by noise, and outliers in a box around it.
Points cloudWith(Index outliers, double noise = 0.0)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1.2, 1.2);
  std::normal_distribution<double> normal;
  Points points(Sphere + outliers, 3);
  points.topRows(Sphere) = conformal::makeGeodesicSphere(40).Positions;
  for (Index i = 0; i < points.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      points(i, k) = i < Sphere ? points(i, k) + noise * normal(random) : uniform(random);
    }
  }
  return points;
}
}

TEST(Outliers, WithoutThemAllSamplesStay)
{
  for (const double noise : { 0.0, 0.02 })
  {
    const Points points = cloudWith(0, noise);
    EXPECT_EQ(conformal::withoutOutliers(TrainingSamples(PointView(points))).size(), Sphere);
  }
}

TEST(Outliers, AlmostAllAreLeftOut)
{
  const Index outliers = Sphere / 20;
  const Points points = cloudWith(outliers);
  const TrainingSamples samples{ PointView(points) };
  const TrainingSamples rest = conformal::withoutOutliers(samples);
  Index kept = 0, near = 0;
  for (Index i = 0; i < rest.size(); ++i)
  {
    const double offset = std::abs(rest.restore(rest[i]).norm() - 1.0);
    kept += offset < 1e-12;
    near += offset >= 1e-12;
  }
  EXPECT_EQ(kept, Sphere);
  EXPECT_LT(near, outliers / 10);           // what is left lies beside the surface, or in clumps
  EXPECT_EQ(rest.scale(), samples.scale()); // the same coordinates
}

// Of many samples, only some are marked; the others are compared with those.
TEST(Outliers, ManySamplesAreComparedWithSome)
{
  const Points part = cloudWith(Sphere / 20);
  constexpr int copies = 10;
  Points points(copies * part.rows(), 3);
  for (int k = 0; k < copies; ++k)
  {
    const Eigen::AngleAxisd turn(0.3 * k, Vector3(1.0, 2.0, 3.0).normalized());
    points.middleRows(k * part.rows(), part.rows()) = part * turn.toRotationMatrix();
  }
  const TrainingSamples samples{ PointView(points) };
  const TrainingSamples rest = conformal::withoutOutliers(samples);
  EXPECT_LT(rest.size(), copies * Sphere * 1.01);
  Index kept = 0;
  for (Index i = 0; i < rest.size(); ++i)
  {
    kept += std::abs(rest.restore(rest[i]).norm() - 1.0) < 1e-12;
  }
  EXPECT_GT(kept, copies * Sphere * 0.999);
}
