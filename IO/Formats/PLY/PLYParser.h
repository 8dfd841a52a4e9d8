/// Parse PLY files: points with all their properties, polygons, triangle strips and range grids.

#ifndef ConformalPLYParser_h
#define ConformalPLYParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/FilePiece.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

namespace conformal
{
struct PLYOptions
{
  /// Maximum edge length of triangles from a range grid [units of the points]. If 0, the maximum is
  /// 4 times the median distance of adjacent points (RangeGrid.h)
  double MaximumEdgeLength = 0.0;
  /// Part of the points to read. Only a binary file without polygons, and without lists in its
  /// element "vertex", can be divided. In all other files, all points belong to the first part
  FilePiece Piece;
};

/// Read a PLY file of format ascii, binary_little_endian or binary_big_endian. The elements of the
/// file may be in any order.
///
/// Element "vertex" defines the points. Its properties x, y, z become the coordinates. Coordinates
/// are Float32 if all three properties are float, otherwise Float64. Related properties of one type
/// become one array:
/// - nx, ny, nz or normal_x, normal_y, normal_z: "Normals" (floating-point);
/// - s, t or u, v or texture_u, texture_v: "TCoords" (floating-point);
/// - red, green, blue, or these names with the prefix diffuse_: "RGB" (UInt8);
/// - red, green, blue, alpha, or these names with the prefix diffuse_: "RGBA" (UInt8);
/// - NAME_0, NAME_1 and so on: "NAME".
///
/// Every other scalar property becomes an array of the same name and type.
///
/// Element "face" defines the polygons, by the list vertex_indices or vertex_index. Its scalar
/// properties become arrays of the polygons. If the file also has strips or a grid of triangles,
/// these arrays are omitted.
///
/// Element "tristrips" defines triangle strips, by the list vertex_indices. In this list, each -1
/// ends a strip. All triangles of a strip get the same orientation. Triangles with a repeated id
/// only change the direction of a strip, or join strips. They are omitted.
///
/// Element "range_grid" is the grid of cells of a range scanner. Each cell has a list
/// vertex_indices, which contains one point id or is empty. The header lines obj_info num_cols and
/// obj_info num_rows state the size of the grid. Adjacent points form triangles. Without these
/// header lines, the element is skipped.
///
/// Other elements and other list properties are skipped.
///
/// If the file has polygons, strips or a grid, a coordinate that is not finite is an error. In
/// other files (point clouds), a point with such a coordinate is omitted. Bytes after the last
/// element are not read. SurfaceData::UnreadBytes is the number of these bytes, without blanks
/// directly after the last element.
SurfaceResult parsePLY(ByteReader& input, const PLYOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif
