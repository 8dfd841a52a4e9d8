/// Measure the angle, area and quasi-conformal distortion of a map from a triangle mesh to the
/// sphere, \cite Floater2005.

#ifndef ConformalDistortion_h
#define ConformalDistortion_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Distortion of each triangle, and a summary. A triangle is degenerate if it has no area on the
/// mesh or on the sphere. Degenerate triangles get the values of undistorted ones, and are left out
/// of the summary.
struct Distortion
{
  /// #F: mean absolute change of the angles at the three corners, in degrees.
  std::vector<double> AngleDistortion;
  /// #F: logarithm of the triangle's fraction of the sphere's area divided by its fraction of the
  /// mesh's area.
  std::vector<double> AreaDistortion;
  /// #F: K >= 1, the ratio of the larger to the smaller singular value of the triangle's map.
  std::vector<double> QuasiConformalError;
  double MeanAngleDistortion = 0.0;
  double MeanQuasiConformalError = 1.0;
  double AreaDistortionDeviation = 0.0; ///< standard deviation of AreaDistortion
  /// Number of times that the map covers the sphere; negative for a mirrored map.
  double SphereDegree = 0.0;
  /// Triangles oriented against most of the area, or without area on the sphere.
  Index NumberOfFlippedTriangles = 0;
  Index NumberOfZeroAreaTriangles = 0;
};

/// Measure the distortion of a map to the sphere. On each triangle of the mesh, the map is linear;
/// its image is the flat triangle between the sphere positions of the vertices.
///
/// K = 1 and AngleDistortion = 0 for a conformal map; AreaDistortion = 0 everywhere for an
/// equal-area map.
///
/// @param[in] points           #V by 3, finite
/// @param[in] triangles        #F by 3 ids in [0, #V)
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument if points are not finite or the sizes differ
Distortion measureDistortion(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const Run& run = {});
}

#endif
