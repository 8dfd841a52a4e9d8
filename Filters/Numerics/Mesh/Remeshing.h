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
  int NumberOfIterations = 3;     ///< iterations of splitting, collapsing, flipping and smoothing
  /// Reach NumberOfVertices exactly, and finish with Delaunay flips
  bool MeetNumber = false;
};

/// Remesh a closed surface with edges of equal length \cite Botsch2004. The target length is that
/// of equilateral triangles with the target number of vertices on the area of the surface.
/// - Split edges longer than 4/3 of the target length, longest first.
/// - Collapse edges shorter than 4/5 of the target length, shortest first.
/// - Flip edges so that vertices approach six neighbors.
/// - Move vertices along the surface to the centroid of their triangles.
///
/// No step changes the topology. No step rotates a normal by 60 degrees or more or makes a needle.
/// An exception is a surface of folds that otherwise keeps too many vertices. Vertices are not
/// projected back to the input surface: the result is to be fitted to data again.
///
/// Implementation note: operations are made in rounds. Each round selects operations by length or
/// gain, then by id, among all that touch common vertices. The selected operations are independent
/// and run concurrently, so the result has the same bits for any number of threads.
///
/// @param[in,out] mesh  finite, a closed manifold, consistently oriented, each position used
/// @throws std::invalid_argument if an option is out of range
/// @throws Aborted
void remesh(Mesh& mesh, const RemeshingOptions& options, const Run& run = {});
}

#endif
