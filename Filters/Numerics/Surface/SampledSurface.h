/// Normals, orientation, support and marks of a curved seamless surface that was evaluated at the
/// vertices of a mesh of directions. Own construction: \cite Liou2008 does not specify the shading
/// of the samples.

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

/// Return whether most of the area is oriented against the normals, as for a mirrored map to the
/// sphere.
bool isOrientedInward(
  const PointsIn& positions, const Triangles& triangles, const PointsIn& normals);

/// Replace normals by the unit means of the triangles' normals around each point. Use it for
/// surfaces without continuous normals: flat triangles, with or without the domes of the sphere.
/// @param[in,out] normals  unchanged at points without a mean normal
void smoothNormals(const PointsIn& positions, const Triangles& triangles, PointsOut normals);

/// Replace normals of length zero by the directions of their points.
void fillNormals(PointsOut normals, const PointsIn& directions, const Run& run = {});

/// Interpolate the support of the network's vertices linearly.
/// @param[in] support     #V, clamped to [0, 1]; 0 where it is not finite
/// @param[in] directions  #P by 3 unit vectors
/// @return #P, in [0, 1]
/// @throws Aborted
std::vector<double> supportAt(const CurvedSeamlessSurface& surface, const NumberView& support,
  const PointsIn& directions, const Run& run = {});

/// Mark triangles that lie in a degenerate triangle of the network.
/// @param[in] triangles     over the directions
/// @param[in] subdivisions  of subdividedNetwork(), or 0 for other directions. With 0, a triangle
///   is marked if one of its vertices is degenerate.
/// @param[in] degenerate    for each direction, as written by evaluate(); used if subdivisions is 0
/// @param[out] marks        1 for each marked triangle
void markDegenerate(const CurvedSeamlessSurface& surface, const Triangles& triangles,
  int subdivisions, const std::vector<unsigned char>& degenerate, unsigned char* marks,
  const Run& run = {});
}

#endif
