/// Build a progressive mesh: a tetrahedron, and the vertex splits that restore a closed surface
/// from the tetrahedron, \cite Hoppe1996. A half-edge collapse removes a vertex by merging it into
/// a neighbor. A vertex split inserts the vertex again.

#ifndef ConformalProgressiveMesh_h
#define ConformalProgressiveMesh_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Mesh/Mesh.h"
#include "Mesh/QuadricCollapse.h"
#include "Mesh/VertexRings.h"

#include <vector>

namespace conformal
{
/// Tetrahedron, and the sequence of vertex splits that restores a mesh from the tetrahedron.
struct ProgressiveMesh
{
  /// Connectivity after all removals. The remaining mesh is a tetrahedron, unless takeOut() removed
  /// only some vertices.
  VertexRings Rings;
  /// Arguments of VertexRings::split() for each split, in the sequence of the splits
  std::vector<QuadricCollapse::Collapse> Splits;
};

/// Build a progressive mesh by half-edge collapses. Collapses that change the shape least are made
/// first. The change is measured by the quadric error (QuadricCollapse.h).
/// @param[in] mesh  mesh that passes requireGenusZero(), with coordinates of magnitude about 1
ProgressiveMesh makeProgressiveMesh(const Mesh& mesh,
  QuadricCollapse::Needles needles = QuadricCollapse::Needles::Keep, const Run& run = {});

/// Build a progressive mesh from connectivity alone. Use this function if the positions of a
/// surface are unusable. Vertices are removed in rounds. Vertices that are removed in the same
/// round share no edges. Vertices with the fewest neighbors are removed first,
/// \cite Kirkpatrick1983. The number of rounds is logarithmic in the number of vertices.
ProgressiveMesh makeProgressiveMesh(
  const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Remove given vertices of a mesh in rounds. Vertices that are removed in the same round share no
/// edges.
/// @param[in] vertices  ids of the vertices to remove. A vertex stays if each of its collapses
///   would change the topology.
/// @param[in] maximum   maximum number of vertices to remove. At least four vertices of triangles
///   must remain.
/// @return connectivity of the remaining mesh, and the splits that restore the removed vertices
ProgressiveMesh takeOut(
  VertexRings rings, std::vector<int> vertices, Index maximum, const Run& run = {});
}

#endif
