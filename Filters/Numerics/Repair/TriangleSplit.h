/// Split a triangle along line segments. Segments that are missing in a triangulation are recovered
/// by flips of edges, \cite Sloan1993.

#ifndef ConformalTriangleSplit_h
#define ConformalTriangleSplit_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace conformal
{
/// Points and segments inside a triangle. Points are identified by their index in Positions.
struct TriangleSplitInput
{
  /// Points in the plane of the triangle. The first three are its corners, counter-clockwise.
  std::vector<Eigen::Vector2d> Positions;
  /// Points on each edge of the triangle, ordered from corner k to the next corner.
  std::array<std::vector<int>, 3> OnEdges;
  /// Pairs of points that the triangulation must connect. Segments cross neither each other nor
  /// other points.
  std::vector<std::array<int, 2>> Segments;
};

/// Triangulate a triangle so that all points are vertices and all segments are edges. Triangles are
/// counter-clockwise. Edges that are not segments are flipped until they are locally Delaunay.
/// @throws NumericalFailure if points or segments are so close to each other that rounding errors
///   decide their order
/// @throws Aborted
std::vector<std::array<int, 3>> splitTriangle(const TriangleSplitInput& input, const Run& run = {});
}

#endif
