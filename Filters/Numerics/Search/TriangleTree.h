/// Closest point of a triangle mesh (foot point).

#ifndef ConformalTriangleTree_h
#define ConformalTriangleTree_h

#include "Base/Lanes.h"
#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/BoxTree.h"

#include <vector>

namespace conformal
{
/// The closest point of a triangle, and where it lies in it.
struct FootPoint
{
  int Triangle = -1;
  Vector3 Barycentric = Vector3::Zero(); ///< of the foot in its triangle; >= 0, sum 1
  Vector3 Position = Vector3::Zero();
  double SquareDistance = std::numeric_limits<double>::infinity();
};

/// Closest point of the triangle a, b, c; degenerate triangles are segments or points.
/// The field Triangle is left at -1.
FootPoint closestPointOfTriangle(
  const Vector3& x, const Vector3& a, const Vector3& b, const Vector3& c);

/// Exact closest points on a mesh that may move.
///
/// A query costs about log(#F) and only reads, so many threads may ask at once.
class TriangleTree
{
public:
  TriangleTree() = default;

  /// @param[in] positions  #V by 3, finite
  /// @param[in] triangles      #F by 3 ids
  /// @throws Aborted
  TriangleTree(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// The same triangles with their vertices moved. O(#F).
  void refit(const Points& positions, const Triangles& triangles, const Run& run = {});

  /// The closest point of the mesh; of triangles equally close, the lowest id.
  /// @param[in] x     a point; distances are exact to rounding
  /// @param[in] hint  a triangle that may be close: saves time, never changes the result
  /// @return Triangle -1 for a mesh without triangles
  FootPoint closestPoint(const Vector3& x, int hint = -1) const;

private:
  struct Corners
  {
    Vector3 A, B, C;
  };
  // Four boxes side by side, grandchildren of a binary tree, measured at the same time.
  struct Quad
  {
    Doubles Lower[3], Upper[3];
    int Next[DoubleLanes];  ///< quad below; -1 under a leaf and where there is no box
    int First[DoubleLanes]; ///< a leaf's first place in Items
    int Count[DoubleLanes]; ///< a leaf's number of triangles, else 0
  };
  int addQuad(const BoxTree& tree, int node, const Run& run);
  Box boxOf(const Quad& quad, int lane) const;
  void update(FootPoint& best, const Vector3& x, int place) const;
  static void measure(const Quad& quad, const double* x, double* distances);

  std::vector<int> Items;      ///< triangles in the tree's order
  std::vector<Quad> Quads;     ///< each before those below it
  std::vector<Corners> Placed; ///< corners of the triangle at each place of Items
  std::vector<int> PlaceOf;    ///< place of each triangle
};
}

#endif
