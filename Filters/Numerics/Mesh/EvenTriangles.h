/// Test whether the triangles of a mesh are as even as those made by remeshing. Own construction:
/// thresholds between values measured on scans and on remeshed surfaces, because none are
/// published.

#ifndef ConformalEvenTriangles_h
#define ConformalEvenTriangles_h

#include "Mesh/Mesh.h"

namespace conformal
{
/// Test whether a closed mesh was probably made by remesh(). The minimum angle of a triangle,
/// averaged over all triangles, must be at least 46 degrees. At least 99 % of the vertices must
/// have five to seven triangles. Scans stay below both limits. Learned adaptive meshes of some
/// thousand vertices pass the test, and so may surfaces that other programs remeshed.
bool hasEvenTriangles(const Mesh& mesh);
}

#endif
