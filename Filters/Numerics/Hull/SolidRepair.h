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
#include <vector>

namespace conformal
{
/// Join the connected components of a solid to the largest component. Each path that joins a
/// component leads along nodes whose indicator is as little below the level as possible. This
/// function reattaches limbs (thin parts of the object) that are disconnected because points are
/// sparse.
///
/// A component is removed instead in three cases:
/// - The component is tiny: fewer than 0.05 % of all nodes of the solid.
/// - Its path is longer than the side of a cube with as many nodes as the component.
/// - Its path is longer than a tenth of the largest distance of a sample from the origin.
///
/// @param[in] indicator  winding number at each node, and the level of the surface
/// @param[in,out] inside  1 for the nodes of the solid, else 0; must be 0 on the faces of the grid
/// @return the number of nodes added: nodes on the paths, and neighbors of these nodes
Index joinPieces(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const Run& run = {});

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
HandleRepair openHandles(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const Run& run = {});
}

#endif
