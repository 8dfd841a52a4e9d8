/// Write meshes and clouds in the .m format of X. Gu's MeshLib.

#ifndef ConformalGuMeshWriter_h
#define ConformalGuMeshWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write "SpherePosition" as trait sph, "Normals", "TCoords" and "RGB" of the points, and "RGB" of
/// the polygons. Other arrays are omitted.
/// @throws std::invalid_argument if a "SpherePosition" has no direction
/// @throws Aborted
std::string makeGuMesh(const SurfaceData& surface, const Run& run = {});
}

#endif
