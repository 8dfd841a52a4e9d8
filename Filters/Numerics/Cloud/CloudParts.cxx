#include "Cloud/CloudParts.h"

#include "Base/DisjointSets.h"

namespace conformal
{
std::vector<int> partsOfCloud(const Points& points, const PointTree& tree, double reach)
{
  constexpr int neighbors = 12;
  DisjointSets sets(points.rows());
  std::vector<Neighbor> around;
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    tree.nearest(points.row(i), neighbors, around);
    for (const Neighbor& neighbor : around)
    {
      if (neighbor.SquareDistance <= reach * reach)
      {
        sets.unite(i, neighbor.Id);
      }
    }
  }
  std::vector<int> parts(points.rows());
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    parts[i] = sets.find(i);
  }
  return parts;
}
}
