/// Bounded areas and cotangents of the triangles of a surface, for sphere maps.
/// Own construction: bounds let needles take part in sphere maps.

#ifndef ConformalBoundedTriangles_h
#define ConformalBoundedTriangles_h

#include "Base/Types.h"
#include "Sphere/SphereStar.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Shapes of triangles by their squared edge lengths. The lengths are slightly regularized, so that
/// needles and triangles of zero size have a shape, too. Areas are scaled to those of the unit
/// sphere.
class BoundedTriangles
{
public:
  enum class Weight
  {
    Area,
    RegularArea ///< smaller for needles, whose angles would otherwise distort their neighbors
  };

  /// @param[in] points  stored by reference, about of size one
  /// @param[in] weight  area of a triangle in the energy
  BoundedTriangles(const Points& points, const Triangles& triangles, Weight weight = Weight::Area);

  SourceTriangle triangle(int a, int b, int c) const;

  /// Append the triangles around a vertex.
  void cornersOf(int v, const Ring& ring, std::vector<Corner>& corners) const;

private:
  const Points& Places;
  Weight Kind;
  double Scale = 1.0;
};

/// Move vertices serially, in several sweeps, each to a position of lower energy (relaxVertex).
/// @param[in,out] positions  #V unit vectors
/// @param[in] counted        called after each vertex
void relaxVertices(std::vector<Vector3>& positions, const std::vector<int>& vertices,
  const VertexRings& rings, const BoundedTriangles& shapes, const SphereEnergy& energy, int sweeps,
  const std::function<void()>& counted = {});
}

#endif
