/// Set up and solve the normal equations of the least-squares fit of a triangle mesh to samples. As
/// in \cite Liou2008, the samples are called patterns, and the positions of the vertices are called
/// weights.

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
/// Least-squares equations for displacements d of the vertices of a mesh. Let w be the positions of
/// the vertices before the displacement. The displacements move the mesh toward patterns x, and
/// minimize the energy
///
///     sum p (b d - r)^T M (b d - r) + sum s_i |L (w + d)|_i^2 + bending of w + d.
///
/// The first sum is over all patterns:
/// - The foot point of a pattern x is its closest point on the mesh, in some triangle.
/// - p is the weight of the pattern.
/// - b are the barycentric weights of the foot point, so that b w is the foot point.
/// - r = x - b w is the vector from the foot point to the pattern.
/// - M is a 3 by 3 matrix of weights. Distances along the normal have weight 1. If the foot point
///   is inside a triangle, distances along the surface have weight 0.02. With this small weight,
///   foot points can slide along the surface from iteration to iteration. If the foot point is on
///   an edge or at a vertex, all distances have weight 1.
///
/// The term (b d - r)^T M (b d - r) is the squared distance of \cite Pottmann2006 without its
/// curvature term. With this distance, a few iterations of the fit suffice.
///
/// The second sum is over all vertices i. L is the uniform Laplacian: the position of vertex i
/// minus the mean position of its neighbors. The stiffness s_i is the weight of this term at vertex
/// i. A larger stiffness makes the surface smoother. The part of the Laplacian along the surface is
/// weighted by `evenness`, a parameter of solve().
///
/// The bending energy (HingeBending.h) is a sum over all edges. Each edge contributes an energy
/// that increases with the angle between the normals of its two triangles. The weight of an edge is
/// the mean stiffness of its two vertices. The bending energy prevents wrinkles of thin triangles.
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

  /// Sum the terms of the patterns over all ranks (processes). The terms added by pull() are not
  /// summed, so all ranks must add equal terms.
  void reduce(const Reduce& reduce) { this->Sums.reduce(reduce); }

  /// Minimize the energy approximately, by up to 25 iterations of conjugate gradients
  /// \cite Hestenes1952 that start at d = 0. To add patterns after solve(), first call clear().
  /// @pre clear() was called after the previous solve()
  /// @param[in] weights    positions w of the vertices before the displacement, #V by 3
  /// @param[in] stiffness  stiffness s, #V
  /// @param[in] evenness   factor of the stiffness in directions along the surface. With a value
  ///   above 1, triangles become more nearly equilateral.
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
