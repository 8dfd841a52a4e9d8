/// Compute a density of points on the sphere that is higher at the details of a picture. The method
/// is an own construction, not from a publication. The density is proportional to the slope of the
/// picture: the change of its values per distance. This proportionality is chosen because the
/// number of points at a border between colors is then the same for sharp and blurred borders.

#ifndef ConformalPictureDensity_h
#define ConformalPictureDensity_h

#include "Base/Run.h"
#include "Sphere/SphereDensity.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

#include <vector>

namespace conformal
{
/// Grid of pixels with one or more values (components) for each pixel.
struct Picture
{
  PixelGrid Grid;
  int NumberOfComponents = 1;
  /// Finite values, Grid.size() * NumberOfComponents. The components of a pixel are consecutive.
  std::vector<double> Values;
};

/// Build a density proportional to the slope of a picture on the sphere, for any projection. The
/// slope of each component is estimated from differences of values at positions about a pixel
/// apart. The density is the square root of the sum of the squared slopes of all components. If
/// points are distributed by the density, the number of points at a border between two colors is
/// the same for sharp and blurred borders.
///
/// @param[in] picture  grid of pixels; stored in the density
/// @param[in] image  position and projection of the picture on the sphere
/// @throws std::invalid_argument if the picture has no pixels
/// @throws std::invalid_argument if the picture has a wrong number of values, or values that are
///   not finite
SphereDensity pictureDensity(Picture picture, const SphereImage& image);

/// Combine a density with the details of a picture. Let points be distributed by the result. One
/// half of the points then follows `density`, and the other half is at the details of the picture.
/// Multiplying all values of the picture by a constant does not change the result. A picture with
/// only one color has no details. For such a picture, the density is returned unchanged.
/// @param[in] density  density for the half of the points that does not depend on the picture
/// @param[in] picture  grid of pixels
/// @param[in] image  position and projection of the picture on the sphere
/// @throws std::invalid_argument if the picture has no pixels, a wrong number of values, or values
///   that are not finite
SphereDensity withDetails(
  SphereDensity density, Picture picture, const SphereImage& image, const Run& run = {});
}

#endif
