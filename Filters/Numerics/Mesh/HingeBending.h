/// Bending energy of a triangle mesh at its edges, as a quadratic form.

#ifndef ConformalHingeBending_h
#define ConformalHingeBending_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <array>
#include <vector>

namespace conformal
{
/// Bending energy of hinges, the two triangles of an edge e, \cite Wardetzky2007.
///
/// Four numbers k, from the cotangents of the angles at e, define k x = |e| (u + v) for the four
/// corners x of a hinge. The unit vectors u and v point from e into its triangles, perpendicular to
/// e. A flat hinge has k x = 0, whatever the shape of its triangles. A hinge bent by theta has |k
/// x| = 2 |e| sin(theta / 2). Unlike the uniform Laplacian, this energy needs no even triangles and
/// detects folds of thin ones.
///
/// The form is sum s (k x)^2 over the edges, with s the mean stiffness of both ends of the edge. It
/// is scaled to be as stiff as sum s (L x)^2, L the uniform Laplacian, for equilateral triangles.
class HingeBending
{
public:
  /// @param[in] triangles  #F by 3, of a closed manifold; must outlive this object
  /// @param[in] around     vertexTriangles() of the triangles; must outlive this object
  /// @param[in] places     #V by 3 positions that define the shape of the hinges
  /// @param[in] stiffness  #V
  HingeBending(const conformal::Triangles& triangles, const Adjacency& around, const Points& places,
    const Eigen::VectorXd& stiffness, const Run& run);

  /// Evaluate k x of every hinge for values x at the vertices, #V by 3. Call it before forceAt().
  void bend(const Points& x, const Run& run);

  /// Return half the gradient of the form at a vertex.
  Vector3 forceAt(int vertex) const;

  /// Return half the second derivative of the form with respect to one coordinate of a vertex.
  double diagonalAt(int vertex) const;

private:
  struct Hinge
  {
    std::array<int, 4> Corners; ///< vertices of the edge, then the two opposite vertices
    std::array<float, 4> K;     ///< k times sqrt(s)
  };
  template <typename Visitor>
  void forHingesOf(int vertex, const Visitor& visit) const;

  const conformal::Triangles& Triangles;
  const Adjacency& Around;
  std::vector<Hinge> Hinges;
  conformal::Triangles HingeOf; ///< entry (r, k): the hinge of edge (k, k + 1 mod 3) of triangle r
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> Bent; ///< sqrt(s) k x
};
}

#endif
