/// Batch training from the sphere, on increasingly fine geodesic networks; used by
/// trainConformalSOM().

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
  int PassesPerLevel = 5;    ///< learning passes on each network, from coarse to fine
  int SamplesPerNeuron = 12; ///< samples per neuron in a pass, at most all samples
};

struct BatchTrainingOptions : BatchOptions
{
  int Frequency = 36; ///< of the finest network
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic; ///< Affine
  FitOptions Fit;
  unsigned int RandomSeed = 1;
  MeshObserver Observer; ///< called after each level and after the fit; may be empty
};

/// Return whether to continue, given the mesh of a level and the weight of the samples in each
/// triangle.
using LevelTest = std::function<bool(const FittedMesh&, const std::vector<double>&)>;

/// Learn on networks of increasing frequency up to options.Frequency, without a fit.
///
/// Each pass sums Eq. 3 of \cite Liou2008 over its patterns with fixed weights: w_i becomes the
/// mean of the patterns, weighted by h. A pattern is assigned to the corners of the triangle that
/// contains its projection. The shares are the barycentric weights of the projection, or of its
/// reference point r (options.ReferencePoint). The neighborhood function is the diffusion of these
/// shares over the network. It becomes narrower from pass to pass.
///
/// @param[in] goesOn  called after each level; empty to learn all levels
/// @return the mesh in the samples' unit (max radius 1), with its estimated noise
/// @throws NumericalFailure if goesOn returns false
/// @throws Aborted
FittedMesh learnFromSphere(const TrainingSamples& samples, const BatchTrainingOptions& options,
  const LevelTest& goesOn, const Run& run = {});

/// Learn on all levels, then fit the vertices to the samples (LeastSquaresFit.h). The fit is
/// smoother if the levels indicate noise.
/// @return the mesh in the samples' unit
/// @throws Aborted
FittedMesh trainBatch(
  const TrainingSamples& samples, const BatchTrainingOptions& options, const Run& run = {});
}

#endif
