/// Triangulation of the grid of a range scan.

#ifndef ConformalRangeGrid_h
#define ConformalRangeGrid_h

#include "Bytes/NamedArray.h"
#include "Bytes/OwnedArray.h"

#include <cstddef>
#include <cstdint>

namespace conformal
{
/// Append triangles between cells of a scanner's grid that neighbor each other and have points.
/// Four cells give two triangles, cut by the shorter diagonal, three give one; a triangle with an
/// edge longer than maximumEdge would bridge a gap of the object and is left out. Seen with columns
/// to the right and rows downwards, triangles are counter-clockwise.
///
/// @param[in] points       #P by 3, Float32 or Float64
/// @param[in] grid         point ids row by row, -1 where the scanner saw nothing
/// @param[in] columns      cells in a row, at least 1
/// @param[in] maximumEdge  0 takes 4 times the median length between neighbors in rows and columns
void appendGridTriangles(const NamedArray& points, const OwnedArray<std::int64_t>& grid,
  std::size_t columns, double maximumEdge, OwnedArray<std::int64_t>& offsets,
  OwnedArray<std::int64_t>& ids);
}

#endif
