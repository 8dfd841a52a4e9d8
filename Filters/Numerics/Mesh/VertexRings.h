/// Editable connectivity of a closed triangle mesh, as a ring of neighbors for each vertex.

#ifndef ConformalVertexRings_h
#define ConformalVertexRings_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// The neighbors of a vertex, counter-clockwise seen from outside. They say all about a closed
/// mesh: the triangles of vertex v are (v, ring[i], ring[i + 1]).
using Ring = std::vector<int>;

class VertexRings
{
public:
  /// @param[in] triangles  of a closed manifold, consistently oriented, no vertex twice in one
  VertexRings(const Triangles& triangles, Index numberOfVertices);

  const Ring& operator[](int v) const { return this->Rings[v]; } ///< empty if v is not in use
  Index size() const { return static_cast<Index>(this->Rings.size()); }

  /// Whether the mesh stays a closed manifold of the same genus when v moves into its neighbor u:
  /// they have no common neighbors but the two of their edge.
  /// @pre more than four vertices are in use
  bool canCollapse(int v, int u) const;

  /// Move v into its neighbor u, which takes it out of use.
  /// @return the ring that v had, u first
  Ring collapse(int v, int u);

  /// Undo a collapse, of which later ones are undone already.
  /// @param[in] ring  as collapse() returned it
  void split(int v, const Ring& ring);

  /// Make room for vertices of ids in [0, count); new ones are not in use.
  void resize(Index count) { this->Rings.resize(count); }

  /// Put vertex m into the edge of a and b, which divides the two triangles beside it.
  /// @pre m is not in use
  void splitEdge(int a, int b, int m);

  /// Take the edge of a and b away and join the two vertices across it instead.
  /// @pre canFlip(a, b)
  void flip(int a, int b);

  /// Whether the mesh stays a closed manifold when the edge of a and b is flipped: both have more
  /// than three neighbors, and the vertices across are not joined yet.
  bool canFlip(int a, int b) const;

  /// The vertices across the edge of a and b: of the triangles (a, b, left) and (b, a, right).
  struct Across
  {
    int Left, Right;
  };
  Across across(int a, int b) const;

  /// Each triangle once, its smallest id first, ascending.
  Triangles triangles() const;

private:
  std::vector<Ring> Rings;
};
}

#endif
