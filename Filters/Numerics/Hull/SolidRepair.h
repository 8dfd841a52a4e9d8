/// Turn a solid, the nodes where an indicator exceeds its level, into one ball without handles and
/// cavities. Own construction: the cheapest changes are made first, because they contradict the
/// indicator least. The cost of a change is the difference of the indicator from its level.

#ifndef ConformalSolidRepair_h
#define ConformalSolidRepair_h

#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"
#include "Hull/IndicatorGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Join the connected components of a solid to the largest one, along paths where the indicator is
/// closest to its level. This reattaches thin limbs that were disconnected because points are
/// sparse.
///
/// A component is removed if it is tiny, or if its distance from the largest component exceeds its
/// own width or a tenth of the maximum radius.
///
/// @param[in,out] inside  1 for the nodes of the solid, else 0; 0 on the faces of the grid
/// @return the number of nodes on the paths
Index joinPieces(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const Run& run = {});

/// Fill the cavities of a solid.
/// @return the number of cavities
Index fillCavities(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run = {});

/// Changes made by openHandles().
struct HandleRepair
{
  Index NumberOfCutNodes = 0, NumberOfFilledNodes = 0;
  /// Number of changed nodes that the indicator puts clearly inside or outside.
  Index NumberOfDefiniteNodes = 0;
};

/// Remove the handles of a solid. Each handle is either cut through, or its opening is filled; the
/// change of lower cost is made. The handle with the cheapest change is first. For a handle of the
/// object itself, both changes are expensive.
///
/// @param[in,out] inside  1 for the nodes of the solid, else 0; the solid must be connected and
///   without cavities
HandleRepair openHandles(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const Run& run = {});
}

#endif
