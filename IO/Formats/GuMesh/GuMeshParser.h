/// Parse meshes in the .m format of X. Gu's MeshLib.

#ifndef ConformalGuMeshParser_h
#define ConformalGuMeshParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read lines "Vertex ID X Y Z {traits}" and lines "Face ID V V V {traits}". The vertices of a face
/// must precede it. Ids are any distinct numbers.
///
/// Points are Float64. Traits of vertices become arrays:
/// - normal=(x y z): "Normals";
/// - uv=(u v): "TCoords";
/// - rgb=(r g b): "RGB" (UInt8);
/// - sph=(x y z), as written by H. Hoppe's programs: "SpherePosition", of unit length.
///
/// All traits except sph may be missing at some vertices. The value is 0 there; a missing color is
/// white. Trait rgb of faces becomes an array of the polygons. Other traits, and lines "Edge" and
/// "Corner", are skipped.
SurfaceResult parseGuMesh(ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file are those of a mesh in this format. Its first line is a
/// vertex, except for blank lines and comments.
bool looksLikeGuMesh(std::string_view start);
}

#endif
