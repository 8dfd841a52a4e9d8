#include "PlateModel/CubedPlates.h"

#include <array>
#include <map>
#include <utility>

namespace conformal
{
namespace
{
using Position = std::array<double, 3>;

Position positionOf(const std::vector<double>& points, std::size_t id)
{
  return { points[3 * id], points[3 * id + 1], points[3 * id + 2] };
}

double squaredDistance(const Position& a, const Position& b)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return sum;
}

// Return six times the volume of the tetrahedron of a triangle and the origin.
double sixVolumes(const Position& a, const Position& b, const Position& c)
{
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
    a[2] * (b[0] * c[1] - b[1] * c[0]);
}
}

//------------------------------------------------------------------------------
CubedPlates connectCubedPlates(const std::vector<double>& grids, std::size_t q)
{
  const std::size_t width = q + 1, side = width * width;
  CubedPlates plates;
  std::map<Position, std::int64_t> borders;
  std::vector<std::int64_t> idOf(cubedSize(q));
  for (std::size_t k = 0; k < idOf.size(); ++k)
  {
    const std::size_t i = k % width, j = k % side / width;
    const Position position = positionOf(grids, k);
    const auto next = static_cast<std::int64_t>(plates.Points.size() / 3);
    const bool isBorder = i == 0 || i == q || j == 0 || j == q;
    const auto found =
      isBorder ? borders.emplace(position, next) : std::make_pair(borders.end(), true);
    idOf[k] = found.second ? next : found.first->second;
    if (found.second)
    {
      plates.Points.insert(plates.Points.end(), position.begin(), position.end());
    }
  }
  double volume = 0.0;
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c)
  {
    plates.Ids.insert(plates.Ids.end(), { idOf[a], idOf[b], idOf[c] });
    volume += sixVolumes(positionOf(grids, a), positionOf(grids, b), positionOf(grids, c));
  };
  for (std::size_t k = 0; k < idOf.size(); ++k)
  {
    if (k % width == q || k % side / width == q)
    {
      continue;
    }
    const std::size_t right = k + 1, above = k + width, opposite = above + 1;
    if (squaredDistance(positionOf(grids, k), positionOf(grids, opposite)) <=
      squaredDistance(positionOf(grids, right), positionOf(grids, above)))
    {
      add(k, right, opposite);
      add(k, opposite, above);
    }
    else
    {
      add(k, right, above);
      add(right, opposite, above);
    }
  }
  for (std::size_t t = 0; volume < 0.0 && t < plates.Ids.size(); t += 3)
  {
    std::swap(plates.Ids[t + 1], plates.Ids[t + 2]);
  }
  return plates;
}
}
