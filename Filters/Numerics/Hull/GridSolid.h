/// Make sets of grid nodes solid: connected and without handles. Own construction: a ball grows by
/// simple nodes in order of distance, because it then meets itself where handles are thin, and
/// handles are cut there.

#ifndef ConformalGridSolid_h
#define ConformalGridSolid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Keep the largest connected component of a set of nodes. Of equally large components, keep that
/// with the lowest node id.
/// @param[in,out] inside  1 for the nodes of the set, else 0; 0 on the faces of the grid
/// @return the number of nodes kept
Index keepLargestPiece(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run = {});

/// Position of the cuts through handles that have no nodes deeper inside than the offset.
enum class HandleCut
{
  HalfWay,     ///< cut as far as possible from the nodes deeper inside: midway between limbs
  FarFromData, ///< cut as far as possible from the data
};

/// Cut a solid open until it has no handles.
///
/// A ball grows within the solid from the solid's deepest node. Only simple nodes are added
/// (isSimpleNode()), since they preserve the topology. The nodes that cannot be added are the cut.
/// Nodes beyond the offset are added first, deepest first. The other nodes follow, ordered by path
/// length from the first nodes (HalfWay) or by distance to the data (FarFromData). A handle is
/// therefore cut where it is thinnest. Limbs that are joined only because their distance is less
/// than twice the offset are separated between them.
///
/// @param[in,out] inside  a connected set without cavities, as keepLargestPiece() leaves it
/// @param[in] distances   distance of each node to the data, in units of the spacing
/// @param[in] offset      nodes farther than this from the data are inside nodes; in the unit of
///   the distances
/// @return the number of nodes cut
Index cutHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, HandleCut place = HandleCut::HalfWay,
  const Run& run = {});

/// Fill a solid until it has no handles.
///
/// The outside grows from the faces of the grid toward the solid. Only simple nodes are added to it
/// (isSimpleNode()), since they preserve the topology. The nodes that cannot be added are added to
/// the solid. Nodes are processed by decreasing distance from the solid; of nodes at equal
/// distance, the one with the lowest value is first. A handle is therefore filled where its opening
/// is narrowest.
///
/// @param[in,out] inside  a connected set without cavities, as keepLargestPiece() leaves it; 0 on
///   the faces of the grid
/// @param[in] values      value of each node, in [0, 1), larger toward the inside
/// @return the number of nodes added
Index fillHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, const Run& run = {});

/// Count the nodes near the data in each connected component of a cut, and return the largest
/// count.
/// @param[in] uncut, cut  the nodes of the solid before and after the cut
/// @param[in] nearness    a node is near the data if its distance is at most this
Index maximumCutNearData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& uncut,
  const std::vector<std::uint8_t>& cut, const std::vector<float>& distances, double nearness);
}

#endif
