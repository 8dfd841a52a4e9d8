/// Angle, area and quasi-conformal distortion of a map from a triangle mesh to the sphere, \cite
/// Floater2005.

#ifndef ConformalDistortion_h
#define ConformalDistortion_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Distortion of each triangle, and a summary of all but the degenerate ones. A triangle is
/// degenerate if it has no area on the mesh or on the sphere; it counts as undistorted.
struct Distortion
{
  /// #F: mean change of the angles of the corners [degrees]
  std::vector<double> AngleDistortion;
  std::vector<double> AreaDistortion;      ///< #F: log of the ratio of the shares of the total area
  std::vector<double> QuasiConformalError; ///< #F: K >= 1, ratio of the singular values
  double MeanAngleDistortion = 0.0;
  double MeanQuasiConformalError = 1.0;
  double AreaDistortionDeviation = 0.0; ///< standard deviation
  /// Number of times the sphere is covered; negative if mirrored
  double SphereDegree = 0.0;
  Index NumberOfFlippedTriangles = 0; ///< oriented against most of the area, or flat
  Index NumberOfZeroAreaTriangles = 0;
};

/// Measure the linear maps from the triangles of a mesh to the flat triangles between their
/// vertices on the sphere.
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
