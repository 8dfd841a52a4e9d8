/// Compute the domes of a curved seamless surface, \cite Liou2008 section 3. The mesh on the sphere
/// is called the network. The mesh in space is called the model. A dome is the curved patch over a
/// flat triangle of the model. The height of the dome is proportional to the height of the unit
/// sphere over the corresponding flat triangle of the network.

#ifndef ConformalSphereDomes_h
#define ConformalSphereDomes_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "TriangleMap/FlatMap.h"

namespace conformal
{
/// Compute directions and heights of the domes, \cite Liou2008 Eqs. 6 to 8, 11 and 12.
///
/// Let p be a direction. The ray along p intersects a flat triangle of the network at p'. Let q' be
/// the image of p' on the flat triangle of the model. The centroid of the network's triangle also
/// has an image on the model's triangle. This image divides the model's triangle into three
/// subtriangles, one at each edge.
///
/// Implementation note: the equations are completed in the following cases.
///
/// - Eq. 11 interpolates between the normal of the triangle and the mean normal at an edge. The
///   weight is a quotient, which is 0/0 at a corner. There, the quotient is set to 1. This choice
///   does not change the surface, since the height of the dome at a corner is 0.
/// - In Eq. 11, a_q' is the point of an edge at which the perpendicular from q' ends. If the image
///   of the centroid projects beyond an end of the edge, the perpendicular can leave the
///   subtriangle before it reaches the edge. In this case, a_q' is the point where the
///   perpendicular leaves the subtriangle.
/// - Neighbors with exactly opposite normals have no mean normal (Eq. 8). The normal of each
///   triangle is then used at the common edge.
/// - A triangle of zero area has no normal. At its edges, the normals of the neighbors are used.
class SphereDomes
{
public:
  SphereDomes() = default;

  /// Store pointers to the first four arguments, which must outlive this object.
  /// @param[in] sphere  unit vectors of the vertices on the sphere, #N by 3
  /// @param[in] model  positions of the vertices in space, #N by 3
  /// @param[in] triangles  vertex ids of the triangles, #R by 3
  /// @param[in] neighbors  result of triangleNeighbors() for the triangles
  /// @param[in] map  map p' -> q' from the flat triangles of the network to those of the model
  /// @param[in] insideOut  whether the triangles of the model are clockwise if seen from outside
  SphereDomes(const Points& sphere, const Points& model, const conformal::Triangles& triangles,
    const conformal::Triangles& neighbors, const FlatMap& map, bool insideOut, const Run& run = {});

  /// Return the height |p - p'| of the unit sphere over a point p' of a triangle of the network.
  /// @param[in] barycentric  barycentric coordinates of p' in the triangle
  double height(Index triangle, const Vector3& barycentric) const;

  /// Return the direction in which the dome is raised over a point q' of the model, n_q' in Eq. 11.
  /// @param[in] barycentric  barycentric coordinates of q' in the triangle
  Vector3 direction(Index triangle, const Vector3& barycentric) const;

  /// Return the unit normal of a flat triangle of the model, Eq. 7. Return zero for zero area.
  Vector3 normal(Index triangle) const { return this->Normals.row(triangle); }

  /// Return whether the triangle and all of its edges have normals.
  bool defined(Index triangle) const;

private:
  bool edgeDirection(Index triangle, int opposite, Vector3& direction) const;

  const Points* Sphere = nullptr;
  const Points* Model = nullptr;
  const conformal::Triangles* Triangles = nullptr;
  const conformal::Triangles* Neighbors = nullptr;
  Points Centers; // barycentric coordinates of the images of the centroids, c_w, #R by 3
  Points Normals; // normals of the flat triangles, #R by 3
};
}

#endif
