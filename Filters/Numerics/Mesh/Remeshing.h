/// Remesh a closed surface to nearly equilateral triangles of about equal size, with a given number
/// of vertices, \cite Botsch2004.

#ifndef ConformalRemeshing_h
#define ConformalRemeshing_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
struct RemeshingOptions
{
  /// Target number of vertices, at least 4. The default is that of a geodesic sphere (subdivided
  /// icosahedron) with 36 segments per edge of the icosahedron: 10 * 36^2 + 2.
  Index NumberOfVertices = 12962;
  int NumberOfIterations = 3; ///< number of iterations, each with the four steps of remesh()
  /// Whether the result has exactly NumberOfVertices vertices. If false, the number of vertices is
  /// approximate. If true, edges are also flipped by the Delaunay criterion: the two angles
  /// opposite the edge have a sum above pi.
  bool MeetNumber = false;
};

/// Remesh a closed surface so that edges have about equal lengths, \cite Botsch2004. The target
/// length is the edge length of a mesh of equilateral triangles with the area of the surface and
/// the target number of vertices. Each iteration has these steps:
/// - Split edges longer than 4/3 of the target length, the longest first.
/// - Collapse edges shorter than 4/5 of the target length, the shortest first.
/// - Flip an edge if the vertices of its two triangles then have numbers of neighbors closer to
///   six.
/// - Move each vertex along the surface toward the centroid of its triangles.
///
/// No step changes the topology. No step makes a needle (very thin triangle) or rotates the normal
/// of a triangle by 60 degrees or more. Because of these conditions, a strongly folded surface
/// possibly keeps too many vertices. If MeetNumber is true, further collapses are made without
/// these conditions. Vertices are not projected back to the input surface. The caller should
/// therefore fit the result to the original data (surface or points) again.
///
/// Implementation note: the splits, collapses and flips are made in rounds. Each round first lists
/// the possible operations, on all threads. The operations are then applied serially. Collapses
/// start with the shortest edge, splits with the longest, flips with the largest improvement. An
/// operation is skipped if another operation of the round changed one of its vertices. The result
/// has the same bits for any number of threads.
///
/// @param[in,out] mesh  mesh to replace: finite, a closed manifold, consistently oriented, without
///   unused positions
/// @throws std::invalid_argument if an option is out of range
/// @throws Aborted
void remesh(Mesh& mesh, const RemeshingOptions& options, const Run& run = {});
}

#endif
