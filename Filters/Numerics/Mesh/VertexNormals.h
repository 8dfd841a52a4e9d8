/// Normals of the vertices of a triangle mesh.

#ifndef ConformalVertexNormals_h
#define ConformalVertexNormals_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

namespace conformal
{
/// Unit means of the normals of the triangles around each vertex, weighted by their areas; zero
/// where there are none or they cancel.
///
/// @param[in] points  #V by 3, of any unit
/// @param[in] triangles   #F by 3 ids
/// @return #V by 3
Points vertexNormals(const Points& points, const Triangles& triangles);

/// @param[in] around  vertexTriangles of the triangles, where they are at hand
Points vertexNormals(
  const Points& points, const Triangles& triangles, const Adjacency& around, const Run& run = {});
}

#endif
