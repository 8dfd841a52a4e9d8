/// Find the rotations of the sphere after which the features of two surfaces agree best. Own
/// construction: rotations all over the space are evaluated, because a descent finds only one local
/// minimum.

#ifndef ConformalRotationSearch_h
#define ConformalRotationSearch_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/RegistrationDescent.h"

#include <vector>

namespace conformal
{
struct FoundRotation
{
  Eigen::Matrix3d Rotation;
  double Difference = 0.0; ///< weighted mean square difference of the features
};

/// Find rotations that differ from each other by at least 30 degrees, and return them by ascending
/// difference of the features. About 1,700 rotations are evaluated, and the best ones are refined
/// to convergence.
/// @param[in] weights  #K, weights of the features
/// @param[in] count    maximum number of rotations to return
std::vector<FoundRotation> searchRotations(const SampledSurface& moving,
  const SampledSurface& fixed, const std::vector<double>& weights, int count, const Run& run = {});
}

#endif
