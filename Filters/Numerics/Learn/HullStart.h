/// A start for learning that has the object's limbs already; a part of trainConformalSOM.

#ifndef ConformalHullStart_h
#define ConformalHullStart_h

#include "Base/Parallel.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Hull/GenusZeroHull.h"

#include <optional>

namespace conformal
{
struct HullStart
{
  Points Positions; ///< #N by 3, in the samples' unit: the hull at the directions given
  HullData Data;    ///< tells samples of the object from those apart from it
  bool Leaks = false;
  Index NumberOfCutNodes = 0; ///< where handles of the hull were cut open
  Index NumberOfSamplesOutside = 0;
};

/// A genus-zero hull of the samples, thinned, mapped to the sphere without folds and resampled at
/// the directions of a lattice.
/// @param[in] directions  #N by 3 unit vectors
/// @return nothing if the hull cannot be mapped: it winds so much that the sphere has no room for
/// it
/// @throws Aborted
std::optional<HullStart> startFromHull(const TrainingSamples& samples, const Points& directions,
  const ParallelFor& parallelFor, const Progress& progress);

/// What startFromHull() takes, in nanoseconds as in Steps.
double workOfHullStart(const TrainingSamples& samples);
}

#endif
