/// Classify grid nodes as inside or outside of a point cloud that may have holes.
/// Basins of the distance are merged by their persistence, \cite Edelsbrunner2002.

#ifndef ConformalDistanceBasins_h
#define ConformalDistanceBasins_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Hole in the data: the pass of the distance between a closed basin and the outside.
struct DataHole
{
  double Saddle = 0.0; ///< distance to the data at the widest point of the hole; 0 for none
  double Peak = 0.0;   ///< maximum distance to the data within the basin behind the hole
};

struct OutsideNodes
{
  std::vector<std::uint8_t> Outside; ///< 1 for each node that is outside
  DataHole LargestHole;              ///< largest of the closed holes
  bool Leaks = false; ///< almost no node passed the persistence test; the likeliest basin was kept
};

/// Classify the nodes of a grid as outside of a cloud, or as inside or within an offset of the
/// data.
///
/// The nodes farther than the offset from the data form basins, one for each local maximum (peak)
/// of the distance. Basins are merged from the highest saddle down, in the order of a watershed
/// transform. A basin that reaches the outside is merged into it unless its peak exceeds
/// `persistence` times the saddle. A hole much wider than the offset is therefore closed if the
/// cavity behind it is wider still.
///
/// If almost no node is inside by this rule, the cloud leaks: a hole is about as wide as the cavity
/// behind it. One basin is then classified as inside. Candidates rise at least a tenth above their
/// saddle to the outside, and have data in two thirds of all directions from their peak. The
/// candidate with the largest rise is selected.
///
/// @param[in,out] distances  of each node, in any unit; nodes on the faces of the grid are always
///   outside and are set to the largest float
/// @param[in] offset         in the unit of the distances
/// @param[in] persistence    at least 1
OutsideNodes findOutside(const FreudenthalGrid& grid, std::vector<float>& distances, double offset,
  double persistence, const Run& run = {});
}

#endif
