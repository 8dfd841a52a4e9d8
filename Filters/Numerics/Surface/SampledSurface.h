/// Compute normals, orientation, support and marks for samples of a curved seamless surface. The
/// surface consists of curved patches, and has one point for each direction (unit vector). The
/// given directions are the vertices of a mesh on the sphere. The sample of a direction is the
/// surface point for this direction. Samples have the triangles of the mesh. The surface was
/// learned from the points of a scan. Support, in [0, 1], is high where points of the scan are near
/// the surface. Marks show degenerate triangles.
///
/// Own construction: \cite Liou2008 does not specify normals for the shading of the samples. The
/// functions below therefore average normals, and replace normals of length zero.

#ifndef ConformalSampledSurface_h
#define ConformalSampledSurface_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Surface/CurvedSeamlessSurface.h"

#include <vector>

namespace conformal
{
using PointsIn = Eigen::Ref<const Points>; ///< #P by 3, a view of existing memory
using PointsOut = Eigen::Ref<Points>;      ///< #P by 3, a view of existing memory

/// Return whether most of the area of a mesh is oriented opposite to given normals. For outward
/// normals, the result is true if most of the area is clockwise seen from outside. If the triangles
/// are counter-clockwise on the sphere, the result is true for a mirrored map to the sphere.
bool isOrientedInward(
  const PointsIn& positions, const Triangles& triangles, const PointsIn& normals);

/// Replace the normal at each point by the normalized mean of the normals of adjacent triangles.
/// Use this function for surfaces with DomeHeight None, Published or Scaled
/// (CurvedSeamlessSurface.h). The normals of these surfaces are the normals of flat triangles,
/// which are discontinuous at edges.
/// @param[in,out] normals  unit normals; unchanged at points where the mean is zero
void smoothNormals(const PointsIn& positions, const Triangles& triangles, PointsOut normals);

/// Replace each normal of length zero by the direction for which the point was evaluated.
void fillNormals(PointsOut normals, const PointsIn& directions, const Run& run = {});

/// Return the support of each vertex of the network in [0, 1], as VertexNumbers of evaluate(). The
/// support of a vertex is high if points of the scan are near the vertex.
/// @param[in] support  support of each vertex of the surface, #V. Values are clamped to [0, 1].
///   Values that are not finite count as 0, and so do vertices of caps.
std::vector<double> clampedSupport(const CurvedSeamlessSurface& surface, const NumberView& support);

/// Mark those triangles of the sampled mesh that are parts of a degenerate triangle of the curved
/// seamless surface. See CurvedSeamlessSurface::degenerate().
/// @param[in] triangles  triangles of the mesh whose vertices are the directions
/// @param[in] subdivisions  number that was passed to subdividedNetwork(), or 0 if the directions
///   are not from this function. subdividedNetwork() divides each triangle of the surface. With 0,
///   a triangle is marked if the direction of one of its vertices is marked in `degenerate`.
/// @param[in] degenerate  mark of each direction, as written by evaluate(); used if subdivisions is
///   0
/// @param[out] marks  1 for each marked triangle, else 0
void markDegenerate(const CurvedSeamlessSurface& surface, const Triangles& triangles,
  int subdivisions, const std::vector<unsigned char>& degenerate, unsigned char* marks,
  const Run& run = {});
}

#endif
