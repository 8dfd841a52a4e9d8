/// Find the intersections of rays with a triangle mesh that are farthest from the origins of the
/// rays, by a tree of bounding boxes, \cite Ericson2005.

#ifndef ConformalOutermostHits_h
#define ConformalOutermostHits_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

namespace conformal
{
/// Intersection of a ray with a triangle.
struct RayHit
{
  int Triangle = -1; ///< -1 if the ray does not intersect the mesh
  Vector3 Barycentric = Vector3::Zero();
  double Distance = 0.0; ///< from the origin of the ray, in units of the direction's length
};

/// Search tree of rays. Queries do not modify the tree, so several threads may query concurrently.
class OutermostHits
{
public:
  /// @param[in] points  #V by 3 positions, kept by reference
  /// @param[in] triangles  #F by 3 ids, kept by reference
  /// @throws Aborted
  OutermostHits(const Points& points, const Triangles& triangles, const Run& run = {});

  /// Return the intersection that is farthest along the ray. Rays through an edge, by rounding
  /// between two triangles, are assigned to one of the triangles.
  /// @param[in] direction  unit vector
  RayHit along(const Vector3& origin, const Vector3& direction) const;

private:
  const Points& Positions;
  const conformal::Triangles& Triangles;
  BoxTree Tree;
};
}

#endif
