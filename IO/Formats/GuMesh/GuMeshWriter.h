/// Write meshes and clouds in the .m format of X. Gu's MeshLib.

#ifndef ConformalGuMeshWriter_h
#define ConformalGuMeshWriter_h

#include "Base/Run.h"
#include "Bytes/SurfaceData.h"

#include <string>

namespace conformal
{
/// Write a mesh, or points without polygons, in the .m format. "SpherePosition", "Normals",
/// "TCoords" and "RGB" of the points are written as traits: named values in braces, such as sph=(x
/// y z). "RGB" of the polygons is also a trait. Other arrays are omitted.
/// @return the text of the file
/// @throws std::invalid_argument if a "SpherePosition" is zero or not finite
/// @throws Aborted
std::string makeGuMesh(const SurfaceData& surface, const Run& run = {});
}

#endif
