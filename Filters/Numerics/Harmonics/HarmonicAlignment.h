/// Rotate surfaces, given by coefficients of spherical harmonics, to a common orientation.
/// Alignment to the first-degree ellipsoid follows \cite Brechbuehler1995.

#ifndef ConformalHarmonicAlignment_h
#define ConformalHarmonicAlignment_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Rotate functions on the sphere by a rotation R: the new value at R p is the old value at p.
/// @param[in] coefficients  (L + 1)^2 by #C
/// @param[in] rotation      the rotation R
Columns rotateHarmonics(
  const Columns& coefficients, const Eigen::Matrix3d& rotation, const Run& run = {});

/// Rigid motion of a surface, and rotation of its map to the sphere. A surface point s that is
/// mapped to p is moved to SurfaceRotation (s - Center), and is then mapped to MapRotation p.
struct HarmonicAlignment
{
  Eigen::Matrix3d MapRotation = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d SurfaceRotation = Eigen::Matrix3d::Identity();
  Vector3 Center = Vector3::Zero();
};

/// Align a surface to the axes of the ellipsoid that its harmonics of degree 1 define, as in
/// \cite Brechbuehler1995 and in SPHARM-PDM.
///
/// The center moves to the origin. The longest, middle and shortest axis become the x, y and z
/// axis. The sphere positions of the ends of these axes also become x, y and z.
///
/// On the longest and on the middle axis, the positive end is the one to which the surface extends
/// farther, by the third moment over the sphere. If the third moment is zero, the largest
/// coordinate of the positive end on the sphere is positive. The order of axes of equal length is
/// arbitrary.
/// @param[in] coefficients  (L + 1)^2 by 3 coefficients of positions
HarmonicAlignment alignToEllipsoid(const Columns& coefficients);

/// Align the ellipsoid axes of a surface with those of a reference. Both may have any orientation.
///
/// Candidates are the four proper rotations that align the axes, and permutations of axes whose
/// lengths differ by less than a tenth. The selected candidate has the maximum correlation between
/// the surfaces, computed with harmonics up to degree 12.
/// @param[in] coefficients, reference  (L + 1)^2 by 3 coefficients of positions; the degrees may
///   differ
/// @param[in] movesSurface             whether to move the surface as well as its map; if false,
///   surfaces are correlated at their present positions
HarmonicAlignment alignToReference(
  const Columns& coefficients, const Columns& reference, bool movesSurface, const Run& run = {});
}

#endif
