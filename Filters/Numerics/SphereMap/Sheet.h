/// Describe sheets: connected surfaces with a border and without handles. Fill their holes. Glue a
/// sheet to its mirror image. The closed surface is the Schottky double, \cite Ahlfors1960.

#ifndef ConformalSheet_h
#define ConformalSheet_h

#include "Base/Types.h"
#include "Mesh/Mesh.h"

#include <utility>
#include <vector>

namespace conformal
{
/// Mark the vertices on the border of a mesh: the vertices of edges with a single triangle.
/// @return #V marks, 1 on the border, otherwise 0
std::vector<char> borderVertices(const Triangles& triangles, Index numberOfVertices);

/// Fill all borders of a manifold but the longest, each by triangles around a new vertex at the
/// center of its vertices. New vertices and triangles follow the old ones.
Mesh withFilledHoles(const Mesh& mesh);

/// Split chords: edges inside of the mesh whose two ends are on the border. A new vertex is placed
/// in the middle of each chord. In a map that places the border on a circle, a triangle at the
/// chord would otherwise have no area. New vertices follow the old ones, and old vertices keep
/// their ids.
/// @param[in] border  result of borderVertices()
struct SplitSheet : Mesh
{
  std::vector<std::pair<int, int>> Ends; ///< ends of the chord of each new vertex
};
SplitSheet withSplitChords(const Mesh& mesh, const std::vector<char>& border);

/// Glue a sheet to a copy of it, along the border. The vertices of the sheet come first. Copies of
/// the vertices inside follow, in the same sequence. Triangles of the sheet come first; those of
/// the copy have the reverse orientation.
/// @param[in] border  result of borderVertices()
/// @pre the sheet has no chords, see withSplitChords()
struct DoubledSheet : Mesh
{
  std::vector<int> MirrorIds; ///< id of the mirror image of each vertex; itself on the border
};
DoubledSheet doubled(const Mesh& sheet, const std::vector<char>& border);
}

#endif
