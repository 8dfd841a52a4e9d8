/// Normal equations of the least-squares fit of a triangle mesh to samples.

#ifndef ConformalSurfaceEquations_h
#define ConformalSurfaceEquations_h

#include "Base/FixedPointSums.h"
#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"
#include "Search/TriangleTree.h"

#include <vector>

namespace conformal
{
/// Least-squares equations for displacements d that move the vertices w of a mesh toward its
/// patterns x:
///
/// minimize  sum p (b d - r)^T M (b d - r) + sum s_i |L (w + d)|_i^2 + bending of w + d
///
/// Here b are the barycentric weights of the pattern's foot point, and r = x - b w. L is the
/// uniform Laplacian. s_i is the stiffness of a vertex, multiplied by the evenness along the
/// surface. The bending energy at the edges (HingeBending.h) has equal stiffness and prevents
/// wrinkles of thin triangles.
///
/// M measures distances. The component along the normal has full weight. The tangential components
/// have almost none if the foot point is inside a triangle, since foot points move from iteration
/// to iteration. This is the squared distance of \cite Pottmann2006 without its curvature; a few
/// iterations suffice with it.
class SurfaceEquations
{
public:
  /// @param[in] triangles  #F by 3, must outlive this
  /// @param[in] neighbors  vertexNeighbors() of the triangles, must outlive this
  SurfaceEquations(const conformal::Triangles& triangles, const Adjacency& neighbors);

  /// Remove all patterns.
  void clear();

  /// Attract the surface to a pattern.
  /// @param[in] weight  p, in [0, 4]
  void add(const FootPoint& foot, const Vector3& x, double weight);

  /// Attract one vertex along a direction: weight (direction . d - distance)^2.
  void pull(int vertex, const Vector3& direction, double distance, double weight);

  /// vertexTriangles() of the triangles
  const Adjacency& around() const { return this->Around; }

  /// Sum the patterns of all ranks, but not the terms of pull().
  void reduce(const Reduce& reduce) { this->Sums.reduce(reduce); }

  /// Run some iterations of conjugate gradients \cite Hestenes1952 from d = 0. The patterns are
  /// then invalid.
  /// @pre clear() since the last call
  /// @param[in] weights    w, #V by 3
  /// @param[in] stiffness  s, #V
  /// @param[in] evenness   a value above 1 favors even triangles over a smooth surface
  /// @return d, #V by 3
  /// @throws Aborted
  Points solve(
    const Points& weights, const Eigen::VectorXd& stiffness, double evenness, const Run& run);

private:
  struct Pull
  {
    int Vertex;
    Vector3 Direction;
    double Distance, Weight;
  };
  const conformal::Triangles& Triangles;
  const Adjacency& Neighbors;
  Adjacency Around;
  FixedPointSums Sums;
  std::vector<Pull> Pulls;
};
}

#endif
