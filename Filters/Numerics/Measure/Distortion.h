/// Angle, area and quasi-conformal distortion of a map from a triangle mesh to the sphere.

#ifndef ConformalDistortion_h
#define ConformalDistortion_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Of each triangle, and of all but the degenerate ones in summary. Degenerate is a triangle that
/// has no area on the mesh or on the sphere, so that no ratio can be formed; it counts as
/// undistorted.
struct Distortion
{
  std::vector<double> AngleDistortion;     ///< #F: mean change of the corners' angles, degrees
  std::vector<double> AreaDistortion;      ///< #F: log of the ratio of the shares of all area
  std::vector<double> QuasiConformalError; ///< #F: K >= 1, ratio of the singular values
  double MeanAngleDistortion = 0.0;
  double MeanQuasiConformalError = 1.0;
  double AreaDistortionDeviation = 0.0; ///< standard deviation
  double SphereDegree = 0.0;            ///< how often the sphere is covered; below 0 if mirrored
  Index NumberOfFlippedTriangles = 0;   ///< oriented unlike most of the area, or flat
  Index NumberOfZeroAreaTriangles = 0;
};

/// Measure the linear maps between the triangles of a mesh and the flat triangles of chords
/// between their places on the sphere.
///
/// K = 1 and AngleDistortion = 0 mean conformal, AreaDistortion = 0 everywhere means equal in area.
///
/// @param[in] points           #V by 3, finite
/// @param[in] triangles        #F by 3 ids in [0, #V)
/// @param[in] spherePositions  #V by 3 unit vectors
/// @throws std::invalid_argument if points are not finite or the sizes differ
Distortion measureDistortion(const PointView& points, const Triangles& triangles,
  const Points& spherePositions, const Run& run = {});
}

#endif
