/// Average the values of a scan over the part of a surface that each pixel of an image shows. Own
/// construction: weighted means of the scan's points near a pixel, or supersampling if the scan has
/// triangles.

#ifndef ConformalAveragedTexture_h
#define ConformalAveragedTexture_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphereProjection.h"

#include <functional>
#include <utility>
#include <vector>

namespace conformal
{
/// Points of a scan and their weights, which have the sum 1. Empty for a pixel without a value.
using PointMixture = std::vector<std::pair<int, double>>;

/// Function that receives the mixtures of consecutive pixels. Several threads may call the function
/// concurrently, with different pixels.
using MixtureSink =
  std::function<void(Index firstPixel, const std::vector<PointMixture>& mixtures)>;

/// Compute weights of a scan's points for every pixel of an image of the sphere.
///
/// If the scan has no triangles, a pixel is a mean of the points within a radius around the point
/// of the surface that the pixel shows. The radius is half the size of the pixel on the surface, or
/// larger where the scan has few points. The weights decrease smoothly to 0 at the radius. If there
/// are more than about 64 points within the radius, only the nearest ones are used. Gaps of the
/// scan are thus filled smoothly. If the scan has triangles, several points of the surface in the
/// pixel are replaced by the closest points of the triangles, and a pixel is the mean of them.
///
/// @param[in] cloud  #P by 3 coordinates, finite; at least one point
/// @param[in] cloudTriangles  #G by 3 ids in [0, #P); empty for a cloud without triangles
/// @throws std::invalid_argument if there are no pixels, if the surface has no triangles, or if the
///   cloud is empty or not finite
/// @post the result does not depend on the number of threads
void averageSphericalTexture(const MappedMesh& surface, const PointView& cloud,
  const Triangles& cloudTriangles, const SphereImage& image, const PixelGrid& grid,
  const MixtureSink& sink, const Run& run = {});

/// Compute the size of an image that shows a scan in full detail: in 95 % of the scan's points, the
/// image has at least the given number of pixels for each point.
/// @param[in] surface  surface with a sphere map
/// @param[in] cloud  #P by 3 coordinates of the scan's points
/// @param[in] pixelsPerPoint  number of pixels for each point of the scan, above 0
/// @return height of the image; a multiple of 64 in [64, 4096]. The width is the height times
///   widthPerHeight().
/// @throws std::invalid_argument if the surface has no triangles, or if the cloud is empty or not
///   finite
Index imageHeightFor(const MappedMesh& surface, const PointView& cloud, const SphereImage& image,
  double pixelsPerPoint, const Run& run = {});

/// Ratio of width to height of an undistorted image.
double widthPerHeight(const SphereImage& image);
}

#endif
