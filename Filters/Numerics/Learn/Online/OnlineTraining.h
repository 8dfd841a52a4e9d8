/// Online training by the CSM Learning Algorithm; used by trainConformalSOM().

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
/// Constants of the paper, options of trainConformalSOM(). t counts epochs from 0.
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
  int Frequency = 36; ///< of the geodesic sphere that is the network
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic; ///< Conformal
  unsigned int RandomSeed = 1;
};

/// Learn by steps 1 to 5 of \cite Liou2008, section 2. Weights are in the samples' unit (max radius
/// 1).
///
/// Implementation note: priorities are used in the second half of the epochs only, when the
/// neighborhood is narrow. In the first half, they would leave too few neurons for the rest of the
/// object.
/// @param[in] network  n_i and triangles, a geodesic sphere of options.Frequency
/// @param[in] start    w_i(0)
/// @throws Aborted
LearnedMesh trainOnline(const TrainingSamples& samples, const Mesh& network, const Points& start,
  const OnlineTrainingOptions& options, const Run& run = {});
}

#endif
