/// Whether a mesh has the even triangles that remeshing makes.

#ifndef ConformalEvenTriangles_h
#define ConformalEvenTriangles_h

#include "Mesh/Mesh.h"

namespace conformal
{
/// Whether a closed mesh is likely to come from remesh(): a mean smallest angle of at least 46
/// degrees, and 99 of 100 vertices with five to seven triangles. Scans stay below both, learned
/// adaptive lattices of some thousand vertices above; other remeshed surfaces may be above too.
bool hasEvenTriangles(const Mesh& mesh);
}

#endif
