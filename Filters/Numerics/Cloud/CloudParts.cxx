#include "Cloud/CloudParts.h"

#include "Base/DisjointSets.h"

#include <algorithm>

namespace conformal
{
std::vector<int> partsOfCloud(const Points& points, const SampleSpacing& spacing, double reach)
{
  constexpr int neighbors = 12;
  constexpr double spacings = 2.0, farthest = 4.0; // farthest in reaches
  DisjointSets sets(points.rows());
  std::vector<Neighbor> around;
  const auto unite = [&](int i, double limit)
  {
    for (const Neighbor& neighbor : around)
    {
      if (neighbor.SquareDistance <= limit * limit)
      {
        sets.unite(i, neighbor.Id);
      }
    }
  };
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    const Neighborhood found = spacing.at(i, around);
    if (found.Count > neighbors)
    {
      unite(i, std::clamp(spacings * found.spacing(), reach, farthest * reach));
    }
    spacing.tree().nearest(points.row(i), neighbors, around);
    unite(i, reach);
  }
  std::vector<int> parts(points.rows());
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    parts[i] = sets.find(i);
  }
  return parts;
}
}
