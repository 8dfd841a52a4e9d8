/// Triangle meshes.

#ifndef ConformalMesh_h
#define ConformalMesh_h

#include "Base/Types.h"

namespace conformal
{
/// Vertices and the triangles between them.
struct Mesh
{
  Points Positions;               ///< #V by 3
  conformal::Triangles Triangles; ///< #F by 3 ids, counter-clockwise seen from outside
};

/// A closed mesh that knows its place on the sphere.
struct MappedMesh : Mesh
{
  Points SpherePositions; ///< #V by 3 unit vectors
};
}

#endif
