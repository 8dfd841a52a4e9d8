#include "Sphere/SphereCoverage.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace conformal
{
namespace
{
struct Part
{
  double SolidAngle = 0.0;
  Index NumberOfFolds = 0;
};

Part measure(const Points& positions, const Triangles& triangles, Index begin, Index end)
{
  Part part;
  for (Index r = begin; r < end; ++r)
  {
    const Vector3 a = positions.row(triangles(r, 0)), b = positions.row(triangles(r, 1)),
                  c = positions.row(triangles(r, 2));
    const Vector3 ab = b - a, ac = c - a;
    const double volume = ab.cross(ac).dot(a); // det(a, b, c), exact for small triangles
    const double denominator = 1.0 + a.dot(b) + b.dot(c) + c.dot(a);
    // Vertices are rounded to 1e-16, so the error of the area is that times the longest edge.
    const double longest =
      std::sqrt(std::max({ ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm() }));
    const double rounding = 1e-15 * longest;
    // A triangle whose plane contains the center covers one half of the sphere or the other, by
    // chance, unless its corners are on less than half of a great circle.
    const bool isUndecided = std::abs(volume) <= rounding && denominator <= 1e-15;
    part.SolidAngle += isUndecided ? 0.0 : 2.0 * std::atan2(volume, denominator);
    part.NumberOfFolds += isUndecided || volume < -rounding;
  }
  return part;
}
}

//------------------------------------------------------------------------------
SphereCoverage measureSphereCoverage(
  const Points& positions, const Triangles& triangles, const Run& run)
{
  const Index blockSize = 1024;
  std::vector<Part> parts((triangles.rows() + blockSize - 1) / blockSize);
  forBlocks(run, triangles.rows(), blockSize,
    [&](Index begin, Index end)
    { parts[begin / blockSize] = measure(positions, triangles, begin, end); });
  SphereCoverage coverage;
  double solidAngle = 0.0;
  for (const Part& part : parts)
  {
    solidAngle += part.SolidAngle;
    coverage.NumberOfFolds += part.NumberOfFolds;
  }
  coverage.Times = solidAngle / (4.0 * Pi);
  // Small holes of a scan are closed by interpolation. A sheet covers half of the sphere, and half
  // is rounded up or down by chance.
  constexpr double smallHoles = 0.01;
  const double nearest = std::round(coverage.Times);
  coverage.Degree = std::abs(coverage.Times - nearest) < smallHoles ? static_cast<int>(nearest) : 0;
  return coverage;
}

//------------------------------------------------------------------------------
SphereCoverage turnToCover(const Points& positions, Triangles& triangles, const Run& run)
{
  SphereCoverage coverage = measureSphereCoverage(positions, triangles, run);
  if (coverage.Degree < 0)
  {
    triangles.col(1).swap(triangles.col(2));
    coverage = measureSphereCoverage(positions, triangles, run);
  }
  return coverage;
}

//------------------------------------------------------------------------------
Triangles turnedToCoverOnce(
  const Points& positions, const Triangles& triangles, const std::string& map, const Run& run)
{
  Triangles turned = triangles;
  const SphereCoverage coverage = turnToCover(positions, turned, run);
  if (coverage.Degree != 1 || coverage.NumberOfFolds > 0)
  {
    throw std::invalid_argument(map + " covers it " + std::to_string(coverage.Degree) +
      " times with " + std::to_string(coverage.NumberOfFolds) +
      " folded triangles, but must cover it once without folds");
  }
  return turned;
}
}
