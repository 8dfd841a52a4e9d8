/// Compute vertex normals of a triangle mesh with the area weights of \cite Max1999.

#ifndef ConformalVertexNormals_h
#define ConformalVertexNormals_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

namespace conformal
{
/// Compute area-weighted unit means of the normals of the triangles around each vertex. The result
/// is zero for a vertex without triangles or with normals that cancel.
///
/// @param[in] points     #V by 3, of any unit
/// @param[in] triangles  #F by 3 ids
/// @return #V by 3
Points vertexNormals(const Points& points, const Triangles& triangles);

/// Compute vertex normals, given the triangles around each vertex.
/// @param[in] around  vertexTriangles() of the triangles
Points vertexNormals(
  const Points& points, const Triangles& triangles, const Adjacency& around, const Run& run = {});
}

#endif
