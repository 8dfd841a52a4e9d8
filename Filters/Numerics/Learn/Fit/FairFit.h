/// Make a fitted mesh fair: remove the noise of the samples from the surface, but keep the detail
/// of the object. The amount of smoothing is found from the samples, separately for each part of
/// the surface. One amount of smoothing does not suit both smooth and detailed parts of an object.
/// The method is an own construction, which combines published methods. Generalized
/// cross-validation \cite Craven1979 selects the smoothing. The EM (expectation-maximization)
/// algorithm \cite Dempster1977 estimates variances.

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
/// Options of fairFit().
struct FairFitOptions : FairSamplesOptions
{
  /// Whether each vertex is on a sharp edge of the object, #V; empty if there are no sharp edges.
  std::vector<bool> Creases;
  /// Factor of the penalty's weight in the second step of fairFit(), in [1e-6, 1e6]. A larger
  /// factor makes the surface smoother.
  double Smoothness = 1.0;
};

/// Measures of the surface that fairFit() makes.
struct FairFitResult
{
  /// Standard error of each vertex along its normal, in the unit of the samples, #V.
  std::vector<double> StandardError;
  /// Number of free parameters of the surface, at most #V. Smoothing decreases this number.
  double DegreesOfFreedom = 0.0;
  /// Variance of the distances between samples and surface. A variance is estimated at each vertex,
  /// and this value is the median. The distances are due to noise, and to detail that is too fine
  /// for the mesh.
  double Variance = 0.0;
};

/// Move the vertices of a fitted mesh along their normals. The moves minimize the squared distances
/// of the samples to the surface, plus a penalty. The penalty is a weight times the squared
/// gradient of the mean curvature, summed over the surface (FairEquations.h). On spheres and
/// cylinders, the mean curvature is constant, so that the penalty does not shrink these shapes.
///
/// The minimum is computed twice, in two steps with different penalties:
///
/// 1. In the first step, a single weight is used. At each vertex, the penalty is divided by the
///    squared gradient of curvature of the fitted mesh near the vertex. The weight is selected by
///    generalized cross-validation \cite Craven1979. Cross-validation estimates how well the
///    surface predicts samples that are left out. For this estimate, the number of free parameters
///    of the surface is computed with a random vector \cite Hutchinson1989.
/// 2. The second step uses a statistical model. In this model, the noise of the samples and the
///    gradient of curvature are independent Gaussian variables. The variances of the variables
///    differ from vertex to vertex. Each variance is the mean square of its variable near the
///    vertex, computed from the surface of the first step. The surface of the first step is
///    uncertain. The expected square of its error is added to each variance. Computing the
///    variances is one step of the EM algorithm \cite Dempster1977. The variances of the gradient
///    also depend on the direction. Along a ridge, the variance is small, and the surface is
///    smoothed. Across the ridge, the variance is large, and the ridge is kept.
///
/// Three kinds of vertices are held near their positions:
/// - vertices in holes of the samples,
/// - vertices on creases, the sharp edges of the object (options.Creases),
/// - vertices with a steep triangle, whose normal and the vertex normal differ by more than 66
///   degrees.
///
/// Across a crease, the penalty has almost no weight.
///
/// @param[in,out] mesh  closed mesh in the unit of the samples, fitted by least squares
/// @throws NumericalFailure if the equations cannot be solved; the mesh is then unchanged
/// @throws Aborted
/// @post The result does not depend on the number of threads or ranks (processes), bit by bit.
FairFitResult fairFit(
  const TrainingSamples& samples, const FairFitOptions& options, Mesh& mesh, const Run& run = {});
}

#endif
