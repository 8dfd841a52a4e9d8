/// Makes the solid of an indicator one ball, by the changes that the indicator minds least.
/// Own construction: changes are ordered by their cost in the indicator.

#ifndef ConformalSolidRepair_h
#define ConformalSolidRepair_h

#include "Base/Types.h"
#include "Hull/FreudenthalGrid.h"
#include "Hull/IndicatorGrid.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Join the pieces of a solid to the largest one, by the ways along which the indicator is missing
/// least to its level. So limbs come back that are too thin for the points to hold together. What
/// is tiny, farther away than it is wide, or farther than a tenth of the largest radius, is no part
/// of the object and left out.
///
/// @param[in,out] inside  1 for the nodes of the solid, else 0; 0 on the grid's faces
/// @return the number of nodes on the ways
Index joinPieces(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const Run& run = {});

/// Fill what is outside of a solid but enclosed by it.
/// @return the number of cavities
Index fillCavities(
  const FreudenthalGrid& grid, std::vector<std::uint8_t>& inside, const Run& run = {});

/// What openHandles() did.
struct HandleRepair
{
  Index NumberOfCutNodes = 0, NumberOfFilledNodes = 0;
  Index NumberOfDefiniteNodes = 0; ///< of both, those far inside or outside by the indicator
};

/// Free a solid from its handles: each is cut through, or what it goes around is filled, whichever
/// the indicator minds less; the cheapest change first. A handle that the object has costs much
/// either way.
///
/// @param[in,out] inside  a connected set without cavities
HandleRepair openHandles(const FreudenthalGrid& grid, const Indicator& indicator,
  std::vector<std::uint8_t>& inside, const Run& run = {});
}

#endif
