#include "Texture/SphericalTextureBlend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using conformal::BlendedPixel;
using conformal::blendPictures;
using conformal::frontShare;
using conformal::Index;
using conformal::PixelGrid;
using conformal::PixelMix;
using conformal::SphereImage;
using conformal::TwoPictures;
using conformal::Vector2;
using conformal::Vector3;

namespace
{
TwoPictures oppositePictures()
{
  TwoPictures pictures;
  pictures.Back.View = { { 0, 0, -1 }, { 0, 1, 0 }, { -1, 0, 0 } };
  pictures.FrontGrid = { 8, 8 };
  pictures.BackGrid = { 5, 7 };
  return pictures;
}

Vector3 at(double degreesFromFront)
{
  const double angle = degreesFromFront * std::acos(-1.0) / 180.0;
  return { std::sin(angle), 0, std::cos(angle) };
}
}

TEST(SphericalTextureBlend, FadesOverTheEquator)
{
  TwoPictures pictures = oppositePictures();
  EXPECT_EQ(frontShare(at(0), pictures), 1.0);
  EXPECT_EQ(frontShare(at(74.9), pictures), 1.0);
  EXPECT_NEAR(frontShare(at(90), pictures), 0.5, 1e-14);
  EXPECT_EQ(frontShare(at(105.1), pictures), 0.0);
  EXPECT_EQ(frontShare(at(180), pictures), 0.0);
  for (double angle = 76; angle < 104; angle += 1.0)
  {
    EXPECT_GT(frontShare(at(angle), pictures), frontShare(at(angle + 1), pictures));
    EXPECT_NEAR(
      frontShare(at(angle), pictures) + frontShare(at(180 - angle), pictures), 1.0, 1e-12);
  }
  pictures.BlendAngle = 0.0;
  EXPECT_EQ(frontShare(at(89.9), pictures), 1.0);
  EXPECT_EQ(frontShare(at(90.1), pictures), 0.0);
}

TEST(SphericalTextureBlend, MixesPixelsBilinearly)
{
  const PixelGrid grid = { 4, 2 };
  const auto valueAt = [&](double s, double t) // of an image that is 10 i + 100 j
  {
    const PixelMix mix = grid.mixAt({ s, t });
    double sum = 0.0, weights = 0.0;
    for (int k = 0; k < 4; ++k)
    {
      sum +=
        mix.Weights[k] * static_cast<double>(10 * (mix.Pixels[k] % 4) + 100 * (mix.Pixels[k] / 4));
      weights += mix.Weights[k];
    }
    EXPECT_NEAR(weights, 1.0, 1e-15);
    return sum;
  };
  EXPECT_NEAR(valueAt(0.125, 0.25), 0.0, 1e-12);
  EXPECT_NEAR(valueAt(0.875, 0.75), 130.0, 1e-12);
  EXPECT_NEAR(valueAt(0.5, 0.5), 65.0, 1e-12);
  EXPECT_NEAR(valueAt(0.25, 0.35), 5.0 + 20.0, 1e-12);
  EXPECT_NEAR(valueAt(-7.0, 0.0), 0.0, 1e-12); // the border, drawn out
  EXPECT_NEAR(valueAt(9.0, 1.0), 130.0, 1e-12);
  const PixelMix single = PixelGrid{ 1, 1 }.mixAt({ 0.3, 0.9 });
  EXPECT_EQ(single.Pixels[3], 0);
}

TEST(SphericalTextureBlend, LooksUpEachPictureFromItsOwnView)
{
  const TwoPictures pictures = oppositePictures();
  SphereImage image;
  image.Projection = conformal::SphereProjection::LongitudeLatitude;
  const PixelGrid grid = { 16, 9 };
  std::vector<BlendedPixel> all(grid.size());
  blendPictures(pictures, image, grid,
    [&](Index first, const std::vector<BlendedPixel>& pixels)
    { std::copy(pixels.begin(), pixels.end(), all.begin() + first); });
  for (Index i = 0; i < grid.size(); ++i)
  {
    const Vector3 n = conformal::textureToSphere(grid.middleOf(i), image);
    const PixelMix front = pictures.FrontGrid.mixAt(conformal::sphereToTexture(n, pictures.Front));
    EXPECT_EQ(all[i].Front.Pixels, front.Pixels);
    EXPECT_EQ(all[i].Back.Weights,
      pictures.BackGrid.mixAt(conformal::sphereToTexture(n, pictures.Back)).Weights);
    EXPECT_EQ(all[i].FrontShare, frontShare(n, pictures));
  }
}

TEST(SphericalTextureBlend, RefusesWhatCannotBeBlended)
{
  const auto sink = [](Index, const std::vector<BlendedPixel>&) {};
  TwoPictures pictures = oppositePictures();
  EXPECT_THROW(blendPictures(pictures, {}, { 0, 1 }, sink), std::invalid_argument);
  for (double bad : { -1.0, 181.0, std::nan("") })
  {
    pictures.BlendAngle = bad;
    EXPECT_THROW(blendPictures(pictures, {}, { 3, 3 }, sink), std::invalid_argument) << bad;
  }
  pictures = oppositePictures();
  pictures.BackGrid = {};
  EXPECT_THROW(blendPictures(pictures, {}, { 3, 3 }, sink), std::invalid_argument);
}
