/// Compute images of plane maps of a body, in the projections of \cite Snyder1987. The body has a
/// map to the sphere. The method is an own construction, not from a publication. Each pixel is
/// converted to a direction, and the point of the body that is mapped to this direction is
/// searched. This method works for every projection.

#ifndef ConformalMapImage_h
#define ConformalMapImage_h

#include "Base/Run.h"
#include "Body/MapProjection.h"
#include "Mesh/Mesh.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphericalTextureImage.h"

#include <vector>

namespace conformal
{
/// Image of a plane map: its projection and its pixels.
struct MapImage
{
  MapProjection Projection = MapProjection::Equirectangular;
  double CentralLongitude = 0.0; ///< longitude of the central meridian of the map [degrees]
  PixelGrid Grid;
  double CapsuleAspect = 1.0; ///< see halfSizeOfMap(); used by MapProjection::Capsule

  /// Return half the width and half the height of the image, in the unit of the map. The map fills
  /// the image. The pixels of a capsule are squares: its map is in the middle of the image, and
  /// fills its width or its height.
  Vector2 halfSize() const;

  /// Return the position of the center of a pixel on the map.
  Vector2 placeOf(Index pixel) const
  {
    return this->halfSize().cwiseProduct(2.0 * this->Grid.middleOf(pixel) - Vector2::Ones());
  }

  /// Compute the position of a direction in pixels. The lower left corner of the image is (0, 0).
  Vector2 toPixels(const Vector3& n) const;

  /// Compute the direction at a position in pixels. This is the inverse of toPixels().
  /// @return false if the position is outside of the map
  bool fromPixels(const Vector2& pixels, Vector3& n) const;

  /// Compute the direction on the sphere that a pixel shows.
  /// @return false if the pixel is outside of the map
  bool directionOf(Index pixel, Vector3& n) const
  {
    return mapToSphere(
      this->placeOf(pixel), this->Projection, this->CentralLongitude, n, this->CapsuleAspect);
  }

  /// Estimate the number of pixels that a small angle at a direction of the sphere corresponds to.
  double pixelsOfAngle(const Vector3& n, double angle) const;
};

/// Find the point of the body that each pixel shows, and pass the points to `sink`, a function of
/// the caller.
/// @param[in] body  body with a sphere map whose north pole is (0, 0, 1)
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintMap(
  const MappedMesh& body, const MapImage& image, const PixelSink& sink, const Run& run = {});

/// Move a body so that the middle of the bounding box of its triangles is the origin. Second
/// moments, and differences of interpolated positions, then have digits also if the body is far
/// from the origin.
/// @param[out] middle  position of the middle before the move
MappedMesh movedToOrigin(const MappedMesh& body, Vector3& middle);

/// Marks of the pixels outside of the map, and of the pixels on its graticule (meridians and
/// parallels).
struct MapMarks
{
  /// For each pixel, 1 if the pixel is outside of the map, else 0.
  std::vector<unsigned char> OutsideMap;
  /// For each pixel, 1 if the pixel is on a meridian or parallel, else 0. Empty if no lines were
  /// requested.
  std::vector<unsigned char> Graticule;
};

/// Mark the pixels outside of the map, and the pixels on its graticule. A pixel is on the graticule
/// if a meridian or parallel separates the center of this pixel from the center of its right or
/// upper neighbor. Near the poles, only meridians at multiples of 90 degrees are marked.
/// @param[in] spacing  angle between neighboring lines, at least 1 [degrees]; 0 for no lines
MapMarks markMap(const MapImage& image, double spacing, const Run& run = {});
}

#endif
