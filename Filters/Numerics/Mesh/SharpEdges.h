/// Sharp edges and corners of a surface whose triangles cut them off.

#ifndef ConformalSharpEdges_h
#define ConformalSharpEdges_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"

namespace conformal
{
/// Move vertices onto the edges and corners where planes meet at 37 degrees or more, of which the
/// triangles between the planes cut some off.
///
/// The normals of the triangles are smoothed, but not across jumps \cite Zheng2011, so that each
/// triangle across an edge takes the side of one plane. A vertex between triangles whose smoothed
/// normals are more than 37 degrees apart belongs to the edge, if most of the area around it has
/// its smoothed normal anyway: on a bend, or amid noise, it does not. It moves to where it is
/// closest to the planes of that area, onto the edge of two or into the corner of three
/// \cite Kobbelt2001.
///
/// It stays, or goes half or a quarter of the way, where a triangle would turn by a right angle
/// or more, become a needle, or fold on to another.
///
/// @param[in,out] mesh  a closed manifold, consistently oriented, its triangles about of one size;
///                      other vertices keep their bits
/// @return how many vertices moved
/// @throws Aborted
/// @post the result does not depend on the number of threads
Index sharpenEdges(Mesh& mesh, const Run& run = {});
}

#endif
