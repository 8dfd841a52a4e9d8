/// Write meshes and clouds in the .m format of X. Gu's MeshLib.

#ifndef ConformalGuMeshWriter_h
#define ConformalGuMeshWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a mesh or a cloud. The point arrays "SpherePosition" (trait sph), "Normals", "TCoords" and
/// "RGB" are written, and "RGB" of the polygons. Other arrays are omitted.
/// @throws std::invalid_argument if a "SpherePosition" is zero or not finite
/// @throws Aborted
std::string makeGuMesh(const SurfaceData& surface, const Run& run = {});
}

#endif
