/// Detect outliers. An outlier is off the surface formed by neighboring points, or far from all
/// other points. The method is our own construction: it measures distances from planes fitted to
/// eight neighbors. The method requires no normals of the points, and no length that depends on the
/// cloud.

#ifndef ConformalStrayPoints_h
#define ConformalStrayPoints_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/PointTree.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Plane fitted to the points nearest to a position. Usually, the position is that of a point of
/// the cloud. This point is then the nearest one. The nearest point is therefore never used.
struct NearestPlane
{
  Vector3 Normal; ///< unit length
  /// Signed distance from the position to the plane, positive along the normal
  double Offset = 0.0;
  /// Variances of the points along their principal axes, ascending; the first is along Normal
  Vector3 SquareWidths;
};

/// Limits of strayPoints() and isolatedPoints(): number of neighbors, distance from the plane
/// divided by w, and distance from neighbors divided by that of the neighbors
struct StrayLimits
{
  static constexpr int Neighbors = 8;
  static constexpr double Steepness = 0.8, FromNeighbors = 3.0;
};

/// Return whether a position is too far from the plane of its neighbors for a point of their
/// surface, see strayPoints().
inline bool isSteep(const NearestPlane& plane)
{
  const double width = plane.SquareWidths[1] + plane.SquareWidths[2];
  return plane.Offset * plane.Offset > StrayLimits::Steepness * StrayLimits::Steepness * width;
}

/// Fit a plane to the points nearest to a position.
/// @param[in] tree   tree of `points`; must have more than `count` points
/// @param[in] count  number of points to which the plane is fitted
NearestPlane planeNear(
  const Points& points, const PointTree& tree, const Vector3& place, int count);

/// Test whether a position and the points nearest to it are approximately in one plane. The result
/// is true if the position is near one plane with its eight nearest points, or with its sixteen
/// nearest points.
/// @param[in] tree  tree of `points`; must have more than eight points
bool liesFlat(const Points& points, const PointTree& tree, const Vector3& place);

/// Mark points that are not on the surface formed by the points around them. A plane is fitted to
/// the eight nearest neighbors of each point. Let w be the root mean square distance of these
/// neighbors from their mean, measured parallel to the plane. A point is marked if its distance
/// from the plane exceeds 0.8 w. Points at sharp tips and some points of very noisy clouds are also
/// marked.
///
/// @param[in] points  #P by 3 coordinates, finite
/// @return #P marks: 1 for outliers, 0 for other points. If there are at most eight points, all
///   marks are 0.
/// @throws Aborted
std::vector<std::uint8_t> strayPoints(const Points& points, const Run& run = {});

/// Mark points that are far from all others. Let d be the distance from a point to its eighth
/// nearest neighbor. A point is marked if its d exceeds 3 times the median of d at its eight
/// nearest neighbors. A point is also marked if its d exceeds `farthest` times the median of d over
/// all points. For both medians, points with d = 0, which have eight copies, are left out.
///
/// By these rules, points of a sparse part of a surface are also marked. Their marks are then
/// removed: a point loses its mark if at least a quarter of the 32 marked points nearest to it pass
/// liesFlat().
///
/// @param[in] points    #P by 3 coordinates, finite
/// @param[in] farthest  maximum of d, divided by the median of d over all points, for points that
///   are not marked
/// @return #P marks: 1 for isolated points, 0 for other points. If there are at most eight points,
///   all marks are 0.
/// @throws Aborted
std::vector<std::uint8_t> isolatedPoints(
  const Points& points, double farthest = 8.0, const Run& run = {});
}

#endif
