/// Compute areas of triangles and cotangents of their angles for maps of surfaces to the sphere.
/// All values are bounded. The bounds are our own construction. Without bounds, needles (very thin
/// triangles) make maps to the sphere fail.

#ifndef ConformalBoundedTriangles_h
#define ConformalBoundedTriangles_h

#include "Base/Types.h"
#include "Sphere/SphereStar.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Compute areas and cotangents of triangles from their squared edge lengths. The lengths are first
/// increased slightly. Even degenerate triangles then have a positive area and finite cotangents.
/// Areas are scaled so that the whole surface has the area of the unit sphere.
class BoundedTriangles
{
public:
  enum class Weight
  {
    Area,
    /// Area, reduced for needles. With the full area as weight, the angles of a needle would
    /// distort its neighbors.
    RegularArea
  };

  /// @param[in] points  #V by 3 positions with coordinates of magnitude about 1; must outlive this
  ///   object
  /// @param[in] weight  quantity used as SourceTriangle::Area. This member is the weight of a
  ///   triangle in SphereEnergy, the energy of a sphere map.
  BoundedTriangles(const Points& points, const Triangles& triangles, Weight weight = Weight::Area);

  SourceTriangle triangle(int a, int b, int c) const;

  /// Append the triangles around a vertex v to `corners`, in the sequence of `ring`, the neighbors
  /// of v.
  void cornersOf(int v, const Ring& ring, std::vector<Corner>& corners) const;

private:
  const Points& Places;
  Weight Kind;
  double Scale = 1.0;
};

/// Move vertices one after another to positions of lower energy, by relaxVertex(). All given
/// vertices are moved once per sweep.
/// @param[in,out] positions  #V unit vectors, the sphere map
/// @param[in] counted        function called after each move, to report progress; may be empty
void relaxVertices(std::vector<Vector3>& positions, const std::vector<int>& vertices,
  const VertexRings& rings, const BoundedTriangles& shapes, const SphereEnergy& energy, int sweeps,
  const std::function<void()>& counted = {});
}

#endif
