/// Moves the vertices of a sphere mesh along a smooth flow that brings landmarks to their targets.
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
  /// Chords over which a landmark carries its surroundings along, tried one after the other: the
  /// widest first, a narrower one where that would fold a triangle; again from the widest as long
  /// as that is worth it.
  std::vector<double> Widths = { 0.8, 0.5, 0.3, 0.15, 0.07, 0.03, 0.015 };
  double Tolerance = 1e-9;         ///< distance at which a landmark has reached its target
  double LongestStep = 0.1;        ///< radians
  int MaximumNumberOfSteps = 1000; ///< in all
  /// Remove flipped triangles by moving vertices a little, and return whether none is left; may be
  /// empty. Tried where a short step folds.
  std::function<bool(Points&)> Repair;
};

struct LandmarkFlowResult
{
  double Error = 0.0;      ///< largest distance that is left, on the unit sphere
  Index NumberOfUnmet = 0; ///< landmarks farther from their targets than a millionth
};

/// Each step turns every vertex x by a vector omega(x), a sum of Gaussians at the landmarks, solved
/// for so that each of them goes straight to its target. Where a triangle would fold, by exact
/// arithmetic, the nearest landmark that is on its way goes on by half as much, down to none, and
/// the others get theirs.
/// @param[in] triangles   #F by 3, of a map to the sphere without flipped triangles
/// @param[in] ids         of the vertices that are landmarks, each once
/// @param[in] targets     one unit vector for each
/// @param[in,out] places  #V by 3 unit vectors; no triangle is flipped
/// @throws Aborted
LandmarkFlowResult flowToLandmarks(const Triangles& triangles, const std::vector<int>& ids,
  const Points& targets, Points& places, const LandmarkFlowOptions& options = {},
  const Run& run = {});
}

#endif
