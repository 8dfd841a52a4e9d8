/// Write meshes and clouds in the .m format of MeshLib, a library of X. Gu.

#ifndef ConformalGuMeshWriter_h
#define ConformalGuMeshWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a mesh, or points without polygons, in the .m format. The point arrays "SpherePosition",
/// "Normals", "TCoords" and "RGB", and the polygon array "RGB", are written as traits. Traits are
/// named values in braces, such as sph=(x y z). Other arrays are omitted.
/// @return the text of the file
/// @throws std::invalid_argument if a "SpherePosition" is zero or not finite
/// @throws Aborted if the progress callback of `run` returns false
std::string makeGuMesh(const SurfaceData& surface, const Run& run = {});
}

#endif
