/// Fairing of a fitted mesh, as smooth in each place as the samples show the object to be.

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
  std::vector<bool> Creases; ///< #V, whether a vertex is on a sharp edge; or empty
  double Smoothness = 1.0;   ///< factor of the weight that is found, in [1e-6, 1e6]
};

struct FairFitResult
{
  std::vector<double> StandardError; ///< #V, along the normals; max radius 1
  double DegreesOfFreedom = 0.0;     ///< of the surface; #V for one that is not smoothed
  /// Median over places of the samples' variance along the normal: noise, and detail that is too
  /// fine for the mesh.
  double Variance = 0.0;
};

/// Move the vertices of a fitted mesh along their normals, to minimize the squared distances of the
/// samples plus a weight times the squared change of mean curvature (FairEquations.h).
///
/// The first solution has variances of the change of curvature in proportion to those of the fitted
/// mesh. Its weight is found by generalized cross-validation \cite Craven1979, with degrees of
/// freedom from a random vector \cite Hutchinson1989. For the second solution, noise and change of
/// curvature are Gaussian, with variances that differ by position; own construction. A variance is
/// the mean around a vertex of the squares that the first solution leaves, plus those of its
/// uncertainty, as in a step of the EM algorithm \cite Dempster1977. Variances of the change also
/// differ by direction. Smooth parts are thus smoothed, and detail and ridges remain.
///
/// Vertices in holes of the data and on creases stay, and so do vertices whose triangles face too
/// differently for displacements along normals. The surface is not smoothed across creases.
///
/// @param[in,out] mesh  closed; vertices in the samples' unit, fitted by least squares
/// @throws NumericalFailure where the equations cannot be solved; the mesh is then as it was
/// @throws Aborted
/// @post the same bits for any number of threads and ranks
FairFitResult fairFit(
  const TrainingSamples& samples, const FairFitOptions& options, Mesh& mesh, const Run& run = {});
}

#endif
