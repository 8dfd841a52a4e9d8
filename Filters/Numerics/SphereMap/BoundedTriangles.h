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
/// A triangle by its squared sides, slightly rounded, so that needles and points, too, have a shape
/// to be mapped. Areas are scaled to those of the unit sphere.
class BoundedTriangles
{
public:
  enum class Weight
  {
    Area,
    RegularArea ///< less for needles, whose angles would be kept at the cost of their neighbors'
  };

  /// @param[in] points  kept by reference, about of size one
  /// @param[in] weight  area that a triangle has in the energy
  BoundedTriangles(const Points& points, const Triangles& triangles, Weight weight = Weight::Area);

  SourceTriangle triangle(int a, int b, int c) const;

  /// Append the triangles around a vertex.
  void cornersOf(int v, const Ring& ring, std::vector<Corner>& corners) const;

private:
  const Points& Places;
  Weight Kind;
  double Scale = 1.0;
};

/// Move vertices one after the other, several times, each to where its energy is lower
/// (relaxVertex).
/// @param[in,out] positions  #V unit vectors
/// @param[in] counted        called after each vertex
void relaxVertices(std::vector<Vector3>& positions, const std::vector<int>& vertices,
  const VertexRings& rings, const BoundedTriangles& shapes, const SphereEnergy& energy, int sweeps,
  const std::function<void()>& counted = {});
}

#endif
