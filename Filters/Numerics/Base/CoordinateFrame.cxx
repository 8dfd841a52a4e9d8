#include "Base/CoordinateFrame.h"

#include "Base/AcrossProcesses.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace conformal
{
namespace
{
/// Return the maximum power of two not above a positive number, or 1 for 0.
double unitOf(double norm)
{
  return norm > 0.0 ? std::ldexp(1.0, std::ilogb(norm)) : 1.0;
}

/// Normalize a vector. Scale it by a power of two first: subnormal lengths have few digits, and the
/// length of huge vectors overflows.
template <typename Vector>
void normalize(Vector& v)
{
  v /= unitOf(v.cwiseAbs().maxCoeff());
  v /= v.stableNorm();
}

double maximumCoordinate(const PointView& points, const Run& run)
{
  constexpr Index blockSize = 1 << 14;
  std::vector<double> maxima((points.size() + blockSize - 1) / blockSize, 0.0);
  forBlocks(run, points.size(), blockSize,
    [&](Index begin, Index end)
    {
      double& ofBlock = maxima[begin / blockSize];
      for (Index i = begin; i < end; ++i)
      {
        const Vector3 x = points[i];
        ofBlock = x.allFinite() ? std::max(ofBlock, x.cwiseAbs().maxCoeff()) : ofBlock;
      }
    });
  return maxima.empty() ? 0.0 : *std::max_element(maxima.begin(), maxima.end());
}
}

//------------------------------------------------------------------------------
Vector3 inUnits(const Vector3& x, double unit)
{
  constexpr double farAway = 0x1p26;
  const Vector3 quotient = x / unit;
  return quotient.cwiseAbs().maxCoeff() <= farAway ? quotient : Vector3(farAway * unitVector(x));
}

//------------------------------------------------------------------------------
CoordinateFrame frameOf(const std::vector<PointView>& points, const Reduce& reduce, const Run& run)
{
  double own = 0.0;
  for (const PointView& some : points)
  {
    own = std::max(own, maximumCoordinate(some, run));
  }
  return { unitOf(maximum(reduce, { own })[0]) };
}

//------------------------------------------------------------------------------
Vector3 unitVector(const Vector3& v)
{
  Vector3 unit = v;
  normalize(unit);
  return unit;
}

//------------------------------------------------------------------------------
Index normalizeRows(Points& vectors)
{
  Index bad = 0;
  for (Index i = 0; i < vectors.rows(); ++i)
  {
    auto row = vectors.row(i);
    normalize(row);
    bad += !row.allFinite();
  }
  return bad;
}
}
