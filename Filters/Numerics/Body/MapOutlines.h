/// Measure outlines that are drawn in a map, such as the border of a cell or a path, on the surface
/// of the body. Own construction: the drawn lines are traced over the triangles of the body.

#ifndef ConformalMapOutlines_h
#define ConformalMapOutlines_h

#include "Base/Run.h"
#include "Body/MapImage.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
/// Line or polygon that is drawn in the image of a map.
struct MapOutline
{
  /// Corners in pixels, right and up. The lower left corner of the image is (0, 0).
  std::vector<Vector2> Corners;
  bool IsClosed = false; ///< whether the last corner is joined to the first
};

/// Outline on the surface, and its measures.
struct SurfaceOutline
{
  /// False if the outline has fewer than two different corners, or leaves the map, or crosses a
  /// hole of the sphere map. There are no points then, and lengths and areas on the surface are 0.
  bool IsOnMap = false;
  double Length = 0.0;        ///< length on the surface
  double Area = 0.0;          ///< area of the surface inside of the outline; 0 for a line
  double PictureLength = 0.0; ///< length in the image [pixels]
  double PictureArea = 0.0;   ///< area in the image [pixels]
  /// Points on the surface, #L by 3. The first point of a closed outline is repeated at the end.
  Points Positions;
  std::vector<int> Corners; ///< for each point, id of the corner of the outline; -1 between corners
  /// For each point, the angle between both sides of a corner on the surface [degrees]; 0 between
  /// corners and at the ends of a line.
  std::vector<double> Angles;
};

/// Measure outlines of a map on the surface.
///
/// Each side of an outline is a straight line in the image. It is divided at the edges of the
/// body's triangles, and until each piece is straight on the surface to about one part in a
/// million. The sum of their lengths is the length of the outline.
///
/// Area: the part of the surface that the image shows inside of the outline, for any orientation of
/// the outline. The triangles of the body are divided until their images are triangles, up to a few
/// hundredths of a thousandth of the image. These are cut by the outline. Parts around which the
/// outline winds twice count twice.
///
/// Angles are those between the tangents of both sides on the surface. Of closed outlines, they are
/// inside, in [0, 360]; of lines, they are in [0, 180].
///
/// If the image shows all longitudes (Equirectangular, Mercator, and the cylinder of Capsule),
/// lines that leave it on the right continue on the left, and vice versa. Other lines must stay on
/// the map.
/// @param[in] body  body with a sphere map whose north pole is (0, 0, 1)
/// @return one result for each outline
/// @throws std::invalid_argument if there are no pixels or no triangles, or if a corner or a
///   point of a triangle is not finite
std::vector<SurfaceOutline> measureMapOutlines(const MappedMesh& body, const MapImage& image,
  const std::vector<MapOutline>& outlines, const Run& run = {});
}

#endif
