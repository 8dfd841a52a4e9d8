/// Move the vertices of a sphere mesh by a smooth flow that brings landmarks to their targets.
/// Landmarks are selected vertices of the mesh. Each landmark has a target, a position on the
/// sphere.
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
  /// The flow is a sum of Gaussian functions of the distance from each landmark. A width is the
  /// standard deviation of the Gaussian functions, as a chord length of the unit sphere. The widths
  /// are used one after the other, from large to small. The next width is used if steps with the
  /// present width do not bring the landmarks closer to their targets. After the last width, the
  /// sequence of widths is repeated. The repetition ends if a sequence reduced the sum of the
  /// landmarks' distances from their targets by less than 5 percent.
  std::vector<double> Widths = { 0.8, 0.5, 0.3, 0.15, 0.07, 0.03, 0.015 };
  /// A landmark has reached its target if its distance from the target is at most Tolerance, on the
  /// unit sphere.
  double Tolerance = 1e-9;
  double LongestStep = 0.1;        ///< maximum rotation of a landmark in a step, in radians
  int MaximumNumberOfSteps = 1000; ///< total number of steps, over all widths
  /// Function that repairs folded triangles by small moves of vertices; may be empty. If a step
  /// folds triangles, the moves of nearby landmarks are halved, see flowToLandmarks(). The function
  /// is called when these moves are a quarter of their full length or less, but triangles are still
  /// folded. The argument contains the vertices after the shortened step. The function returns true
  /// if it has repaired all triangles. If the function returns false, the moves are halved again.
  std::function<bool(Points&)> Repair;
};

/// Remaining distances between landmarks and targets.
struct LandmarkFlowResult
{
  double Error = 0.0;      ///< maximum distance of a landmark from its target, on the unit sphere
  Index NumberOfUnmet = 0; ///< number of landmarks farther than 1e-6 from their targets
};

/// Move landmarks to their targets by a flow that folds no triangle. A triangle is folded if it is
/// clockwise on the sphere seen from outside, or has zero area.
///
/// Let omega(x) be a vector field on the sphere. The field is a sum of Gaussian functions centered
/// at the landmarks, with vectors as coefficients. Each step rotates every vertex x by the rotation
/// vector omega(x). The coefficients are computed from linear equations. With these coefficients,
/// every landmark moves along a great circle toward its target.
///
/// A landmark is called active if it has not reached its target. If a step would fold a triangle,
/// the active landmark nearest to the triangle is moved less. The step of this landmark is halved
/// until no triangle is folded, or options.Repair succeeds. If 1/64 of the step still folds a
/// triangle, the landmark is not moved. The steps of the other landmarks keep their length.
/// @param[in] triangles   #F by 3, triangles of a map to the sphere
/// @param[in] ids         ids of the landmark vertices; no id is repeated
/// @param[in] targets     target of each landmark: one unit vector per row
/// @param[in,out] places  #V by 3 unit vectors, the vertices of the sphere mesh. Precondition: no
///   triangle is folded. The result has no folded triangle, either.
/// @throws Aborted
LandmarkFlowResult flowToLandmarks(const Triangles& triangles, const std::vector<int>& ids,
  const Points& targets, Points& places, const LandmarkFlowOptions& options = {},
  const Run& run = {});
}

#endif
