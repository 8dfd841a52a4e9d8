/// Change a solid so that it has the topology of a ball: connected, without handles and cavities.
/// The solid consists of the grid nodes where an indicator (winding number) exceeds its level. The
/// method is an own construction, not from a publication. The cost of changing a node increases
/// with the difference between its indicator value and the level. The cheapest changes are made
/// first, because these changes contradict the indicator least.

#ifndef ConformalSolidRepair_h
#define ConformalSolidRepair_h

#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"
#include "Hull/IndicatorGrid.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace conformal
{
/// Join the connected components of a solid to the largest component. Each path that joins a
/// component leads along nodes whose indicator is as little below the level as possible. This
/// function reattaches limbs (thin parts of the object) that are disconnected because points are
/// sparse.
///
/// A component is removed if it is tiny: fewer than 0.05 % of all nodes of the solid. A component
/// is also removed if its path is long: longer than the side of a cube with as many nodes as the
/// component, or than a tenth of the largest distance of a sample from the origin.
///
/// A long path is accepted if it leads across a hole of the data that has cut a limb into two. The
/// ends of both parts are then open: there are no samples where the path leaves the parts, and the
/// indicator between them is well above 0. Separate objects are closed. The path is accepted up to
/// half of the largest distance of a sample, if its indicator is at least 0.15 of the level. All
/// nodes around the path with about the indicator of the path are added, too.
///
/// @param[in] indicator  winding number at each node, and the level of the surface
/// @param[in,out] inside  1 for the nodes of the solid, else 0; must be 0 on the faces of the grid
/// @param[in] hasSamples  test for nodes with samples nearby; empty if there are none
/// @return the number of nodes added: nodes on the paths, and neighbors of these nodes
Index joinPieces(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const std::function<bool(int node)>& hasSamples = {},
  const Run& run = {});

/// Fill the cavities of a solid: add all nodes that are not connected to the faces of the grid.
/// @param[in,out] inside  1 for the nodes of the solid, else 0; must be 0 on the faces of the grid
/// @return the number of cavities
Index fillCavities(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run = {});

/// Changes made by openHandles().
struct HandleRepair
{
  Index NumberOfCutNodes = 0, NumberOfFilledNodes = 0;
  /// Number of changed nodes that were clearly inside or outside before: the difference between
  /// indicator and level exceeded 0.25.
  Index NumberOfDefiniteNodes = 0;
};

/// Remove the handles of a solid. A handle is removed by a cut through the handle, or by filling
/// its opening. Of these two changes, the one of lower cost is made. The handle with the cheapest
/// change is removed first. If the handle is due to the object itself, cutting and filling both
/// have a high cost.
///
/// @param[in] indicator  winding number at each node, and the level of the surface
/// @param[in,out] inside  1 for the nodes of the solid, else 0; the solid must be connected and
///   have no cavities
/// @param[in] isKept  test for the connected nodes of a cut or filling: true if the handle belongs
///   to the object, so that this change is not made; empty to remove all handles
HandleRepair openHandles(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside,
  const std::function<bool(const std::vector<int>&)>& isKept = {}, const Run& run = {});
}

#endif
