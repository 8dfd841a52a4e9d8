/// Orient a cloud without normals from all its points together, \cite Lin2022 and \cite Lin2024.

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
  /// Width of the winding numbers in the first iteration, see WindingNumbers.h; then decreasing
  /// evenly
  double FirstWidth = 0.04;
  double LastWidth = 0.01; ///< about half the distance between neighbors; for noise, twice its size
};

/// Compute outward area vectors of the surface sampled by a cloud, so that the winding number is
/// 1/2 at all points. Starting from zero, each iteration applies
/// - a step of steepest descent for the least squares of A a - 1/2 (the linear system of Parametric
///   Gauss Reconstruction, \cite Lin2022);
/// - the direction of each area vector from the gradient of the winding number, with its length
///   kept (Winding Number Normal Consistency, \cite Lin2024).
///
/// Holes in the data do not matter if the other points imply how they close. Every normal depends
/// on the whole cloud, not on its neighbors alone.
///
/// @return #P by 3
/// @throws Aborted
Points orient(
  const WindingNumbers& cloud, const OrientationOptions& options = {}, const Run& run = {});

/// Estimate the area of each point: its share of a circle that contains eight neighbors.
/// @return #P
std::vector<double> areasOfPoints(const Points& points, const Run& run = {});

/// Compute how sparse the cloud is at each point: its area relative to the usual one. The value is
/// 1 for a ratio below four, and for points that seem to be outliers.
/// @return #P, at least 1
Eigen::VectorXd sparsityOf(const Points& points, const Run& run = {});

/// Compute area vectors of length areasOfPoints() from given normals; zero for a zero normal.
/// @param[in] normals  #P by 3, unit vectors or zero
Points areaVectors(const Points& points, const Points& normals, const Run& run = {});

/// Reverse all area vectors if they point inward.
/// @param[in,out] areas  #P by 3
/// @return whether the area vectors agree on the inside; otherwise they are of no use, like normals
///   of inconsistent signs
bool turnOutward(const WindingNumbers& cloud, Points& areas, double width, const Run& run = {});

/// Offsets of points from the surface that they sample.
struct PointNoise
{
  /// #P: offset of the mean of the neighbors of each point, along its normal
  Eigen::VectorXd Offsets;
  double Deviation = 0.0; ///< standard deviation of the noise, without the offsets caused by bends
};

/// Estimate the noise of points from their neighbors with similar normals.
/// @param[in] areas  #P by 3, area vectors
PointNoise noiseOf(const Points& points, const Points& areas, const Run& run = {});

/// Estimate the distance of neighbors for points spread evenly with the typical density; 0 for
/// fewer than two points.
double typicalSpacing(const Points& points, const Run& run = {});
}

#endif
