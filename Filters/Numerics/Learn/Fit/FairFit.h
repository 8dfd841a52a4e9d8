/// Make a fitted mesh fair: remove the noise of the samples from the surface, but keep the detail
/// of the object. The amount of smoothing is found from the samples, separately for each part of
/// the surface. Own construction from published parts, since one amount of smoothing does not suit
/// both smooth and detailed parts. The parts are cross-validation \cite Craven1979 and variances by
/// expectation and maximization \cite Dempster1977.

#ifndef ConformalFairFit_h
#define ConformalFairFit_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Fit/FairEquations.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace conformal
{
struct FairFitOptions : FairSamplesOptions
{
  /// Whether each vertex is on a sharp edge of the object, #V; empty if there are no sharp edges.
  std::vector<bool> Creases;
  double Smoothness = 1.0; ///< factor of the smoothing that is found, in [1e-6, 1e6]
};

struct FairFitResult
{
  /// Standard error of each vertex along its normal, in the unit of the samples, #V.
  std::vector<double> StandardError;
  /// Number of free parameters of the surface, at most #V. Smoothing decreases this number.
  double DegreesOfFreedom = 0.0;
  /// Variance of the samples along the normals of the surface, the median over all vertices. The
  /// variance contains noise, and detail that is too fine for the mesh.
  double Variance = 0.0;
};

/// Move the vertices of a fitted mesh along their normals. The moves minimize the squared distances
/// of the samples to the surface, plus a penalty: a weight times the squared change (gradient) of
/// the mean curvature (FairEquations.h). The mean curvature of a sphere and of a cylinder does not
/// change, so that the penalty does not shrink them.
///
/// The minimum is computed twice.
///
/// 1. The first penalty has one weight, which is divided at each vertex by the squared change of
///    curvature of the fitted mesh. The weight is found by generalized cross-validation
///    \cite Craven1979, in which the surface must predict samples that are left out. The number of
///    free parameters of the surface is estimated with a random vector \cite Hutchinson1989.
/// 2. The second minimum is that of a statistical model. Noise of the samples and change of
///    curvature are independent Gaussian variables. Their variances differ from vertex to vertex. A
///    variance is the mean square near the vertex after the first solution, plus the square that is
///    expected from the uncertainty of this solution. This is one step of the EM algorithm
///    \cite Dempster1977. The variances of the change of curvature also depend on the direction, so
///    that a ridge is smoothed along the ridge, but not across.
///
/// A vertex does not move if it is in a hole of the samples or on a crease (options.Creases), or if
/// a triangle is inclined to the vertex normal by more than 66 degrees. The penalty does not couple
/// the two sides of a crease.
///
/// @param[in,out] mesh  closed mesh in the unit of the samples, fitted by least squares
/// @throws NumericalFailure if the equations cannot be solved; the mesh is then unchanged
/// @throws Aborted
/// @post the same bits for any number of threads and ranks
FairFitResult fairFit(
  const TrainingSamples& samples, const FairFitOptions& options, Mesh& mesh, const Run& run = {});
}

#endif
