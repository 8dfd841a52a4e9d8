/// Find the rotations of the sphere after which the features of two surfaces agree best.
///
/// Own construction, not from a publication: rotations spread evenly over all rotations are
/// evaluated before the best ones are refined. Refinement alone would find only the local minimum
/// nearest to its start.

#ifndef ConformalRotationSearch_h
#define ConformalRotationSearch_h

#include "Base/Run.h"
#include "Base/Types.h"
#include "Register/RegistrationDescent.h"

#include <vector>

namespace conformal
{
/// Rotation with the remaining difference between the features of both surfaces.
struct FoundRotation
{
  Eigen::Matrix3d Rotation;
  double Difference = 0.0; ///< weighted mean square difference of the features
};

/// Find rotations of the moving surface's sphere that minimize the difference of the features. The
/// result is sorted by ascending difference. Any two of the rotations differ by more than 30
/// degrees.
///
/// Initially, 1,680 rotations are evaluated. Then the 60 best distinct rotations are refined, each
/// by at most eight Gauss-Newton steps.
/// @param[in] weights  #K, weights of the features
/// @param[in] count    maximum number of rotations to return
std::vector<FoundRotation> searchRotations(const SampledSurface& moving,
  const SampledSurface& fixed, const std::vector<double>& weights, int count, const Run& run = {});
}

#endif
