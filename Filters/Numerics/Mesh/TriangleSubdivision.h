/// Cut the triangles of a closed mesh into smaller ones of the same shape. Own construction:
/// numbering by edges makes ids independent of the order of work.

#ifndef ConformalTriangleSubdivision_h
#define ConformalTriangleSubdivision_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Cut every triangle into k x k, by k equal steps along each edge. Points on an edge are those of
/// both its triangles.
///
/// The #V vertices come first, as they are. Then the k - 1 points on each edge, counted from its
/// vertex of lower id, then those inside the triangles. Triangle r is cut into the triangles from
/// r k^2 on.
///
/// @param[in] mesh          a closed manifold, consistently oriented
/// @param[in] subdivisions  k, at least 1
/// @return (#V - 2) k^2 + 2 vertices and #F k^2 triangles, where the Euler number is 2
/// @throws std::invalid_argument if k is below 1, or ids do not fit into an int
/// @throws Aborted
Mesh subdivide(const Mesh& mesh, int subdivisions, const Run& run = {});

/// Find the minimum k, at least 1, at which a closed mesh of genus zero has at least the given
/// number of points.
int subdivisionsFor(Index numberOfVertices, double numberOfPoints);
}

#endif
