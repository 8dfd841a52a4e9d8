/// Remove slivers, very thin triangles, from a closed mesh. Maps are computed by weights that
/// depend on angles, and one sliver can have a quasi-conformal error of thousands.
///
/// Own construction, from the edge flips and collapses of \cite Botsch2004. Here, they are made
/// only at slivers, so that a mesh without slivers keeps its bits.

#ifndef ConformalSlivers_h
#define ConformalSlivers_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

#include <array>
#include <vector>

namespace conformal
{
/// Changes made by removeSlivers().
struct SliverRemoval
{
  Index Before = 0, After = 0; ///< numbers of slivers
  /// #V, the two vertices of the former mesh from which each vertex was made; twice the same vertex
  /// if it was kept. Empty if the mesh did not change.
  std::vector<std::array<int, 2>> Sources;
};

/// Remove slivers. Let A be the area of a triangle, and S the sum of its squared edge lengths. A
/// triangle is a sliver if 4 sqrt(3) A / S is below 0.1 (1 if equilateral). Its smallest angle is
/// then below about 6 degrees.
///
/// First, small parts of the surface that are joined to the rest by three edges are cut off. Such a
/// part has at most 0.5 % of the vertices, and reaches at most 1.5 times the longest of these edges
/// beyond them. A map to the sphere cannot represent it. Longer parts, such as thin tails, belong
/// to the object.
///
/// The worst sliver is first. Its longest edge is flipped, or one of its edges collapses, so that
/// the worst of the changed triangles is better than before. No other triangle turns by 26 degrees
/// or more. As many edges as collapsed are then split, the longest first, so that the mesh keeps
/// its number of vertices.
///
/// @param[in,out] mesh  finite, a closed manifold, consistently oriented, without unused positions.
///   A mesh without slivers and such parts does not change.
/// @throws Aborted
/// @post genus, number of vertices and number of triangles are those of the input
SliverRemoval removeSlivers(Mesh& mesh, const Run& run = {});
}

#endif
