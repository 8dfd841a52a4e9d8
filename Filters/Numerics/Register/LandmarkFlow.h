/// Move the vertices of a sphere mesh by a smooth flow that brings landmarks to their targets. Own
/// construction: each step is tested by exact predicates, because rounding must not hide folds.

#ifndef ConformalLandmarkFlow_h
#define ConformalLandmarkFlow_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace conformal
{
struct LandmarkFlowOptions
{
  /// Widths of the Gaussians of the landmarks, as chords on the unit sphere. The widths are used
  /// from large to small; the next one is used if a step would fold a triangle. The sequence is
  /// repeated while landmarks come closer to their targets.
  std::vector<double> Widths = { 0.8, 0.5, 0.3, 0.15, 0.07, 0.03, 0.015 };
  double Tolerance = 1e-9;         ///< distance at which a landmark has reached its target
  double LongestStep = 0.1;        ///< maximum rotation of a vertex in a step, in radians
  int MaximumNumberOfSteps = 1000; ///< total over all widths and repetitions
  /// Function that repairs flipped triangles by small moves of vertices, and returns whether none
  /// is left. It is called if a short step folds a triangle. May be empty.
  std::function<bool(Points&)> Repair;
};

struct LandmarkFlowResult
{
  double Error = 0.0;      ///< maximum distance of a landmark from its target, on the unit sphere
  Index NumberOfUnmet = 0; ///< number of landmarks farther than 1e-6 from their targets
};

/// Move landmarks to their targets by a flow without folds.
///
/// Each step rotates every vertex x by a vector omega(x), a sum of Gaussians at the landmarks. The
/// coefficients of the sum are the solution of linear equations, by which each landmark moves
/// straight to its target. If a triangle would fold, by exact arithmetic, the step of the nearest
/// moving landmark is halved, repeatedly if necessary and finally to zero. The other landmarks keep
/// their steps.
/// @param[in] triangles   #F by 3, triangles of a map to the sphere
/// @param[in] ids         ids of the landmark vertices, without repetition
/// @param[in] targets     one unit vector for each landmark
/// @param[in,out] places  #V by 3 unit vectors, without flipped triangles before and after
/// @throws Aborted
LandmarkFlowResult flowToLandmarks(const Triangles& triangles, const std::vector<int>& ids,
  const Points& targets, Points& places, const LandmarkFlowOptions& options = {},
  const Run& run = {});
}

#endif
