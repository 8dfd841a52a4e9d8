/// Adjacency of vertices and triangles in a triangle mesh.

#ifndef ConformalMeshTopology_h
#define ConformalMeshTopology_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Lists of ids, one for each item: list i is Ids[Offsets[i]] ... Ids[Offsets[i + 1] - 1].
struct Adjacency
{
  std::vector<int> Offsets;
  std::vector<int> Ids;

  const int* begin(Index i) const { return this->Ids.data() + this->Offsets[i]; }
  const int* end(Index i) const { return this->Ids.data() + this->Offsets[i + 1]; }
  int size(Index i) const { return this->Offsets[i + 1] - this->Offsets[i]; }
};

/// List the triangles around each vertex in ascending order.
/// @param[in] triangles         #F by 3 ids in [0, numberOfVertices)
/// @param[in] numberOfVertices  #V
Adjacency vertexTriangles(const Triangles& triangles, Index numberOfVertices);

/// List the vertices that share an edge with each vertex, each once, in ascending order.
Adjacency vertexNeighbors(const Triangles& triangles, Index numberOfVertices);

/// Find the triangle across each edge. Entry (r, k) is the triangle that shares edge (k, k + 1 mod
/// 3) of triangle r in the opposite direction, or -1.
/// @pre no directed edge belongs to two triangles, see checkGenusZero()
Triangles triangleNeighbors(
  const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Find the triangle across each edge, given the triangles around each vertex.
/// @param[in] around  vertexTriangles() of the triangles
Triangles triangleNeighbors(
  const Triangles& triangles, const Adjacency& around, const Run& run = {});

/// Count the edges of triangles without an opposite edge in another triangle: 0 for a closed,
/// consistently oriented mesh.
Index countOpenEdges(const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Call a visitor with each neighbor of a vertex.
using VisitNeighbors = std::function<void(int vertex, const std::function<void(int)>& visit)>;

/// Partition vertices into sets of which no two members are neighbors, so that the vertices of one
/// set can move concurrently. Greedy coloring: each vertex joins the first set without a neighbor
/// of it, in the given order.
/// @param[in] vertices  ids in [0, numberOfVertices), each once
std::vector<std::vector<int>> independentSets(
  const std::vector<int>& vertices, int numberOfVertices, const VisitNeighbors& visitNeighbors);
}

#endif
