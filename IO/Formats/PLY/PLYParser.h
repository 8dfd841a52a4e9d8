/// Parser of PLY files: points with all their properties, polygons and triangle strips.

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
  double MaximumEdgeLength = 0.0; ///< of triangles from a range grid; 0: see appendGridTriangles()
  FilePiece Piece;                ///< of a binary cloud without lists; other files cannot be cut
};

/// Read a PLY file: ascii, binary_little_endian or binary_big_endian, its elements in any order.
///
/// Element "vertex": x, y, z become Points (Float32 if all three are, else Float64). Properties of
/// one type that belong together become one array: nx, ny, nz "Normals" and s, t or u, v or
/// texture_u, texture_v "TCoords" (floating), red, green, blue "RGB", with alpha "RGBA" (UInt8,
/// also diffuse_red ...), NAME_0, NAME_1 and so on "NAME". Every other scalar keeps its name and
/// its type. Element "face": the list vertex_indices or vertex_index gives the polygons; scalars
/// are kept. Element "tristrips": the list vertex_indices gives strips, each ended by -1; they are
/// resolved into triangles of one winding, and those with an id twice, which only turn a strip, are
/// left out. Element "range_grid": the list vertex_indices gives the one point, or none, of each
/// cell of a scanner's grid, whose size is in the lines obj_info num_cols and num_rows; neighbors
/// become triangles. Without these lines it is skipped. Other elements and other lists are skipped.
///
/// A point that is not finite is dropped from a cloud and is an error in a mesh. Bytes behind the
/// last element, from the first that is no blank, are not read but counted.
SurfaceResult parsePLY(ByteReader& input, const PLYOptions& options = {},
  const ParseLimits& limits = {}, const Run& run = {});
}

#endif
