/// Initial surface for learning, from a hull of the samples; used by trainConformalSOM.

#ifndef ConformalHullStart_h
#define ConformalHullStart_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Cloud/TrainingSamples.h"
#include "Hull/GenusZeroHull.h"
#include "Search/TriangleTree.h"

#include <memory>
#include <optional>

namespace conformal
{
/// Of a hull as fine as the samples are dense, in units of the largest radius. Winding numbers see
/// no gaps between samples on a grid that is finer than these are dense.
/// @param[in] minimumSpacing  where the grid need not be as fine
double hullSpacing(
  const TrainingSamples& samples, HullIndicator indicator, double minimumSpacing = 0.0);

/// A genus-zero hull of the samples, on a grid of hullSpacing().
/// @param[in] indicator       how its inside is told from the outside
/// @throws Aborted
GenusZeroHullResult makeHull(
  const TrainingSamples& samples, double minimumSpacing, HullIndicator indicator, const Run& run);

/// What makeHull() takes, in nanoseconds as in Steps, and how many vertices it makes of a usual
/// object.
double workOfHull(const TrainingSamples& samples, double spacing, HullIndicator indicator);
double verticesOfHull(double spacing);

struct HullStart
{
  Points Positions; ///< #N by 3, in the samples' unit: the hull at the directions given
  HullData Data;    ///< tells samples of the object from those apart from it
  std::shared_ptr<const TriangleTree> Guide; ///< the hull, where winding numbers told its inside
  HullIndicator Indicator = HullIndicator::Distance; ///< what was used
  bool NormalsUsed = false;                          ///< see GenusZeroHullResult
  bool Leaks = false;
  double CutFraction = 0.0; ///< see cutFraction()
  Index NumberOfSamplesOutside = 0;
};

/// The hull thinned, mapped to the sphere without folds and resampled at the directions of a grid.
/// @param[in] directions  #N by 3 unit vectors
/// @return nothing if the hull cannot be mapped: it winds so much that the sphere has no room for
/// it
/// @throws Aborted
std::optional<HullStart> startFromHull(const TrainingSamples& samples, const Points& directions,
  HullIndicator indicator, const Run& run);

/// What startFromHull() takes, in nanoseconds as in Steps.
double workOfHullStart(const TrainingSamples& samples, HullIndicator indicator);
}

#endif
