#include "Search/PointTree.h"

#include "Search/BoxTree.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

namespace conformal
{
namespace
{
constexpr Index PointsPerLeaf = 8;

Index middleOf(Index first, Index last)
{
  return first + (last - first) / 2;
}

// Neighbor at infinite distance.
constexpr Neighbor Nobody = { std::numeric_limits<int>::max(),
  std::numeric_limits<double>::infinity() };

// Neighbors found so far; a better neighbor replaces the farthest one.
struct NearestOne
{
  Neighbor Best = Nobody;
  const Neighbor& farthest() const { return this->Best; }
  void replaceFarthest(const Neighbor& neighbor) { this->Best = neighbor; }
};

struct NearestHeap
{
  std::vector<Neighbor>& Heap; ///< at its final size, the farthest neighbor first
  const Neighbor& farthest() const { return this->Heap.front(); }
  void replaceFarthest(const Neighbor& neighbor)
  {
    std::pop_heap(this->Heap.begin(), this->Heap.end());
    this->Heap.back() = neighbor;
    std::push_heap(this->Heap.begin(), this->Heap.end());
  }
};
}

//------------------------------------------------------------------------------
PointTree::PointTree(const PointView& points, const Run& run)
  : Places(points.size())
{
  Index bad = 0;
  for (Index i = 0; i < points.size(); ++i)
  {
    this->Places[i] = { points[i], static_cast<int>(i) };
    bad += !this->Places[i].Position.allFinite();
  }
  if (bad > 0)
  {
    throw std::invalid_argument(std::to_string(bad) + " of " + std::to_string(points.size()) +
      " points of the cloud are not finite");
  }
  // If the two parts of a range differ in size, the lower part has one more point.
  Index nodes = 0;
  for (Index longest = this->size(), count = 1; longest > PointsPerLeaf; longest /= 2)
  {
    nodes += count;
    count *= 2;
  }
  this->Axes.resize(nodes);
  this->split(0, 0, this->size(), run);
}

//------------------------------------------------------------------------------
void PointTree::split(Index node, Index first, Index last, const Run& run)
{
  // Smaller ranges are split in a short time, and are not reported
  constexpr Index sizeToReport = 1 << 12;
  if (last - first <= PointsPerLeaf)
  {
    return;
  }
  Box bounds;
  for (Index i = first; i < last; ++i)
  {
    bounds.extend(this->Places[i].Position);
  }
  int axis = 0;
  (0.5 * bounds.Upper - 0.5 * bounds.Lower).maxCoeff(&axis);
  const Index middle = middleOf(first, last);
  const auto begin = this->Places.begin();
  std::nth_element(begin + first, begin + middle, begin + last,
    [axis](const Place& a, const Place& b)
    {
      return a.Position[axis] < b.Position[axis] ||
        (a.Position[axis] == b.Position[axis] && a.Id < b.Id);
    });
  this->Axes[node] = static_cast<unsigned char>(axis);
  this->split(2 * node + 1, first, middle, run);
  this->split(2 * node + 2, middle + 1, last, run);
  if (last - first >= sizeToReport)
  {
    run.report(static_cast<double>(last) / static_cast<double>(this->size()));
  }
}

//------------------------------------------------------------------------------
template <typename Found>
void PointTree::search(
  const Vector3& x, const Vector3& apart, Index node, Index first, Index last, Found& found) const
{
  const auto look = [&](const Place& place)
  {
    const Vector3 difference = x - place.Position;
    const Neighbor neighbor = { place.Id, difference.dot(difference) };
    if (neighbor < found.farthest())
    {
      found.replaceFarthest(neighbor);
    }
  };
  if (last - first <= PointsPerLeaf)
  {
    for (Index i = first; i < last; ++i)
    {
      look(this->Places[i]);
    }
    return;
  }
  const Index middle = middleOf(first, last);
  const int axis = this->Axes[node];
  const double beyond = x[axis] - this->Places[middle].Position[axis];
  look(this->Places[middle]);
  const auto searchSide = [&](bool upper, const Vector3& gap)
  {
    if (upper)
    {
      this->search(x, gap, 2 * node + 2, middle + 1, last, found);
    }
    else
    {
      this->search(x, gap, 2 * node + 1, first, middle, found);
    }
  };
  searchSide(beyond >= 0.0, apart);
  // Lower bound of the distance to the other half, axis by axis. At equal distance, the other half
  // may contain a lower id.
  Vector3 gap = apart;
  gap[axis] = beyond;
  if (gap.dot(gap) <= found.farthest().SquareDistance)
  {
    searchSide(beyond < 0.0, gap);
  }
}

//------------------------------------------------------------------------------
void PointTree::nearest(const Vector3& x, int k, std::vector<Neighbor>& neighbors) const
{
  const Index count = std::min<Index>(std::max(k, 0), this->size());
  neighbors.assign(count, Nobody);
  if (count > 0)
  {
    NearestHeap found = { neighbors };
    this->search(x, Vector3::Zero(), 0, 0, this->size(), found);
    std::sort_heap(neighbors.begin(), neighbors.end());
  }
}

//------------------------------------------------------------------------------
Neighbor PointTree::nearest(const Vector3& x) const
{
  NearestOne found;
  this->search(x, Vector3::Zero(), 0, 0, this->size(), found);
  return this->size() > 0 ? found.Best : Neighbor();
}
}
