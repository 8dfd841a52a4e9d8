/// Edit the connectivity of a closed triangle mesh, stored as a ring of neighbors for each vertex.

#ifndef ConformalVertexRings_h
#define ConformalVertexRings_h

#include "Base/Types.h"

#include <vector>

namespace conformal
{
/// Neighbors of a vertex, counter-clockwise seen from outside. The rings define a closed mesh: the
/// triangles of vertex v are (v, ring[i], ring[i + 1]), where the first neighbor follows the last.
using Ring = std::vector<int>;

/// Connectivity of a closed triangle mesh. Edits change the triangles, but not the ids of vertices.
class VertexRings
{
public:
  /// @param[in] triangles  triangles of a closed manifold, consistently oriented; no triangle
  ///   repeats a vertex
  VertexRings(const Triangles& triangles, Index numberOfVertices);

  /// Return the ring of v. The ring is empty if v is not in use, that is, not a vertex of any
  /// triangle.
  const Ring& operator[](int v) const { return this->Rings[v]; }
  Index size() const { return static_cast<Index>(this->Rings.size()); }

  /// Test whether the mesh stays a closed manifold of the same genus if v collapses into (merges
  /// with) its neighbor u. The result is true if v and u have exactly two common neighbors, the
  /// vertices opposite their common edge.
  /// @pre more than four vertices are in use
  bool canCollapse(int v, int u) const;

  /// Test whether a collapse of v into its neighbor u would make a loop of three edges that bounds
  /// no triangle. A part of the surface then hangs on three edges, and maps distort it.
  /// @pre canCollapse(v, u)
  bool collapsePinches(int v, int u) const;

  /// Collapse v into its neighbor u. Vertex v is then no longer in use.
  /// @return ring of v before the collapse, starting with u
  Ring collapse(int v, int u);

  /// Undo the collapse of v. All later collapses must already be undone.
  /// @param[in] ring  result of collapse() for v
  void split(int v, const Ring& ring);

  /// Change the number of vertex ids to `count`. New ids are not in use.
  void resize(Index count) { this->Rings.resize(count); }

  /// Insert vertex m into the edge between a and b, and split both triangles of this edge.
  /// @pre m is not in use
  void splitEdge(int a, int b, int m);

  /// Flip the edge between a and b: replace this edge by the edge between the two vertices opposite
  /// it.
  /// @pre canFlip(a, b)
  void flip(int a, int b);

  /// Test whether the mesh stays a closed manifold if the edge between a and b is flipped. Two
  /// conditions must hold:
  /// - Vertices a and b each have more than three neighbors.
  /// - The two vertices opposite the edge are not neighbors.
  bool canFlip(int a, int b) const;

  /// Test whether a flip of the edge between a and b would make a loop of three edges that bounds
  /// no triangle, see collapsePinches().
  /// @pre canFlip(a, b)
  bool flipPinches(int a, int b) const;

  /// Vertices opposite the edge between a and b. The triangles of the edge are (a, b, Left) and (b,
  /// a, Right).
  struct Across
  {
    int Left, Right;
  };
  Across across(int a, int b) const;

  /// List each triangle once, in ascending order. Each triangle starts with its smallest vertex id.
  Triangles triangles() const;

private:
  std::vector<Ring> Rings;
};
}

#endif
