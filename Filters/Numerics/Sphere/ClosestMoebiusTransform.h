/// The conformal map of the sphere to itself that fits best.

#ifndef ConformalClosestMoebiusTransform_h
#define ConformalClosestMoebiusTransform_h

#include "Base/Run.h"
#include "Sphere/MoebiusTransform.h"

namespace conformal
{
/// The transform that brings positions closest to others, in the sense of weighted least squares.
/// @param[in] from, to  #P by 3 unit vectors, three or more of them different
/// @param[in] weights   #P, not negative
MoebiusTransform closestMoebiusTransform(
  const Points& from, const Points& to, const Eigen::VectorXd& weights, const Run& run = {});
}

#endif
