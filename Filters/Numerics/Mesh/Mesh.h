/// Define triangle meshes.

#ifndef ConformalMesh_h
#define ConformalMesh_h

#include "Base/Types.h"

#include <Eigen/Geometry>

namespace conformal
{
/// Triangle mesh: vertex positions and triangles.
struct Mesh
{
  Points Positions;               ///< #V by 3
  conformal::Triangles Triangles; ///< #F by 3 ids, counter-clockwise seen from outside
};

/// Compute the area vector of a triangle: the unit normal times the area.
inline Vector3 areaVector(const Points& positions, const Triangles& triangles, Index triangle)
{
  const Vector3 a = positions.row(triangles(triangle, 0)),
                b = positions.row(triangles(triangle, 1)),
                c = positions.row(triangles(triangle, 2));
  return 0.5 * (b - a).cross(c - a);
}

/// Closed mesh and its map to the unit sphere.
struct MappedMesh : Mesh
{
  Points SpherePositions; ///< #V by 3 unit vectors
};
}

#endif
