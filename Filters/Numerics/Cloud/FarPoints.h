/// Detects points so far from a cloud that they would set its scale.

#ifndef ConformalFarPoints_h
#define ConformalFarPoints_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <limits>

namespace conformal
{
/// Points far from all others of a cloud, on all processes.
struct FarPoints
{
  Index Count = 0; ///< number of far points
  Index Total = 0; ///< number of points examined, far ones included
  double Distance =
    0.0; ///< of the nearest far point, in units of the cloud's radius; 0 without any
  double MaximumCoordinate = 0.0; ///< of the points that are not far; 0 without far points

  Vector3 QuarterOfCenter = Vector3::Zero(); ///< of the cloud, coordinatewise median
  double QuarterOfReach = std::numeric_limits<double>::infinity(); ///< beyond it a point is far

  /// Test whether a finite point is far. Quarters, since differences of coordinates may overflow.
  bool contains(const Vector3& x) const
  {
    return (0.25 * x - this->QuarterOfCenter).cwiseAbs().maxCoeff() > this->QuarterOfReach;
  }
};

/// Find the few points that lie so far from a cloud that a frame around all points would leave no
/// resolution to the cloud: places of invalid pixels, such as (0, 0, 0), and outliers of any size.
///
/// Distances are maximum norms from the coordinatewise median; the radius is that of nine tenths of
/// the places. Points are far
/// - beyond a gap: at most 3 points lie between some distance R, at least the radius, and 4 R; or
/// - beyond 32 radii, gap or not;
///
/// if they are at no more than 32 places, or at no more than a twentieth of all places and do not
/// lie on a surface of their own: less than a quarter of them lie flat (StrayPoints.h) among
/// neighbors that are nearer than half the distance to the cloud. Points at one place count as one.
/// A cloud of fewer than 20 places has no far points. Own construction: usual criteria of outliers,
/// such as distances to neighbors, fail for outliers at one place.
///
/// @param[in] points  #P by 3, in any unit; points that are not finite are not examined
/// @param[in] skip    test whether to leave a point out; may be empty
/// @param[in] reduce  adds up over the processes that hold the other parts of the cloud
/// @throws Aborted
/// @post the result depends only on the points, not on threads or ranks
FarPoints findFarPoints(const PointView& points, const std::function<bool(Index)>& skip = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif
