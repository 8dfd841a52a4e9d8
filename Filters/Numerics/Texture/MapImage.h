/// Images of plane maps of a body.

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
/// An image that a map fills.
struct MapImage
{
  MapProjection Projection = MapProjection::Equirectangular;
  double CentralLongitude = 0.0; ///< degrees
  PixelGrid Grid;

  /// The place on the map of a pixel's middle.
  Vector2 placeOf(Index pixel) const
  {
    return halfSizeOfMap(this->Projection)
      .cwiseProduct(2.0 * this->Grid.middleOf(pixel) - Vector2::Ones());
  }

  /// Which direction a pixel shows; false beyond the outline.
  bool directionOf(Index pixel, Vector3& n) const
  {
    return mapToSphere(this->placeOf(pixel), this->Projection, this->CentralLongitude, n);
  }
};

/// Find the point of the body for every pixel.
/// @param[in] body  with a map whose north pole is (0, 0, 1)
/// @throws std::invalid_argument if there are no pixels or no triangles
void paintMap(
  const MappedMesh& body, const MapImage& image, const PixelSink& sink, const Run& run = {});

/// What of an image is no map, and where its lines are.
struct MapMarks
{
  std::vector<unsigned char> OutsideMap; ///< of each pixel: 1 beyond the outline
  std::vector<unsigned char> Graticule;  ///< of each pixel: 1 on a line; empty without lines
};

/// Lines run between pixels of which one is beyond a meridian or a parallel and the other is not.
/// @param[in] spacing  of lines in degrees, at least 1; 0 for none
MapMarks markMap(const MapImage& image, double spacing, const Run& run = {});
}

#endif
