/// Two pictures of an object, from the front and from the back, as one image of its sphere.

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
  SphereImage Front, Back;       ///< how each lies on the sphere
  PixelGrid FrontGrid, BackGrid; ///< at least a pixel each
  double BlendAngle = 30.0;      ///< degrees of the sphere, in [0, 180]
};

/// A pixel of the blended image: FrontShare of the one mix and the rest of the other.
struct BlendedPixel
{
  PixelMix Front, Back;
  double FrontShare = 0.5;
};

/// May be called from several threads at once, for other pixels each time.
using BlendSink = std::function<void(Index firstPixel, const std::vector<BlendedPixel>& pixels)>;

/// The share of the front picture at a direction: a smooth step from 0 to 1 over BlendAngle, in the
/// middle of which the poles of both pictures are equally far. For opposite poles that is the
/// equator.
double frontShare(const Vector3& n, const TwoPictures& pictures);

/// Blend two pictures into an image of the sphere.
/// @throws std::invalid_argument if an image has no pixels or BlendAngle is out of range
void blendPictures(const TwoPictures& pictures, const SphereImage& image, const PixelGrid& grid,
  const BlendSink& sink, const Run& run = {});
}

#endif
