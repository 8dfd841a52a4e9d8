/// Detect points so far from a cloud that they would determine its scale. Own construction: gaps in
/// the distances from the median, because usual criteria fail if many outliers share one position.
/// An example of a usual criterion is the distance to neighbors.

#ifndef ConformalFarPoints_h
#define ConformalFarPoints_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <limits>

namespace conformal
{
/// Result of findFarPoints(), equal on all ranks: the number and the distance of the far points of
/// a cloud.
struct FarPoints
{
  Index Count = 0; ///< number of far points
  Index Total = 0; ///< number of points examined, including far points
  double Distance =
    0.0; ///< distance of the nearest far point, in units of the cloud's radius; 0 if there is none
  /// Maximum absolute coordinate of the points that are not far; 0 if there are no far points
  double MaximumCoordinate = 0.0;

  /// One quarter of the coordinate-wise median of the cloud
  Vector3 QuarterOfCenter = Vector3::Zero();
  /// One quarter of the distance from the median beyond which a point is far
  double QuarterOfReach = std::numeric_limits<double>::infinity();

  /// Test whether a finite point is far. The test uses quarters of coordinates, since differences
  /// of coordinates may overflow.
  bool contains(const Vector3& x) const
  {
    return (0.25 * x - this->QuarterOfCenter).cwiseAbs().maxCoeff() > this->QuarterOfReach;
  }
};

/// Find the far points of a cloud: a few points at a great distance. Scaled together with them, the
/// cloud would be too small to be resolved. Examples are invalid pixels at (0, 0, 0), and outliers
/// with huge coordinates.
///
/// Distances are measured from the coordinate-wise median, in the maximum norm. The radius of the
/// cloud is the distance within which nine tenths of the positions lie. Candidates for far points
/// are points
/// - beyond a gap: for some distance R, at least the radius, at most 3 points lie between R and 4
///   R; or
/// - beyond 32 radii.
///
/// Candidates are far points if they have at most 32 different positions. They are also far points
/// if they have at most a twentieth of all positions and do not form a surface. Candidates form a
/// surface if a quarter or more of them pass liesFlat() (StrayPoints.h) with neighbors nearer than
/// half the distance to the cloud.
///
/// Points at the same position count as one. A cloud of fewer than 20 positions has no far points.
///
/// @param[in] points  #P by 3 coordinates, in any unit; points that are not finite are not examined
/// @param[in] skip    function that returns true for points to leave out; may be empty
/// @param[in] reduce  sums over the ranks; each rank passes its own part of the cloud
/// @throws Aborted
/// @post the result does not depend on the number of threads or ranks
FarPoints findFarPoints(const PointView& points, const std::function<bool(Index)>& skip = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif
