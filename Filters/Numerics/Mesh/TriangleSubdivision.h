/// Cut the triangles of a closed mesh into smaller triangles of the same shape. Own construction:
/// new points are numbered by edges, because their ids then do not depend on the order of
/// computation.

#ifndef ConformalTriangleSubdivision_h
#define ConformalTriangleSubdivision_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Cut every triangle into k^2 smaller ones, with k equal segments along each edge. Both triangles
/// of an edge share the new points on it.
///
/// The #V old vertices come first, with unchanged ids. The k - 1 points on each edge follow,
/// starting near its vertex with the lower id. The points inside the triangles come last. The
/// pieces of triangle r have the ids r k^2 to (r + 1) k^2 - 1.
///
/// @param[in] mesh          closed manifold, consistently oriented
/// @param[in] subdivisions  number k of segments per edge, at least 1
/// @return mesh of #F k^2 triangles. For genus zero it has (#V - 2) k^2 + 2 vertices.
/// @throws std::invalid_argument if k is below 1, or ids do not fit into an int
/// @throws Aborted
Mesh subdivide(const Mesh& mesh, int subdivisions, const Run& run = {});

/// Find the minimum k for which subdivide() of a closed mesh of genus zero has at least the given
/// number of points. The result is at least 1.
int subdivisionsFor(Index numberOfVertices, double numberOfPoints);
}

#endif
