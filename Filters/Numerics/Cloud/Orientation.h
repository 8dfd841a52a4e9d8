/// Compute normals of a cloud, pointing outward, from all points together, \cite Lin2022 and
/// \cite Lin2024.

#ifndef ConformalOrientation_h
#define ConformalOrientation_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/WindingNumbers.h"

#include <vector>

namespace conformal
{
struct OrientationOptions
{
  int NumberOfIterations = 20;
  /// Width of the winding numbers in the first iteration, see WindingNumbers.h. Later the width
  /// decreases linearly to LastWidth
  double FirstWidth = 0.04;
  /// Width in the last iteration: about half the distance between neighboring points; for noisy
  /// points, about twice the size of the noise
  double LastWidth = 0.01;
};

/// Compute outward area vectors at the points of a cloud, so that the winding number becomes 1/2 at
/// all points. The area vectors start from zero. Each iteration has two parts:
/// - One step of steepest descent reduces the sum of squares of A a - 1/2. Here a are the area
///   vectors, and A a the winding numbers at the points. This is the linear system of Parametric
///   Gauss Reconstruction, \cite Lin2022.
/// - Each area vector gets the direction of the negative gradient of the winding number. Its length
///   does not change. This is Winding Number Normal Consistency, \cite Lin2024.
///
/// Every normal depends on the whole cloud, not only on its neighbors. Holes in the data therefore
/// do no harm if the other points determine how the surface closes there.
///
/// @return #P by 3 area vectors
/// @throws Aborted
Points orient(
  const WindingNumbers& cloud, const OrientationOptions& options = {}, const Run& run = {});

/// Estimate the surface area that each point represents: an eighth of the area of a circle that
/// contains its eight nearest neighbors.
/// @return #P areas
std::vector<double> areasOfPoints(const Points& points, const Run& run = {});

/// Compute how sparse the cloud is at each point. The result is the point's area divided by the
/// median area. If this ratio is at most 4, or if the point seems to be an outlier, the result is
/// 1.
/// @return #P ratios, at least 1
Eigen::VectorXd sparsityOf(const Points& points, const Run& run = {});

/// Compute area vectors from given normals, with the lengths of areasOfPoints(). The result is zero
/// for a zero normal.
/// @param[in] normals  #P by 3 unit vectors or zeros
Points areaVectors(const Points& points, const Points& normals, const Run& run = {});

/// Reverse all area vectors if most of them point inward.
/// @param[in,out] areas  #P by 3 area vectors
/// @return whether the area vectors agree on which side is inside. If they do not, they are
///   useless, as are normals with inconsistent signs.
bool turnOutward(const WindingNumbers& cloud, Points& areas, double width, const Run& run = {});

/// Offsets of points from the surface that they sample.
struct PointNoise
{
  /// #P distances, along the normal of each point, from the point to the mean of its neighbors
  Eigen::VectorXd Offsets;
  /// Standard deviation of the noise. Offsets caused by the bending of the surface are subtracted.
  double Deviation = 0.0;
};

/// Estimate the noise of points from their neighbors with similar normals.
/// @param[in] areas  #P by 3 area vectors
PointNoise noiseOf(const Points& points, const Points& areas, const Run& run = {});

/// Estimate the typical distance between neighboring points: the distance if all points were spread
/// evenly with the median density. The result is 0 for fewer than two points.
double typicalSpacing(const Points& points, const Run& run = {});
}

#endif
