/// Train online by the CSM Learning Algorithm of \cite Liou2008, one pattern per step. Used by
/// trainConformalSOM().

#ifndef ConformalOnlineTraining_h
#define ConformalOnlineTraining_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Fit/LearnedMesh.h"
#include "Learn/Online/ReferencePoint.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Constants of \cite Liou2008, which are options of trainConformalSOM(). Here t is the number of
/// the epoch, counted from 0.
struct OnlineOptions
{
  int NumberOfEpochs = 80;
  int SamplesPerEpoch = 8000;
  double InitialNeighborhoodRadius = 0.4; ///< sigma_0; sigma(t) = sigma_0 exp(-t / tau_1)
  double NeighborhoodTimeConstant = 20.0; ///< tau_1, in epochs
  double InitialLearningRate = 0.01;      ///< alpha_0 in [0, 1); alpha(t) = alpha_0 exp(-t / tau_2)
  double LearningRateTimeConstant = 60.0; ///< tau_2, in epochs
};

struct OnlineTrainingOptions : OnlineOptions
{
  int Frequency = 36; ///< frequency of the geodesic sphere that is the network
  /// Reference point of a pattern; Automatic means Conformal.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;
  unsigned int RandomSeed = 1;
};

/// Learn by steps 1 to 5 of \cite Liou2008, section 2. Weights are in the samples' unit (maximum
/// radius 1).
///
/// Implementation note: priorities are used in the second half of the epochs only, when the
/// neighborhood is narrow. In the first half, priorities would leave too few neurons for the rest
/// of the object.
/// @param[in] network  geodesic sphere of options.Frequency: positions n_i, and triangles
/// @param[in] start    initial weights w_i(0)
/// @throws Aborted
LearnedMesh trainOnline(const TrainingSamples& samples, const Mesh& network, const Points& start,
  const OnlineTrainingOptions& options, const Run& run = {});
}

#endif
