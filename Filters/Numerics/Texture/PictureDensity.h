/// Density of points that follows the details of a picture on the sphere. Own construction: the
/// slope of the picture, so that blur at a border between colors does not matter.

#ifndef ConformalPictureDensity_h
#define ConformalPictureDensity_h

#include "Base/Run.h"
#include "Sphere/SphereDensity.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

#include <vector>

namespace conformal
{
/// Values of each pixel, all components of one pixel after those of the previous one.
struct Picture
{
  PixelGrid Grid;
  int NumberOfComponents = 1;
  std::vector<double> Values; ///< Grid.size() * NumberOfComponents, finite
};

/// Build a density proportional to the slope of a picture on the sphere, for any projection. It is
/// the root of the sum of squares of the slopes of all components, by differences over about a
/// pixel. The share of points at a border between two colors does not depend on its sharpness.
///
/// @param[in] picture  kept as long as the density
/// @throws std::invalid_argument if it has no pixels, or not the right number of finite values
SphereDensity pictureDensity(Picture picture, const SphereImage& image);

/// Give half of the points to a picture's details. Values are divided by the largest magnitude, so
/// that they may be of any unit. A picture of one color has no details and changes nothing.
/// @param[in] density  of the other half
/// @throws std::invalid_argument as pictureDensity() does
SphereDensity withDetails(
  SphereDensity density, Picture picture, const SphereImage& image, const Run& run = {});
}

#endif
