/// A density of points that follows the details of a picture on the sphere.

#ifndef ConformalPictureDensity_h
#define ConformalPictureDensity_h

#include "Base/Run.h"
#include "Sphere/SphereDensity.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

#include <vector>

namespace conformal
{
/// Numbers for each pixel, all components of one after the other.
struct Picture
{
  PixelGrid Grid;
  int NumberOfComponents = 1;
  std::vector<double> Values; ///< Grid.size() * NumberOfComponents, finite
};

/// A density in proportion to the change of a picture with the direction, whatever its projection:
/// the root of the squares of all components' slopes added up, over steps of about a pixel. So the
/// share of points that the border between two colors gets does not depend on how sharp it is.
///
/// @param[in] picture  is kept as long as the density
/// @throws std::invalid_argument if it has no pixels, or not so many finite values
SphereDensity pictureDensity(Picture picture, const SphereImage& image);

/// Give half of the points to a picture's details. Values are divided by the largest magnitude, so
/// that they may be of any unit. A picture of one color has no details and changes nothing.
/// @param[in] density  of the other half
/// @throws std::invalid_argument as pictureDensity() does
SphereDensity withDetails(
  SphereDensity density, Picture picture, const SphereImage& image, const Run& run = {});
}

#endif
