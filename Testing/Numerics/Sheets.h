/// Make sheets for tests: caps of the unit sphere, and points on them.

#ifndef ConformalTestSheets_h
#define ConformalTestSheets_h

#include "Base/Random.h"
#include "Mesh/Mesh.h"

#include <cmath>
#include <vector>

namespace sheets
{
/// Return a cap of the unit sphere around the axis z, up to a polar angle: rings of triangles. Ring
/// i has 6 i vertices, and the last ring is the border.
inline conformal::Mesh cap(int rings, double angle)
{
  using conformal::Index;
  conformal::Mesh mesh;
  const auto first = [](int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); };
  mesh.Positions.resize(first(rings + 1), 3);
  mesh.Positions.row(0) << 0.0, 0.0, 1.0;
  std::vector<int> ids;
  for (int ring = 1; ring <= rings; ++ring)
  {
    const double theta = angle * ring / rings;
    for (int k = 0; k < 6 * ring; ++k)
    {
      const double phi = 2.0 * conformal::Pi * k / (6.0 * ring);
      mesh.Positions.row(first(ring) + k) << std::sin(theta) * std::cos(phi),
        std::sin(theta) * std::sin(phi), std::cos(theta);
    }
    for (int side = 0; side < 6; ++side)
    {
      for (int k = 0; k < ring; ++k)
      {
        const auto outer = [&](int i) { return first(ring) + (side * ring + i) % (6 * ring); };
        const auto inner = [&](int i)
        { return ring == 1 ? 0 : first(ring - 1) + (side * (ring - 1) + i) % (6 * (ring - 1)); };
        ids.insert(ids.end(), { outer(k), outer(k + 1), inner(k) });
        if (k + 1 < ring)
        {
          ids.insert(ids.end(), { inner(k), outer(k + 1), inner(k + 1) });
        }
      }
    }
  }
  mesh.Triangles =
    Eigen::Map<const conformal::Triangles>(ids.data(), static_cast<Index>(ids.size()) / 3, 3);
  return mesh;
}

/// Return random points of the unit sphere, evenly distributed where z is at least a height.
inline conformal::Points pointsAbove(double height, conformal::Index count, unsigned int seed)
{
  conformal::Random random(seed);
  conformal::Points points(count, 3);
  for (conformal::Index i = 0; i < count; ++i)
  {
    const double z = height + (1.0 - height) * random.uniform();
    const double angle = 2.0 * conformal::Pi * random.uniform(), r = std::sqrt(1.0 - z * z);
    points.row(i) << r * std::cos(angle), r * std::sin(angle), z;
  }
  return points;
}
}

#endif
