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
/// Bending energy of hinges, \cite Wardetzky2007. A hinge consists of the two triangles at an edge
/// e.
///
/// Four numbers k are computed from the cotangents of the angles at e. Their products with the
/// positions x of the four corners of the hinge have the sum k x = |e| (u + v). The unit vectors u
/// and v point from e into its triangles, perpendicular to e. A flat hinge has k x = 0, whatever
/// the shape of its triangles. A hinge bent by an angle theta has |k x| = 2 |e| sin(theta / 2).
/// Unlike the uniform Laplacian, this energy does not need even triangles, and it detects folds of
/// thin triangles.
///
/// The energy is the sum of s (k x)^2 over all edges, where s is the mean stiffness of the edge's
/// two vertices. Let L be the uniform Laplacian. For equilateral triangles, the energy is scaled to
/// be as stiff as the sum of s (L x)^2 over all vertices.
class HingeBending
{
public:
  /// @param[in] triangles  #F by 3 ids of a closed manifold; must outlive this object
  /// @param[in] around     result of vertexTriangles() for these triangles; must outlive this
  ///   object
  /// @param[in] places     #V by 3 positions that define the shape of the hinges
  /// @param[in] stiffness  #V values, the stiffness at each vertex
  HingeBending(const conformal::Triangles& triangles, const Adjacency& around, const Points& places,
    const Eigen::VectorXd& stiffness, const Run& run);

  /// Evaluate k x of every hinge for positions x of the vertices, #V by 3. Call this function
  /// before forceAt().
  void bend(const Points& x, const Run& run);

  /// Return half the gradient of the energy with respect to the position of a vertex.
  Vector3 forceAt(int vertex) const;

  /// Return half the second derivative of the energy with respect to one coordinate of a vertex.
  double diagonalAt(int vertex) const;

private:
  struct Hinge
  {
    std::array<int, 4> Corners; ///< vertices of the edge, then the two opposite vertices
    std::array<float, 4> K;     ///< numbers k of the hinge, times sqrt(s)
  };
  template <typename Visitor>
  void forHingesOf(int vertex, const Visitor& visit) const;

  const conformal::Triangles& Triangles;
  const Adjacency& Around;
  std::vector<Hinge> Hinges;
  conformal::Triangles HingeOf; ///< entry (r, j): hinge at edge (j, j + 1 mod 3) of triangle r
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> Bent; ///< sqrt(s) k x of each hinge
};
}

#endif
