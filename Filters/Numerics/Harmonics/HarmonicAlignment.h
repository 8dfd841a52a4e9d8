/// Rotate surfaces to a common orientation. Each surface is given by coefficients of spherical
/// harmonics, which define its positions as functions on the unit sphere. The harmonics of degree 1
/// define an ellipsoid. Alignment by the axes of this ellipsoid follows \cite Brechbuehler1995.

#ifndef ConformalHarmonicAlignment_h
#define ConformalHarmonicAlignment_h

#include "Base/Run.h"
#include "Base/Types.h"

namespace conformal
{
/// Rotate functions on the sphere by a rotation R. The value of a rotated function at R p is the
/// value of the original function at p.
/// @param[in] coefficients  (L + 1)^2 by #C, coefficients of #C functions up to degree L
/// @param[in] rotation      the rotation R
/// @return (L + 1)^2 by #C coefficients of the rotated functions
Columns rotateHarmonics(
  const Columns& coefficients, const Eigen::Matrix3d& rotation, const Run& run = {});

/// Result of an alignment: rigid motion of a surface, and rotation of the surface's map to the
/// sphere. Let s be a surface point that is mapped to the sphere point p. Alignment moves s to
/// SurfaceRotation (s - Center). The moved point is mapped to MapRotation p.
struct HarmonicAlignment
{
  Eigen::Matrix3d MapRotation = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d SurfaceRotation = Eigen::Matrix3d::Identity();
  Vector3 Center = Vector3::Zero();
  /// Of alignToEllipsoid(): how clearly the ends of the axes are chosen, in [0, 4]. If the margin
  /// is near 0, small changes of the surface may exchange the ends of two axes.
  double EndMargin = 0.0;
};

/// Align a surface with the coordinate axes by its ellipsoid, as in \cite Brechbuehler1995 and in
/// the software SPHARM-PDM. The ellipsoid is the surface that the harmonics of degree 1 define.
///
/// The surface is moved so that the center of the ellipsoid is at the origin. The longest, middle
/// and shortest axis of the ellipsoid become the x, y and z axis. The map is rotated, too: the
/// positive end of each axis is mapped to the same axis of the sphere.
///
/// Each axis has two ends, one of which becomes the positive end. Four choices keep the frame of
/// the axes right-handed. The skewness along an axis is the third moment divided by the third
/// absolute moment, about the center of the surface's area. Moments are integrals over the area of
/// the surface that the harmonics up to degree 12 define. The choice with the largest sum of the
/// skewness along the three positive axes is selected. EndMargin is the difference of the largest
/// and the second-largest sum. If sums are equal, the ends of the longest and the middle axis are
/// compared by their positions on the sphere before the rotation. At the positive end, the sphere
/// coordinate of largest magnitude is positive. If two axes have equal lengths, their order is
/// arbitrary.
///
/// Implementation note: integrals over the sphere would weight the surface by its map. Limbs, which
/// distinguish the ends best, are small on the sphere.
/// @param[in] coefficients  (L + 1)^2 by 3 coefficients of positions
HarmonicAlignment alignToEllipsoid(const Columns& coefficients);

/// Align a surface with a reference surface by the axes of their ellipsoids. The orientations of
/// both surfaces are arbitrary.
///
/// Candidates are the four rotations that align the axes of both ellipsoids. Two axes are called
/// similar if their lengths differ by less than a tenth. If two axes of the surface are similar,
/// rotations about the third axis are also candidates. If all three axes are similar, rotations of
/// any kind are candidates. The candidate with the maximum correlation between the positions of
/// both surfaces is selected and refined. Correlations are computed with harmonics up to degree 12.
/// @param[in] coefficients  (L + 1)^2 by 3 coefficients of the positions of the surface
/// @param[in] reference     coefficients of the reference; its degree L may be different
/// @param[in] movesSurface  whether the surface is moved, too. If false, only the map is rotated.
///   The correlation is then computed from the present positions.
HarmonicAlignment alignToReference(
  const Columns& coefficients, const Columns& reference, bool movesSurface, const Run& run = {});
}

#endif
