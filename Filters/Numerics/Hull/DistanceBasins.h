/// Classify grid nodes as inside or outside of a point cloud, even if the cloud has holes. Each
/// local maximum of the distance to the points defines a region, its basin. Basins are merged by
/// their persistence \cite Edelsbrunner2002, here the ratio of two distances to the points: at the
/// maximum, and at the border to the next basin.

#ifndef ConformalDistanceBasins_h
#define ConformalDistanceBasins_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Hole in a point cloud through which a cavity is connected to the outside.
struct DataHole
{
  /// Distance from the middle of the hole (the saddle) to the points. This is about the radius of
  /// the hole; 0 if there is no hole.
  double Saddle = 0.0;
  double Peak = 0.0; ///< maximum distance to the points, over all nodes in the cavity
};

/// Result of findOutside().
struct OutsideNodes
{
  std::vector<std::uint8_t> Outside; ///< 1 for each node that is outside, else 0
  DataHole LargestHole;              ///< largest hole that was closed
  /// Whether the cloud leaks, as defined at findOutside(), and one more basin was classified as
  /// inside. False if no basin was a candidate.
  bool Leaks = false;
};

/// Find the nodes of a grid that are outside of a point cloud. The other nodes are enclosed by the
/// points, or are within a given distance of a point, the offset.
///
/// The nodes farther than the offset from the points form basins, one for each local maximum of the
/// distance. A basin consists of the nodes from which steepest ascent of the distance leads to one
/// maximum. The distance at the maximum is called the peak of the basin. The saddle between two
/// basins is the largest distance at which the basins touch each other. Basins are merged from the
/// highest saddle down, as in a watershed transform.
///
/// Persistence rule: suppose that a basin touches the outside at a saddle. If the peak of the basin
/// exceeds `persistence` times the saddle, the basin is classified as inside. The hole at the
/// saddle is thus closed. Otherwise, the basin is merged into the outside. A hole much wider than
/// the offset is thus also closed, if the cavity behind the hole is even wider.
///
/// A cloud leaks if almost no node is inside by the persistence rule: fewer than 1 % of the number
/// of nodes within the offset. Usually, a hole is then about as wide as the cavity behind it. In a
/// leaking cloud, one more basin is classified as inside: the candidate with the largest difference
/// between peak and saddle. A basin is a candidate if two conditions hold:
/// - Its peak is at least 1.1 times its saddle to the outside.
/// - Of rays in all directions from its maximum, at least two thirds pass within the offset of a
///   point.
///
/// @param[in,out] distances  distance of each node to the points, in any unit. Nodes on the faces
///   of the grid are always outside; their distances are set to the largest float.
/// @param[in] offset  nodes within this distance of a point are not classified as outside; in the
///   unit of the distances
/// @param[in] persistence  minimum ratio of peak to saddle for a basin that is classified as
///   inside, at least 1
OutsideNodes findOutside(const FreudenthalGrid& grid, std::vector<float>& distances, double offset,
  double persistence, const Run& run = {});
}

#endif
