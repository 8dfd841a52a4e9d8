/// Restore sharp edges and corners of a surface that its triangles cut off, \cite Kobbelt2001.

#ifndef ConformalSharpEdges_h
#define ConformalSharpEdges_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Move vertices onto sharp edges and corners, where planes meet at 37 degrees or more and
/// triangles cut the edge off.
///
/// The normals of the triangles are smoothed, but not across jumps \cite Zheng2011, so that each
/// triangle across an edge joins one of the planes. A vertex belongs to an edge if smoothed normals
/// of its triangles differ by more than 37 degrees. Most of the area around it must also lie in
/// planes, which excludes bends and noise. The vertex moves to the point closest to these planes:
/// onto the edge of two, or into the corner of three \cite Kobbelt2001.
///
/// A vertex moves half or a quarter of the way, or stays, to avoid defects. Defects are a triangle
/// rotated by a right angle or more, a needle, or a fold.
///
/// @param[in,out] mesh  a closed manifold, consistently oriented, with triangles of about equal
///   size; other vertices keep their bits
/// @return the number of vertices moved
/// @throws Aborted
/// @post the result does not depend on the number of threads
Index sharpenEdges(Mesh& mesh, const Run& run = {});
}

#endif
