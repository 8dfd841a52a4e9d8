/// Progressive mesh: a tetrahedron and the vertex splits that restore a closed surface.

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
/// \cite Hoppe1996
struct ProgressiveMesh
{
  VertexRings Rings;                             ///< of the tetrahedron
  std::vector<QuadricCollapse::Collapse> Splits; ///< in the order of Rings.split
};

/// @param[in] mesh  about of size one, with triangles that requireGenusZero() lets pass
ProgressiveMesh makeProgressiveMesh(const Mesh& mesh,
  QuadricCollapse::Needles needles = QuadricCollapse::Needles::Keep, const Run& run = {});

/// The same from the connectivity alone, for surfaces whose shape does not tell what to keep: in
/// each of a logarithmic number of rounds a share of the vertices goes, those with the fewest
/// neighbors first and no two that are joined \cite Kirkpatrick1983.
ProgressiveMesh makeProgressiveMesh(
  const Triangles& triangles, Index numberOfVertices, const Run& run = {});

/// Take some vertices out of a mesh in that way.
/// @param[in] vertices  in use; those that cannot go without the others stay
/// @param[in] most      how many are to go at most; four have to stay in the mesh
/// @return the rings without them, and the splits that put them back
ProgressiveMesh takeOut(
  VertexRings rings, std::vector<int> vertices, Index maximum, const Run& run = {});
}

#endif
