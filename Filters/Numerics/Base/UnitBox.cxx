#include "Base/UnitBox.h"

#include <stdexcept>
#include <string>

namespace conformal
{
//------------------------------------------------------------------------------
UnitBox unitBoxOf(const PointView& points)
{
  if (points.size() == 0)
  {
    return {};
  }
  Vector3 lower = points[0], upper = points[0];
  Index bad = 0;
  for (Index i = 0; i < points.size(); ++i)
  {
    bad += !points[i].allFinite();
    lower = lower.cwiseMin(points[i]);
    upper = upper.cwiseMax(points[i]);
  }
  if (bad > 0)
  {
    throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(points.size()) +
      " points of the surface are not finite");
  }
  const double half = (0.5 * upper - 0.5 * lower).maxCoeff();
  return { lower, half > 0.0 ? half : 1.0 };
}

//------------------------------------------------------------------------------
Points inUnitBox(const PointView& points)
{
  const UnitBox box = unitBoxOf(points);
  Points moved(points.size(), 3);
  for (Index i = 0; i < points.size(); ++i)
  {
    moved.row(i) = box(points[i]);
  }
  return moved;
}
}
