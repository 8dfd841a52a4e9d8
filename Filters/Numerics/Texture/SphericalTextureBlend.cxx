#include "Texture/SphericalTextureBlend.h"

#include "Mesh/Mesh.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace conformal
{
//------------------------------------------------------------------------------
double frontShare(const Vector3& n, const TwoPictures& pictures)
{
  const double degrees = 180.0 / Pi;
  const double toFront = 0.5 * degrees *
    (angleBetween(n, pictures.Back.View.Pole) - angleBetween(n, pictures.Front.View.Pole));
  if (pictures.BlendAngle <= 0.0)
  {
    return toFront < 0.0 ? 0.0 : 1.0;
  }
  const double x = std::clamp(toFront / pictures.BlendAngle + 0.5, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

//------------------------------------------------------------------------------
void blendPictures(const TwoPictures& pictures, const SphereImage& image, const PixelGrid& grid,
  const BlendSink& sink, const Run& run)
{
  if (grid.size() < 1 || pictures.FrontGrid.size() < 1 || pictures.BackGrid.size() < 1)
  {
    throw std::invalid_argument("an image must have at least one pixel");
  }
  if (!(pictures.BlendAngle >= 0.0 && pictures.BlendAngle <= 180.0))
  {
    throw std::invalid_argument("BlendAngle must lie between 0 and 180 degrees");
  }
  constexpr Index blockSize = 1 << 10;
  forBlocksReporting(run, grid.size(), blockSize,
    [&](Index begin, Index end)
    {
      std::vector<BlendedPixel> pixels(end - begin);
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 n = textureToSphere(grid.middleOf(i), image);
        pixels[i - begin] = { pictures.FrontGrid.mixAt(sphereToTexture(n, pictures.Front)),
          pictures.BackGrid.mixAt(sphereToTexture(n, pictures.Back)), frontShare(n, pictures) };
      }
      sink(begin, pixels);
    });
}
}
