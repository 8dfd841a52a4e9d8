/// Classifies grid nodes as inside or outside of a point cloud that may have holes.
/// Persistence of \cite Edelsbrunner2002.

#ifndef ConformalDistanceBasins_h
#define ConformalDistanceBasins_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// A pass between what was taken for inside and the outside: a hole in the data.
struct DataHole
{
  double Saddle = 0.0; ///< distance to the data at the widest place of the hole; 0 for none
  double Peak = 0.0;   ///< largest distance to the data in what it leads to
};

struct OutsideNodes
{
  std::vector<std::uint8_t> Outside; ///< 1 for each node that is outside
  DataHole LargestHole;              ///< that was closed
  bool Leaks = false; ///< next to nothing passed the test of persistence; the likeliest was taken
};

/// Tell the nodes outside of a cloud from those inside and those closer to it than an offset.
///
/// The nodes beyond the offset fall into basins, each a hill of the distance with its peak. Basins
/// are joined from the highest saddle down, in the order of a watershed transform. One that meets
/// the outside becomes part of it unless it is persistent: unless its peak is more than
/// `persistence` times as high as the saddle. So a hole in the data is closed though it is much
/// wider than the offset, if what it opens into is wider still.
///
/// Where next to nothing is inside by this rule, the cloud leaks: a hole is about as wide as what
/// it opens into. Then the basin is taken for inside that rises highest above its saddle to the
/// outside, among those that rise by a tenth and from whose peak data are seen in two thirds of all
/// directions.
///
/// @param[in,out] distances  of each node, in any unit; those of the grid's faces are set to the
///                           largest float, since they are outside whatever they are
/// @param[in] offset         in the unit of the distances
/// @param[in] persistence    at least 1
OutsideNodes findOutside(const FreudenthalGrid& grid, std::vector<float>& distances, double offset,
  double persistence, const Run& run = {});
}

#endif
