/// Detect outliers: points off the surface sampled by the others, or far from all of them. Own
/// construction: planes through eight neighbors need neither normals nor a scale.

#ifndef ConformalStrayPoints_h
#define ConformalStrayPoints_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/PointTree.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// Plane through the points nearest to a position, without a point at the position itself.
struct NearestPlane
{
  Vector3 Normal;       ///< unit length
  double Offset = 0.0;  ///< signed distance of the plane from the position, along the normal
  Vector3 SquareWidths; ///< mean square extents along the principal axes, ascending
};

/// Fit a plane to the points nearest to a position.
/// @param[in] tree   of the points, more than `count`
/// @param[in] count  number of points
NearestPlane planeNear(
  const Points& points, const PointTree& tree, const Vector3& place, int count);

/// Test whether a position and its nearest points lie in one plane, for the eight or the sixteen
/// nearest points.
/// @param[in] tree  of the points, more than eight
bool liesFlat(const Points& points, const PointTree& tree, const Vector3& place);

/// Mark points off the surface that the points around them form. The limit of the distance from the
/// plane through the eight nearest other points is 0.8 times their root mean square width in that
/// plane. Points at sharp tips and some points of a very noisy cloud are marked too.
///
/// @param[in] points  #P by 3, finite
/// @return #P, 1 for an outlier, else 0; all 0 for up to eight points
/// @throws Aborted
std::vector<std::uint8_t> strayPoints(const Points& points, const Run& run = {});

/// Mark points far from all others, by the distance to their eighth neighbor. A point is marked if
/// that distance exceeds 3 times the median of its eight neighbors, or `farthest` times that of the
/// cloud.
///
/// Noise and sparse parts of a surface are kept. A point is not marked if a quarter of the 32
/// nearest such points lie flat, in a plane with their neighbors.
///
/// @param[in] points    #P by 3, finite
/// @param[in] farthest  maximum distance of the eighth neighbor, in units of the typical one
/// @return #P, 1 for an isolated point, else 0; all 0 for up to eight points
/// @throws Aborted
std::vector<std::uint8_t> isolatedPoints(
  const Points& points, double farthest = 8.0, const Run& run = {});
}

#endif
