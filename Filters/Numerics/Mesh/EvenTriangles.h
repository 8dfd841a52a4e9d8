/// Test whether a mesh has the even triangles that remeshing makes. Own construction: thresholds
/// between those measured on scans and on remeshed surfaces.

#ifndef ConformalEvenTriangles_h
#define ConformalEvenTriangles_h

#include "Mesh/Mesh.h"

namespace conformal
{
/// Test whether a closed mesh likely results from remesh(). The mean over the triangles of their
/// minimum angle must be at least 46 degrees. At least 99 % of the vertices must have five to seven
/// triangles. Scans stay below both limits. Learned adaptive meshes of some thousand vertices
/// exceed them, and other remeshed surfaces may.
bool hasEvenTriangles(const Mesh& mesh);
}

#endif
