/// Train a self-organizing map online, with one sample (pattern) per step. The algorithm is the CSM
/// Learning Algorithm of \cite Liou2008.

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
/// Constants of \cite Liou2008, which are also options of trainConformalSOM(). Training consists of
/// epochs, each of many steps. In a step, a sample moves neurons, the vertices of the mesh that is
/// learned. Here t is the number of the epoch, counted from 0.
struct OnlineOptions
{
  int NumberOfEpochs = 80;
  int SamplesPerEpoch = 8000; ///< number of steps in an epoch; each step uses one sample
  /// Initial neighborhood radius sigma_0, a length on the unit sphere. Within about this distance,
  /// neurons move together. The radius of epoch t is sigma_0 exp(-t / tau_1).
  double InitialNeighborhoodRadius = 0.4;
  double NeighborhoodTimeConstant = 20.0; ///< time constant tau_1 of the radius, in epochs
  /// Initial learning rate alpha_0, the factor of moves toward a sample, in [0, 1). The learning
  /// rate of epoch t is alpha_0 exp(-t / tau_2).
  double InitialLearningRate = 0.01;
  double LearningRateTimeConstant = 60.0; ///< time constant tau_2 of the learning rate, in epochs
};

/// All options of online training.
struct OnlineTrainingOptions : OnlineOptions
{
  int Frequency = 36; ///< frequency of the geodesic sphere that is the network
  /// Kind of reference point: the point on the unit sphere around which a pattern moves neurons,
  /// see ReferencePoint.h. Automatic means Conformal.
  conformal::ReferencePoint ReferencePoint = conformal::ReferencePoint::Automatic;
  unsigned int RandomSeed = 1; ///< seed of the selection of samples
};

/// Learn by steps 1 to 5 of \cite Liou2008, section 2. The network is a mesh on the unit sphere
/// whose vertices are the neurons. Each neuron has a weight vector, its position in space. Weight
/// vectors are in the samples' unit (maximum radius 1).
///
/// Implementation note: samples can have priorities, which are given with the samples. In the
/// second half of the epochs, samples are drawn with probabilities proportional to their
/// priorities. In the first half, all samples have equal probabilities. With priorities from the
/// beginning, too few neurons would represent parts of the surface where samples have low
/// priorities.
/// @param[in] network  geodesic sphere of options.Frequency: positions n_i, and triangles
/// @param[in] start    initial weight vectors w_i(0)
/// @throws Aborted
LearnedMesh trainOnline(const TrainingSamples& samples, const Mesh& network, const Points& start,
  const OnlineTrainingOptions& options, const Run& run = {});
}

#endif
