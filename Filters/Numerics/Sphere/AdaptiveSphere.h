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

  /// By which the number of points may differ from the one wanted, as a share of it.
  static constexpr double Tolerance = 0.02;

  /// No angle of a triangle is smaller, in degrees.
  static constexpr double MinimumAngle = 28.0;
};

/// A closed triangle mesh of the unit sphere whose points lie as close as a density asks for, as
/// the "dense vertices in an area with fine texture" of N^new in \cite Liou2008 section 3.
///
/// This is Delaunay refinement of an icosahedron, as in \cite Chew1993 for curved surfaces. The
/// triangle that is farthest from the size wanted gets a point at the middle of its circumscribed
/// circle, until there are as many points as wanted. Before that a triangle with an angle below
/// MinimumAngle gets one. Such a point is farther from all others than the triangle's shortest edge
/// is long, so that this comes to an end whatever the density, and makes the gradual transition
/// that a jump of the density needs. Then points move to the middle of their triangles, and edges
/// are flipped, as far as no angle falls below the bound.
///
/// Implementation note: sizes get a random factor, else all triangles of a region of even density
/// would be divided at the same time and a region that is divided last be coarser by 1.7.
///
/// @return unit vectors, within 2 % of the number wanted; triangles counter-clockwise seen from
///   outside. No triangle is divided below a radius of 1e-7, where positions get rounded.
/// @throws std::invalid_argument if an option is out of range, or the density is 0 everywhere, or
///   as densitiesOf()
/// @throws Aborted
Mesh makeAdaptiveSphere(
  const SphereDensity& density, const AdaptiveSphereOptions& options = {}, const Run& run = {});
}

#endif
