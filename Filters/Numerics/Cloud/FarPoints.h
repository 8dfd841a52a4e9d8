/// Detect the far points of a cloud: a few points that are so far from all others that the bounding
/// box of the cloud would be much too large. The method is our own construction: it finds gaps in
/// the distances of points from the median. Distances between neighboring points are not used,
/// because these distances are small if many outliers have one position.

#ifndef ConformalFarPoints_h
#define ConformalFarPoints_h

#include "Base/Reduce.h"
#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <limits>

namespace conformal
{
/// Number and distance of the far points of a cloud. The result of findFarPoints() is equal on all
/// ranks (MPI processes).
struct FarPoints
{
  Index Count = 0; ///< number of far points
  Index Total = 0; ///< number of points examined, including far points
  double Distance =
    0.0; ///< distance of the nearest far point, divided by the cloud's radius; 0 without far points
  /// Maximum absolute coordinate of the points that are not far. If there are no far points, this
  /// number is 0.
  double MaximumCoordinate = 0.0;

  /// One quarter of the coordinate-wise median of the points; see contains() for the reason of the
  /// quarter
  Vector3 QuarterOfCenter = Vector3::Zero();
  /// One quarter of the minimum distance of far points from the median
  double QuarterOfReach = std::numeric_limits<double>::infinity();

  /// Test whether a finite point is far. The test uses quarters of coordinates, since differences
  /// of whole coordinates can overflow.
  bool contains(const Vector3& x) const
  {
    return (0.25 * x - this->QuarterOfCenter).cwiseAbs().maxCoeff() > this->QuarterOfReach;
  }
};

/// Find the far points of a cloud: a few points at a great distance from all others. In a grid over
/// the bounding box of all points, the other points would occupy only a few cells. Examples of far
/// points are invalid pixels with position (0, 0, 0), and outliers with huge coordinates.
///
/// Distances are measured from the coordinate-wise median, in the maximum norm. The radius of the
/// cloud is the distance within which nine tenths of the positions lie. Two candidates, each a set
/// of points, are tested one after the other. The far points are the first candidate that is
/// accepted. The candidates are, in this sequence:
/// - points beyond a gap. Let R be a distance of at least the radius. The interval of distances
///   from R to 4 R is a gap if it contains at most 3 points. The gap with the smallest R is used.
/// - points at distances above 32 times the radius.
///
/// A set is accepted in two cases:
/// - The set has at most 32 different positions.
/// - Its different positions are at most a twentieth as many as the points of the cloud, and the
///   set does not form a surface.
///
/// A set forms a surface if at least a quarter of its positions are flat. A position is flat if two
/// conditions hold:
/// - The position passes liesFlat() (StrayPoints.h): the position and its nearest neighbors in the
///   set are approximately in one plane.
/// - Its eight nearest neighbors in the set are closer than half the distance from the position to
///   the median.
///
/// Several points at one position count as one position. A cloud with fewer than 20 positions has
/// no far points.
///
/// @param[in] points  #P by 3 coordinates, in any unit. Points that are not finite are ignored.
/// @param[in] skip    function that returns true for points that are not examined; empty to examine
///   all points
/// @param[in] reduce  communication between ranks; each rank passes its part of the cloud
/// @throws Aborted
/// @post the result does not depend on the number of threads or ranks
FarPoints findFarPoints(const PointView& points, const std::function<bool(Index)>& skip = {},
  const Reduce& reduce = {}, const Run& run = {});
}

#endif
