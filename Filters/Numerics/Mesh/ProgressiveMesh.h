/// Progressive mesh: a tetrahedron, and vertex splits that restore a closed surface from it,
/// \cite Hoppe1996.

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
/// Tetrahedron, and the sequence of vertex splits that restores the mesh from it.
struct ProgressiveMesh
{
  VertexRings Rings; ///< connectivity of the tetrahedron
  /// Arguments of VertexRings::split(), in the order of the splits
  std::vector<QuadricCollapse::Collapse> Splits;
};

/// Build a progressive mesh by collapses in the order of their quadric error.
/// @param[in] mesh  mesh of size about 1 that passes requireGenusZero()
ProgressiveMesh makeProgressiveMesh(const Mesh& mesh,
  QuadricCollapse::Needles needles = QuadricCollapse::Needles::Keep, const Run& run = {});

/// Build a progressive mesh from connectivity alone, for surfaces whose shape is unusable. Each
/// round removes independent vertices: no two share an edge. Vertices with the fewest neighbors are
/// removed first, \cite Kirkpatrick1983. The number of rounds is logarithmic in the number of
/// vertices.
ProgressiveMesh makeProgressiveMesh(
  const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Remove some vertices of a mesh in rounds of independent vertices, as makeProgressiveMesh() does
/// for all vertices.
/// @param[in] vertices  ids of the vertices to remove; some may have to stay
/// @param[in] maximum   maximum number of vertices to remove; four vertices of the mesh always stay
/// @return rings of the remaining mesh, and the splits that restore the removed vertices
ProgressiveMesh takeOut(
  VertexRings rings, std::vector<int> vertices, Index maximum, const Run& run = {});
}

#endif
