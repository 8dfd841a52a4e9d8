/// Clouds on the unit sphere, shared by tests.

#ifndef ConformalTestSpheres_h
#define ConformalTestSpheres_h

#include "Base/Types.h"
#include "Clouds.h"
#include "Mesh/GeodesicSphere.h"

#include <cmath>
#include <functional>

namespace spheres
{
/// Points of a geodesic sphere for which the test holds.
inline conformal::Points geodesicWhere(
  int frequency, const std::function<bool(const conformal::Vector3&)>& test)
{
  return clouds::where(conformal::makeGeodesicSphere(frequency).Positions, test);
}

/// Spread evenly along a spiral.
inline conformal::Points spiral(conformal::Index size)
{
  conformal::Points points(size, 3);
  for (conformal::Index i = 0; i < size; ++i)
  {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(size);
    const double turn = 2.399963229728653 * static_cast<double>(i), r = std::sqrt(1.0 - z * z);
    points.row(i) << r * std::cos(turn), r * std::sin(turn), z;
  }
  return points;
}
}

#endif
