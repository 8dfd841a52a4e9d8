/// Set up and solve the normal equations of the least-squares fit of a triangle mesh to samples.
/// The samples are called patterns, as in \cite Liou2008.

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
/// Least-squares equations for displacements d of the vertices w of a mesh. The displacements move
/// the mesh toward patterns x, and minimize the energy
///
///     sum p (b d - r)^T M (b d - r) + sum s_i |L (w + d)|_i^2 + bending of w + d.
///
/// The first sum is over all patterns:
/// - The foot point of a pattern x is its closest point on the mesh, in some triangle.
/// - p is the weight of the pattern.
/// - b are the barycentric weights of the foot point, so that b w is the foot point.
/// - r = x - b w is the vector from the foot point to the pattern.
/// - M is a 3 by 3 matrix, by which distances along the normal have full weight. If the foot point
///   is inside a triangle, distances along the surface have almost no weight. The reason is that
///   foot points move along the surface from iteration to iteration.
///
/// This is the squared distance of \cite Pottmann2006 without its curvature term. With this
/// distance, a few iterations suffice.
///
/// The second sum is over all vertices i. L is the uniform Laplacian, and s_i is the stiffness at
/// vertex i. The part of L along the surface is multiplied by the evenness. The bending energy at
/// the edges (HingeBending.h) has the same stiffness. This energy prevents wrinkles of thin
/// triangles.
class SurfaceEquations
{
public:
  /// @param[in] triangles  #F by 3; must outlive this object
  /// @param[in] neighbors  vertexNeighbors() of the triangles; must outlive this object
  SurfaceEquations(const conformal::Triangles& triangles, const Adjacency& neighbors);

  /// Remove all patterns.
  void clear();

  /// Add a pattern to the energy.
  /// @param[in] foot    foot point of the pattern on the mesh
  /// @param[in] x       position of the pattern
  /// @param[in] weight  weight p, in [0, 4]
  void add(const FootPoint& foot, const Vector3& x, double weight);

  /// Add a term to the energy that moves one vertex along a direction: weight (direction . d -
  /// distance)^2. Here d is the displacement of this vertex.
  void pull(int vertex, const Vector3& direction, double distance, double weight);

  /// Return vertexTriangles() of the triangles: the triangles around each vertex.
  const Adjacency& around() const { return this->Around; }

  /// Sum the terms of the patterns over all ranks. The terms added by pull() are not summed, so all
  /// ranks must add equal terms.
  void reduce(const Reduce& reduce) { this->Sums.reduce(reduce); }

  /// Minimize the energy approximately, by some iterations of conjugate gradients
  /// \cite Hestenes1952 that start at d = 0. Afterward, call clear() before further patterns are
  /// added.
  /// @pre clear() was called after the previous solve()
  /// @param[in] weights    vertices w, #V by 3
  /// @param[in] stiffness  stiffness s, #V
  /// @param[in] evenness   factor of the stiffness along the surface. With a value above 1,
  ///   triangles become more nearly equilateral.
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
