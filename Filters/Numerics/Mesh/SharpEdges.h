/// Restore sharp edges and corners that the triangles of a surface cut off, \cite Kobbelt2001.

#ifndef ConformalSharpEdges_h
#define ConformalSharpEdges_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Move vertices onto the sharp edges and corners of the shape. An edge is sharp if its two planes
/// meet at 37 degrees or more.
///
/// The normals of the triangles are smoothed, but not across jumps, \cite Zheng2011. Each triangle
/// that cuts off an edge is thus assigned to one of the edge's planes. A vertex belongs to an edge
/// if smoothed normals of its triangles differ by more than 37 degrees. Most of the area around the
/// vertex must also lie in planes, which excludes bends and noise. The vertex moves to the point
/// closest to its planes: onto the edge of two planes, or into the corner of three,
/// \cite Kobbelt2001.
///
/// If the whole move would cause a defect, the vertex moves half or a quarter of the way, or stays.
/// Defects are needles, folds, and triangles rotated by a right angle or more.
///
/// @param[in,out] mesh  closed manifold, consistently oriented, with triangles of about equal size.
///   Vertices that are not moved keep their bits.
/// @return number of vertices moved
/// @throws Aborted
/// @post the result does not depend on the number of threads
Index sharpenEdges(Mesh& mesh, const Run& run = {});
}

#endif
