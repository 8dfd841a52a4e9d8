/// Classify grid nodes as inside or outside of a point cloud that may have holes. Basins of the
/// distance to the data are merged by their persistence, \cite Edelsbrunner2002.

#ifndef ConformalDistanceBasins_h
#define ConformalDistanceBasins_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Hole in the data between a closed basin of the distance and the outside.
struct DataHole
{
  /// Distance to the data at the saddle in the hole, about the hole's radius; 0 for no hole.
  double Saddle = 0.0;
  double Peak = 0.0; ///< maximum distance to the data in the basin behind the hole
};

struct OutsideNodes
{
  std::vector<std::uint8_t> Outside; ///< 1 for each node that is outside
  DataHole LargestHole;              ///< largest hole that was closed
  /// Whether almost no node passed the persistence test, so that the likeliest basin was kept as
  /// inside.
  bool Leaks = false;
};

/// Classify the nodes of a grid. A node is either outside of a cloud, or it is inside or within an
/// offset of the data.
///
/// The nodes farther than the offset from the data form basins, one for each local maximum (peak)
/// of the distance. Basins are merged from the highest saddle down, in the order of a watershed
/// transform. A basin that reaches the outside is merged into it unless its peak exceeds
/// `persistence` times the saddle. Even a hole much wider than the offset is therefore closed if
/// the cavity behind it is wider than the hole.
///
/// If almost no node is inside by this rule, the cloud leaks: it has a hole about as wide as the
/// cavity behind it. One basin is then classified as inside. A candidate's peak is at least a tenth
/// higher than its saddle to the outside. Two thirds of all directions from the peak lead to data.
/// The candidate with the largest difference between peak and saddle is selected.
///
/// @param[in,out] distances  distance of each node to the data, in any unit. Nodes on the faces of
///   the grid are always outside; their distances are set to the largest float.
/// @param[in] offset         distance within which nodes are not outside, in the unit of the
///   distances
/// @param[in] persistence    minimum ratio of peak to saddle of an inside basin, at least 1
OutsideNodes findOutside(const FreudenthalGrid& grid, std::vector<float>& distances, double offset,
  double persistence, const Run& run = {});
}

#endif
