/// Normals of the vertices of a triangle mesh.

#ifndef ConformalVertexNormals_h
#define ConformalVertexNormals_h

#include "Base/Parallel.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

namespace conformal
{
/// Unit means of the normals of the triangles around each vertex, weighted by their areas; zero
/// where there are none or they cancel.
///
/// @param[in] points  #V by 3, of any unit
/// @param[in] faces   #F by 3 ids
/// @return #V by 3
Points vertexNormals(const Points& points, const Triangles& faces);

/// @param[in] around  vertexTriangles of the faces, where they are at hand
Points vertexNormals(const Points& points, const Triangles& faces, const Adjacency& around,
  const ParallelFor& parallelFor = {});
}

#endif
