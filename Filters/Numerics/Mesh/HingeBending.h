/// Compute the bending energy of a triangle mesh, a sum over its edges, \cite Wardetzky2007. The
/// energy is a quadratic form in the positions of the vertices.

#ifndef ConformalHingeBending_h
#define ConformalHingeBending_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <array>
#include <vector>

namespace conformal
{
/// Bending energy of the hinges of a mesh, \cite Wardetzky2007. A hinge consists of the two
/// triangles at an edge e.
///
/// Each corner of a hinge has a number k, computed from the cotangents of the angles at e. The
/// position x of each corner is multiplied by its number k. Let k x denote the sum of these four
/// products. Let u and v be the unit vectors that point from e into the two triangles,
/// perpendicular to e. Then k x is |e| (u + v). A flat hinge has k x = 0 for any shape of its
/// triangles. A hinge bent by an angle theta has |k x| = 2 |e| sin(theta / 2). At folds, |k x| is
/// large even if the triangles are thin. Another measure is the uniform Laplacian of a vertex: its
/// position minus the mean of its neighbors. The uniform Laplacian measures bending only if
/// triangles are nearly equilateral. At needles (very thin triangles), the four numbers k are
/// scaled down to a magnitude of at most 4. Larger numbers would make the equations for minimizing
/// the energy ill-conditioned.
///
/// The stiffness is a given weight at each vertex. Let s be the mean stiffness of the two vertices
/// of an edge. The energy is the sum of s (k x)^2 over all edges, times the constant 1/14. The
/// constant makes the energy comparable with another energy: the sum of s (L x)^2 over all
/// vertices, where L x is the uniform Laplacian. For equilateral triangles and constant stiffness
/// s, the second derivatives of the two energies by coordinates are about equal.
class HingeBending
{
public:
  /// @param[in] triangles  #F by 3 ids of a closed manifold; must outlive this object
  /// @param[in] around     result of vertexTriangles() for these triangles; must outlive this
  ///   object
  /// @param[in] places     #V by 3 positions from which the numbers k are computed
  /// @param[in] stiffness  #V values, the stiffness at each vertex
  HingeBending(const conformal::Triangles& triangles, const Adjacency& around, const Points& places,
    const Eigen::VectorXd& stiffness, const Run& run);

  /// Compute k x of every hinge for vertex positions x, #V by 3. Call this function before
  /// forceAt().
  void bend(const Points& x, const Run& run);

  /// Return half the gradient of the energy with respect to the position of a vertex. The gradient
  /// is evaluated at the positions passed to bend().
  Vector3 forceAt(int vertex) const;

  /// Return half the second derivative of the energy with respect to a coordinate of a vertex. All
  /// three coordinates have equal second derivatives.
  double diagonalAt(int vertex) const;

private:
  struct Hinge
  {
    std::array<int, 4> Corners; ///< vertices of the edge, then the two opposite vertices
    std::array<float, 4> K;     ///< numbers k of the hinge, times sqrt(s / 14)
  };
  template <typename Visitor>
  void forHingesOf(int vertex, const Visitor& visit) const;

  const conformal::Triangles& Triangles;
  const Adjacency& Around;
  std::vector<Hinge> Hinges;
  /// Entry (r, j): id of the hinge at edge (j, j + 1 mod 3) of triangle r
  conformal::Triangles HingeOf;
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> Bent; ///< sqrt(s / 14) k x of each hinge
};
}

#endif
