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
/// Where the vertices w of a mesh should move, d, to meet its patterns x:
///
///     minimize  sum p (b d - r)^T M (b d - r) + sum s_i |L (w + d)|_i^2 + bending of w + d
///
/// with b the barycentric weights of the pattern's foot point, r = x - b w, L the uniform Laplacian
/// and s_i a vertex's stiffness, times the evenness along the surface; the bending at the edges
/// (HingeBending.h) is as stiff and keeps thin triangles from wrinkling. M measures distances:
/// along the normal they count in full; along the surface hardly at all where the foot lies inside
/// a triangle, for there it may as well lie beside: the feet of a round need not be those of the
/// next. This is the squared distance of \cite Pottmann2006 without its curvature, and what makes a
/// few rounds enough.
class SurfaceEquations
{
public:
  /// @param[in] triangles      #F by 3, must outlive this
  /// @param[in] neighbors  vertexNeighbors of the triangles, likewise
  SurfaceEquations(const conformal::Triangles& triangles, const Adjacency& neighbors);

  /// Begin anew, without patterns.
  void clear();

  /// Draw the surface to a pattern.
  /// @param[in] weight  p, in [0, 4]
  void add(const FootPoint& foot, const Vector3& x, double weight);

  /// Draw one vertex along a direction: weight (direction . d - distance)^2.
  void pull(int vertex, const Vector3& direction, double distance, double weight);

  /// vertexTriangles of its triangles
  const Adjacency& around() const { return this->Around; }

  /// Add what the other processes have added; not their single equations.
  void reduce(const Reduce& reduce) { this->Sums.reduce(reduce); }

  /// Some steps of conjugate gradients from d = 0. The patterns are then forgotten.
  /// @pre clear() since the last time
  /// @param[in] weights    w, #V by 3
  /// @param[in] stiffness  s, #V
  /// @param[in] evenness   above 1 it makes triangles more even than the surface is smooth
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
