/// Areas and cotangents of the triangles of a surface, with bounds, for sphere maps. Own
/// construction: bounds on both, because without them needles (very thin triangles) make sphere
/// maps fail.

#ifndef ConformalBoundedTriangles_h
#define ConformalBoundedTriangles_h

#include "Base/Types.h"
#include "Sphere/SphereStar.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Compute areas and cotangents of triangles from their squared edge lengths. The lengths are
/// slightly increased, so that triangles of zero area have an area and cotangents, too. Areas are
/// scaled so that the whole surface has the area of the unit sphere.
class BoundedTriangles
{
public:
  enum class Weight
  {
    Area,
    /// Area, reduced for needles, because their angles would otherwise distort their neighbors
    RegularArea
  };

  /// @param[in] points  #V by 3 positions, of size about 1; must outlive this object
  /// @param[in] weight  weight of a triangle in the energy
  BoundedTriangles(const Points& points, const Triangles& triangles, Weight weight = Weight::Area);

  SourceTriangle triangle(int a, int b, int c) const;

  /// Append the triangles around a vertex to `corners`.
  void cornersOf(int v, const Ring& ring, std::vector<Corner>& corners) const;

private:
  const Points& Places;
  Weight Kind;
  double Scale = 1.0;
};

/// Move vertices serially, in several sweeps, each to a position of lower energy by relaxVertex().
/// @param[in,out] positions  #V unit vectors, the sphere map
/// @param[in] counted        function called after each vertex, for progress; may be empty
void relaxVertices(std::vector<Vector3>& positions, const std::vector<int>& vertices,
  const VertexRings& rings, const BoundedTriangles& shapes, const SphereEnergy& energy, int sweeps,
  const std::function<void()>& counted = {});
}

#endif
