/// Remeshing of a closed surface to even triangles, with a given number of vertices.

#ifndef ConformalRemeshing_h
#define ConformalRemeshing_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct RemeshingOptions
{
  Index NumberOfVertices = 12962; ///< wanted, at least 4
  int NumberOfIterations = 3;     ///< of splitting, collapsing, flipping and smoothing
  bool MeetNumber = false;        ///< exactly, and end with Delaunay flips
};

/// Remesh a closed surface with edges of equal length \cite Botsch2004. Edges longer than 4/3 of it
/// are split, longest first; edges shorter than 4/5 are collapsed, shortest first; edges are
/// flipped towards six neighbors for each vertex; vertices move along the surface to the middle of
/// their triangles. The length is what as many vertices as wanted need on the surface's area.
///
/// No step changes the topology. Nor does one turn a normal by 60 degrees or more or make a needle,
/// unless a surface that is little but folds has too many vertices otherwise. Vertices
/// are not drawn back to the surface they came from: it is for meshes that are fitted to data
/// again.
///
/// Implementation note: operations are made in rounds. Each round takes those that come first, by
/// length or gain and then by id, among all that touch the same vertices; they are independent of
/// each other and made at the same time. So the result has the same bits for any number of threads.
///
/// @param[in,out] mesh  finite, a closed manifold, consistently oriented, each position used
/// @throws std::invalid_argument if an option is out of range
/// @throws Aborted
void remesh(Mesh& mesh, const RemeshingOptions& options, const Run& run = {});
}

#endif
