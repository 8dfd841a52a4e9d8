/// Fit a Moebius transform (conformal map of the sphere to itself) to pairs of positions. The
/// method is our own construction, because no formula for the solution is known. The transform is
/// computed by weighted least squares, with the method of Levenberg and Marquardt. The initial
/// transform is the closest rotation.

#ifndef ConformalClosestMoebiusTransform_h
#define ConformalClosestMoebiusTransform_h

#include "Base/Run.h"
#include "Sphere/MoebiusTransform.h"

namespace conformal
{
/// Find the Moebius transform that minimizes the weighted mean square distance between the
/// transformed positions `from` and the positions `to`.
/// @param[in] from, to  #P by 3 unit vectors; each matrix has at least three different rows
/// @param[in] weights   #P weights of the pairs, >= 0
MoebiusTransform closestMoebiusTransform(
  const Points& from, const Points& to, const Eigen::VectorXd& weights, const Run& run = {});
}

#endif
