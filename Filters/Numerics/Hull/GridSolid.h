/// Change sets of grid nodes to solids: connected sets without handles. The method is an own
/// construction, not from a publication. A ball grows inside the set, beginning with the nodes that
/// are farthest from the points of the cloud. Each node is added only if the topology of the ball
/// is preserved. Parts of the ball then touch each other where a handle is thin, and the handle is
/// cut there.

#ifndef ConformalGridSolid_h
#define ConformalGridSolid_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Keep the largest connected component of a set of nodes. If several components are equally large,
/// keep the component that contains the lowest node id.
/// @param[in,out] inside  1 for the nodes of the set, else 0; must be 0 on the faces of the grid
/// @return the number of nodes kept
Index keepLargestPiece(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run = {});

/// Position of the cut through a handle. A node is called enclosed if its distance to the data, the
/// points of a cloud, exceeds a given offset. The position is chosen only for handles without
/// enclosed nodes.
enum class HandleCut
{
  HalfWay,     ///< cut as far as possible from the enclosed nodes: midway between limbs
  FarFromData, ///< cut as far as possible from the data
};

/// Cut the handles of a solid, a set of nodes, until no handle is left.
///
/// A ball grows within the solid, beginning with the deepest node of the solid. Only simple nodes
/// are added (isSimpleNode()), since simple nodes preserve the topology. The nodes that cannot be
/// added are removed from the solid. These nodes form the cut.
///
/// Enclosed nodes (nodes deeper than the offset) are added first, beginning with the deepest one.
/// The other nodes follow. With HandleCut::HalfWay, they are sorted by the length of the path from
/// the enclosed nodes, the shortest first. With HandleCut::FarFromData, they are sorted by distance
/// to the data, the smallest first. Since the cut is where nodes would be added last, a handle is
/// cut where it is thinnest. Two limbs may be joined only because their distance is less than twice
/// the offset. HandleCut::HalfWay then separates the limbs by a cut midway between them.
///
/// @param[in,out] inside  1 for the nodes of the solid, else 0; the solid must be connected and
///   have no cavities
/// @param[in] distances  depth of each node: the distance to the data, or another value that
///   increases toward the inside
/// @param[in] offset  nodes of greater depth are enclosed nodes; in the unit of the distances
/// @return the number of nodes removed
Index cutHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& distances, double offset, HandleCut place = HandleCut::HalfWay,
  const Run& run = {});

/// Fill the handles of a solid, a set of nodes, until no handle is left.
///
/// The outside grows from the faces of the grid toward the solid. Only simple nodes are added to
/// the outside (isSimpleNode()), since simple nodes preserve the topology. The nodes that cannot be
/// added become nodes of the solid.
///
/// Nodes are processed by decreasing distance from the solid. Among nodes at equal distance, the
/// node with the lowest value is first. A handle is therefore filled where its opening is
/// narrowest.
///
/// @param[in,out] inside  1 for the nodes of the solid, else 0; must be 0 on the faces of the grid.
///   The solid must be connected and have no cavities.
/// @param[in] values  value of each node, in [0, 1), larger toward the inside
/// @return the number of nodes added
Index fillHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, const Run& run = {});

/// Count the nodes near the data in each connected component of a cut. Return the largest of these
/// numbers.
/// @param[in] uncut, cut  nodes of the solid before and after the cut: 1 in the solid, else 0
/// @param[in] distances  distance of each node to the data, in any unit
/// @param[in] nearness  maximum distance of a node that is near the data, in the unit of the
///   distances
Index maximumCutNearData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& uncut,
  const std::vector<std::uint8_t>& cut, const std::vector<float>& distances, double nearness);
}

#endif
