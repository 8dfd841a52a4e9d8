#include "Learn/Fit/NoiseEstimate.h"

#include "Base/Random.h"
#include "Clouds.h"
#include "Mesh/GeodesicSphere.h"

#include <gtest/gtest.h>

#include <cmath>

using conformal::Index;
using conformal::noiseToDetail;
using conformal::noiseVariance;
using conformal::Points;

TEST(NoiseEstimate, TellsNoiseFromDetail)
{
  EXPECT_EQ(noiseVariance(6.0, 1.0), 0.0); // detail falls sixfold
  EXPECT_EQ(noiseToDetail(6.0, 1.0), 0.0);
  EXPECT_NEAR(noiseToDetail(7.0, 2.0), 1.0, 1e-12); // 6 + 1 and 1 + 1
  EXPECT_NEAR(noiseVariance(7.0, 2.0) / noiseVariance(1.0, 1.0), 1.0, 1e-12);
  EXPECT_EQ(noiseToDetail(1.0, 1.0), 10.0);
  EXPECT_EQ(noiseToDetail(1.0, 2.0), 10.0);
}

// Points off a sphere by a normal deviate: its variance comes back from their typical error.
TEST(NoiseEstimate, FindsTheVarianceOfGaussianNoise)
{
  constexpr double Deviation = 0.01;
  const conformal::Mesh sphere = conformal::makeGeodesicSphere(40);
  Points points = sphere.Positions;
  conformal::Random random(2);
  for (Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) *= 1.0 + Deviation * clouds::gaussian(random);
  }
  const conformal::TrainingSamples samples(points);
  Points surface = sphere.Positions;
  for (Index i = 0; i < surface.rows(); ++i)
  {
    surface.row(i) = samples.normalize(surface.row(i));
  }
  const double error =
    conformal::typicalSquareError(samples, surface, sphere.Triangles, points.rows());
  const double variance = noiseVariance(error, error) * samples.scale() * samples.scale();
  EXPECT_NEAR(std::sqrt(variance) / Deviation, 1.0, 0.05);
}
