#include "SphereCoverage.h"

#include <algorithm>
#include <cmath>

namespace conformal
{
SphereCoverage measureSphereCoverage(const Points& positions, const Triangles& faces)
{
  SphereCoverage coverage;
  double solidAngle = 0.0;
  for (Index r = 0; r < faces.rows(); ++r)
  {
    const Vector3 a = positions.row(faces(r, 0)), b = positions.row(faces(r, 1)),
                  c = positions.row(faces(r, 2));
    const Vector3 ab = b - a, ac = c - a;
    const double volume = ab.cross(ac).dot(a); // det(a, b, c), exact for small triangles
    solidAngle += 2.0 * std::atan2(volume, 1.0 + a.dot(b) + b.dot(c) + c.dot(a));
    // A vertex is known to 1e-16, so the area to that times the longest edge.
    const double longest =
      std::sqrt(std::max({ ab.squaredNorm(), ac.squaredNorm(), (c - b).squaredNorm() }));
    coverage.NumberOfFolds += volume < -1e-15 * longest;
  }
  const double sphere = 4.0 * std::acos(-1.0);
  coverage.Degree = static_cast<int>(std::lround(solidAngle / sphere));
  return coverage;
}
}
