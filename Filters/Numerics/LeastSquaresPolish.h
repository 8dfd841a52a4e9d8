/// The best vertices a flat triangle mesh can have; the last part of batch training.

#ifndef ConformalLeastSquaresPolish_h
#define ConformalLeastSquaresPolish_h

#include "ConformalSOM.h"

namespace conformal
{
/// options.NumberOfPolishRounds times: the foot point of every sample on the surface, then the
/// weights w that minimise  sum |B w - x|^2 + lambda |L w|^2,  where B holds the feet's barycentric
/// weights, L is the uniform Laplacian of the lattice and lambda is options.Smoothness times the
/// mean weight of the samples of a neuron.
///
/// @param[in,out] result  weights in the samples' unit, and the history, one record a round
void polish(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const ParallelFor& parallelFor, const Progress& progress, ConformalSOMResult& result);
}

#endif
