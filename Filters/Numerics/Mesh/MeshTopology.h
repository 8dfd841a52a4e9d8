/// Find neighboring vertices and triangles of a triangle mesh, and its borders. Partition vertices
/// into sets in which no two vertices are neighbors.

#ifndef ConformalMeshTopology_h
#define ConformalMeshTopology_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <functional>
#include <vector>

namespace conformal
{
/// Lists of ids, for example the ids of the triangles around each vertex. List i is
/// Ids[Offsets[i]], ..., Ids[Offsets[i + 1] - 1].
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
/// @param[in] numberOfVertices  #V, the number of vertices
Adjacency vertexTriangles(const Triangles& triangles, Index numberOfVertices);

/// List the neighbors of each vertex once, in ascending order. Two vertices are neighbors if they
/// share an edge.
Adjacency vertexNeighbors(const Triangles& triangles, Index numberOfVertices);

/// List the vertices that belong to a triangle, in ascending order.
std::vector<int> usedVertices(const Triangles& triangles, Index numberOfVertices);

/// Shortest paths along edges to the nearest of some vertices.
struct EdgePaths
{
  std::vector<double> Lengths; ///< for each vertex; -1 if it is not connected with a source
  /// For each vertex, the next vertex on its path; its own id for a source, and -1 if it is not
  /// connected with a source
  std::vector<int> Ways;
};

/// Find the shortest paths along edges to the nearest of some vertices, \cite Dijkstra1959.
/// @param[in] sources  ids of vertices
EdgePaths pathsAlongEdges(const Mesh& mesh, const std::vector<int>& sources);

/// Find the triangle across each edge. Entry (r, k) of the result belongs to edge (k, k + 1 mod 3)
/// of triangle r. Its value is the id of the triangle that contains this edge in the opposite
/// direction. If there is no such triangle, the value is -1.
/// @pre no edge has the same direction in two triangles, see checkGenusZero()
Triangles triangleNeighbors(
  const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Find the triangle across each edge, given the triangles around each vertex.
/// @param[in] around  result of vertexTriangles() for these triangles
Triangles triangleNeighbors(
  const Triangles& triangles, const Adjacency& around, const Run& run = {});

/// Count the directed edges (three per triangle) whose opposite direction occurs in no other
/// triangle. The result is 0 for a closed, consistently oriented mesh.
Index countOpenEdges(const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Border of a mesh, a closed curve of edges with a single triangle: ids of its vertices, in the
/// direction of the triangles' edges. The mesh is on the left, seen from outside.
using BorderLoop = std::vector<int>;

/// Return the borders of a mesh, the longest first. The others are in the sequence of their
/// smallest ids.
/// @pre manifold and consistently oriented, so that each vertex is on at most one border
std::vector<BorderLoop> borderLoops(const Mesh& mesh);

/// Function that calls `visit` with each neighbor of a vertex.
using VisitNeighbors = std::function<void(int vertex, const std::function<void(int)>& visit)>;

/// Partition vertices into independent sets. No two vertices of an independent set are neighbors.
/// Threads can therefore move all vertices of a set concurrently, even if each move depends on the
/// neighbors. The method is greedy coloring in the given sequence of vertices. Each vertex is added
/// to the first set that contains none of its neighbors.
/// @param[in] vertices  ids in [0, numberOfVertices), each once
std::vector<std::vector<int>> independentSets(
  const std::vector<int>& vertices, int numberOfVertices, const VisitNeighbors& visitNeighbors);
}

#endif
