/// Curved triangles over a closed mesh: a position and a normal for each vertex.

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
/// A PN triangle (\cite Vlachos2001): the cubic, with vertices w, normals n and barycentric
/// coordinates m,
///     q(m) = sum_k m_k w_k - sum_k sum_{j != k} (m_k^2 m_j + m_0 m_1 m_2 / 2) ((w_j - w_k) n_k)
///     n_k.
/// An edge depends on its own ends only, so neighbors meet without a gap. Domes rise on ridges and
/// sink in hollows, since a normal tells on which side of it the neighbors lie; a normal shorter
/// than 1 gives a flatter corner. Where they meet the tangent planes agree at the vertices only.
class CurvedTriangle
{
public:
  CurvedTriangle() = default;
  CurvedTriangle(const std::array<Vector3, 3>& positions, const std::array<Vector3, 3>& normals);

  /// q(m).
  Vector3 position(const Vector3& barycentric) const;

  /// Column k is the derivative of q with m_k.
  Eigen::Matrix3d derivative(const Vector3& barycentric) const;

  /// The surface's own normal, which jumps a little across edges. Unit, or zero without area.
  Vector3 surfaceNormal(const Vector3& barycentric) const;

  /// Whether it turns over somewhere, seen along the normal of the flat triangle: never reported
  /// for one without area, and only where a point of a fine grid does unless the control points
  /// exclude it.
  bool folds() const;

  /// Bounds: of the control points.
  Box bounds() const;

  const std::array<Vector3, 3>& positions() const { return this->W; }
  const std::array<Vector3, 3>& normals() const { return this->N; }

  /// Displacement of the middle of the edge opposite to a corner.
  Vector3 rise(int edge) const;

private:
  Vector3 controlPoint(int k, int j) const;

  std::array<Vector3, 3> W, N;
  Eigen::Matrix3d Rise; // (w_j - w_k) n_k at (k, j)
};

/// Normals for shading over a triangle, the same from both sides of an edge: the quadratic field of
/// \cite Vlachos2001.
class ShadingNormals
{
public:
  ShadingNormals() = default;
  explicit ShadingNormals(const CurvedTriangle& triangle);

  /// Unit, or zero where normals cancel.
  Vector3 operator()(const Vector3& barycentric) const;

private:
  std::array<Vector3, 3> Ends, Middles;
};

/// Curved triangles over a mesh.
class CurvedTriangles
{
public:
  CurvedTriangles() = default;

  /// @param[in] positions  #V by 3, w
  /// @param[in] normals    #V by 3, n, of length 1 or less
  /// @param[in] triangles      #F by 3 ids
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

/// Vertices moved inwards on ridges and outwards in hollows, so that the curved triangles over them
/// lie where the flat ones lay in the mean. A mesh that was fitted to points by least squares has
/// its flat triangles in the middle of the points, its vertices outside of ridges: curved triangles
/// through these would lie too far out.
///
/// This is one step of the projection of the curved on to the flat surface, with the mass matrix
/// lumped: w_i + share n_i (n_i g_i) / c_i, where g_i is the domes' volume around the vertex,
/// weighted by its hat function, and c_i a third of the area around.
///
/// @param[in] around  vertexTriangles of the surface's triangles
Points lowerVertices(
  const CurvedTriangles& surface, const Adjacency& around, double share, const Run& run = {});

/// Shorten normals until no triangle folds.
/// @return #F, 1 for those that did
std::vector<unsigned char> flattenFolds(CurvedTriangles& surface, const Run& run = {});

/// Angles between the surface normals of two triangles along their edges, in degrees.
struct NormalJumps
{
  double Mean = 0.0, Maximum = 0.0;
};
NormalJumps measureNormalJumps(
  const CurvedTriangles& surface, const conformal::Triangles& neighbors, const Run& run = {});

/// Closest points of curved triangles.
///
/// Every triangle whose bounds are close enough is searched by Newton's method from its flat foot,
/// step by step on the tangent triangle, so that edges and corners need no cases. A query only
/// reads, so many threads may ask at once.
class CurvedTriangleTree
{
public:
  CurvedTriangleTree() = default;
  explicit CurvedTriangleTree(const CurvedTriangles& surface, const Run& run = {});

  /// @param[in] hint  a triangle that may be close, or -1: saves time
  FootPoint closestPoint(const Vector3& x, int hint = -1) const;

private:
  struct Item
  {
    CurvedTriangle Triangle;
    Box Bounds;
  };
  FootPoint footAt(int place, const Vector3& x, double worthwhile) const;

  BoxTree Tree;
  std::vector<Item> Placed; // of the triangle at each place of Tree.Items
  std::vector<int> PlaceOf; // of each triangle
};
}

#endif
