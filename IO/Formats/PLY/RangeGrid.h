/// Triangulate the grid of a range scan.

#ifndef ConformalRangeGrid_h
#define ConformalRangeGrid_h

#include "Bytes/NamedArray.h"
#include "Bytes/OwnedArray.h"

#include <cstddef>
#include <cstdint>

namespace conformal
{
/// Append triangles between adjacent cells of the grid of a scanner that have points. Four cells
/// form two triangles, divided by the shorter diagonal; three cells form one. A triangle with an
/// edge longer than maximumEdge would bridge a gap of the object and is omitted. Triangles are
/// counter-clockwise if columns run to the right and rows downward.
///
/// @param[in] points       #P by 3, Float32 or Float64
/// @param[in] grid         point ids row by row, -1 for a cell without a point
/// @param[in] columns      number of cells in a row, at least 1
/// @param[in] maximumEdge  maximum edge length; 0 for 4 times the median distance between neighbors
///   in rows and columns
void appendGridTriangles(const NamedArray& points, const OwnedArray<std::int64_t>& grid,
  std::size_t columns, double maximumEdge, OwnedArray<std::int64_t>& offsets,
  OwnedArray<std::int64_t>& ids);
}

#endif
