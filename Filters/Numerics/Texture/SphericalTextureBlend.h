/// Blend two pictures of an object, from the front and from the back, into one image of the sphere.
/// The method is an own construction, not from a publication. The weights of the pictures change
/// gradually between the middles of both pictures. In the result, the pictures therefore have no
/// visible edges.

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
  PixelGrid FrontGrid, BackGrid; ///< size of each picture, at least one pixel
  double BlendAngle = 30.0;      ///< width of the blended zone on the sphere, in [0, 180] [degrees]
};

/// Pixel of the blended image. Front and Back contain the four pixels of each picture to
/// interpolate, with weights. The value of the blended pixel is FrontShare times the value of
/// Front, plus (1 - FrontShare) times the value of Back.
struct BlendedPixel
{
  PixelMix Front, Back;
  double FrontShare = 0.5;
};

/// Function that receives blended pixels. Several threads may call the function concurrently, with
/// different pixels.
using BlendSink = std::function<void(Index firstPixel, const std::vector<BlendedPixel>& pixels)>;

/// Compute the weight of the front picture at a direction. From the back to the front, the weight
/// increases smoothly from 0 to 1, within a zone of width BlendAngle. The weight is 1/2 at
/// directions that have equal distances to the poles (middles) of both pictures. If the poles are
/// opposite to each other, these directions form the equator between the poles.
double frontShare(const Vector3& n, const TwoPictures& pictures);

/// Blend two pictures into an image of the sphere, and pass the pixels to `sink`, a function of the
/// caller.
/// @param[in] image  position and projection of the blended image on the sphere
/// @param[in] grid  size of the blended image
/// @throws std::invalid_argument if an image has no pixels or BlendAngle is out of range
void blendPictures(const TwoPictures& pictures, const SphereImage& image, const PixelGrid& grid,
  const BlendSink& sink, const Run& run = {});
}

#endif
