/// Build a triangle mesh of the unit sphere whose points have a given density.

#ifndef ConformalAdaptiveSphere_h
#define ConformalAdaptiveSphere_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Sphere/SphereDensity.h"

namespace conformal
{
struct AdaptiveSphereOptions
{
  /// Target number of points, in [MinimumPoints, MaximumPoints] of AdaptiveSphereLimits.
  Index NumberOfPoints = 64002;
  int SmoothingRounds = 5; ///< number of smoothing rounds, at least 0
};

struct AdaptiveSphereLimits
{
  static constexpr Index MinimumPoints = 500, MaximumPoints = 100000000;

  /// Maximum deviation of the number of points from the target number, as a fraction of the target
  /// number.
  static constexpr double Tolerance = 0.02;

  /// Minimum angle of every triangle of the mesh [degrees].
  static constexpr double MinimumAngle = 28.0;
};

/// Build a closed triangle mesh of the unit sphere with a given density of points. A mesh with
/// "dense vertices in an area with fine texture", named N^new, is proposed in \cite Liou2008
/// section 3.
///
/// The method is Delaunay refinement of an icosahedron, as in \cite Chew1993 for curved surfaces. A
/// triangle is divided by a new point at the center of its circumcircle. Triangles with an angle
/// below MinimumAngle are divided first. If there are none, the triangle with the largest ratio of
/// actual size to target size is divided. The density at the triangle determines its target size.
/// Refinement ends at the target number of points.
///
/// The distance from a new point to any other point exceeds the shortest edge of the divided
/// triangle. Points thus keep a minimum distance, so that refinement ends for any density. Even
/// where the density jumps, the size of triangles changes gradually. After the refinement, points
/// are moved towards the centroid of their triangles, and edges are flipped, in SmoothingRounds
/// rounds. A move is skipped if the smallest angle around the point would decrease to below 35
/// degrees. A flip is made only if it increases the smallest angle of its two triangles.
///
/// Implementation note: the ratios of actual size to target size are multiplied by random factors.
/// Otherwise, all triangles in a region of constant density would be divided at about the same
/// time. If refinement ended before all of them are divided, the other triangles of the region
/// would have edges up to 1.7 times too long.
///
/// @return mesh with unit vectors as positions, and triangles counter-clockwise seen from outside.
///   The number of points differs from the target number by at most 2 %. The number may be lower if
///   the density requires triangles with a circumradius below 1e-7. Triangles of this size are not
///   divided, because rounding of positions would distort them.
/// @throws std::invalid_argument if an option is out of range, or the density is 0 everywhere. Also
///   thrown if a value of the density is negative or not finite.
/// @throws Aborted
Mesh makeAdaptiveSphere(
  const SphereDensity& density, const AdaptiveSphereOptions& options = {}, const Run& run = {});
}

#endif
