/// Compute normals, orientation, support and marks of a curved seamless surface that was evaluated
/// at the vertices of a mesh of directions. Own construction: normals are averaged and filled in
/// here, because \cite Liou2008 does not specify the shading of the samples.

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

/// Return whether most of the area is oriented against the normals. This is the case for a mirrored
/// map to the sphere.
bool isOrientedInward(
  const PointsIn& positions, const Triangles& triangles, const PointsIn& normals);

/// Replace the normal at each point by the normalized mean of the normals of the triangles around
/// it. Use this function for surfaces without continuous normals: flat triangles, with or without
/// the domes of the sphere.
/// @param[in,out] normals  unit normals; unchanged at points where the mean is zero
void smoothNormals(const PointsIn& positions, const Triangles& triangles, PointsOut normals);

/// Replace each normal of length zero by the direction of its point.
void fillNormals(PointsOut normals, const PointsIn& directions, const Run& run = {});

/// Interpolate the support of the network's vertices linearly.
/// @param[in] support     #V, support of each vertex. Values are clamped to [0, 1]; values that are
///   not finite count as 0
/// @param[in] directions  #P by 3 unit vectors
/// @return #P, support in each direction, in [0, 1]
/// @throws Aborted
std::vector<double> supportAt(const CurvedSeamlessSurface& surface, const NumberView& support,
  const PointsIn& directions, const Run& run = {});

/// Mark the triangles that lie in a degenerate triangle of the network.
/// @param[in] triangles     triangles whose vertices are the directions
/// @param[in] subdivisions  number passed to subdividedNetwork(), or 0 for other directions. With
///   0, a triangle is marked if one of its vertices is degenerate.
/// @param[in] degenerate    mark of each direction, as written by evaluate(); used if subdivisions
///   is 0
/// @param[out] marks        1 for each marked triangle
void markDegenerate(const CurvedSeamlessSurface& surface, const Triangles& triangles,
  int subdivisions, const std::vector<unsigned char>& degenerate, unsigned char* marks,
  const Run& run = {});
}

#endif
