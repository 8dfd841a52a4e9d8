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
/// Rotation of the moving surface's sphere, and the difference of the features after the rotation.
struct FoundRotation
{
  Eigen::Matrix3d Rotation;
  double Difference = 0.0; ///< weighted mean square difference of the features of both surfaces
};

/// Find rotations of the moving surface's sphere that minimize the difference of the features. The
/// result is sorted by ascending difference. Any two of the rotations differ by more than 30
/// degrees.
///
/// Initially, 1,680 rotations are evaluated. Then up to 60 of the best rotations are refined, each
/// by at most eight Gauss-Newton steps. Any two rotations selected for refinement differ by more
/// than 24 degrees.
/// @param[in] weights  #K, weights of the features
/// @param[in] count    maximum number of rotations to return
std::vector<FoundRotation> searchRotations(const SampledSurface& moving,
  const SampledSurface& fixed, const std::vector<double>& weights, int count, const Run& run = {});
}

#endif
