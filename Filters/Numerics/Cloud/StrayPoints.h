/// Detect outliers: points that do not lie on the surface formed by other points, or are far from
/// all others. Own construction: distances from planes fitted to eight neighbors, because they need
/// neither normals nor a scale.

#ifndef ConformalStrayPoints_h
#define ConformalStrayPoints_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/PointTree.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Plane fitted to the points nearest to a position. A point at the position itself is not used.
struct NearestPlane
{
  Vector3 Normal;       ///< unit length
  double Offset = 0.0;  ///< signed distance from the position to the plane, along the normal
  Vector3 SquareWidths; ///< variances of the points along their principal axes, ascending
};

/// Fit a plane to the points nearest to a position.
/// @param[in] tree   tree of the points, of which there are more than `count`
/// @param[in] count  number of points to use
NearestPlane planeNear(
  const Points& points, const PointTree& tree, const Vector3& place, int count);

/// Test whether a position lies about in one plane with its eight nearest points, or with its
/// sixteen nearest points.
/// @param[in] tree  tree of the points, of which there are more than eight
bool liesFlat(const Points& points, const PointTree& tree, const Vector3& place);

/// Mark points that do not lie on the surface formed by the points around them. A plane is fitted
/// to the eight nearest other points. The point is marked if its distance from this plane exceeds
/// 0.8 times the root mean square width of the eight points in the plane. Points at sharp tips and
/// some points of very noisy clouds are marked, too.
///
/// @param[in] points  #P by 3 coordinates, finite
/// @return #P marks, 1 for an outlier, 0 for others; all 0 if there are at most eight points
/// @throws Aborted
std::vector<std::uint8_t> strayPoints(const Points& points, const Run& run = {});

/// Mark points that are far from all others. The distance from each point to its eighth nearest
/// neighbor is compared with the same distance of other points. A point is marked if its distance
/// exceeds 3 times the median over its eight neighbors. It is also marked if its distance exceeds
/// `farthest` times the median over the whole cloud.
///
/// Sparse parts of a surface are not marked: a mark is removed if at least a quarter of the 32
/// nearest marked points pass liesFlat().
///
/// @param[in] points    #P by 3 coordinates, finite
/// @param[in] farthest  maximum distance of the eighth nearest neighbor, divided by the median over
///   the cloud
/// @return #P marks, 1 for an isolated point, 0 for others; all 0 if there are at most eight points
/// @throws Aborted
std::vector<std::uint8_t> isolatedPoints(
  const Points& points, double farthest = 8.0, const Run& run = {});
}

#endif
