/// Move the vertices of a sphere mesh along a smooth flow that brings landmarks to their targets.
/// Own construction: exact predicates keep every step free of folds.

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
  /// Widths of the Gaussians of the landmarks, as chords on the unit sphere. The largest width is
  /// tried first, and a smaller one if that would fold a triangle. The sequence is repeated while
  /// it makes progress.
  std::vector<double> Widths = { 0.8, 0.5, 0.3, 0.15, 0.07, 0.03, 0.015 };
  double Tolerance = 1e-9;         ///< distance at which a landmark has reached its target
  double LongestStep = 0.1;        ///< maximum step in radians
  int MaximumNumberOfSteps = 1000; ///< over all widths and repetitions
  /// Repair flipped triangles by small moves of vertices, and return whether none is left. May be
  /// empty. Called if a short step folds a triangle.
  std::function<bool(Points&)> Repair;
};

struct LandmarkFlowResult
{
  double Error = 0.0;      ///< maximum remaining distance, on the unit sphere
  Index NumberOfUnmet = 0; ///< landmarks farther than 1e-6 from their targets
};

/// Move landmarks to their targets by a flow without folds.
///
/// Each step rotates every vertex x by a vector omega(x), a sum of Gaussians at the landmarks. Its
/// coefficients are solved for so that each landmark moves straight to its target. If a triangle
/// would fold, by exact arithmetic, the nearest moving landmark gets half of its step, repeatedly
/// down to zero. The other landmarks keep their steps.
/// @param[in] triangles   #F by 3, of a map to the sphere without flipped triangles
/// @param[in] ids         landmark vertices, each once
/// @param[in] targets     one unit vector for each landmark
/// @param[in,out] places  #V by 3 unit vectors; no triangle is flipped
/// @throws Aborted
LandmarkFlowResult flowToLandmarks(const Triangles& triangles, const std::vector<int>& ids,
  const Points& targets, Points& places, const LandmarkFlowOptions& options = {},
  const Run& run = {});
}

#endif
