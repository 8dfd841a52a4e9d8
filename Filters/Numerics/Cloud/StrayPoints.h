/// Detects stray points: off the surface sampled by the others, or far from all of them.

#ifndef ConformalStrayPoints_h
#define ConformalStrayPoints_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Search/PointTree.h"

#include <cstdint>
#include <vector>

namespace conformal
{
/// The plane through the points that are nearest to a place, one at the place itself left out.
struct NearestPlane
{
  Vector3 Normal;       ///< unit length
  double Offset = 0.0;  ///< of the plane from the place, along the normal
  Vector3 SquareWidths; ///< mean squares along the principal axes, ascending
};

/// @param[in] tree  of the points, more than `count`
NearestPlane planeNear(
  const Points& points, const PointTree& tree, const Vector3& place, int count);

/// Test whether a place lies in the plane of its eight or sixteen nearest points, which lie in one.
/// @param[in] tree  of the points, more than eight
bool liesFlat(const Points& points, const PointTree& tree, const Vector3& place);

/// Mark points that lie off the surface which the points around them make up: farther from the
/// plane through the eight nearest other points, along its normal, than 0.8 times the root mean
/// square width of these in it. Points at sharp tips and some of a very noisy cloud are marked too.
///
/// @param[in] points  #P by 3, finite
/// @return #P, 1 for a stray point, else 0; all 0 for up to eight points
/// @throws Aborted
std::vector<std::uint8_t> strayPoints(const Points& points, const Run& run = {});

/// Mark points that are far from all others: whose eighth neighbor is more than 3 times as far as
/// those of its eight neighbors typically are, or more than `farthest` times as far as the typical
/// point's.
/// Noise is kept, and so are sparse parts of a surface: where a quarter of the points that would be
/// marked lie flat, in a plane with their neighbors, they are none of them.
///
/// @param[in] points  #P by 3, finite
/// @return #P, 1 for an isolated point, else 0; all 0 for up to eight points
/// @throws Aborted
std::vector<std::uint8_t> isolatedPoints(
  const Points& points, double farthest = 8.0, const Run& run = {});
}

#endif
