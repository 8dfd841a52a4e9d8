/// Cuts the triangles of a closed mesh into smaller ones of the same shape.

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

/// The least k at which a closed mesh of genus zero gets at least so many points. At least 1.
int subdivisionsFor(Index numberOfVertices, double numberOfPoints);
}

#endif
