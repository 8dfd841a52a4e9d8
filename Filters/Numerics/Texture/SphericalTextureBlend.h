/// Blend two pictures of an object, from the front and from the back, into one image of its sphere.
/// Own construction: a smooth step between the poles of both pictures.

#ifndef ConformalSphericalTextureBlend_h
#define ConformalSphericalTextureBlend_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

#include <functional>
#include <vector>

namespace conformal
{
struct TwoPictures
{
  SphereImage Front, Back;       ///< position of each picture on the sphere
  PixelGrid FrontGrid, BackGrid; ///< at least one pixel each
  double BlendAngle = 30.0;      ///< degrees of the sphere, in [0, 180]
};

/// Pixel of the blended image: FrontShare of the front mix, and the rest of the back mix.
struct BlendedPixel
{
  PixelMix Front, Back;
  double FrontShare = 0.5;
};

/// Receive blended pixels. May be called from several threads concurrently, with different pixels.
using BlendSink = std::function<void(Index firstPixel, const std::vector<BlendedPixel>& pixels)>;

/// Compute the share of the front picture at a direction: a smooth step from 0 to 1 over
/// BlendAngle. In its middle the poles of both pictures are at equal distances. For opposite poles
/// that is the equator.
double frontShare(const Vector3& n, const TwoPictures& pictures);

/// Blend two pictures into an image of the sphere.
/// @throws std::invalid_argument if an image has no pixels or BlendAngle is out of range
void blendPictures(const TwoPictures& pictures, const SphereImage& image, const PixelGrid& grid,
  const BlendSink& sink, const Run& run = {});
}

#endif
