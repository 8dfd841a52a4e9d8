#include "Linear/NestedDissection.h"

#include <algorithm>
#include <numeric>

namespace conformal
{
namespace
{
constexpr int LeafSize = 48;

class Dissector
{
public:
  Dissector(const Adjacency& graph, const Points& places, CutAxes axes, NestedDissection& result)
    : Graph(graph)
    , Places(places)
    , Axes(axes)
    , Result(result)
    , Sides(places.rows(), -1)
  {
  }

  // Divide the unknowns in [begin, end), and return the index of their last part.
  int part(int begin, int end, int level)
  {
    std::vector<int> children;
    int own = begin;
    if (end - begin > LeafSize)
    {
      const auto [left, right] = this->cut(begin, end);
      // Halves that are not connected need no separator, but a part has one.
      const int separator = std::min(right, end - 1);
      if (left > begin && separator > left)
      {
        children = { this->part(begin, left, level + 1), this->part(left, separator, level + 1) };
        own = separator;
      }
    }
    this->Result.Parts.push_back({ own, end, level, std::move(children) });
    return static_cast<int>(this->Result.Parts.size()) - 1;
  }

private:
  // Sort the unknowns in [begin, end) into left half, right half and separator. Return the ends of
  // both halves.
  std::pair<int, int> cut(int begin, int end)
  {
    auto* ids = this->Result.Order.data();
    Eigen::RowVector3d low = this->Places.row(ids[begin]), high = low;
    for (int i = begin + 1; i < end; ++i)
    {
      low = low.cwiseMin(this->Places.row(ids[i]));
      high = high.cwiseMax(this->Places.row(ids[i]));
    }
    const int middle = begin + (end - begin) / 2;
    // Put the unknowns of the right half behind the middle. Return the number of this cut.
    const auto halve = [&](Index axis)
    {
      std::nth_element(ids + begin, ids + middle, ids + end,
        [&](int a, int b)
        {
          const double x = this->Places(a, axis), y = this->Places(b, axis);
          return x != y ? x < y : a < b;
        });
      const int stamp = this->Stamp++;
      for (int i = middle; i < end; ++i)
      {
        this->Sides[ids[i]] = stamp;
      }
      return stamp;
    };
    Index axis = 0;
    (high - low).maxCoeff(&axis);
    if (this->Axes == CutAxes::FewestUnknowns)
    {
      Index fewest = end - begin;
      for (const Index other : { axis, (axis + 1) % 3, (axis + 2) % 3 })
      {
        const Index count = this->separatorSize(begin, middle, halve(other));
        axis = count < fewest ? other : axis;
        fewest = std::min(fewest, count);
      }
    }
    const int stamp = halve(axis);
    const auto inside = [&](int id)
    {
      return std::none_of(this->Graph.begin(id), this->Graph.end(id),
        [&](int neighbor) { return this->Sides[neighbor] == stamp; });
    };
    const auto* left = std::stable_partition(ids + begin, ids + middle, inside);
    std::rotate(ids + (left - ids), ids + middle, ids + end);
    const int leftEnd = static_cast<int>(left - ids);
    return { leftEnd, leftEnd + (end - middle) };
  }

  // Count the unknowns in [begin, end) that have neighbors in the right half of a cut.
  Index separatorSize(int begin, int end, int stamp) const
  {
    const auto* ids = this->Result.Order.data();
    return std::count_if(ids + begin, ids + end,
      [&](int id)
      {
        return std::any_of(this->Graph.begin(id), this->Graph.end(id),
          [&](int neighbor) { return this->Sides[neighbor] == stamp; });
      });
  }

  const Adjacency& Graph;
  const Points& Places;
  CutAxes Axes;
  NestedDissection& Result;
  std::vector<int> Sides; // number of the last cut that had the unknown in its right half
  int Stamp = 0;
};
}

//------------------------------------------------------------------------------
NestedDissection dissect(const Adjacency& graph, const Points& places, CutAxes axes)
{
  NestedDissection result;
  const int size = static_cast<int>(places.rows());
  result.Order.resize(size);
  std::iota(result.Order.begin(), result.Order.end(), 0);
  if (size > 0)
  {
    Dissector(graph, places, axes, result).part(0, size, 0);
  }
  result.Positions.resize(size);
  for (int i = 0; i < size; ++i)
  {
    result.Positions[result.Order[i]] = i;
  }
  return result;
}
}
