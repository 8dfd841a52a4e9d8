/// Define triangle meshes.

#ifndef ConformalMesh_h
#define ConformalMesh_h

#include "Base/Types.h"

#include <Eigen/Geometry>

#include <cmath>

namespace conformal
{
/// Triangle mesh: vertex positions and triangles.
struct Mesh
{
  Points Positions;               ///< #V by 3
  conformal::Triangles Triangles; ///< #F by 3 ids, counter-clockwise seen from outside
};

/// Compute twice the area vector of a triangle: the unit normal times twice the area.
inline Vector3 twiceAreaVector(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return (b - a).cross(c - a);
}

/// Compute the quality of a triangle: 1 if equilateral, 0 without area.
inline double triangleQuality(const Vector3& a, const Vector3& b, const Vector3& c)
{
  const double squares = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
  return squares > 0.0 ? 2.0 * std::sqrt(3.0) * twiceAreaVector(a, b, c).norm() / squares : 0.0;
}

/// Compute the cosine of the angle between two vectors; 0 if one of them is zero.
inline double cosineBetween(const Vector3& a, const Vector3& b)
{
  const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm());
  return lengths > 0.0 ? a.dot(b) / lengths : 0.0;
}

/// Compute the angle between two vectors, accurate for all angles.
inline double angleBetween(const Vector3& a, const Vector3& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Compute the area vector of a triangle: the unit normal times the area.
inline Vector3 areaVector(const Points& positions, const Triangles& triangles, Index triangle)
{
  const Vector3 a = positions.row(triangles(triangle, 0)),
                b = positions.row(triangles(triangle, 1)),
                c = positions.row(triangles(triangle, 2));
  return 0.5 * (b - a).cross(c - a);
}

/// Return which corner of a triangle a vertex is: 0, 1 or 2, or -1 if it is none.
inline int cornerOf(const Triangles& triangles, Index triangle, int vertex)
{
  const auto ids = triangles.row(triangle);
  return ids[0] == vertex ? 0 : ids[1] == vertex ? 1 : ids[2] == vertex ? 2 : -1;
}

/// Closed mesh and its map to the unit sphere.
struct MappedMesh : Mesh
{
  Points SpherePositions; ///< #V by 3 unit vectors
};
}

#endif
