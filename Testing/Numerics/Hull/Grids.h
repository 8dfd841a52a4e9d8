/// Make grids for tests.

#ifndef ConformalTestGrids_h
#define ConformalTestGrids_h

#include "Hull/FreudenthalGrid.h"

#include <cstdint>
#include <vector>

namespace grids
{
using Marks = std::vector<std::uint8_t>; ///< one mark for each node of a grid

/// Return a grid with `size` nodes along each axis.
inline conformal::FreudenthalGrid cube(int size)
{
  conformal::FreudenthalGrid grid;
  grid.Size = { size, size, size };
  return grid;
}
}

#endif
