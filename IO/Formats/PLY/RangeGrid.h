/// Triangulate a range scan: points in the cells of a scanner's rectangular grid.

#ifndef ConformalRangeGrid_h
#define ConformalRangeGrid_h

#include "Bytes/NamedArray.h"
#include "Bytes/OwnedArray.h"

#include <cstddef>
#include <cstdint>

namespace conformal
{
/// Append triangles that connect the points of adjacent grid cells. Four points in a block of 2 by
/// 2 cells form two triangles, divided by the shorter diagonal. Three points in a block form one
/// triangle. A triangle with an edge longer than maximumEdge is omitted, because it would bridge a
/// gap of the scanned object. If columns run to the right and rows run downward for a viewer, the
/// triangles are counter-clockwise for this viewer.
///
/// @param[in] points       positions of all points: #P by 3, Float32 or Float64
/// @param[in] grid         point ids of the cells, row by row; -1 for a cell without a point
/// @param[in] columns      number of cells in a row, at least 1
/// @param[in] maximumEdge  maximum edge length [units of the points]. If 0, the maximum is 4 times
///   the median distance of adjacent points. Points are adjacent if their cells are neighbors in a
///   row or a column
/// @param[in,out] offsets  for each triangle, the index in `ids` after its last id; new triangles
///   are appended
/// @param[in,out] ids      point ids of the triangles; new triangles are appended
void appendGridTriangles(const NamedArray& points, const OwnedArray<std::int64_t>& grid,
  std::size_t columns, double maximumEdge, OwnedArray<std::int64_t>& offsets,
  OwnedArray<std::int64_t>& ids);
}

#endif
