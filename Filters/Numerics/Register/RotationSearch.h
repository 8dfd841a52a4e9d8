/// Finds the rotations after which two surfaces agree best on features.
/// Own construction: exhaustive search with refinement finds all good rotations.

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

/// Rotations that differ from each other by 30 degrees or more, the best one first: the best of
/// some 1,700 all over, each improved as far as it goes.
/// @param[in] weights  #K, of the features
/// @param[in] count    how many to find at most
std::vector<FoundRotation> searchRotations(const SampledSurface& moving,
  const SampledSurface& fixed, const std::vector<double>& weights, int count, const Run& run = {});
}

#endif
