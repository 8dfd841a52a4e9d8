/// Curved triangles over a closed mesh. They are defined by a position and a normal for each
/// vertex.

#ifndef ConformalCurvedTriangles_h
#define ConformalCurvedTriangles_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"
#include "Search/BoxTree.h"
#include "Search/TriangleTree.h"

#include <array>
#include <vector>

namespace conformal
{
/// PN triangle of \cite Vlachos2001, the cubic, with vertices w, normals n and barycentric
/// coordinates m, q(m) = sum_k m_k w_k - sum_k sum_{j != k} (m_k^2 m_j + m_0 m_1 m_2 / 2) ((w_j -
/// w_k) n_k) n_k.
///
/// A curved edge depends only on the positions and normals at its ends, so adjacent triangles join
/// without a gap. Triangles bulge outward on ridges and inward in hollows, since (w_j - w_k) n_k
/// has different signs there. A normal shorter than 1 gives a flatter corner. The tangent planes of
/// adjacent triangles agree at the vertices only.
class CurvedTriangle
{
public:
  CurvedTriangle() = default;
  CurvedTriangle(const std::array<Vector3, 3>& positions, const std::array<Vector3, 3>& normals);

  /// Return q(m).
  Vector3 position(const Vector3& barycentric) const;

  /// Return the derivative of q by m; column k is the partial derivative by m_k.
  Eigen::Matrix3d derivative(const Vector3& barycentric) const;

  /// Return the exact unit normal of the surface, or zero where the area is zero. It is slightly
  /// discontinuous across edges.
  Vector3 surfaceNormal(const Vector3& barycentric) const;

  /// Return whether the curved triangle folds over: somewhere its normal is opposite to the normal
  /// of the flat triangle. Return false for zero area. If the control points do not exclude a fold,
  /// points of a fine grid are tested.
  bool folds() const;

  /// Return the bounding box of the control points, which contains the curved triangle.
  Box bounds() const;

  const std::array<Vector3, 3>& positions() const { return this->W; }
  const std::array<Vector3, 3>& normals() const { return this->N; }

  /// Return the displacement of the midpoint of a curved edge from the flat edge. The edge is given
  /// by the opposite corner.
  Vector3 rise(int edge) const;

private:
  Vector3 controlPoint(int k, int j) const;

  std::array<Vector3, 3> W, N;
  Eigen::Matrix3d Rise; // (w_j - w_k) n_k at (k, j)
};

/// Normals for shading over a triangle: the quadratic field of \cite Vlachos2001, which is
/// continuous across edges.
class ShadingNormals
{
public:
  ShadingNormals() = default;
  explicit ShadingNormals(const CurvedTriangle& triangle);

  /// Return a unit vector, or zero where normals cancel.
  Vector3 operator()(const Vector3& barycentric) const;

private:
  std::array<Vector3, 3> Ends, Middles;
};

/// Curved triangles over a mesh.
class CurvedTriangles
{
public:
  CurvedTriangles() = default;

  /// @param[in] positions  #V by 3, positions w
  /// @param[in] normals    #V by 3, normals n of length 1 or less
  /// @param[in] triangles  #F by 3 ids
  CurvedTriangles(
    const Points& positions, const Points& normals, const conformal::Triangles& triangles);

  const Points& positions() const { return this->Positions; }
  const Points& normals() const { return this->Normals; }
  const conformal::Triangles& triangles() const { return this->Triangles; }

  CurvedTriangle operator[](Index triangle) const;

private:
  Points Positions;
  Points Normals;
  conformal::Triangles Triangles;
};

/// Move vertices inward on ridges and outward in hollows, so that the curved triangles coincide
/// with the original flat triangles on average.
///
/// A mesh that was fitted to points by least squares has flat triangles in the middle of the
/// points, and its vertices lie outside of ridges. Curved triangles through these vertices would be
/// too far outside.
///
/// The result is w_i + share n_i (n_i g_i) / c_i. This is one step of the projection of the curved
/// surface onto the flat surface, with a lumped mass matrix. Here g_i is the volume between curved
/// and flat triangles around the vertex, weighted by the vertex's hat function. c_i is a third of
/// the area of the adjacent triangles.
///
/// @param[in] around  vertexTriangles() of the surface's triangles
Points lowerVertices(
  const CurvedTriangles& surface, const Adjacency& around, double share, const Run& run = {});

/// Shorten normals until no curved triangle folds.
/// @return #F, 1 for triangles that folded
std::vector<unsigned char> flattenFolds(CurvedTriangles& surface, const Run& run = {});

/// Angles between the surface normals of two adjacent triangles along their common edge, in
/// degrees; mean and maximum over all edges.
struct NormalJumps
{
  double Mean = 0.0, Maximum = 0.0;
};
NormalJumps measureNormalJumps(
  const CurvedTriangles& surface, const conformal::Triangles& neighbors, const Run& run = {});

/// Search tree for closest points on curved triangles.
///
/// A query searches every triangle whose bounding box is close enough. Newton's method starts at
/// the foot point on the flat triangle. Each step minimizes the distance over the tangent triangle,
/// so that edges and corners need no special cases. Queries only read, so several threads may query
/// concurrently.
class CurvedTriangleTree
{
public:
  CurvedTriangleTree() = default;
  explicit CurvedTriangleTree(const CurvedTriangles& surface, const Run& run = {});

  /// @param[in] hint  triangle that may be close, which reduces the cost; or -1
  FootPoint closestPoint(const Vector3& x, int hint = -1) const;

private:
  struct Item
  {
    CurvedTriangle Triangle;
    Box Bounds;
  };
  FootPoint footAt(int place, const Vector3& x, double worthwhile) const;

  BoxTree Tree;
  std::vector<Item> Placed; // triangle and bounds at each position of Tree.Items
  std::vector<int> PlaceOf; // position of each triangle in Tree.Items
};
}

#endif
