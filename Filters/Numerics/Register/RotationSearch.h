/// Find the rotations of the sphere after which the features of two surfaces agree best. A feature
/// is a number at each point of a surface, such as the curvature. Both surfaces have maps to the
/// sphere. One surface is called moving, the other one fixed. The sphere of the moving surface is
/// rotated, and features at equal sphere positions are compared.
///
/// Own construction, not from a publication: many rotations, spread evenly over the group of
/// rotations, are evaluated. Only the best of these rotations are refined. Refinement of a single
/// rotation would find only a local minimum near this rotation.

#ifndef ConformalRotationSearch_h
#define ConformalRotationSearch_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/RegistrationDescent.h"

#include <vector>

namespace conformal
{
/// Rotation of the moving surface's sphere, and the difference of the surfaces after the rotation.
struct FoundRotation
{
  Eigen::Matrix3d Rotation;
  /// Weighted mean square difference of the features of both surfaces, plus the weighted mean
  /// square distance between landmarks and their targets on the unit sphere.
  double Difference = 0.0;
};

/// Find rotations of the moving surface's sphere that minimize the difference of the features and
/// the distances between landmarks and their targets. The result is sorted by ascending difference.
/// Any two of the rotations differ by more than 30 degrees.
///
/// Initially, 1,680 rotations are evaluated. Then up to 60 of the best rotations are refined, each
/// by at most eight Gauss-Newton steps. If there are landmarks, only the quarter of the rotations
/// that brings them nearest to their targets is evaluated, and up to 15 are refined. Any two
/// rotations selected for refinement differ by more than 24 degrees.
/// @param[in] pairs    landmarks: corresponding positions on the spheres of both surfaces
/// @param[in] weights  weights of the features and of the landmarks
/// @param[in] count    maximum number of rotations to return
std::vector<FoundRotation> searchRotations(const SampledSurface& moving,
  const SampledSurface& fixed, const std::vector<SpherePair>& pairs,
  const RegistrationWeights& weights, int count, const Run& run = {});
}

#endif
