/// Find vertices on the creases of a triangle mesh: edges at which two smooth parts of the surface
/// meet at an angle. The method is an own construction, not from a publication.

#ifndef ConformalCreases_h
#define ConformalCreases_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/MeshTopology.h"

#include <vector>

namespace conformal
{
/// Mark the vertices on creases.
///
/// An edge belongs to a crease if two conditions hold. First, the normals of its two triangles
/// differ by 37 degrees or more. Second, the surface bends much less on both sides of the edge. A
/// side consists of the triangles around the vertex opposite to the edge, as far as they can be
/// reached without crossing an angle of 37 degrees. On a side, no normal may differ from the normal
/// of the triangle at the edge by more than 0.4 times the angle of the edge, and a side has at
/// least two triangles. The second condition excludes round shapes with coarse triangles.
///
/// A vertex is marked if it has two or more such edges, since a crease continues in two directions.
///
/// @param[in] points  #V by 3 positions, in any unit
/// @param[in] triangles  #F by 3 ids of a closed mesh
/// @param[in] around  result of vertexTriangles() for these triangles
/// @param[in] across  result of triangleNeighbors() for these triangles
/// @return #V marks, 1 for vertices on creases, else 0
std::vector<unsigned char> creaseVertices(const Points& points, const Triangles& triangles,
  const Adjacency& around, const Triangles& across, const Run& run = {});
}

#endif
