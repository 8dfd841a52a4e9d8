/// Build a mesh of the sphere whose points have a given density.

#ifndef ConformalAdaptiveSphere_h
#define ConformalAdaptiveSphere_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Sphere/SphereDensity.h"

namespace conformal
{
struct AdaptiveSphereOptions
{
  /// Target number, in [AdaptiveSphereLimits::MinimumPoints, MaximumPoints]
  Index NumberOfPoints = 64002;
  int SmoothingRounds = 5; ///< number of smoothing rounds, at least 0
};

struct AdaptiveSphereLimits
{
  static constexpr Index MinimumPoints = 500, MaximumPoints = 100000000;

  /// Maximum relative deviation from the target number of points.
  static constexpr double Tolerance = 0.02;

  /// Minimum angle of every triangle [degrees].
  static constexpr double MinimumAngle = 28.0;
};

/// Build a closed triangle mesh of the unit sphere with a given density of points. \cite Liou2008
/// section 3 proposes such a mesh, named N^new there, with "dense vertices in an area with fine
/// texture".
///
/// The method is Delaunay refinement of an icosahedron, as in \cite Chew1993 for curved surfaces. A
/// triangle is divided by a new point at the center of its circumcircle. Triangles with an angle
/// below MinimumAngle are divided first. Otherwise, the triangle with the largest ratio of actual
/// size to target size is divided. Refinement ends at the target number of points.
///
/// The distance from a new point to any other point exceeds the shortest edge of the divided
/// triangle. Refinement therefore ends for any density, and the size of triangles changes gradually
/// where the density jumps. Finally, points move towards the centroid of their triangles and edges
/// are flipped, unless an angle would fall below MinimumAngle.
///
/// Implementation note: target sizes have a random factor. Without this factor, all triangles in a
/// region of constant density would be divided at about the same time. The part of the region that
/// is divided last would then have edges up to 1.7 times as long as the others.
///
/// @return mesh with unit vectors as positions, and triangles counter-clockwise seen from outside.
///   The number of points is within 2 % of the target number, unless the density requires too small
///   triangles. Triangles with a circumradius below 1e-7 are not divided, because rounding of
///   positions would distort them.
/// @throws std::invalid_argument if an option is out of range, if the density is 0 everywhere, or
///   for a reason given at densitiesOf()
/// @throws Aborted
Mesh makeAdaptiveSphere(
  const SphereDensity& density, const AdaptiveSphereOptions& options = {}, const Run& run = {});
}

#endif
