/// Editable connectivity of a closed triangle mesh, as a ring of neighbors for each vertex.

#ifndef ConformalVertexRings_h
#define ConformalVertexRings_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Neighbors of a vertex, counter-clockwise seen from outside. The rings define a closed mesh: the
/// triangles of vertex v are (v, ring[i], ring[i + 1]).
using Ring = std::vector<int>;

class VertexRings
{
public:
  /// @param[in] triangles  of a closed manifold, consistently oriented, without repeated vertices
  ///   in a triangle
  VertexRings(const Triangles& triangles, Index numberOfVertices);

  const Ring& operator[](int v) const { return this->Rings[v]; } ///< empty if v is not in use
  Index size() const { return static_cast<Index>(this->Rings.size()); }

  /// Test whether the mesh stays a closed manifold of the same genus when v collapses into its
  /// neighbor u. Their only common neighbors must be the two opposite their edge.
  /// @pre more than four vertices are in use
  bool canCollapse(int v, int u) const;

  /// Collapse v into its neighbor u. Vertex v is no longer in use.
  /// @return the former ring of v, starting with u
  Ring collapse(int v, int u);

  /// Undo a collapse; later collapses must have been undone before.
  /// @param[in] ring  result of collapse()
  void split(int v, const Ring& ring);

  /// Resize to vertices with ids in [0, count); new ones are not in use.
  void resize(Index count) { this->Rings.resize(count); }

  /// Insert vertex m into the edge of a and b and split both its triangles.
  /// @pre m is not in use
  void splitEdge(int a, int b, int m);

  /// Replace the edge of a and b by the edge between the two opposite vertices.
  /// @pre canFlip(a, b)
  void flip(int a, int b);

  /// Test whether the mesh stays a closed manifold when the edge of a and b is flipped. Both need
  /// more than three neighbors, and the opposite vertices must not be neighbors yet.
  bool canFlip(int a, int b) const;

  /// Vertices opposite the edge of a and b, in the triangles (a, b, left) and (b, a, right).
  struct Across
  {
    int Left, Right;
  };
  Across across(int a, int b) const;

  /// List each triangle once, with its smallest id first, in ascending order.
  Triangles triangles() const;

private:
  std::vector<Ring> Rings;
};
}

#endif
