/// Move the vertices of a sphere mesh by a smooth flow that brings landmarks to their targets.
/// Landmarks are selected vertices of the mesh.
///
/// Own construction, not from a publication: each step of the flow is tested for folded triangles
/// by exact predicates. Inexact tests could miss folds because of rounding.

#ifndef ConformalLandmarkFlow_h
#define ConformalLandmarkFlow_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Options of flowToLandmarks().
struct LandmarkFlowOptions
{
  /// Widths of the Gaussian functions of which the flow is composed, as chords on the unit sphere.
  /// The widths are used one after the other, from large to small. The next width is used if the
  /// present width cannot bring the landmarks closer to their targets. After the last width, the
  /// first one is used again if the total distance has decreased by at least 5 percent.
  std::vector<double> Widths = { 0.8, 0.5, 0.3, 0.15, 0.07, 0.03, 0.015 };
  double Tolerance = 1e-9;         ///< distance below which a landmark has reached its target
  double LongestStep = 0.1;        ///< maximum rotation of a landmark in a step, in radians
  int MaximumNumberOfSteps = 1000; ///< total number of steps, over all widths
  /// Function that repairs flipped triangles by small moves of vertices, and returns whether none
  /// is left. The function is called if a step folds triangles even though the step was shortened
  /// to a quarter. May be empty.
  std::function<bool(Points&)> Repair;
};

/// Remaining distances between landmarks and targets.
struct LandmarkFlowResult
{
  double Error = 0.0;      ///< maximum distance of a landmark from its target, on the unit sphere
  Index NumberOfUnmet = 0; ///< number of landmarks more than 1e-6 from their targets
};

/// Move landmarks to their targets by a flow that folds no triangle.
///
/// Let omega(x) be a vector field on the sphere, a sum of Gaussian functions centered at the
/// landmarks. Each step rotates every vertex x by the rotation vector omega(x). The coefficients of
/// the sum solve linear equations, so that every landmark moves straight toward its target.
///
/// If a step would fold a triangle, a landmark near this triangle is slowed down. This is the
/// nearest landmark that has not reached its target. The step of the landmark is halved, repeatedly
/// if necessary and finally to zero. The steps of the other landmarks do not change.
/// @param[in] triangles   #F by 3, triangles of a map to the sphere
/// @param[in] ids         ids of the landmark vertices; no id is repeated
/// @param[in] targets     target of each landmark: one unit vector per row
/// @param[in,out] places  #V by 3 unit vectors, the vertices of the sphere mesh. No triangle is
///   flipped before or after the call.
/// @throws Aborted
LandmarkFlowResult flowToLandmarks(const Triangles& triangles, const std::vector<int>& ids,
  const Points& targets, Points& places, const LandmarkFlowOptions& options = {},
  const Run& run = {});
}

#endif
