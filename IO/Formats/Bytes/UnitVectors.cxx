#include "Bytes/UnitVectors.h"

#include <cmath>
#include <cstring>

namespace conformal
{
//------------------------------------------------------------------------------
bool makeUnitVectors(NamedArray& vectors)
{
  constexpr double tolerance = 1e-12;
  for (std::size_t i = 0; i < vectors.Values.size(); i += 3 * sizeof(double))
  {
    double v[3];
    std::memcpy(v, vectors.Values.data() + i, sizeof(v));
    const double length = std::hypot(v[0], v[1], v[2]);
    if (!std::isfinite(length) || !(length > 0.0))
    {
      return false;
    }
    if (std::abs(length - 1.0) > tolerance)
    {
      for (double& component : v)
      {
        component /= length;
      }
      std::memcpy(vectors.Values.data() + i, v, sizeof(v));
    }
  }
  return true;
}
}
