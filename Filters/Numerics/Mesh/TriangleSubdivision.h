/// Cut each triangle of a closed mesh into smaller triangles of the same shape. The numbering is
/// our own construction: new points on edges precede all points inside triangles. Ids thus do not
/// depend on the sequence in which triangles are cut.

#ifndef ConformalTriangleSubdivision_h
#define ConformalTriangleSubdivision_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Cut every triangle into k^2 smaller triangles, with k equal segments along each edge. Both
/// triangles of an edge share the new points on this edge.
///
/// The #V old vertices come first, with unchanged ids. The k - 1 points on each edge follow,
/// starting near the end of the edge with the lower vertex id. The points inside the triangles come
/// last. Triangle r is cut into the new triangles r k^2 to (r + 1) k^2 - 1.
///
/// @param[in] mesh          closed manifold, consistently oriented
/// @param[in] subdivisions  number k of segments per edge, at least 1
/// @return mesh of #F k^2 triangles. If the genus is zero, the result has (#V - 2) k^2 + 2
///   vertices.
/// @throws std::invalid_argument if k is below 1, or ids do not fit into an int
/// @throws Aborted
Mesh subdivide(const Mesh& mesh, int subdivisions, const Run& run = {});

/// Find the minimum number k, at least 1, for which subdivide() returns at least `numberOfPoints`
/// vertices. The mesh to subdivide is closed and has genus zero and `numberOfVertices` vertices.
int subdivisionsFor(Index numberOfVertices, double numberOfPoints);
}

#endif
