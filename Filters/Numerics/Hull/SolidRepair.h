/// Make the solid of an indicator one ball, by the changes that fit the indicator best.
/// Own construction: changes are ordered by their cost, the difference of the indicator from its
/// level.

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
/// closest to its level. Thin limbs that sparse points have disconnected are reattached.
///
/// A component that is tiny, farther away than it is wide, or farther than a tenth of the maximum
/// radius is removed.
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
  Index NumberOfDefiniteNodes = 0; ///< far inside or outside by the indicator
};

/// Remove the handles of a solid. Each handle is cut through or its opening is filled, whichever
/// costs less in the indicator. The cheapest change is made first. Either change is expensive for a
/// handle of the object itself.
///
/// @param[in,out] inside  a connected set without cavities
HandleRepair openHandles(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const Run& run = {});
}

#endif
