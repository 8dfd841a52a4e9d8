/// Rotate coefficients of surfaces to a common orientation. Alignment to the first-degree ellipsoid
/// follows \cite Brechbuehler1995.

#ifndef ConformalHarmonicAlignment_h
#define ConformalHarmonicAlignment_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Rotate functions on the sphere: the value at R p becomes the former value at p.
/// @param[in] coefficients  (L + 1)^2 by #C
/// @param[in] rotation      R
Columns rotateHarmonics(
  const Columns& coefficients, const Eigen::Matrix3d& rotation, const Run& run = {});

/// Rigid motion of a surface and rotation of its map. A surface point s that maps to p moves to
/// SurfaceRotation (s - Center), and maps to MapRotation p.
struct HarmonicAlignment
{
  Eigen::Matrix3d MapRotation = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d SurfaceRotation = Eigen::Matrix3d::Identity();
  Vector3 Center = Vector3::Zero();
};

/// Align a surface to the axes of the ellipsoid that its harmonics of degree 1 define, as in \cite
/// Brechbuehler1995 and in SPHARM-PDM.
///
/// The center moves to the origin. The longest, middle and shortest axis become the x, y and z
/// axis. Their directions on the sphere become x, y and z, too.
///
/// The positive end of the longest and of the middle axis is that to which the surface extends
/// farther, by the third moment over the sphere. If both ends are equal, the positive end has a
/// positive largest coordinate on the sphere. The order of axes of equal length is arbitrary.
/// @param[in] coefficients  (L + 1)^2 by 3, of positions
HarmonicAlignment alignToEllipsoid(const Columns& coefficients);

/// Align the ellipsoid axes of a surface to those of a reference, whatever their orientation.
///
/// Candidates are the four proper alignments of the axes, and permutations of axes whose lengths
/// differ by less than a tenth. The candidate of maximum correlation between the surfaces is
/// selected, by harmonics up to degree 12.
/// @param[in] coefficients, reference  (L + 1)^2 by 3, of positions; the degrees may differ
/// @param[in] movesSurface             whether the surface is moved as well as its map; otherwise,
///   surfaces are correlated in place
HarmonicAlignment alignToReference(
  const Columns& coefficients, const Columns& reference, bool movesSurface, const Run& run = {});
}

#endif
