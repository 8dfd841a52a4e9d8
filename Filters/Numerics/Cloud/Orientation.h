/// Normals of a cloud that has none, found from all of its points together.

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
  double FirstWidth = 0.04; ///< of the winding numbers, see WindingNumbers.h; then falling evenly
  double LastWidth = 0.01; ///< about half the distance between neighbors; with noise twice its size
};

/// Area vectors of the surface that is sampled by a cloud, outward: they make the winding number
/// 1/2 at all points. From nothing, each iteration takes
/// - a step of steepest descent for the least squares of A a - 1/2 (the linear system of Parametric
///   Gauss Reconstruction, \cite Lin2022);
/// - the direction of each area vector from the gradient of the winding number, its size kept
///   (Winding Number Normal Consistency, \cite Lin2024).
///
/// Holes in the data do not matter where the rest of the points implies how they close: no point
/// asks its neighbors alone.
///
/// @return #P by 3
/// @throws Aborted
Points orient(
  const WindingNumbers& cloud, const OrientationOptions& options = {}, const Run& run = {});

/// The area that each point has for itself: its share of a circle that holds eight neighbors.
/// @return #P
std::vector<double> areasOfPoints(const Points& points, const Run& run = {});

/// How much larger than usual the area is that a point has for itself: 1 where that is less than
/// four times, and for points that seem to be outliers.
/// @return #P, at least 1
Eigen::VectorXd sparsityOf(const Points& points, const Run& run = {});

/// Area vectors of points whose normals are known, areasOfPoints() long. Zero where the normal is.
/// @param[in] normals  #P by 3, unit vectors or zero
Points areaVectors(const Points& points, const Points& normals, const Run& run = {});

/// Turn area vectors that point inward all together outward.
/// @param[in,out] areas  #P by 3
/// @return whether they agree on what is inside: where they do not, they are of no use, as normals
///   whose signs were never made consistent
bool turnOutward(const WindingNumbers& cloud, Points& areas, double width, const Run& run = {});

/// How points lie off the surface that they sample.
struct PointNoise
{
  Eigen::VectorXd
    Offsets;              ///< #P: along its normal, how far the middle of each point's neighbors is
  double Deviation = 0.0; ///< standard deviation of the noise, that of bends left out
};

/// By the neighbors of each point that face the same way.
/// @param[in] areas  #P by 3, area vectors
PointNoise noiseOf(const Points& points, const Points& areas, const Run& run = {});

/// The distance of neighbors if points were spread evenly on a surface as dense as the typical
/// point finds it around itself; 0 for fewer than two points.
double typicalSpacing(const Points& points, const Run& run = {});
}

#endif
