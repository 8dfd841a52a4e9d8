/// Fit a Moebius transform of the sphere to pairs of positions. Own construction: weighted least
/// squares by the method of Levenberg and Marquardt, started from the closest rotation.

#ifndef ConformalClosestMoebiusTransform_h
#define ConformalClosestMoebiusTransform_h

#include "Base/Run.h"
#include "Sphere/MoebiusTransform.h"

namespace conformal
{
/// Find the Moebius transform that minimizes the weighted mean square distance between transformed
/// and target positions.
/// @param[in] from, to  #P by 3 unit vectors, three or more of them different
/// @param[in] weights   #P, >= 0
MoebiusTransform closestMoebiusTransform(
  const Points& from, const Points& to, const Eigen::VectorXd& weights, const Run& run = {});
}

#endif
