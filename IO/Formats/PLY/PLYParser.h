/// Parse PLY files: points with all their properties, polygons and triangle strips.

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
  /// Maximum edge length of triangles from a range grid; 0 for the default of appendGridTriangles()
  double MaximumEdgeLength = 0.0;
  /// Part to read of a binary cloud without lists; other files cannot be divided
  FilePiece Piece;
};

/// Read a PLY file: ascii, binary_little_endian or binary_big_endian, with elements in any order.
///
/// Element "vertex": properties x, y, z become Points (Float32 if all three properties are, else
/// Float64). Related properties of one type become one array:
/// - nx, ny, nz: "Normals" (floating);
/// - s, t or u, v or texture_u, texture_v: "TCoords" (floating);
/// - red, green, blue: "RGB", with alpha "RGBA" (UInt8, also diffuse_red ...);
/// - NAME_0, NAME_1 and so on: "NAME".
///
/// Every other scalar property keeps its name and its type.
///
/// Element "face": the list vertex_indices or vertex_index defines the polygons. Scalar properties
/// become arrays of the polygons.
///
/// Element "tristrips": the list vertex_indices defines strips, each ended by -1. Strips are
/// converted to triangles of one orientation. Triangles with a repeated id are omitted; they only
/// change the direction of a strip.
///
/// Element "range_grid": the list vertex_indices has one point or none for each cell of the grid of
/// a scanner. The lines obj_info num_cols and num_rows define the size of the grid. Adjacent points
/// form triangles. Without these lines the element is skipped. Other elements and other lists are
/// skipped.
///
/// A point that is not finite is omitted from a cloud, but is an error in a mesh. Bytes after the
/// last element are not read. They are counted from the first byte that is not a blank.
SurfaceResult parsePLY(ByteReader& input, const PLYOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif
