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
/// The two triangles of an edge e are a hinge. With the cotangents of their angles at e, four
/// numbers k make k x = |e| (u + v) of the hinge's corners x, u and v the unit vectors from e into
/// its triangles, at right angles to e: zero when flat, however long and thin the triangles are,
/// and of length 2 |e| sin(theta / 2) when bent by theta \cite Wardetzky2007. Unlike the uniform
/// Laplacian it asks for no even triangles, and it sees the folds of thin ones.
///
/// The form is sum s (k x)^2 over the edges, s the mean stiffness of the edge's ends, scaled so
/// that it is as stiff as sum s (L x)^2 where triangles are equilateral.
class HingeBending
{
public:
  /// @param[in] triangles      #F by 3, of a closed manifold; must outlive this
  /// @param[in] around     vertexTriangles of the triangles; likewise
  /// @param[in] places     #V by 3, what gives the hinges their shape
  /// @param[in] stiffness  #V
  HingeBending(const conformal::Triangles& triangles, const Adjacency& around, const Points& places,
    const Eigen::VectorXd& stiffness, const Run& run);

  /// Prepare forceAt() for values x at the vertices, #V by 3.
  void bend(const Points& x, const Run& run);

  /// Half the gradient of the form at a vertex.
  Vector3 forceAt(int vertex) const;

  /// Half the form's second derivative by one coordinate of a vertex.
  double diagonalAt(int vertex) const;

private:
  struct Hinge
  {
    std::array<int, 4> Corners; ///< the edge's, then the opposite ones
    std::array<float, 4> K;     ///< times sqrt(s)
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
