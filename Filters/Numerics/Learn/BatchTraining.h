/// Batch training, from coarse to fine networks; used by trainConformalSOM.

#ifndef ConformalBatchTraining_h
#define ConformalBatchTraining_h

#include "Base/Parallel.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Learn/Training.h"

namespace conformal
{
/// Batch learning; weights in the samples' unit (max radius 1).
///
/// From the sphere: on lattices of rising frequency up to options.Frequency. Each pass is Eq. 3 of
/// \cite Liou2008 summed over its patterns, the weights kept still meanwhile: w_i becomes the mean
/// of the patterns, weighted by h. A pattern stands for the foot point of its projection, shared by
/// the three corners of that simplex by their barycentric weights; the neighborhood function is
/// diffusion of these shares over the lattice, narrower from pass to pass. A polish ends it.
///
/// From a hull (HullStart.h): where the surface so learned has parts without patterns, or always,
/// as options.StartingShape says. Averages over neighborhoods would cut across the creases between
/// limbs and grow webs anew, so the hull is polished only, from smooth to fine.
ConformalSOMResult trainBatch(const TrainingSamples& samples, const ConformalSOMOptions& options,
  const ParallelFor& parallelFor, const Progress& progress);

/// From weights given, in the samples' unit: polished only, from smooth to fine.
ConformalSOMResult trainBatchFrom(Points weights, const TrainingSamples& samples,
  const ConformalSOMOptions& options, const ParallelFor& parallelFor, const Progress& progress);
}

#endif
