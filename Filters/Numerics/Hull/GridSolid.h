/// Change sets of grid nodes to solids: connected sets without handles. The method is an own
/// construction, not from a publication. The set is the inside of a point cloud. Within the set, a
/// ball of nodes grows from the node that is farthest from the points. A node is added only if the
/// topology of the ball is preserved. The ball enters each handle from both ends. Where the two
/// parts of the ball meet in the handle, no node can be added, and the handle is cut.

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
/// points of a cloud, exceeds a given offset. If enclosed nodes lead through a handle from one end
/// to the other, this choice has no effect on the cut.
enum class HandleCut
{
  HalfWay,     ///< cut farthest from the enclosed nodes: midway between limbs (thin parts)
  FarFromData, ///< cut farthest from the data
};

/// Cut the handles of a solid, a set of nodes, until no handle is left.
///
/// The depth of a node is its distance to the data, or another value that increases toward the
/// inside. A ball grows within the solid, beginning with the deepest node of the solid. Only simple
/// nodes are added (isSimpleNode()), since simple nodes preserve the topology. The nodes that
/// cannot be added form the cut, and are removed from the solid.
///
/// Enclosed nodes (nodes deeper than the offset) are added first, beginning with the deepest one.
/// The other nodes follow. With HandleCut::HalfWay, the other nodes are sorted by the length of the
/// path from the enclosed nodes, the shortest first. With HandleCut::FarFromData, the other nodes
/// are sorted by distance to the data, the smallest first. A handle is cut at the nodes that are
/// last in this sequence. If the handle has enclosed nodes along its whole length, the cut is thus
/// where the handle is thinnest. If the distance of two limbs is less than twice the offset, the
/// solid joins the limbs. HandleCut::HalfWay then separates the limbs by a cut midway between them.
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
/// added to the outside become nodes of the solid.
///
/// Nodes are processed by decreasing distance from the solid. Among nodes at equal distance, the
/// node with the lowest value is first. The nodes in the narrowest part of a handle's opening are
/// last, and fill the handle.
///
/// @param[in,out] inside  1 for the nodes of the solid, else 0; must be 0 on the faces of the grid.
///   The solid must be connected and have no cavities.
/// @param[in] values  value of each node, in [0, 1), larger toward the inside
/// @return the number of nodes added
Index fillHandles(const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside,
  const std::vector<float>& values, const Run& run = {});

/// Count the nodes near the data (the points of the cloud) in each connected component of a cut.
/// Return the largest of these numbers.
/// @param[in] uncut, cut  nodes of the solid before and after the cut: 1 in the solid, else 0
/// @param[in] distances  distance of each node to the data, in any unit
/// @param[in] nearness  maximum distance of a node that is near the data, in the unit of the
///   distances
Index maximumCutNearData(const FreudenthalGrid& grid, const std::vector<std::uint8_t>& uncut,
  const std::vector<std::uint8_t>& cut, const std::vector<float>& distances, double nearness);
}

#endif
