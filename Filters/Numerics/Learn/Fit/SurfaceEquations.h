/// Set up and solve the normal equations of the least-squares fit of a triangle mesh to samples.

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
/// Here p is the weight of a pattern, b are the barycentric weights of its foot point, and r = x -
/// b w. L is the uniform Laplacian. s_i is the stiffness at vertex i; its tangential part is
/// multiplied by the evenness. The bending energy at the edges (HingeBending.h) has the same
/// stiffness. It prevents wrinkles of thin triangles.
///
/// M measures distances. The distance component along the normal has full weight. If the foot point
/// is inside a triangle, the tangential components have almost no weight, since foot points move
/// from iteration to iteration. This is the squared distance of \cite Pottmann2006 without the
/// curvature term. With this distance, a few iterations suffice.
class SurfaceEquations
{
public:
  /// @param[in] triangles  #F by 3; must outlive this object
  /// @param[in] neighbors  vertexNeighbors() of the triangles; must outlive this object
  SurfaceEquations(const conformal::Triangles& triangles, const Adjacency& neighbors);

  /// Remove all patterns.
  void clear();

  /// Add a pattern, which attracts the surface.
  /// @param[in] weight  weight p, in [0, 4]
  void add(const FootPoint& foot, const Vector3& x, double weight);

  /// Add a term that moves one vertex along a direction: weight (direction . d - distance)^2.
  void pull(int vertex, const Vector3& direction, double distance, double weight);

  /// Return vertexTriangles() of the triangles.
  const Adjacency& around() const { return this->Around; }

  /// Sum the terms of the patterns over all ranks. Terms of pull() are not summed.
  void reduce(const Reduce& reduce) { this->Sums.reduce(reduce); }

  /// Run some iterations of conjugate gradients \cite Hestenes1952, starting at d = 0. The call
  /// uses up the patterns: call clear() before the next patterns are added.
  /// @pre clear() was called after the previous solve()
  /// @param[in] weights    vertices w, #V by 3
  /// @param[in] stiffness  stiffness s, #V
  /// @param[in] evenness   factor of the tangential stiffness; a value above 1 favors even
  ///   triangles over a smooth surface
  /// @return displacements d, #V by 3
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
