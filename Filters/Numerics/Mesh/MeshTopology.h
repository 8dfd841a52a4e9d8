/// Adjacency of vertices and triangles in a triangle mesh.

#ifndef ConformalMeshTopology_h
#define ConformalMeshTopology_h

#include "Base/Run.h"
#include "Base/Types.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Lists of ids, one list an item: list i is Ids[Offsets[i]] ... Ids[Offsets[i + 1] - 1].
struct Adjacency
{
  std::vector<int> Offsets;
  std::vector<int> Ids;

  const int* begin(Index i) const { return this->Ids.data() + this->Offsets[i]; }
  const int* end(Index i) const { return this->Ids.data() + this->Offsets[i + 1]; }
  int size(Index i) const { return this->Offsets[i + 1] - this->Offsets[i]; }
};

/// Triangles around each vertex, ids ascending.
/// @param[in] triangles             #F by 3 ids in [0, numberOfVertices)
/// @param[in] numberOfVertices  #V
Adjacency vertexTriangles(const Triangles& triangles, Index numberOfVertices);

/// Vertices that share an edge with each vertex, ids ascending, each once.
Adjacency vertexNeighbors(const Triangles& triangles, Index numberOfVertices);

/// Across each edge: entry (r, k) is the triangle that shares edge (k, k + 1 mod 3) of triangle r
/// with the opposite sense, or -1 where none does.
/// @pre no directed edge belongs to two triangles (checkGenusZero tells)
Triangles triangleNeighbors(
  const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// @param[in] around  vertexTriangles of the triangles, where they are at hand
Triangles triangleNeighbors(
  const Triangles& triangles, const Adjacency& around, const Run& run = {});

/// Edges of triangles across which no triangle has the opposite sense: 0 for a closed mesh whose
/// triangles are oriented alike.
Index countOpenEdges(const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Calls a visitor with each neighbor of a vertex.
using VisitNeighbors = std::function<void(int vertex, const std::function<void(int)>& visit)>;

/// Sets of vertices of which no two are neighbors, so that those of a set can be moved at the same
/// time. Each vertex takes the first set that has no neighbor of it, in the order given.
/// @param[in] vertices  ids in [0, numberOfVertices), each once
std::vector<std::vector<int>> independentSets(
  const std::vector<int>& vertices, int numberOfVertices, const VisitNeighbors& visitNeighbors);
}

#endif
