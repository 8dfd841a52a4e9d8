/// Fit a Moebius transform of the sphere to pairs of positions. Own construction: weighted least
/// squares by the method of Levenberg and Marquardt, because no formula gives the solution. It
/// starts from the closest rotation.

#ifndef ConformalClosestMoebiusTransform_h
#define ConformalClosestMoebiusTransform_h

#include "Base/Run.h"
#include "Sphere/MoebiusTransform.h"

namespace conformal
{
/// Find the Moebius transform that moves the positions `from` as close as possible to the positions
/// `to`. It minimizes the weighted mean square distance of the pairs.
/// @param[in] from, to  #P by 3 unit vectors, at least three of them different
/// @param[in] weights   #P weights of the pairs, >= 0
MoebiusTransform closestMoebiusTransform(
  const Points& from, const Points& to, const Eigen::VectorXd& weights, const Run& run = {});
}

#endif
