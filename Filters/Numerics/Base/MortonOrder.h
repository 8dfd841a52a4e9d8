/// Sort positions along a Morton curve, \cite Morton1966, on which successive positions are usually
/// close together. If data are stored or visited in this sequence, neighboring data are usually in
/// the cache of the processor.

#ifndef ConformalMortonOrder_h
#define ConformalMortonOrder_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Return the ids 0, 1, ..., count - 1, sorted along a Morton curve through a grid of 1024^3 cells.
/// Ids of positions in the same cell are ascending.
/// @param[in] count  number of positions, at most 2^31 - 1
/// @param[in] place  function that returns the position of an id, in the cube [0, 1]^3; other
///   positions belong to the nearest cell
std::vector<int> mortonOrder(
  Index count, const std::function<Vector3(Index)>& place, const Run& run = {});
}

#endif
