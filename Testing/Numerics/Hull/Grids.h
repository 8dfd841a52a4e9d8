/// Grids shared by tests.

#ifndef ConformalTestGrids_h
#define ConformalTestGrids_h

#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace grids
{
using Marks = std::vector<std::uint8_t>; ///< of nodes

/// As many nodes along each axis.
inline conformal::FreudenthalGrid cube(int size)
{
  conformal::FreudenthalGrid grid;
  grid.Size = { size, size, size };
  return grid;
}
}

#endif
