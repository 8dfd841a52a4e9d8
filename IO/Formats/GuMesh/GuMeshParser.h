/// Parse meshes in the .m format of MeshLib, a library of X. Gu.

#ifndef ConformalGuMeshParser_h
#define ConformalGuMeshParser_h

#include "Base/Run.h"
#include "Bytes/ByteReader.h"
#include "Bytes/ParseLimits.h"
#include "Bytes/SurfaceData.h"

#include <string_view>

namespace conformal
{
/// Read a mesh of lines "Vertex ID X Y Z {traits}" and "Face ID V V V {traits}". Each vertex has an
/// ID, an integer that no other vertex has. A face refers to vertices by their ids V. These
/// vertices must precede the face.
///
/// Points are Float64. Traits are optional named values of a vertex or a face. Traits of vertices
/// become point arrays:
/// - normal=(x y z): "Normals";
/// - uv=(u v): "TCoords";
/// - rgb=(r g b): "RGB" (UInt8);
/// - sph=(x y z), a trait of H. Hoppe's programs: "SpherePosition", the position on a sphere,
///   scaled to unit length.
///
/// If only some vertices have a trait, the other vertices have the value 0, or the color white.
/// Trait sph must either be at every vertex, or at no vertex. Trait rgb of faces becomes the
/// polygon array "RGB". Other traits, and lines "Edge" and "Corner", are skipped.
SurfaceResult parseGuMesh(ByteReader& input, const ParseLimits& limits = {}, const Run& run = {});

/// Test whether the first bytes of a file identify a mesh in this format. The first line that is
/// not blank or a comment must be a vertex.
bool looksLikeGuMesh(std::string_view start);
}

#endif
