/// Density of points that is higher at the details of a picture on the sphere. Own construction:
/// density in proportion to the slope of the picture, because blur at a border between colors then
/// does not matter.

#ifndef ConformalPictureDensity_h
#define ConformalPictureDensity_h

#include "Base/Run.h"
#include "Sphere/SphereDensity.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

#include <vector>

namespace conformal
{
/// Picture: a grid of pixels with one or more values (components) per pixel.
struct Picture
{
  PixelGrid Grid;
  int NumberOfComponents = 1;
  /// Grid.size() * NumberOfComponents values, finite; the components of a pixel are consecutive
  std::vector<double> Values;
};

/// Build a density proportional to the slope of a picture on the sphere, for any projection. The
/// slope of each component is estimated by differences over about a pixel. The density is the root
/// of the sum of the squared slopes of all components. The number of points at a border between two
/// colors does not depend on the sharpness of the border.
///
/// @param[in] picture  picture; stored in the density
/// @throws std::invalid_argument if the picture has no pixels, a wrong number of values, or values
///   that are not finite
SphereDensity pictureDensity(Picture picture, const SphereImage& image);

/// Combine a density with the details of a picture: half of the points follow the density, the
/// other half the details. The values of the picture may have any unit. A picture of one color has
/// no details; the density is then returned unchanged.
/// @param[in] density  density of the half that does not follow the picture
/// @throws std::invalid_argument for a reason given at pictureDensity()
SphereDensity withDetails(
  SphereDensity density, Picture picture, const SphereImage& image, const Run& run = {});
}

#endif
