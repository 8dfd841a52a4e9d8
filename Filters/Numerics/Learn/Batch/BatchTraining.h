/// Train a self-organizing map in batches, on increasingly fine geodesic networks. Training starts
/// from the sphere. Used by trainConformalSOM().

#ifndef ConformalBatchTraining_h
#define ConformalBatchTraining_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Fit/FitOptions.h"
#include "Learn/Fit/LearnedMesh.h"
#include "Learn/Online/ReferencePoint.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Options that a caller of trainConformalSOM() may set.
struct BatchOptions
{
  int PassesPerLevel = 5; ///< number of learning passes on each network
  /// Number of samples used in a pass, per neuron; limited to all samples.
  int SamplesPerNeuron = 12;
};

struct BatchTrainingOptions : BatchOptions
{
  int Frequency = 36; ///< frequency of the finest network, see makeGeodesicSphere()
  /// Reference point of a pattern; Automatic means Affine.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;
  FitOptions Fit;
  unsigned int RandomSeed = 1;
  MeshObserver Observer; ///< function called after each level and after the fit; may be empty
};

/// Function that returns whether to continue after a level. Its arguments are the level's mesh and
/// the weight of the samples in each triangle.
using LevelTest = std::function<bool(const FittedMesh&, const std::vector<double>&)>;

/// Learn on networks of increasing frequency up to options.Frequency. No least-squares fit follows.
///
/// A pass replaces each neuron's weight vector w_i by a mean of the pass's patterns, weighted by
/// the neighborhood function h. This is Eq. 3 of \cite Liou2008, summed over the patterns with w
/// fixed. A pattern is divided among the corners of the triangle that contains its projection. The
/// fractions are the barycentric weights of the projection, or of its reference point r
/// (options.ReferencePoint). Diffusion of these fractions over the network gives the weights h. The
/// diffusion becomes narrower from pass to pass.
///
/// @param[in] goesOn  function called after each level; if empty, all levels are learned
/// @return the mesh, in the samples' unit (maximum radius 1), with the estimated noise
/// @throws NumericalFailure if goesOn returns false
/// @throws Aborted
FittedMesh learnFromSphere(const TrainingSamples& samples, const BatchTrainingOptions& options,
  const LevelTest& goesOn, const Run& run = {});

/// Learn on all levels, then fit the vertices to the samples (LeastSquaresFit.h). The fit is
/// smoother if the errors of the levels indicate noise.
/// @return the mesh in the samples' unit
/// @throws Aborted
FittedMesh trainBatch(
  const TrainingSamples& samples, const BatchTrainingOptions& options, const Run& run = {});
}

#endif
