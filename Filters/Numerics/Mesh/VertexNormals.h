/// Compute vertex normals of a triangle mesh: means of the triangles' normals, weighted by area, as
/// discussed in \cite Max1999.

#ifndef ConformalVertexNormals_h
#define ConformalVertexNormals_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

namespace conformal
{
/// Compute a unit normal at each vertex: the normalized, area-weighted mean of the normals of its
/// triangles. The normal is zero if the vertex has no triangles, or if the normals of its triangles
/// cancel each other.
///
/// @param[in] points     #V by 3 positions, in any unit
/// @param[in] triangles  #F by 3 ids
/// @return #V by 3 unit vectors or zeros
Points vertexNormals(const Points& points, const Triangles& triangles);

/// Compute vertex normals, given the triangles around each vertex.
/// @param[in] around  result of vertexTriangles() for these triangles
Points vertexNormals(
  const Points& points, const Triangles& triangles, const Adjacency& around, const Run& run = {});
}

#endif
