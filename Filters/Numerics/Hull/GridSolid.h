/// Makes sets of grid nodes solid: connected and without handles.
/// Own construction: growth by simple nodes in order of distance cuts handles at thin places.

#ifndef ConformalGridSolid_h
#define ConformalGridSolid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Keep the largest connected piece of a set of nodes; of equals, that of the lowest node.
/// @param[in,out] inside  1 for the nodes of the set, else 0; 0 on the grid's faces
/// @return the number of nodes kept
Index keepLargestPiece(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run = {});

/// Where handles are cut that have nothing inside.
enum class HandleCut
{
  HalfWay, ///< as far as can be from what is inside: limbs are parted in the middle between them
  FarFromData, ///< as far as can be from the data
};

/// Cut a solid open until it has no handles: grow a ball within it, from the node deepest inside,
/// by nodes that change nothing in the topology; what cannot be added is the cut.
///
/// Nodes beyond the offset are added from the deepest up, then the others by the way from these, or
/// by their distance to the data. So a handle is cut where it is thinnest, and limbs that only the
/// offset had joined are parted between them.
///
/// @param[in,out] inside  a connected set without cavities, as keepLargestPiece leaves it
/// @param[in] distances   of each node to the data, in units of the spacing
/// @param[in] offset      in the unit of the distances
/// @return the number of nodes cut
Index cutHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, HandleCut place = HandleCut::HalfWay,
  const Run& run = {});

/// Fill a solid up until it has no handles: what is outside is carved away from the grid's faces
/// on, by nodes that change nothing in the topology, the farthest from the solid first and of those
/// equally far the lowest values; what cannot be carved is added to the solid. So a handle is
/// filled where the way through it is narrowest.
///
/// @param[in,out] inside  a connected set without cavities, as keepLargestPiece leaves it; 0 on the
///                        grid's faces
/// @param[in] values      of each node, in [0, 1), larger toward the inside
/// @return the number of nodes added
Index fillHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, const Run& run = {});

/// Of the nodes that were cut from a solid, those of one connected piece that are near the data:
/// the most of any piece.
/// @param[in] uncut, cut  the solid before and after
/// @param[in] nearness    distance up to which a node is near
Index maximumCutNearData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& uncut,
  const std::vector<std::uint8_t>& cut, const std::vector<float>& distances, double nearness);
}

#endif
