/// Compute outward normals of a point cloud from all points together, \cite Lin2022 and
/// \cite Lin2024.

#ifndef ConformalOrientation_h
#define ConformalOrientation_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/WindingNumbers.h"

#include <vector>

namespace conformal
{
/// Parameters of orient().
struct OrientationOptions
{
  int NumberOfIterations = 20;
  /// Smoothing width in the first iteration [units of the points]: the radius of the ball over
  /// which winding numbers are averaged, see WindingNumbers. From iteration to iteration, the width
  /// decreases linearly to LastWidth.
  double FirstWidth = 0.04;
  /// Smoothing width in the last iteration [units of the points]. A good width is half the distance
  /// between neighboring points. For noisy points, a good width is twice the standard deviation of
  /// the noise.
  double LastWidth = 0.01;
};

/// Compute outward area vectors at the points of a cloud. An area vector is the outward normal
/// times the area that the point represents. The area vectors define winding numbers, which are
/// about 1 inside and 0 outside. The area vectors are chosen so that the winding number is close to
/// 1/2 at all points. Initially, all area vectors are zero. Each iteration has two parts:
/// - Let a be the area vectors, and A a the winding numbers at the points. One step of steepest
///   descent reduces the sum of squares of A a - 1/2. The term of each point is weighted by
///   sparsityOf(), so that sparse parts of the cloud count more. This part is Parametric Gauss
///   Reconstruction, \cite Lin2022.
/// - Each area vector is rotated to the direction of the negative gradient of the winding number.
///   This part is Winding Number Normal Consistency, \cite Lin2024.
///
/// Every normal depends on all points of the cloud, not only on points nearby. If a scan has holes,
/// its normals are still consistent, provided that the other points determine inside and outside.
///
/// @return #P by 3 area vectors
/// @throws Aborted
Points orient(
  const WindingNumbers& cloud, const OrientationOptions& options = {}, const Run& run = {});

/// Estimate the area of the surface that each point represents. The estimate is an eighth of the
/// area of a circle. The radius of the circle is the distance to the eighth nearest neighbor.
/// @return #P areas
std::vector<double> areasOfPoints(const Points& points, const Run& run = {});

/// Compute how sparse the cloud is at each point. The result is the area of the point (see
/// areasOfPoints()), divided by the median area. There are two exceptions, for which the result is
/// 1: ratios of at most 4, and outliers. Outliers are the points marked by isolatedPoints()
/// (StrayPoints.h) with the argument farthest = 2.5. These points are far from all others.
/// @return #P ratios, at least 1
Eigen::VectorXd sparsityOf(const Points& points, const Run& run = {});

/// Compute area vectors: given normals times the areas computed by areasOfPoints(). If a normal is
/// zero, its area vector is zero.
/// @param[in] normals  #P by 3 unit vectors or zeros
Points areaVectors(const Points& points, const Points& normals, const Run& run = {});

/// Make area vectors point outward: if the median of the winding numbers at the points is negative,
/// reverse all area vectors.
/// @param[in,out] areas  #P by 3 area vectors
/// @param[in] width  smoothing width of the winding numbers, in the unit of the points
/// @return whether the orientations are consistent: after the reversal, the median is above 0.15,
///   and more than three quarters of the winding numbers are positive. If false, do not use the
///   area vectors.
bool turnOutward(const WindingNumbers& cloud, Points& areas, double width, const Run& run = {});

/// Estimated noise of the points of a cloud, computed by noiseOf().
struct PointNoise
{
  /// #P signed distances from each point to the mean of its neighbors, along the normal of the
  /// point
  Eigen::VectorXd Offsets;
  /// Standard deviation of the noise, estimated from Offsets. The bending of the surface also
  /// causes offsets, which are nearly equal at neighboring points. The offsets due to bending are
  /// therefore subtracted first.
  double Deviation = 0.0;
};

/// Estimate the noise of points from the sixteen nearest neighbors of each point. Neighbors whose
/// normal differs by 90 degrees or more are ignored.
/// @param[in] areas  #P by 3 area vectors
PointNoise noiseOf(const Points& points, const Points& areas, const Run& run = {});

/// Estimate the typical distance between neighboring points: the square root of the median of
/// areasOfPoints(). If there are fewer than two points, the result is 0.
double typicalSpacing(const Points& points, const Run& run = {});
}

#endif
