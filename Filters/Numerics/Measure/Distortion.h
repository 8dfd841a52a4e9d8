/// Measure the angle, area and quasi-conformal distortion of a map from a triangle mesh to the
/// sphere, \cite Floater2005.

#ifndef ConformalDistortion_h
#define ConformalDistortion_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <array>
#include <vector>

namespace conformal
{
/// Compute the quasi-conformal error K of the linear map from one triangle to another: the ratio of
/// the larger to the smaller singular value. The result is not finite if a triangle has no area.
double quasiConformalError(const std::array<Vector3, 3>& from, const std::array<Vector3, 3>& to);

/// Distortion of each triangle, and a summary. A triangle is degenerate if its area on the mesh or
/// on the sphere is 0. Degenerate triangles get the values of undistorted triangles, and are left
/// out of the summary.
struct Distortion
{
  /// Mean absolute change of the three angles of each triangle, #F [degrees].
  std::vector<double> AngleDistortion;
  /// Logarithm of the area ratio of each triangle, #F. The ratio is the triangle's fraction of the
  /// total area on the sphere, divided by its fraction of the area of the mesh.
  std::vector<double> AreaDistortion;
  /// Quasi-conformal error K of each triangle, at least 1, #F. K is the ratio of the larger to the
  /// smaller singular value of the map of the triangle.
  std::vector<double> QuasiConformalError;
  double MeanAngleDistortion = 0.0;
  double MeanQuasiConformalError = 1.0;
  double MaximumQuasiConformalError = 1.0;
  /// Mean of QuasiConformalError, weighted by the areas of the triangles of the mesh. A few thin
  /// triangles hardly change this mean.
  double AreaMeanQuasiConformalError = 1.0;
  double AreaDistortionDeviation = 0.0; ///< standard deviation of AreaDistortion
  /// Number of times that the map covers the sphere, usually 1. If the map is mirrored, the number
  /// is negative.
  double SphereDegree = 0.0;
  /// Number of triangles that are flipped or have no area on the sphere. A triangle is flipped if
  /// its orientation on the sphere is opposite to the orientation of most of the area.
  Index NumberOfFlippedTriangles = 0;
  Index NumberOfZeroAreaTriangles = 0;
};

/// Measure the distortion of a map to the sphere. The map is linear on each triangle of the mesh.
/// The image of a triangle is the flat triangle between the sphere positions of the vertices.
///
/// For a conformal map, QuasiConformalError is 1 and AngleDistortion is 0 everywhere. For an
/// equal-area map, AreaDistortion is 0 everywhere.
///
/// @param[in] points  positions of the vertices in space, #V by 3, finite
/// @param[in] triangles  #F by 3 ids in [0, #V)
/// @param[in] spherePositions  positions of the vertices on the sphere, #V by 3 unit vectors
/// @throws std::invalid_argument if points are not finite, or if the numbers of points and sphere
///   positions differ
Distortion measureDistortion(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const Run& run = {});
}

#endif
