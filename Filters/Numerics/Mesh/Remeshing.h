/// Remesh a closed surface to even triangles with a given number of vertices, \cite Botsch2004.

#ifndef ConformalRemeshing_h
#define ConformalRemeshing_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct RemeshingOptions
{
  Index NumberOfVertices = 12962; ///< target number of vertices, at least 4
  int NumberOfIterations = 3;     ///< number of iterations, each with the four steps of remesh()
  /// Whether to reach NumberOfVertices exactly, and finish with Delaunay flips
  bool MeetNumber = false;
};

/// Remesh a closed surface so that edges have about equal lengths, \cite Botsch2004. The target
/// length is the edge length at which equilateral triangles with the target number of vertices
/// cover the area of the surface. Each iteration has these steps:
/// - Split edges longer than 4/3 of the target length, longest first.
/// - Collapse edges shorter than 4/5 of the target length, shortest first.
/// - Flip edges so that vertices approach six neighbors.
/// - Move vertices along the surface to the centroid of their triangles.
///
/// No step changes the topology. No step makes a needle or rotates the normal of a triangle by 60
/// degrees or more. With MeetNumber, strongly folded surfaces that would otherwise keep too many
/// vertices are an exception. Vertices are not projected back to the input surface, so the caller
/// should fit the result to the data again.
///
/// Implementation note: the operations of each step are made in rounds. Of operations that touch
/// common vertices, a round selects the one with the best length or gain, then the smallest id. The
/// selected operations are independent and run concurrently, so the result has the same bits for
/// any number of threads.
///
/// @param[in,out] mesh  mesh to replace: finite, a closed manifold, consistently oriented, without
///   unused positions
/// @throws std::invalid_argument if an option is out of range
/// @throws Aborted
void remesh(Mesh& mesh, const RemeshingOptions& options, const Run& run = {});
}

#endif
