/// Make sets of grid nodes solid: connected and without handles.
/// Own construction: growth by simple nodes in order of distance cuts handles where they are thin.

#ifndef ConformalGridSolid_h
#define ConformalGridSolid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Keep the largest connected component of a set of nodes; of equal ones, that of the lowest node.
/// @param[in,out] inside  1 for the nodes of the set, else 0; 0 on the faces of the grid
/// @return the number of nodes kept
Index keepLargestPiece(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run = {});

/// Where to cut handles that have no inside nodes.
enum class HandleCut
{
  HalfWay,     ///< as far as possible from inside nodes: limbs are separated midway
  FarFromData, ///< as far as possible from the data
};

/// Cut a solid open until it has no handles.
///
/// A ball grows within the solid from its deepest node, by simple nodes, which preserve the
/// topology. The nodes that cannot be added are the cut. Nodes beyond the offset are added first,
/// deepest first. The others follow by their path length from these nodes, or by their distance to
/// the data. A handle is therefore cut where it is thinnest. Limbs that are joined by the offset
/// alone are separated between them.
///
/// @param[in,out] inside  a connected set without cavities, as keepLargestPiece() leaves it
/// @param[in] distances   of each node to the data, in units of the spacing
/// @param[in] offset      in the unit of the distances
/// @return the number of nodes cut
Index cutHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, HandleCut place = HandleCut::HalfWay,
  const Run& run = {});

/// Fill a solid until it has no handles.
///
/// The outside is carved from the faces of the grid inward, by simple nodes, which preserve the
/// topology. The nodes that cannot be carved are added to the solid. Nodes are carved by decreasing
/// distance from the solid; of equal distances, the lowest value first. A handle is therefore
/// filled where its opening is narrowest.
///
/// @param[in,out] inside  a connected set without cavities, as keepLargestPiece() leaves it; 0 on
///   the faces of the grid
/// @param[in] values      of each node, in [0, 1), larger toward the inside
/// @return the number of nodes added
Index fillHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, const Run& run = {});

/// Count the nodes near the data in each connected component of the cut, and return the maximum.
/// @param[in] uncut, cut  the solid before and after the cut
/// @param[in] nearness    maximum distance of a node near the data
Index maximumCutNearData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& uncut,
  const std::vector<std::uint8_t>& cut, const std::vector<float>& distances, double nearness);
}

#endif
