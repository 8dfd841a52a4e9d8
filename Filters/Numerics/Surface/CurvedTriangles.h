/// Build and evaluate curved triangles over a closed mesh. The triangles are defined by a position
/// and a normal for each vertex, \cite Vlachos2001.

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
/// Evaluate one curved triangle, the cubic PN triangle of \cite Vlachos2001. Let w_k be the
/// positions and n_k the normals of the corners, and let m_k be barycentric coordinates. The point
/// at m is
///
///     q(m) = sum_k m_k w_k
///            - sum_k sum_{j != k} (m_k^2 m_j + m_0 m_1 m_2 / 2) ((w_j - w_k) . n_k) n_k
///
/// A curved edge depends only on the positions and normals at its ends. Adjacent triangles
/// therefore join without a gap. Triangles bulge outward on ridges and inward in hollows, since
/// (w_j - w_k) . n_k has different signs there. A normal shorter than 1 gives a flatter corner. The
/// tangent planes of adjacent triangles agree at the vertices only.
class CurvedTriangle
{
public:
  CurvedTriangle() = default;
  CurvedTriangle(const std::array<Vector3, 3>& positions, const std::array<Vector3, 3>& normals);

  /// Return the point q(m) of the curved triangle.
  Vector3 position(const Vector3& barycentric) const;

  /// Return the derivative of q(m). Column k is the partial derivative by m_k.
  Eigen::Matrix3d derivative(const Vector3& barycentric) const;

  /// Return the exact unit normal of the surface, or zero where the area is zero. This normal is
  /// slightly discontinuous across edges.
  Vector3 surfaceNormal(const Vector3& barycentric) const;

  /// Return whether the curved triangle folds over: somewhere, its normal is opposite to the normal
  /// of the flat triangle. If the control points do not exclude a fold, the points of a fine grid
  /// are tested. Return false if the flat triangle has zero area.
  bool folds() const;

  /// Return the bounding box of the control points, which contains the curved triangle.
  Box bounds() const;

  const std::array<Vector3, 3>& positions() const { return this->W; }
  const std::array<Vector3, 3>& normals() const { return this->N; }

  /// Return the mean of the displacement q(m) - sum_k m_k w_k over the flat triangle, weighted by
  /// the barycentric coordinate of a corner, in {0, 1, 2}.
  Vector3 moment(int corner) const;

private:
  Vector3 controlPoint(int k, int j) const;

  std::array<Vector3, 3> W, N;
  Eigen::Matrix3d Rise; // (w_j - w_k) . n_k at (k, j)
};

/// Evaluate normals for shading over a triangle. The normals are the quadratic field of
/// \cite Vlachos2001, which is continuous across edges.
class ShadingNormals
{
public:
  ShadingNormals() = default;
  explicit ShadingNormals(const CurvedTriangle& triangle);

  /// Return the unit normal at given barycentric coordinates, or zero where normals cancel.
  Vector3 operator()(const Vector3& barycentric) const;

private:
  std::array<Vector3, 3> Ends, Middles;
};

/// Store the curved triangles over a mesh.
class CurvedTriangles
{
public:
  CurvedTriangles() = default;

  /// @param[in] positions  positions of the vertices, #V by 3
  /// @param[in] normals  normals of the vertices, of length 1 or less, #V by 3
  /// @param[in] triangles  vertex ids of the triangles, #F by 3
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

/// Move vertices inward on ridges and outward in hollows. On average, the curved triangles then
/// coincide with the original flat triangles.
///
/// Use this function for a mesh that was fitted to points by least squares. The flat triangles of
/// such a mesh are in the middle of the points. Vertices on ridges are therefore outside. Curved
/// triangles through these vertices would be too far outside.
///
/// Let w_i be the position and n_i the normal of vertex i, and let phi_i be the hat function of the
/// vertex: the piecewise linear function that is 1 there and 0 at all other vertices. Let g_i be
/// the integral of phi_i times the displacement from the flat to the curved triangles. The moves
/// u_i solve M u = (n_i . g_i). The mass matrix M contains the integrals of phi_i phi_j over the
/// flat triangles. The new position is w_i - share u_i n_i. With share 1, this is the L2 projection
/// of the displacement onto piecewise linear functions.
///
/// The normals are those of the flat triangles, also for the moved vertices. Normals of the moved
/// mesh were measured to be worse, since moving a vertex sharpens the mesh.
///
/// Implementation note: the system is solved by 8 steps of the Chebyshev iteration, preconditioned
/// by the row sums of M. The eigenvalues are then in [1/4, 1], so that each step reduces the error
/// by a factor of 3. The steps need no sums over all vertices, and the result has the same bits for
/// any number of threads.
///
/// @param[in] surface  curved triangles through the original vertices
/// @param[in] around  triangles around each vertex, see vertexTriangles()
/// @param[in] share  factor of the move; 1 preserves the volume
/// @return the new positions, #V by 3
Points lowerVertices(
  const CurvedTriangles& surface, const Adjacency& around, double share, const Run& run = {});

/// Shorten vertex normals until no curved triangle folds. Shorter normals make the triangles
/// flatter.
/// @return #F marks, 1 for triangles that were folded, else 0
std::vector<unsigned char> flattenFolds(CurvedTriangles& surface, const Run& run = {});

/// Angles between the exact normals of two adjacent triangles along the common edge, in degrees.
/// Mean and maximum are taken over all edges.
struct NormalJumps
{
  double Mean = 0.0, Maximum = 0.0;
};
NormalJumps measureNormalJumps(
  const CurvedTriangles& surface, const conformal::Triangles& neighbors, const Run& run = {});

/// Find closest points on curved triangles with a search tree.
///
/// A query searches every triangle whose bounding box is close enough. Newton's method starts at
/// the foot point (closest point) on the flat triangle. Each step minimizes the distance to the
/// tangent triangle, so that edges and corners need no special cases. Queries do not modify the
/// tree, so several threads may query concurrently.
class CurvedTriangleTree
{
public:
  CurvedTriangleTree() = default;
  explicit CurvedTriangleTree(const CurvedTriangles& surface, const Run& run = {});

  /// Return the closest point on all curved triangles.
  /// @param[in] hint  id of a triangle that may be close, which reduces the cost; -1 for none
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
