/// A closed triangle mesh that knows its place on the sphere.

#ifndef ConformalMappedMesh_h
#define ConformalMappedMesh_h

#include "Base/Types.h"

namespace conformal
{
/// A closed mesh with its map to the sphere, from which learning may start.
struct MappedMesh
{
  Points Positions;       ///< #V by 3, in the points' own coordinates
  Triangles Faces;        ///< #F by 3
  Points SpherePositions; ///< #V by 3 unit vectors
};
}

#endif
