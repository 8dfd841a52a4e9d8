/// A mesh of the sphere with a given density.

#ifndef ConformalAdaptiveSphere_h
#define ConformalAdaptiveSphere_h

#include "Base/Run.h"
#include "Mesh/Mesh.h"
#include "Sphere/SphereDensity.h"

namespace conformal
{
struct AdaptiveSphereOptions
{
  Index NumberOfPoints = 64002; ///< in [AdaptiveSphereLimits::MinimumPoints, MaximumPoints]
  int SmoothingRounds = 5;      ///< at least 0
};

struct AdaptiveSphereLimits
{
  static constexpr Index MinimumPoints = 500, MaximumPoints = 100000000;

  /// Maximum relative deviation from the target number of points.
  static constexpr double Tolerance = 0.02;

  /// Lower bound of all angles of triangles [degrees].
  static constexpr double MinimumAngle = 28.0;
};

/// Build a closed triangle mesh of the unit sphere with a prescribed density of points. It provides
/// the "dense vertices in an area with fine texture" of N^new in \cite Liou2008 section 3.
///
/// The method is Delaunay refinement of an icosahedron, as in \cite Chew1993 for curved surfaces. A
/// triangle is divided at the center of its circumcircle. A triangle with an angle below
/// MinimumAngle is divided first. Otherwise the triangle with the largest ratio of actual to target
/// size is divided, until the target number of points is reached.
///
/// The new point is farther from all others than the shortest edge of the triangle. Refinement thus
/// ends for any density and grades the mesh at a jump of the density. Finally points move to the
/// centroid of their triangles and edges are flipped, as long as no angle falls below the bound.
///
/// Implementation note: target sizes have a random factor. Without it all triangles of a region of
/// even density would be divided at about the same time. A region divided last would then be
/// coarser by a factor of 1.7.
///
/// @return unit vectors, within 2 % of the target number; triangles counter-clockwise seen from
///   outside. No triangle of a radius below 1e-7 is divided, where positions are rounded.
/// @throws std::invalid_argument if an option is out of range, if the density is 0 everywhere, or
///   as densitiesOf()
/// @throws Aborted
Mesh makeAdaptiveSphere(
  const SphereDensity& density, const AdaptiveSphereOptions& options = {}, const Run& run = {});
}

#endif
