/// Parser of meshes in the .m format of X. Gu's MeshLib.

#ifndef ConformalGuMeshParser_h
#define ConformalGuMeshParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read lines "Vertex ID X Y Z {traits}" and, behind the vertices they name, "Face ID V V V
/// {traits}". Ids are any numbers, each once.
///
/// Points are Float64. Traits of vertices: normal=(x y z) gives "Normals", uv=(u v) "TCoords",
/// rgb=(r g b) "RGB" (UInt8), sph=(x y z), which H. Hoppe's programs write, "SpherePosition", of
/// unit length; all but sph may be missing at some vertices: they are 0 there, or white. rgb of
/// faces gives an array of the polygons. Other traits and lines "Edge" and "Corner" are skipped.
SurfaceResult parseGuMesh(ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Whether bytes from the start of a file are those of such a mesh: a vertex is the first.
bool looksLikeGuMesh(std::string_view start);
}

#endif
