/// Compute normals, orientation, support and marks for samples of a curved seamless surface. The
/// surface consists of curved patches, and has one point for each direction. The samples are the
/// points for given directions, the vertices of a mesh on the sphere. Support, in [0, 1], is high
/// where points of the scan were near the surface. Marks show degenerate triangles. The method is
/// an own construction, not from a publication. Normals are averaged and filled in here, because
/// \cite Liou2008 does not specify the shading of the samples.

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

/// Return whether most of the area of a mesh is oriented opposite to given normals. If the normals
/// point outward, the result is true if the map to the sphere is mirrored.
bool isOrientedInward(
  const PointsIn& positions, const Triangles& triangles, const PointsIn& normals);

/// Replace the normal at each point by the normalized mean of the normals of adjacent triangles.
/// Use this function for surfaces with DomeHeight None, Published or Scaled. Their normals are the
/// normals of flat triangles, which are discontinuous at edges.
/// @param[in,out] normals  unit normals; unchanged at points where the mean is zero
void smoothNormals(const PointsIn& positions, const Triangles& triangles, PointsOut normals);

/// Replace each normal of length zero by the direction for which the point was evaluated.
void fillNormals(PointsOut normals, const PointsIn& directions, const Run& run = {});

/// Interpolate the support at given directions. The support of a vertex is in [0, 1], and high if
/// points of the scan were near the vertex. Between vertices, support is interpolated linearly on
/// the triangles of the sphere.
/// @param[in] support  support of each vertex of the surface, #V. Values are clamped to [0, 1].
///   Values that are not finite count as 0.
/// @param[in] directions  unit vectors, #P by 3
/// @return support in each direction, in [0, 1], #P
/// @throws Aborted
std::vector<double> supportAt(const CurvedSeamlessSurface& surface, const NumberView& support,
  const PointsIn& directions, const Run& run = {});

/// Mark the triangles that are within a degenerate triangle of the curved seamless surface.
/// @param[in] triangles  triangles of the mesh whose vertices are the directions
/// @param[in] subdivisions  number that was passed to subdividedNetwork(), or 0 if the directions
///   are not from this function. With 0, a triangle is marked if the direction of one of its
///   vertices is marked in `degenerate`.
/// @param[in] degenerate  mark of each direction, as written by evaluate(); used if subdivisions is
///   0
/// @param[out] marks  1 for each marked triangle, else 0
void markDegenerate(const CurvedSeamlessSurface& surface, const Triangles& triangles,
  int subdivisions, const std::vector<unsigned char>& degenerate, unsigned char* marks,
  const Run& run = {});
}

#endif
