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
/// positions of the corners, and n_k their outward normals. Let m_k be the barycentric coordinates
/// of a point. The point of the curved triangle at m = (m_0, m_1, m_2) is
///
///     q(m) = sum_k m_k w_k
///            - sum_k sum_{j != k} (m_k^2 m_j + m_0 m_1 m_2 / 2) ((w_j - w_k) . n_k) n_k
///
/// A curved edge depends only on the positions and normals at its ends. Adjacent triangles
/// therefore join without a gap. On ridges, (w_j - w_k) . n_k is negative, and the triangles bulge
/// outward. In hollows, (w_j - w_k) . n_k is positive, and the triangles bulge inward. A normal
/// shorter than 1 gives a flatter corner. The tangent planes of adjacent triangles agree at the
/// vertices only.
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

  /// Return whether the curved triangle folds over: at some point, its normal and the normal of the
  /// flat triangle point to opposite sides. The control points of the cubic patch are tested first.
  /// If they do not exclude a fold, the points of a fine grid are tested. Return false if the flat
  /// triangle has zero area.
  bool folds() const;

  /// Return the bounding box of the control points, which contains the curved triangle.
  Box bounds() const;

  const std::array<Vector3, 3>& positions() const { return this->W; }
  const std::array<Vector3, 3>& normals() const { return this->N; }

  /// Return the mean of (q(m) - sum_k m_k w_k) m_c over the flat triangle, where c is `corner`.
  /// @param[in] corner  0, 1 or 2
  Vector3 moment(int corner) const;

private:
  Vector3 controlPoint(int k, int j) const;

  std::array<Vector3, 3> W, N;
  Eigen::Matrix3d Rise; // (w_j - w_k) . n_k at (k, j)
};

/// Evaluate normals for shading over a triangle. The normals are interpolated quadratically as in
/// \cite Vlachos2001. They are continuous across edges, in contrast to the exact normals.
class ShadingNormals
{
public:
  ShadingNormals() = default;
  explicit ShadingNormals(const CurvedTriangle& triangle);

  /// Return the unit normal at given barycentric coordinates, or zero where the interpolated normal
  /// has length 0.
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
  /// @param[in] normals  normals of the vertices, #V by 3; normals shorter than 1 give flatter
  ///   triangles
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

/// Compute the vertex normals for curved triangles over a mesh. They are those of vertexNormals(),
/// but 1000 times shorter at vertices on creases, see creaseVertices(). There, no normal is
/// perpendicular to all parts of the surface. Curved triangles between vertices on creases are
/// therefore flat.
/// @param[in] around  result of vertexTriangles() for these triangles
/// @param[in] across  result of triangleNeighbors() for these triangles
Points curvingNormals(const Points& positions, const Triangles& triangles, const Adjacency& around,
  const Triangles& across, const Run& run = {});

/// Move vertices inward on ridges and outward in hollows. On average, curved triangles through the
/// moved vertices then coincide with the flat triangles through the original vertices.
///
/// Use this function for a mesh that was fitted to points by least squares. The flat triangles of a
/// fitted mesh pass through the middle of the points. On ridges, the vertices of the mesh are
/// therefore outside of the sampled surface. Curved triangles through these vertices would bulge
/// even farther outward.
///
/// Let w_i be the position and n_i the normal of vertex i. Let phi_i be the hat function of vertex
/// i: the piecewise linear function that is 1 at this vertex and 0 at all other vertices. Let g_i
/// be the integral of phi_i times the displacement from the flat to the curved triangles. The moves
/// u_i solve the linear system M u = b, where b_i = n_i . g_i. The mass matrix M contains the
/// integrals of phi_i phi_j over the flat triangles. The new position is w_i - share u_i n_i. The
/// moves are the L2 projection of the displacement onto piecewise linear functions. With share 1,
/// the whole projection is subtracted.
///
/// To build curved triangles through the moved vertices, use the vertex normals of the original
/// mesh. In measurements, normals of the moved mesh were less accurate, because moving a vertex
/// makes the mesh sharper there.
///
/// Implementation note: the system is solved by 8 steps of the Chebyshev iteration, preconditioned
/// by the row sums of M. The eigenvalues of the preconditioned matrix are in [1/4, 1]. Each step
/// therefore reduces the error by a factor of 3. No step sums values over all vertices. The result
/// therefore has the same bits for any number of threads.
///
/// @param[in] surface  curved triangles through the original vertices
/// @param[in] around  triangles around each vertex, see vertexTriangles()
/// @param[in] share  factor of the move; with 1, the curved triangles enclose about the volume of
///   the flat triangles
/// @return the new positions, #V by 3
Points lowerVertices(
  const CurvedTriangles& surface, const Adjacency& around, double share, const Run& run = {});

/// Shorten vertex normals until no curved triangle folds. Shorter normals make the triangles
/// flatter.
/// @return #F marks, 1 for triangles that folded before, else 0
std::vector<unsigned char> flattenFolds(CurvedTriangles& surface, const Run& run = {});

/// Angles between the exact normals of two adjacent triangles at their common edge [degrees]. Mean
/// and maximum are over all edges.
struct NormalJumps
{
  double Mean = 0.0, Maximum = 0.0;
};
NormalJumps measureNormalJumps(
  const CurvedTriangles& surface, const conformal::Triangles& neighbors, const Run& run = {});

/// Find closest points on curved triangles with a search tree.
///
/// A query searches every curved triangle whose bounding box is closer than the closest point found
/// so far. In each curved triangle, the closest point is found by Newton's method. The method
/// starts at the foot point (closest point) on the flat triangle. Each step moves toward the
/// closest point of the tangent triangle, a flat triangle tangent to the curved one at the current
/// point. Edges and corners thus need no special cases. Queries do not modify the tree, so several
/// threads may query concurrently.
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
