/// Learning from many patterns at a time, from coarse to fine; a part of trainConformalSOM.

#ifndef ConformalBatchTraining_h
#define ConformalBatchTraining_h

#include "ConformalSOM.h"

namespace conformal
{
/// Batch learning on lattices of rising frequency up to options.Frequency; weights in the samples'
/// unit (max radius 1).
///
/// Each pass is Eq. 3 of \cite Liou2008 summed over its patterns, the weights kept still meanwhile:
/// w_i becomes the mean of the patterns, weighted by h. A pattern stands for the foot point of its
/// projection, shared by the three corners of that simplex by their barycentric weights; the
/// neighbourhood function is diffusion of these shares over the lattice, narrower from pass to
/// pass.
ConformalSOMResult trainBatch(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const ParallelFor& parallelFor, const Progress& progress);
}

#endif
