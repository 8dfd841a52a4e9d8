/// Test whether the triangles of a mesh are as nearly equilateral as those made by remesh()
/// (Remeshing.h). The thresholds of the test are our own construction, because none are published.
/// The thresholds are between the values measured on scans and those measured on remeshed surfaces.

#ifndef ConformalEvenTriangles_h
#define ConformalEvenTriangles_h

#include "Mesh/Mesh.h"

namespace conformal
{
/// Test whether a closed mesh was probably made by remesh(). Two conditions must hold:
/// - The smallest angle of each triangle, averaged over all triangles, is at least 46 degrees.
/// - At least 99 % of the vertices belong to five, six or seven triangles.
///
/// In our measurements, scans satisfied neither condition. The test also accepts some meshes that
/// were not made by remesh():
/// - meshes of some thousand vertices that vtkConformalSOM learned with the property MeshType set
///   to Adaptive,
/// - some surfaces that were remeshed by other programs.
bool hasEvenTriangles(const Mesh& mesh);
}

#endif
