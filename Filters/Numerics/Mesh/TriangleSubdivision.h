/// Cut the triangles of a closed mesh into smaller ones of the same shape. Own construction:
/// numbering by edges makes ids independent of the order of work.

#ifndef ConformalTriangleSubdivision_h
#define ConformalTriangleSubdivision_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Cut every triangle into k x k triangles by k equal steps along each edge. Both triangles of an
/// edge share the points on it.
///
/// The order of the points is: the #V vertices, then k - 1 points on each edge, then the points
/// inside triangles. Points on an edge are counted from its vertex of smaller id. The parts of
/// triangle r start at triangle r k^2.
///
/// @param[in] mesh          a closed manifold, consistently oriented
/// @param[in] subdivisions  k, at least 1
/// @return #F k^2 triangles; (#V - 2) k^2 + 2 vertices if the Euler number is 2
/// @throws std::invalid_argument if k is below 1
/// @throws std::length_error if ids do not fit into an int
/// @throws Aborted
Mesh subdivide(const Mesh& mesh, int subdivisions, const Run& run = {});

/// Find the minimum k, at least 1, at which a closed mesh of genus zero has at least the given
/// number of points.
int subdivisionsFor(Index numberOfVertices, double numberOfPoints);
}

#endif
