/// Turns coefficients of surfaces so that they can be compared.

#ifndef ConformalHarmonicAlignment_h
#define ConformalHarmonicAlignment_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Functions on a sphere that was turned: their value at R p is what it was at p.
/// @param[in] coefficients  (L + 1)^2 by #C
/// @param[in] rotation      R
Columns rotateHarmonics(
  const Columns& coefficients, const Eigen::Matrix3d& rotation, const Run& run = {});

/// A point s of a surface that is mapped to p comes to SurfaceRotation (s - Center) and is mapped
/// to MapRotation p.
struct HarmonicAlignment
{
  Eigen::Matrix3d MapRotation = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d SurfaceRotation = Eigen::Matrix3d::Identity();
  Vector3 Center = Vector3::Zero();
};

/// Along the axes of the ellipsoid that the harmonics of degree 1 make of the sphere, as in
/// \cite Brechbuehler1995 and in SPHARM-PDM. The places on the sphere where its longest, middle and
/// shortest axes end come to the x, y and z axis, and so do the axes themselves; its center comes
/// to the origin. Of the two ends of the longest and the middle axis that one is positive to which
/// the surface reaches farther, by the third moment over the sphere; where both are alike, the one
/// whose place on the sphere has a positive largest coordinate. Axes of equal length are taken as
/// they come.
/// @param[in] coefficients  (L + 1)^2 by 3, of positions
HarmonicAlignment alignToEllipsoid(const Columns& coefficients);

/// The same axes upon those of a reference, wherever they lie there. Of the four ways to do so, and
/// of all others where axes differ in length by less than a tenth, that one is taken after which
/// the surfaces correlate best, by the harmonics up to degree 12.
/// @param[in] coefficients, reference  (L + 1)^2 by 3, of positions; the degrees may differ
/// @param[in] movesSurface             whether the surface is turned as well as its map, else the
///                                     correlation is that of the surfaces where they are
HarmonicAlignment alignToReference(
  const Columns& coefficients, const Columns& reference, bool movesSurface, const Run& run = {});
}

#endif
