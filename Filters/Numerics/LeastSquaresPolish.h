/// The best vertices a flat triangle mesh can have; the last part of batch training.

#ifndef ConformalLeastSquaresPolish_h
#define ConformalLeastSquaresPolish_h

#include "ConformalSOM.h"

#include <functional>
#include <vector>

namespace conformal
{
struct PolishOptions
{
  int NumberOfRounds = 10;
  double FirstSmoothness = 0.01; ///< in the first round, then falling in equal ratios
  double LastSmoothness = 0.01;  ///< in the last round
  int RelaxedRounds = 0;         ///< rounds before which neurons move half-way to the middle of
                                 ///< their neighbours, along the surface
  bool AutomaticPriority = true; ///< samples count in proportion to their distance, within limits
  std::function<bool(const Vector3&)> Belongs; ///< whether a sample counts at all; may be empty
};

/// So many times: the foot point of every sample on the surface, then the weights w that minimise
/// sum p |B w - x|^2 + lambda |L w|^2,  where B holds the feet's barycentric weights, L is the
/// uniform Laplacian of the lattice and lambda is the smoothness times the mean weight of the
/// samples of a neuron. The priority p of a sample is its weight and, with AutomaticPriority, its
/// distance in units of the root mean square, between 0.3 and 2.8: tips that a least-squares fit
/// would cut off have a say. Samples more than six times as far as the
/// root mean square around them are outliers and left out.
///
/// @param[in,out] result  weights in the samples' unit, and the history, one record a round
/// @return for each triangle the weight of the samples that have their feet in it in the last
///         round; zeros if there is none
std::vector<double> polish(const TrainingSamples& samples, const PolishOptions& options,
  const ParallelFor& parallelFor, const Progress& progress, ConformalSOMResult& result);
}

#endif
