/// Make point clouds for tests.

#ifndef ConformalTestClouds_h
#define ConformalTestClouds_h

#include "Base/Random.h"
#include "Base/Types.h"

#include <cmath>
#include <functional>

namespace clouds
{
/// Return the points that satisfy a condition, in unchanged order.
inline conformal::Points where(
  const conformal::Points& all, const std::function<bool(const conformal::Vector3&)>& test)
{
  conformal::Points points(all.rows(), 3);
  conformal::Index size = 0;
  for (conformal::Index i = 0; i < all.rows(); ++i)
  {
    if (test(all.row(i)))
    {
      points.row(size++) = all.row(i);
    }
  }
  return points.topRows(size);
}

/// Return random points in the unit cube [0, 1)^3.
inline conformal::Points inUnitCube(conformal::Index size, unsigned int seed)
{
  conformal::Random random(seed);
  conformal::Points points(size, 3);
  for (conformal::Index i = 0; i < points.size(); ++i)
  {
    points.data()[i] = random.uniform();
  }
  return points;
}

/// Return a number of the standard normal distribution, by the method of Box and Muller.
inline double gaussian(conformal::Random& random)
{
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * conformal::Pi * random.uniform());
}
}

#endif
