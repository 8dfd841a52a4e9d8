/// Images of plane maps of a body. Own construction: one located direction for each pixel, for the
/// projections of \cite Snyder1987.

#ifndef ConformalMapImage_h
#define ConformalMapImage_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Texture/MapProjection.h"
#include "Texture/PixelGrid.h"
#include "Texture/SphericalTextureImage.h"

#include <vector>

namespace conformal
{
/// Image of a plane map.
struct MapImage
{
  MapProjection Projection = MapProjection::Equirectangular;
  double CentralLongitude = 0.0; ///< degrees
  PixelGrid Grid;

  /// Return the position on the map of the center of a pixel.
  Vector2 placeOf(Index pixel) const
  {
    return halfSizeOfMap(this->Projection)
      .cwiseProduct(2.0 * this->Grid.middleOf(pixel) - Vector2::Ones());
  }

  /// Compute the direction shown by a pixel.
  /// @return false outside of the outline of the map
  bool directionOf(Index pixel, Vector3& n) const
  {
    return mapToSphere(this->placeOf(pixel), this->Projection, this->CentralLongitude, n);
  }
};

/// Find the point of the body for every pixel.
/// @param[in] body  mapped to the sphere with north pole (0, 0, 1)
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintMap(
  const MappedMesh& body, const MapImage& image, const PixelSink& sink, const Run& run = {});

/// Masks of the pixels outside of the map and on its graticule.
struct MapMarks
{
  std::vector<unsigned char> OutsideMap; ///< of each pixel: 1 outside of the outline
  std::vector<unsigned char> Graticule;  ///< of each pixel: 1 on a line; empty without lines
};

/// Mark pixels outside of the map and on its graticule. A line separates pixels on different sides
/// of a meridian or a parallel.
/// @param[in] spacing  of lines in degrees, at least 1; 0 for none
MapMarks markMap(const MapImage& image, double spacing, const Run& run = {});
}

#endif
