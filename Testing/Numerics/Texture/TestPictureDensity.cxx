#include "Texture/PictureDensity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

using conformal::Index;
using conformal::Picture;
using conformal::pictureDensity;
using conformal::SphereDensity;
using conformal::SphereImage;
using conformal::SphereProjection;
using conformal::Vector3;

namespace
{
SphereImage wideImage(SphereProjection projection)
{
  SphereImage image;
  image.Projection = projection;
  image.FieldOfView = 300.0;
  return image;
}

/// Values of a function of the direction.
template <typename Function>
Picture painted(Index width, Index height, const SphereImage& image, Function function)
{
  Picture picture;
  picture.Grid = { width, height };
  for (Index i = 0; i < picture.Grid.size(); ++i)
  {
    picture.Values.push_back(function(conformal::textureToSphere(picture.Grid.middleOf(i), image)));
  }
  return picture;
}
}

// The slope of a linear function on the sphere, in every projection.
TEST(PictureDensity, IsTheSlope)
{
  const Vector3 axis(0.3, -0.2, 0.6);
  for (const SphereProjection projection :
    { SphereProjection::Stereographic, SphereProjection::LongitudeLatitude,
      SphereProjection::Octahedral, SphereProjection::CubeMap })
  {
    const SphereImage image = wideImage(projection);
    const SphereDensity density = pictureDensity(
      painted(600, 400, image, [&](const Vector3& n) { return axis.dot(n); }), image);
    for (const Vector3& direction :
      { Vector3(0.2, 0.3, 0.9), Vector3(0.5, -0.3, 0.4), Vector3(-0.6, 0.1, 0.5) })
    {
      const Vector3 n = direction.normalized();
      const double expected = (axis - axis.dot(n) * n).norm();
      EXPECT_NEAR(density.At(n), expected, 0.05 * expected);
    }
  }
}

TEST(PictureDensity, AddsSquaresOfComponents)
{
  const SphereImage image = wideImage(SphereProjection::LongitudeLatitude);
  const Picture one = painted(200, 100, image, [](const Vector3& n) { return n[0]; });
  Picture two = { one.Grid, 2, {} };
  for (const double value : one.Values)
  {
    two.Values.insert(two.Values.end(), { 3.0 * value, -4.0 * value });
  }
  const Vector3 direction = Vector3(0.1, 0.8, 0.3).normalized();
  const double ofOne = pictureDensity(one, image).At(direction);
  EXPECT_NEAR(pictureDensity(two, image).At(direction), 5.0 * ofOne, 1e-12);
}

// The border of two colors: as many points whether it is sharp or soft.
TEST(PictureDensity, CountsTheChangeAndNotItsSharpness)
{
  const SphereImage image = wideImage(SphereProjection::LongitudeLatitude);
  const auto total = [&](double width)
  {
    const SphereDensity density =
      pictureDensity(painted(800, 400, image,
                       [=](const Vector3& n) { return 1.0 / (1.0 + std::exp(-n[0] / width)); }),
        image);
    return conformal::integralOf(density, conformal::densitiesOf(density));
  };
  // A step of 1 across a great circle of length 2 pi.
  EXPECT_NEAR(total(0.05), 2.0 * std::acos(-1.0), 0.2);
  EXPECT_NEAR(total(0.01), 2.0 * std::acos(-1.0), 0.2);
}

TEST(PictureDensity, OfOneColorIsZero)
{
  const SphereImage image = wideImage(SphereProjection::LongitudeLatitude);
  const SphereDensity density =
    pictureDensity(painted(1, 1, image, [](const Vector3&) { return 0.5; }), image);
  EXPECT_FALSE(conformal::isAnywhere(density));
}

TEST(PictureDensity, DetailsGetHalfOfThePointsInAnyUnit)
{
  const SphereImage image = wideImage(SphereProjection::LongitudeLatitude);
  SphereDensity even =
    pictureDensity(painted(40, 20, image, [](const Vector3&) { return 0.5; }), image);
  even.At = [](const Vector3&) { return 1.0; };
  const Vector3 ahead = Vector3(1.0, 0.2, 0.1).normalized(),
                aside = Vector3(0.1, 1.0, 0.1).normalized();
  for (const double unit : { 1e-200, 1.0, 1e200 })
  {
    const Picture picture = painted(40, 20, image, [=](const Vector3& n) { return unit * n[1]; });
    const SphereDensity both = conformal::withDetails(even, picture, image);
    const auto all = conformal::densitiesOf(both);
    // The slope of n_y is largest where n_y is 0; the other half has density 1 everywhere.
    EXPECT_GT(both.At(ahead), 1.5 * both.At(aside));
    EXPECT_TRUE(std::isfinite(conformal::integralOf(both, all)));
  }
  const Picture plain = painted(4, 2, image, [](const Vector3&) { return 3.0; });
  const SphereDensity kept = conformal::withDetails(even, plain, image);
  EXPECT_EQ(kept.At(ahead), 1.0);
  EXPECT_EQ(kept.At(aside), 1.0);
}

TEST(PictureDensity, BadPicturesAreRefused)
{
  EXPECT_THROW(conformal::withDetails({}, {}, {}), std::invalid_argument);
  const SphereImage image;
  EXPECT_THROW(pictureDensity({}, image), std::invalid_argument);
  EXPECT_THROW(pictureDensity({ { 2, 2 }, 1, { 1.0, 2.0, 3.0 } }, image), std::invalid_argument);
  EXPECT_THROW(pictureDensity({ { 1, 2 }, 0, {} }, image), std::invalid_argument);
  EXPECT_THROW(
    pictureDensity({ { 1, 2 }, 1, { 1.0, std::numeric_limits<double>::quiet_NaN() } }, image),
    std::invalid_argument);
}
