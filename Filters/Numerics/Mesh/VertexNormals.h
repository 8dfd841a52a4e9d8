/// Compute vertex normals of a triangle mesh with the area weights of \cite Max1999.

#ifndef ConformalVertexNormals_h
#define ConformalVertexNormals_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

namespace conformal
{
/// Compute vertex normals: the area-weighted means of the normals of the triangles around each
/// vertex, normalized to unit length. A normal is zero for a vertex without triangles, or if the
/// triangles' normals cancel each other.
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
