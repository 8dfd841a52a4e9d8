/// Restore sharp edges and corners of a shape that are beveled by the triangles of its mesh,
/// \cite Kobbelt2001.

#ifndef ConformalSharpEdges_h
#define ConformalSharpEdges_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Maximum cosine between the normals at a sharp edge, 37 degrees or more.
inline constexpr double SharpCosine = 0.8;

/// Move vertices of a mesh onto the sharp edges and corners of the shape. A sharp edge is the
/// intersection of two nearly planar parts whose normals differ by 37 degrees or more.
///
/// The normals of the triangles are smoothed, but not across jumps of the normal, \cite Zheng2011.
/// A triangle that bevels a sharp edge thus gets the normal of one of the two planes of the edge. A
/// vertex belongs to a sharp edge if two conditions hold. First, the smoothed normals of its
/// triangles differ by more than 37 degrees. Second, most of the area around the vertex consists of
/// nearly planar parts. The second condition excludes bends and noise. The vertex moves to the
/// point closest to the planes of these parts. This point is on the edge of two planes, or in the
/// corner of three planes, \cite Kobbelt2001.
///
/// If the whole move would cause a defect, half and a quarter of the move are tried. If all three
/// moves would cause a defect, the vertex does not move. Defects are needles (very thin triangles),
/// folds, and triangles rotated by a right angle or more.
///
/// @param[in,out] mesh  closed manifold, consistently oriented, with triangles of about equal size.
///   Positions of vertices that are not moved keep all bits.
/// @return number of vertices moved
/// @throws Aborted
/// @post the result does not depend on the number of threads
Index sharpenEdges(Mesh& mesh, const Run& run = {});
}

#endif
