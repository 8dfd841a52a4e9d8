/// PLY files: points with all their properties, polygons and triangle strips.

#ifndef ConformalPLYParser_h
#define ConformalPLYParser_h

#include "ByteReader.h"
#include "NamedArray.h"
#include "OwnedArray.h"
#include "ParseLimits.h"
#include "ParseStatus.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace conformal
{
struct PLYData
{
  NamedArray Points;                   ///< #P by 3, Float32 or Float64
  std::vector<NamedArray> PointArrays; ///< #P tuples each
  std::vector<NamedArray>
    PolygonArrays; ///< one tuple for each polygon; none if strips or a grid gave more polygons
  OwnedArray<std::int64_t> PolygonOffsets; ///< #F + 1: where each polygon's ids begin; may be empty
  OwnedArray<std::int64_t> PolygonIds;     ///< in [0, #P), no id twice in a polygon

  std::uint64_t DroppedPoints = 0;   ///< of a cloud, whose coordinates were not finite
  std::uint64_t DroppedPolygons = 0; ///< of fewer than 3 ids, or with an id twice
  std::uint64_t ReplacedValues = 0;  ///< of point and polygon arrays, not finite, now 0
};

struct PLYOptions
{
  double MaximumEdgeLength = 0.0; ///< of triangles from a range grid; 0: see appendGridTriangles()
};

struct PLYResult
{
  ParseStatus Status;
  PLYData Data; ///< empty unless Status.ok()
};

/// Read a PLY file: ascii, binary_little_endian or binary_big_endian, its elements in any order.
///
/// Element "vertex": x, y, z become Points (Float32 if all three are, else Float64). Properties of
/// one type that belong together become one array: nx, ny, nz "Normals" and s, t or u, v or
/// texture_u, texture_v "TCoords" (floating), red, green, blue "RGB", with alpha "RGBA" (UInt8,
/// also diffuse_red ...). Every other scalar keeps its name and its type.
/// Element "face": the list vertex_indices or vertex_index gives the polygons; scalars are kept.
/// Element "tristrips": the list vertex_indices gives strips, each ended by -1; they are resolved
/// into triangles of one winding, and those with an id twice, which only turn a strip, are left
/// out.
/// Element "range_grid": the list vertex_indices gives the one point, or none, of each cell of a
/// scanner's grid, whose size is in the lines obj_info num_cols and num_rows; neighbours become
/// triangles. Without these lines it is skipped.
/// Other elements and other lists are skipped.
///
/// A point that is not finite is dropped from a cloud and is an error in a mesh.
PLYResult parsePLY(ByteReader& input, const PLYOptions& options = {},
  const ParseLimits& limits = {}, const ParseProgress& progress = {});

/// The same for bytes in memory.
PLYResult parsePLY(std::string_view bytes, const PLYOptions& options = {},
  const ParseLimits& limits = {}, const ParseProgress& progress = {});
}

#endif
