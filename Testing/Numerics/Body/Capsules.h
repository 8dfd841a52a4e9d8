/// Make capsules (cylinders with a hemisphere at each end), and their conformal map to the sphere.

#ifndef ConformalTestCapsules_h
#define ConformalTestCapsules_h

#include "Mesh/Mesh.h"

#include <cmath>
#include <vector>

namespace capsules
{
/// Return the tangent of half the angle from the north pole, on the sphere, of a point of a capsule
/// at an arc length from the equator.
inline double halfTangent(double arc, double half)
{
  const double beyond = std::abs(arc) - half, quarter = 0.25 * conformal::Pi;
  const double onCap = std::tan(quarter - 0.5 * std::max(beyond, 0.0));
  const double tangent = std::exp(-std::min(std::abs(arc), half)) * onCap;
  return arc < 0.0 ? 1.0 / tangent : tangent;
}

/// Make a capsule of radius 1 around the z axis.
/// @param[in] half     half the length of the cylinder
/// @param[in] columns  number of vertices around; there are about as many per length along it
inline conformal::MappedMesh make(double half, int columns)
{
  using conformal::Pi;
  using conformal::Vector3;
  const double longest = half + 0.5 * Pi;
  const int rings = 2 * static_cast<int>(std::ceil(longest * columns / (2.0 * Pi)));
  std::vector<Vector3> positions, directions;
  const auto add = [&](double arc, double longitude)
  {
    const double beyond = std::max(std::abs(arc) - half, 0.0), t = halfTangent(arc, half);
    const double radius = std::abs(arc) == longest ? 0.0 : std::cos(beyond);
    const Vector3 around(std::cos(longitude), std::sin(longitude), 0.0);
    const double z = std::min(std::abs(arc), half) + std::sin(beyond);
    positions.push_back(radius * around + Vector3(0, 0, std::copysign(z, arc)));
    const double u = arc < 0.0 ? 1.0 / t : t;
    const double scale = radius > 0.0 ? 2.0 * u / (1.0 + u * u) : 0.0;
    directions.push_back(
      scale * around + Vector3(0, 0, std::copysign((1.0 - u * u) / (1.0 + u * u), arc)));
  };
  add(-longest, 0.0);
  for (int j = 1; j < rings; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      add(longest * (2.0 * j / rings - 1.0), 2.0 * Pi * (i + 0.5 * (j % 2)) / columns);
    }
  }
  add(longest, 0.0);
  std::vector<Eigen::RowVector3i> triangles;
  const int last = static_cast<int>(positions.size()) - 1;
  for (int i = 0; i < columns; ++i)
  {
    const int next = (i + 1) % columns;
    triangles.emplace_back(0, 1 + next, 1 + i);
    triangles.emplace_back(last, last - columns + i, last - columns + next);
    for (int j = 1; j + 1 < rings; ++j)
    {
      const int low = 1 + (j - 1) * columns, high = low + columns;
      if (j % 2 == 0)
      {
        triangles.emplace_back(low + i, low + next, high + i);
        triangles.emplace_back(low + next, high + next, high + i);
      }
      else
      {
        triangles.emplace_back(low + i, low + next, high + next);
        triangles.emplace_back(low + i, high + next, high + i);
      }
    }
  }
  conformal::MappedMesh mesh;
  mesh.Positions.resize(static_cast<conformal::Index>(positions.size()), 3);
  mesh.SpherePositions.resize(mesh.Positions.rows(), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    mesh.Positions.row(static_cast<conformal::Index>(i)) = positions[i];
    mesh.SpherePositions.row(static_cast<conformal::Index>(i)) = directions[i];
  }
  mesh.Triangles.resize(static_cast<conformal::Index>(triangles.size()), 3);
  for (std::size_t r = 0; r < triangles.size(); ++r)
  {
    mesh.Triangles.row(static_cast<conformal::Index>(r)) = triangles[r];
  }
  return mesh;
}
}

#endif
