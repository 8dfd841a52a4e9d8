/// Progressive mesh: a tetrahedron and the vertex splits that restore a closed surface, \cite
/// Hoppe1996.

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
/// Tetrahedron and the sequence of vertex splits that restores the mesh.
struct ProgressiveMesh
{
  VertexRings Rings;                             ///< connectivity of the tetrahedron
  std::vector<QuadricCollapse::Collapse> Splits; ///< in the order of VertexRings::split()
};

/// Build a progressive mesh by collapses in the order of quadric error.
/// @param[in] mesh  of size about 1, with triangles that pass requireGenusZero()
ProgressiveMesh makeProgressiveMesh(const Mesh& mesh,
  QuadricCollapse::Needles needles = QuadricCollapse::Needles::Keep, const Run& run = {});

/// Build a progressive mesh from connectivity alone, for surfaces without a usable shape. The
/// number of rounds is logarithmic in the number of vertices. Each round removes a set of vertices
/// of which no two share an edge, those with the fewest neighbors first, \cite Kirkpatrick1983.
ProgressiveMesh makeProgressiveMesh(
  const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Remove some vertices of a mesh in rounds of independent vertices, as makeProgressiveMesh() does.
/// @param[in] vertices  candidates in use; some may have to stay
/// @param[in] most      maximum number of vertices to remove; four vertices of the mesh always stay
/// @return the remaining rings, and the splits that restore the removed vertices
ProgressiveMesh takeOut(
  VertexRings rings, std::vector<int> vertices, Index maximum, const Run& run = {});
}

#endif
