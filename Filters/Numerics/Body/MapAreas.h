/// Choose a map on which the areas of a long body are nearly true, and measure the areas that
/// pixels show. Own construction: areas are those of the body's triangles, by the Jacobian
/// determinant of the map at each pixel.

#ifndef ConformalMapAreas_h
#define ConformalMapAreas_h

#include "Base/Run.h"
#include "Body/MapImage.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePlace.h"

#include <vector>

namespace conformal
{
/// Find the aspect of the capsule on which areas are closest to those of the body. Let d be the
/// logarithm of the ratio of a triangle's area on the body to its area on the capsule. The result
/// has the smallest variance of d over the area of the body.
/// @param[in] body  body with a sphere map, whose poles are the ends of the body
/// @return ratio of length to diameter, in [1, MaximumCapsuleAspect], a multiple of 0.01
/// @throws std::invalid_argument if there are no triangles
double findCapsuleAspect(const MappedMesh& body, const Run& run = {});

/// Return the aspect of the capsule that a map needs: 1 for other projections than Capsule, the
/// given aspect if it is at least 1, and otherwise the result of findCapsuleAspect().
double capsuleAspectOf(
  const MappedMesh& body, MapProjection projection, double aspect, const Run& run = {});

/// Compute the area of the body that a pixel shows, from the derivatives at the middle of the
/// pixel.
/// @param[in] place  point that the pixel shows, of paintMap()
/// @return area; 0 if the pixel shows no point
double areaOfPixel(
  const MappedMesh& body, const MapImage& image, Index pixel, const SurfacePlace& place);

/// Areas that pixels show, over their mean.
struct PixelAreas
{
  std::vector<double> Scales; ///< for each pixel; 0 outside of the map, 1 if the area is the mean
  double Low = 1.0;           ///< scale below which the pixels show 5 percent of the body's area
  double High = 1.0;          ///< scale above which the pixels show 5 percent of the body's area
};

/// Divide the areas of pixels by their mean over the pixels with an area.
PixelAreas comparePixelAreas(std::vector<double> areas);
}

#endif
