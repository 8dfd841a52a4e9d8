/// Divide the triangles of a body into parts whose images in a map are triangles, and measure the
/// area of the body inside of polygons of the map. Own construction: with the division, areas
/// inside of a polygon are those of a plane map.

#ifndef ConformalMapParts_h
#define ConformalMapParts_h

#include "Base/Run.h"
#include "Body/MapImage.h"
#include "Mesh/Mesh.h"
#include "Search/BoxTree.h"

#include <array>
#include <vector>

namespace conformal
{
/// Length in pixels that is a thousandth of the side of a square with the area of the image.
double pictureUnit(const MapImage& image);

/// Move a position that is left or right of an image into it, if the image shows all longitudes
/// there. Return other positions unchanged.
/// @param[in] pixels  right and up, from the lower left corner of the image
Vector2 inImage(const MapImage& image, const Vector2& pixels);

/// Parts of a body's triangles, in the image of a map.
class MapParts
{
public:
  MapParts() = default;

  /// Divide the triangles. A part is small enough if the middles of its sides are within a
  /// twentieth of pictureUnit() of the middles in the image. Parts at seams are divided until they
  /// are smaller than a sixteenth of this unit, and count where their middles are. If the map
  /// covers the sphere n times, as that of a soup of triangles, the unit is n times as large. The
  /// number of parts is then no larger than for a map that covers the sphere once.
  MapParts(const MappedMesh& body, const MapImage& image, const Run& run = {});

  /// Compute the area of the body inside of a polygon. A part around which the polygon winds twice
  /// counts twice.
  /// @param[in] polygon  corners in pixels, of any orientation
  /// @return area, at least 0
  double areaInside(const std::vector<Vector2>& polygon) const;

private:
  struct Part
  {
    std::array<Vector2, 3> Corners; // equal if the part has no image
    double Area;
  };
  struct Division;

  // Area inside of a polygon in a node of the tree, of which only some sides can touch the node.
  double areaOfNode(
    int node, const std::vector<Vector2>& polygon, const std::vector<int>& sides) const;

  std::vector<Part> Parts;
  BoxTree Tree;
  std::vector<double> AreasBefore; // sum of the areas before each of Tree.Items, and of all
  std::vector<int> FirstOf, EndOf; // items of each node
  double Period = 0.0;             // width of the image if lines continue across its sides, else 0
};
}

#endif
