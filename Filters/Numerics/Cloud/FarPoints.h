/// Detect points so far from a cloud that they would set its scale. Own construction: usual
/// criteria of outliers, such as distances to neighbors, fail for outliers at one position.

#ifndef ConformalFarPoints_h
#define ConformalFarPoints_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <limits>

namespace conformal
{
/// Points far from all others of a cloud, on all ranks.
struct FarPoints
{
  Index Count = 0; ///< number of far points
  Index Total = 0; ///< number of points examined, far ones included
  double Distance =
    0.0; ///< of the nearest far point, in units of the cloud's radius; 0 without any
  /// Maximum over the points that are not far; 0 without far points
  double MaximumCoordinate = 0.0;

  Vector3 QuarterOfCenter = Vector3::Zero(); ///< quarter of the coordinate-wise median of the cloud
  /// Quarter of the distance beyond which a point is far
  double QuarterOfReach = std::numeric_limits<double>::infinity();

  /// Test whether a finite point is far. Quarters are used since differences of coordinates may
  /// overflow.
  bool contains(const Vector3& x) const
  {
    return (0.25 * x - this->QuarterOfCenter).cwiseAbs().maxCoeff() > this->QuarterOfReach;
  }
};

/// Find the few points so far from a cloud that a frame around all points would leave no resolution
/// to the cloud. Examples are invalid pixels at (0, 0, 0), and outliers of any size.
///
/// Distances are maximum norms from the coordinate-wise median. The radius contains nine tenths of
/// the positions. Candidates are points
/// - beyond a gap: at most 3 points lie between some distance R, at least the radius, and 4 R; or
/// - beyond 32 radii.
///
/// Candidates are far points if they occupy at most 32 positions. They are also far points if they
/// occupy at most a twentieth of all positions and do not form a surface of their own. Candidates
/// form a surface if a quarter or more of them lie flat (StrayPoints.h) among neighbors nearer than
/// half the distance to the cloud.
///
/// Points at one position count as one. A cloud of fewer than 20 positions has no far points.
///
/// @param[in] points  #P by 3, in any unit; points that are not finite are not examined
/// @param[in] skip    test whether to leave a point out; may be empty
/// @param[in] reduce  sums over the ranks that hold the other parts of the cloud
/// @throws Aborted
/// @post the result depends only on the points, not on threads or ranks
FarPoints findFarPoints(const PointView& points, const std::function<bool(Index)>& skip = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif
