/// Least-squares fit of the vertices of a triangle mesh to samples; the last stage of batch
/// training.

#ifndef ConformalLeastSquaresPolish_h
#define ConformalLeastSquaresPolish_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Training.h"
#include "Search/TriangleTree.h"

#include <functional>
#include <memory>
#include <vector>

namespace conformal
{
struct PolishOptions
{
  int NumberOfRounds = 10;
  double FirstSmoothness = 0.01;               ///< in the first round, then falling in equal ratios
  double LastSmoothness = 0.01;                ///< in the last round
  double Evenness = 1.0;                       ///< of triangles, see SurfaceEquations.h
  double OutlierRatio = 6.0;                   ///< see LocalScale.h
  bool AutomaticPriority = true;               ///< see below
  std::shared_ptr<const TriangleTree> Guide;   ///< see below; may be null
  Index SamplesPerRound = 1000000;             ///< others in each round, where there are more
  unsigned int RandomSeed = 1;                 ///< which these are
  std::function<bool(const Vector3&)> Belongs; ///< whether a sample counts at all; may be empty
};

/// In each round: the foot point of every sample on the surface, then the weights w that meet the
/// samples best in the sense of SurfaceEquations.h, the stiffness being the smoothness times the
/// mean weight of the samples of a neuron. Stiffer are neurons without samples around, whose part
/// of the surface is drawn straight across, and in the last rounds those in folds.
///
/// Samples much farther from the surface than those around them are left out (LocalScale.h).
///
/// With AutomaticPriority
/// - a sample counts in proportion to its distance in units of the root mean square, between 0.3
///   and 2.8: tips that a least-squares fit would cut off have a say;
/// - where there is no guide, a neuron without samples is drawn along its normal to the nearest one
///   that lies there, and so lids over hollows come down.
///
/// A guide is a surface that knows what samples far from each other imply: neurons between them are
/// drawn along their normals to it, lightly. Those over holes more than eight edges wide are then
/// not drawn anywhere.
///
/// @param[in,out] result  weights in the samples' unit, and the history, one record a round
/// @return for each triangle the weight of the samples that have their feet in it in the last
///         round; zeros if there is none
/// @throws Aborted
std::vector<double> polish(const TrainingSamples& samples, const PolishOptions& options,
  ConformalSOMResult& result, const Run& run = {});

/// What polish() takes, in nanoseconds as in Steps.
double workOfPolish(
  const TrainingSamples& samples, const PolishOptions& options, Index numberOfNeurons);
}

#endif
