/// Name all columns in an indexed view of a matrix. Own construction: Eigen 3.4 has Eigen::all, and
/// Eigen 5 only Eigen::placeholders::all, which Eigen 3.4 warns of. Both versions have the type.

#ifndef ConformalAllColumns_h
#define ConformalAllColumns_h

#include <Eigen/Core>

namespace conformal
{
const Eigen::internal::all_t AllColumns{}; ///< for the second argument of a matrix
}

#endif
